//! Rays that were not sent: a line where they would have started, with the number that decided; and the reasons in sentences.

use std::fmt::{Formatter, Result};

use crate::probe::AbsenceReason;
use crate::trace::document::{AbsentRay, Document, RayNode, SampleTree};
use crate::trace::export::xml::escape;
use crate::trace::format::{degrees, num};

/// Rays of one kind to one light that were not sent for one reason.
struct MissingRays<'a> {
    /// The first of them.
    first: &'a AbsentRay,
    /// How many.
    count: usize,
    /// The least and the greatest number that decided.
    range: Option<[f64; 2]>,
}

/// The rays that a hit did not send; those to an area light together.
pub fn rays(f: &mut Formatter, document: &Document, node: &RayNode) -> Result {
    if node.absent.is_empty() {
        return Ok(());
    }
    let lines = together(&node.absent);
    let lines = lines.iter().map(|missing| line(document, node, missing));
    let lines: Vec<String> = lines.collect();
    writeln!(f, "<p class=a>{}", escape_lines(&lines))
}

fn escape_lines(lines: &[String]) -> String {
    let lines: Vec<String> = lines.iter().map(|line| escape(line)).collect();
    lines.join("\n")
}

/// Samples of an area light stand side by side: what differs from its neighbour in number alone is counted.
fn together(absent: &[AbsentRay]) -> Vec<MissingRays<'_>> {
    let mut all: Vec<MissingRays> = Vec::new();
    for ray in absent {
        let number = number(ray);
        match all.last_mut() {
            Some(last) if is_alike(last.first, ray) => {
                last.count += 1;
                let ends = last.range.zip(number);
                last.range = ends.map(|([low, high], x)| [low.min(x), high.max(x)]);
            }
            _ => all.push(MissingRays {
                first: ray,
                count: 1,
                range: number.map(|x| [x, x]),
            }),
        }
    }
    all
}

fn is_alike(a: &AbsentRay, b: &AbsentRay) -> bool {
    a.light.is_some() && (a.kind, a.reason, &a.light) == (b.kind, b.reason, &b.light)
}

/// The number that decided.
fn number(ray: &AbsentRay) -> Option<f64> {
    let numbers = [ray.k, ray.n_dot_l, ray.n_dot_r, ray.cos_angle, ray.weight];
    numbers.into_iter().flatten().next()
}

fn line(document: &Document, node: &RayNode, missing: &MissingRays) -> String {
    let ray = missing.first;
    let light = ray.light.as_ref();
    let to = light.map_or(String::new(), |light| format!(" to {light}"));
    let times = match missing.count {
        1 => String::new(),
        count => format!(" ({count} samples)"),
    };
    let number = match missing.range {
        Some([low, high]) if low < high => format!("{} to {}", num(low), num(high)),
        Some([x, _]) => num(x),
        None => String::new(),
    };
    let reason = reason(document, node, missing, &number);
    format!("no {}{to}{times}: {reason}", ray.kind.letter())
}

/// Why, in a few words, with the number that decided.
fn reason(document: &Document, node: &RayNode, missing: &MissingRays, number: &str) -> String {
    let settings = &document.settings;
    match missing.first.reason {
        AbsenceReason::TotalInternalReflection => {
            format!("total internal reflection, 1 - (n1/n2)² sin² = {number}")
        }
        AbsenceReason::NoReflection => "reflects nothing".to_owned(),
        AbsenceReason::NoTransmission => "lets nothing through".to_owned(),
        AbsenceReason::NoLocalLight => "Kd = Ks = 0".to_owned(),
        AbsenceReason::FacingAway => format!("behind the surface, N·L {number}"),
        AbsenceReason::OutsideCone => {
            let angles = missing.range.map(|ends| ends.map(degrees));
            let angle = match angles {
                Some([far, near]) if far != near => format!("{near} to {far}"),
                Some([far, _]) => far,
                None => String::new(),
            };
            format!("outside the cone, {angle} from its axis")
        }
        AbsenceReason::BelowSurface => format!("through the surface that it leaves, N·R {number}"),
        AbsenceReason::MinWeight => {
            let least = num(settings.min_weight);
            format!("too weak, {number} < {least}")
        }
        AbsenceReason::DepthLimit => format!("depth {} of {}", node.depth, settings.depth),
        AbsenceReason::EffectOff => "switched off".to_owned(),
        AbsenceReason::RayBudget => {
            let pixels = u64::from(document.image.width) * u64::from(document.image.height);
            let rays = (settings.max_rays / pixels.max(1)).max(1);
            format!("the pixel's {rays} rays are used up")
        }
    }
}

/// What the reasons mean: a sentence for each one that is on the page.
pub fn sentences(f: &mut Formatter, document: &Document) -> Result {
    let mut reasons: Vec<AbsenceReason> = Vec::new();
    for ray in document.samples.iter().flat_map(SampleTree::rays) {
        for absent in &ray.node.absent {
            if !reasons.contains(&absent.reason) {
                reasons.push(absent.reason);
            }
        }
    }
    if reasons.is_empty() {
        return Ok(());
    }
    f.write_str("<h2>Why rays were not sent</h2>\n<dl>\n")?;
    for reason in reasons {
        writeln!(f, "<dt>{}<dd>{}", reason.words(), reason.sentence())?;
    }
    f.write_str("</dl>\n")
}
