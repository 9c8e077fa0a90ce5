//! The tree of a sample as folds inside folds, written without recursion: trees may be deep.

use std::collections::HashMap;
use std::fmt::{Formatter, Result};

use super::ray::{RayOnPage, color, share};
use crate::math::Rgb;
use crate::probe::RayKind;
use crate::trace::document::{Document, RayNode, SampleTree, TermValue};
use crate::trace::export::xml::escape;
use crate::trace::format::{counted, num, rgb};

const CLOSE: &str = "</details>\n";

/// The rays of a sample. If there are several samples, each is a fold, of which the first is open.
pub fn tree(f: &mut Formatter, document: &Document, sample: &SampleTree) -> Result {
    let is_one_of_many = document.samples.len() > 1;
    if is_one_of_many {
        let [x, y] = sample.film.map(num);
        let is_first = document
            .samples
            .first()
            .is_some_and(|s| s.index == sample.index);
        let open = if is_first { " open" } else { "" };
        let radiance = sample.root.as_ref().and_then(|root| root.radiance);
        writeln!(
            f,
            "<details{open}><summary {}>sample {} at ({x}, {y}), weight {}</summary>",
            color(document, radiance.unwrap_or_default()),
            sample.index,
            num(sample.weight)
        )?;
    }
    rays(f, document, sample)?;
    f.write_str(if is_one_of_many { CLOSE } else { "" })
}

/// The rays to an area light, which are open while they are written.
struct OpenBundle<'a> {
    light: &'a str,
    /// Rays between them and the eye.
    level: usize,
    /// The terms of their hit, by the numbers of the light's samples.
    terms: HashMap<u32, Vec<&'a TermValue>>,
}

fn rays(f: &mut Formatter, document: &Document, sample: &SampleTree) -> Result {
    // The rays from the eye to the one that is written.
    let mut around: Vec<&RayNode> = Vec::new();
    let mut bundle: Option<OpenBundle> = None;
    for ray in sample.rays() {
        let node = ray.node;
        let light = node.sample.and(node.light.as_deref());
        if bundle
            .take_if(|b| light != Some(b.light) || ray.level != b.level)
            .is_some()
        {
            f.write_str(CLOSE)?;
        }
        while around.len() > ray.level {
            around.pop();
            f.write_str(CLOSE)?;
        }
        let sender = around.last().copied();
        if let (None, Some(light), Some(sender)) = (&bundle, light, sender) {
            open(f, document, sample, (sender, light))?;
            bundle = Some(OpenBundle {
                light,
                level: ray.level,
                terms: terms(sender, light),
            });
        }
        let on_page = RayOnPage {
            document,
            sample,
            ray,
            sender,
        };
        if node.kind == RayKind::Light {
            let number = node.sample.unwrap_or_default();
            let terms = bundle.as_ref().and_then(|b| b.terms.get(&number));
            on_page.to_light(f, terms.map_or(&[], Vec::as_slice))?;
        } else {
            on_page.open(f)?;
            around.push(node);
        }
    }
    if bundle.is_some() {
        f.write_str(CLOSE)?;
    }
    around.iter().try_for_each(|_| f.write_str(CLOSE))
}

/// Opens the rays from a hit to an area light: how many there are, and what they bring.
fn open(
    f: &mut Formatter,
    document: &Document,
    sample: &SampleTree,
    (sender, light): (&RayNode, &str),
) -> Result {
    let bundle = sender.bundles.iter().find(|bundle| bundle.light == light);
    let mean = bundle.map_or(Rgb::BLACK, |bundle| bundle.mean);
    let color = color(document, mean);
    write!(f, "<details class=L><summary {color}>L ")?;
    if let Some(bundle) = bundle {
        let (lit, blocked) = (bundle.lit, bundle.blocked);
        let samples = counted(bundle.samples.into(), "sample");
        write!(
            f,
            "to {}: {lit} of {samples} lit, {blocked} blocked, mean {}",
            escape(light),
            rgb(mean)
        )?;
    }
    let throughput = sender.throughput.unwrap_or(Rgb::WHITE);
    let fraction = document.fraction(sample, throughput * mean);
    writeln!(f, ", {}</summary>", share(fraction))
}

fn terms<'a>(sender: &'a RayNode, light: &str) -> HashMap<u32, Vec<&'a TermValue>> {
    let mut by_sample: HashMap<u32, Vec<&TermValue>> = HashMap::new();
    for term in &sender.terms {
        if let (Some(sample), true) = (term.sample, term.light.as_deref() == Some(light)) {
            by_sample.entry(sample).or_default().push(term);
        }
    }
    by_sample
}
