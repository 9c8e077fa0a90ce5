//! A ray on the page: its line, and below it where it goes, what it meets, and the light that it brings.

use std::fmt::{Formatter, Result};

use super::{equation, missing};
use crate::math::Rgb;
use crate::probe::RayKind;
use crate::scene::limits::MAX_PAGE_STEPS;
use crate::trace::document::{Document, RayInTree, RayNode, RayOutcome, SampleTree, TermValue};
use crate::trace::export::phrases;
use crate::trace::export::tree_layout::hex;
use crate::trace::export::xml::escape;
use crate::trace::format::{counted, num, percent, rgb, triple};

/// A ray, and what stands around it.
pub struct RayOnPage<'a> {
    /// The whole pixel.
    pub document: &'a Document,
    /// The sample.
    pub sample: &'a SampleTree,
    /// The ray.
    pub ray: RayInTree<'a>,
    /// The ray whose hit sent it.
    pub sender: Option<&'a RayNode>,
}

impl RayOnPage<'_> {
    /// Opens an I, R or T ray: its line and its numbers. The rays that its hit sent follow, then its end tag.
    pub fn open(&self, f: &mut Formatter) -> Result {
        let node = self.ray.node;
        let open = if self.ray.level == 0 && self.is_first() {
            " open"
        } else {
            ""
        };
        let letter = node.kind.letter();
        writeln!(
            f,
            "<details id=r{} class={letter}{open}><summary {}>{letter} {}, {}</summary>",
            node.id,
            color(self.document, node.radiance.unwrap_or_default()),
            escape(&end(node)),
            self.share()
        )?;
        write!(
            f,
            "<p>{}\nweight {}, throughput {}",
            self.way(),
            rgb(node.weight.unwrap_or_default()),
            rgb(node.throughput.unwrap_or_default())
        )?;
        let passed = node.passed.iter().map(phrases::passed);
        let hit = node.hit.iter().map(|hit| phrases::hit(hit));
        let boundary = node.boundary.iter().map(|b| phrases::boundary(b));
        for line in passed.chain(hit).chain(boundary) {
            write!(f, "\n{}", escape(&line))?;
        }
        f.write_str("\n")?;
        equation::equation(f, node)?;
        missing::rays(f, self.document, node)?;
        steps(f, node)
    }

    /// An L ray, as a paragraph; of a ray to an area light the terms of its sample as well.
    pub fn to_light(&self, f: &mut Formatter, terms: &[&TermValue]) -> Result {
        let node = self.ray.node;
        let to = match node.sample {
            Some(sample) => sample.to_string(),
            None => format!("to {}", node.light.as_deref().unwrap_or_default()),
        };
        let away = node
            .t_max
            .map_or(String::new(), |t| format!(", {} away", num(t)));
        write!(
            f,
            "<p id=r{} class=L>L {}: {}, {}\n{}{away}",
            node.id,
            escape(&to),
            escape(&end(node)),
            self.share(),
            self.way(),
        )?;
        if let Some(hit) = &node.hit {
            write!(f, "\n{}", escape(&phrases::hit(hit)))?;
        }
        for term in terms {
            write!(f, "\n{} {}", term.term.name(), equation::product(term))?;
        }
        f.write_str("\n")?;
        steps(f, node)
    }

    /// Whether its sample is the first one.
    fn is_first(&self) -> bool {
        let first = self.document.samples.first();
        first.is_some_and(|first| first.index == self.sample.index)
    }

    /// Its origin and direction. An origin that is written as the hit point that it was sent from is not written again.
    fn way(&self) -> String {
        let (origin, direction) = (
            triple(self.ray.node.origin),
            triple(self.ray.node.direction),
        );
        let hit = self.sender.and_then(|sender| sender.hit.as_ref());
        match hit {
            Some(hit) if triple(hit.point) == origin => format!("along {direction}"),
            _ => format!("from {origin} along {direction}"),
        }
    }

    /// Its part of the pixel's brightness.
    fn share(&self) -> String {
        share(self.document.fraction(self.sample, self.ray.contribution))
    }
}

/// A part of the pixel's brightness, 0 to 1.
pub fn share(fraction: f64) -> String {
    percent(fraction)
}

/// The attribute of a line that ends in a square of the colour which a screen shows for a radiance.
pub fn color(document: &Document, radiance: Rgb) -> String {
    let color = (radiance * document.settings.exposure).to_srgb8();
    format!("style=--c:{}", hex(color))
}

/// How a ray ended.
fn end(node: &RayNode) -> String {
    let blocked = match node.outcome {
        Some(RayOutcome::Blocked) => "blocked by ",
        _ => "",
    };
    match (&node.hit, node.outcome) {
        (Some(hit), _) => format!("{blocked}{}, t = {}", hit.object, num(hit.t)),
        (None, Some(RayOutcome::Lit)) => "lit".to_owned(),
        (None, Some(_)) if node.kind == RayKind::Light => "blocked".to_owned(),
        (None, Some(_)) => "miss".to_owned(),
        (None, None) => "not finished".to_owned(),
    }
}

/// The ray's steps through the acceleration structure, folded.
fn steps(f: &mut Formatter, node: &RayNode) -> Result {
    let count = node.traversal.len();
    if count == 0 {
        return Ok(());
    }
    write!(
        f,
        "<details><summary>{} through the accelerator</summary><ol>",
        counted(count as u64, "step")
    )?;
    for step in node.traversal.iter().take(MAX_PAGE_STEPS) {
        write!(f, "\n<li>{}", escape(&phrases::step(step)))?;
    }
    f.write_str("</ol>")?;
    if count > MAX_PAGE_STEPS {
        write!(f, "<p>steps that are not shown: {}", count - MAX_PAGE_STEPS)?;
    }
    f.write_str("</details>\n")
}
