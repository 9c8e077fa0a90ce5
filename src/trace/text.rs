//! The ray tree as text: a line a ray, with its terms and absences below it.

use std::fmt;

use super::format::{num, rgb, vec3};
use super::tree::Outcome;
use super::{LightEstimate, View};
use crate::probe::{Event, NONE, RayKind};

/// A recorded pixel, written as text by `Display`.
pub struct Text<'a>(pub View<'a>);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let view = self.0;
        let (trace, settings) = (view.trace, view.settings);
        let [r, g, b] = (trace.pixel.color * settings.image.exposure).to_srgb8();
        writeln!(
            f,
            "{}, pixel ({}, {}) of {} x {}: {} = sRGB ({r}, {g}, {b}), {} rays",
            view.world.scene.name,
            trace.x,
            trace.y,
            settings.image.width,
            settings.image.height,
            rgb(trace.pixel.color),
            trace.pixel.rays,
        )?;
        if trace.pixel.error.is_finite() {
            let error = num(trace.pixel.error);
            writeln!(f, "standard error of its luminance, estimated: {error}")?;
        }
        for sample in &trace.tree.samples {
            if trace.tree.samples.len() > 1 {
                writeln!(f, "sample {}, weight {}", sample.index, num(sample.weight))?;
            }
            if let Some(root) = sample.root {
                subtree(f, view, root)?;
            }
        }
        if trace.tree.dropped > 0 {
            writeln!(
                f,
                "... the log is full: {} more events were not kept",
                trace.tree.dropped
            )?;
        }
        Ok(())
    }
}

/// A node and all that hangs on it, with guide lines. Without recursion: trees may be deep.
fn subtree(f: &mut fmt::Formatter, view: View, root: u32) -> fmt::Result {
    let tree = &view.trace.tree;
    // The nodes still to be written, with the guides of their line and of the lines below.
    let mut open = vec![(root, String::new(), String::new())];
    while let Some((id, first, rest)) = open.pop() {
        writeln!(f, "{first}{}", summary(view, id))?;
        let children: Vec<u32> = tree.children(id).collect();
        let bar = if children.is_empty() { "   " } else { "│  " };
        for (_, event) in tree.own_events(id) {
            if let Some(line) = detail(view, event) {
                writeln!(f, "{rest}{bar}{line}")?;
            }
        }
        for bundle in view.light_estimates(id) {
            writeln!(f, "{rest}{bar}{}", bundle_line(view, &bundle))?;
        }
        for (i, child) in children.iter().enumerate().rev() {
            let last = i + 1 == children.len();
            let (corner, below) = if last {
                ("└─ ", "   ")
            } else {
                ("├─ ", "│  ")
            };
            open.push((*child, format!("{rest}{corner}"), format!("{rest}{below}")));
        }
    }
    Ok(())
}

/// One line for a ray: kind, end, and what it brings.
pub fn summary(view: View, id: u32) -> String {
    let node = view.trace.tree.node(id);
    let letter = node.ray.kind.letter();
    let end = match node.outcome {
        Some(Outcome::Hit(hit)) => {
            let object = &view.world.scene.object_of(hit.primitive).name;
            format!("{object} at t = {}", num(hit.t))
        }
        Some(Outcome::Miss) => "miss".to_owned(),
        Some(Outcome::Lit) => "lit".to_owned(),
        Some(Outcome::Blocked(hit)) => {
            let object = &view.world.scene.object_of(hit.primitive).name;
            format!("blocked by {object} at t = {}", num(hit.t))
        }
        None => "not finished".to_owned(),
    };
    if node.ray.kind == RayKind::Light {
        return format!("{letter} to {}: {end}", view.light_name(node.ray.light));
    }
    format!(
        "{letter} {end}, radiance {}, weight {}, {:.1} % of the pixel",
        rgb(node.radiance),
        rgb(node.ray.weight),
        view.fraction(id) * 100.0
    )
}

/// One line for the shadow rays to an area light.
pub fn bundle_line(view: View, bundle: &LightEstimate) -> String {
    let error = bundle
        .standard_error
        .map_or(String::new(), |error| format!(" +- {}", num(error)));
    format!(
        "+ {} {}{error}: {} of {} samples lit, {} blocked",
        view.light_name(bundle.light),
        rgb(bundle.mean),
        bundle.lit,
        view.settings.rays_to_area(),
        bundle.blocked
    )
}

/// The line of an event that deserves one.
fn detail(view: View, event: &Event) -> Option<String> {
    let light = |light: u32| {
        if light == NONE {
            String::new()
        } else {
            format!(" {}", view.light_name(light))
        }
    };
    match *event {
        Event::Ray(sent) if sent.kind != RayKind::Light => Some(format!(
            "from {} along {}",
            vec3(sent.origin),
            vec3(sent.direction)
        )),
        Event::Term { light, .. } if view.is_area(light) => None,
        Event::Term {
            term,
            light: id,
            value,
            ..
        } => Some(format!("+ {}{} {}", term.name(), light(id), rgb(value))),
        Event::Absent {
            kind,
            light: id,
            reason,
        } => Some(format!(
            "no {}{}: {}",
            kind.letter(),
            light(id),
            reason.name()
        )),
        Event::Passed { hit, medium } => Some(format!(
            "straight through the surface of {} at t = {}, inside {}",
            view.world.scene.object_of(hit.primitive).name,
            num(hit.t),
            view.world.scene.medium_name(medium)
        )),
        Event::Boundary {
            n1,
            n2,
            reflectance,
        } => Some(format!(
            "boundary from index {} to {}, reflectance {}",
            num(n1),
            num(n2),
            num(reflectance)
        )),
        _ => None,
    }
}
