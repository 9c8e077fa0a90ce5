//! The ray tree as text: a line a ray, with its terms and absences below it.

use std::collections::HashMap;
use std::fmt;

use super::phrases;
use crate::probe::RayKind;
use crate::scene::printable::printable;
use crate::trace::document::{Document, LightSummary, RayInTree, RayNode, RayOutcome, SampleTree};
use crate::trace::format::{counted, num, percent, rgb, triple};

/// A document written as text by `Display`.
pub struct Text<'a>(pub &'a Document);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let document = self.0;
        let [r, g, b] = document.color.srgb8;
        writeln!(
            f,
            "{}: {} = sRGB ({r}, {g}, {b}), {}",
            printable(&super::heading(document)),
            rgb(document.color.linear),
            counted(document.rays, "ray"),
        )?;
        if let Some(cut) = document.cut {
            let (depth, weight, share) = (cut.depth, cut.weight, num(100.0 * cut.share));
            writeln!(
                f,
                "rays left out: {depth} by depth, {weight} by weight, with up to {share} % of its light"
            )?;
        }
        if let Some(error) = document.standard_error {
            let error = num(error);
            writeln!(f, "standard error of its luminance, estimated: {error}")?;
        }
        let lights: Lights = (1..)
            .zip(&document.scene.lights)
            .map(|(i, l)| (l.as_str(), i))
            .collect();
        for sample in &document.samples {
            if document.samples.len() > 1 {
                writeln!(f, "sample {}, weight {}", sample.index, num(sample.weight))?;
            }
            tree(f, document, sample, &lights)?;
        }
        if let Some(dropped) = document.truncated {
            writeln!(
                f,
                "... the log is full; events that were not kept: {dropped}"
            )?;
        }
        Ok(())
    }
}

/// The scene's lights by name, numbered from 1 in the order in which a hit asks them.
type Lights<'a> = HashMap<&'a str, usize>;

/// The tree of a sample, with guide lines.
fn tree(
    f: &mut fmt::Formatter,
    document: &Document,
    sample: &SampleTree,
    lights: &Lights,
) -> fmt::Result {
    // The guides of the lines below a ray's, level by level.
    let mut guides: Vec<&str> = Vec::new();
    for ray in sample.rays() {
        guides.truncate(ray.level.saturating_sub(1));
        write!(f, "{}", guides.concat())?;
        if ray.level > 0 {
            f.write_str(if ray.is_last { "└─ " } else { "├─ " })?;
            guides.push(if ray.is_last { "   " } else { "│  " });
        }
        writeln!(f, "{}", printable(&summary(document, sample, &ray)))?;
        let bar = if ray.node.children.is_empty() {
            "   "
        } else {
            "│  "
        };
        let rest = guides.concat();
        for line in details(ray.node, lights) {
            writeln!(f, "{rest}{bar}{}", printable(&line))?;
        }
    }
    Ok(())
}

/// One line for a ray: kind, end, and what it brings.
fn summary(document: &Document, sample: &SampleTree, ray: &RayInTree) -> String {
    let node = ray.node;
    let letter = node.kind.letter();
    let blocked = match node.outcome {
        Some(RayOutcome::Blocked) => "blocked by ",
        _ => "",
    };
    let end = match (&node.hit, node.outcome) {
        (Some(hit), _) => format!("{blocked}{} at t = {}", hit.object, num(hit.t)),
        (None, Some(RayOutcome::Lit)) => "lit".to_owned(),
        (None, Some(_)) => "miss".to_owned(),
        (None, None) => "not finished".to_owned(),
    };
    if node.kind == RayKind::Light {
        let light = node.light.as_deref().unwrap_or_default();
        let away = node
            .t_max
            .map_or(String::new(), |t| format!(", {} away", num(t)));
        let along = triple(node.direction);
        return format!("{letter} to {light} along {along}{away}: {end}");
    }
    format!(
        "{letter} {end}, radiance {}, weight {}, {} of the pixel",
        rgb(node.radiance.unwrap_or_default()),
        rgb(node.weight.unwrap_or_default()),
        percent(document.fraction(sample, ray.contribution))
    )
}

/// The lines below a ray's, in the tracer's order: steps through the accelerator, passed surfaces, the hit, own terms, light by
/// light, the boundary, R and T.
fn details(node: &RayNode, lights: &Lights) -> Vec<String> {
    let mut lines = Vec::new();
    if node.kind != RayKind::Light {
        let (origin, direction) = (triple(node.origin), triple(node.direction));
        lines.push(format!("from {origin} along {direction}"));
    }
    lines.extend(node.traversal.iter().map(phrases::step));
    lines.extend(node.passed.iter().map(phrases::passed));
    if node.kind != RayKind::Light {
        lines.extend(
            node.hit
                .iter()
                .map(|hit| format!("hits {}", phrases::hit(hit))),
        );
    }
    let mut terms = Vec::new();
    let mut secondary = Vec::new();
    for absent in &node.absent {
        let (kind, reason) = (absent.kind.letter(), absent.reason.words());
        match &absent.light {
            Some(light) => terms.push((light.as_str(), format!("no {kind} {light}: {reason}"))),
            None => secondary.push(format!("no {kind}: {reason}")),
        }
    }
    // The terms of area lights are told in one line each, at the end.
    for term in node.terms.iter().filter(|term| term.sample.is_none()) {
        let light = term.light.as_deref().unwrap_or_default();
        let space = if light.is_empty() { "" } else { " " };
        let (name, value) = (term.term.name(), rgb(term.value));
        let blended = if term.corners.is_some() {
            " blended"
        } else {
            ""
        };
        terms.push((light, format!("+ {name}{space}{light}{blended} {value}")));
    }
    terms.sort_by_key(|(light, _)| lights.get(light));
    lines.extend(terms.into_iter().map(|(_, line)| line));
    lines.extend(
        node.boundary
            .iter()
            .map(|b| format!("boundary {}", phrases::boundary(b))),
    );
    lines.extend(secondary);
    lines.extend(node.bundles.iter().map(area_light));
    lines
}

/// One line for the shadow rays to an area light.
fn area_light(summary: &LightSummary) -> String {
    let error = summary
        .standard_error
        .map_or(String::new(), |error| format!(" +- {}", num(error)));
    format!(
        "+ {} {}{error}: {} of {} lit, {} blocked",
        summary.light,
        rgb(summary.mean),
        summary.lit,
        counted(summary.samples.into(), "sample"),
        summary.blocked
    )
}
