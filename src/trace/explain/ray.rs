//! Rays: where they come from, and why they are sent.

use super::{Explanation, UNKNOWN};
use crate::probe::{Event, RayKind, RayRecord};
use crate::trace::format::{degrees, num, vec3};
use crate::trace::{SurfaceHit, View};

/// A sample of the pixel begins.
pub fn sample(view: View, index: u32, [x, y]: [f64; 2], weight: f64) -> Explanation {
    let camera = &view.world.scene.camera;
    let (width, height) = view.settings.size();
    let (w, h) = (f64::from(width), f64::from(height));
    let tan = camera.half_height;
    let pilot = if index < view.settings.pixel.pilot() {
        " It only decides how many other samples there are, and does not count."
    } else if view.settings.pixel.asks_around() {
        " How many samples there are was decided by the first ones of the pixels around."
    } else {
        ""
    };
    let is_whole = view.trace.is_whole();
    let samples = if is_whole {
        view.trace.pixel.samples.to_string()
    } else {
        UNKNOWN.to_owned()
    };
    // While the direction of the eye ray is asked for, near the middle of the picture these numbers would be it.
    let mut sent = view.trace.tree.samples.iter();
    let is_sent = sent.any(|sample| sample.index == index && sample.root.is_some());
    let told = |x: f64| {
        if is_whole || is_sent {
            num(x)
        } else {
            UNKNOWN.to_owned()
        }
    };
    Explanation::new(
        format!("sample {} of {samples}", index + 1),
        format!(
            "The film point ({}, {}) of the {width} x {height} picture decides where the eye ray goes.{pilot}",
            num(x),
            num(y)
        ),
    )
    .row(
        "right",
        format!(
            "(2x/width - 1) tan(fov/2) width/height = {}",
            told((2.0 * x / w - 1.0) * tan * w / h)
        ),
    )
    .row(
        "up",
        format!("(1 - 2y/height) tan(fov/2) = {}", told((1.0 - 2.0 * y / h) * tan)),
    )
    .row("u", vec3(camera.frame.u))
    .row("v", vec3(camera.frame.v))
    .row("w", vec3(camera.frame.w))
    .row("I", "normalize(right u + up v - w)")
    .row("weight", num(weight))
}

/// A ray sets out.
pub fn sent(view: View, node: u32, sent: &RayRecord) -> Explanation {
    let scene = &view.world.scene;
    let base = match sent.kind {
        RayKind::Incident => Explanation::new(
            "I: a ray from the eye",
            "The picture is made backwards: this ray asks what light comes to the eye from here.",
        ),
        RayKind::Light => to_light(view, node, sent),
        RayKind::Reflected => reflected(view, node),
        RayKind::Transmitted => transmitted(view, node, sent),
    };
    let base = base
        .row("origin", vec3(sent.origin))
        .row("direction", vec3(sent.direction))
        .row(
            "medium",
            format!(
                "{} (index {})",
                scene.medium_name(sent.medium),
                num(scene.medium_ior(sent.medium))
            ),
        );
    if sent.kind == RayKind::Light {
        return base.row("t_max", num(sent.t_max));
    }
    base.color("weight", sent.weight)
        .color("throughput", view.trace.tree.node(node).throughput)
}

fn to_light(view: View, node: u32, sent: &RayRecord) -> Explanation {
    let light = view.light_name(sent.light);
    Explanation::new(
        format!("L: a shadow ray to `{light}`"),
        format!("Does anything stand between the hit point and `{light}`?"),
    )
    .row(
        "depth",
        format!(
            "{}, seen from ray {}",
            sent.depth,
            view.trace.tree.node(node).parent.map_or(0, |p| p)
        ),
    )
}

fn reflected(view: View, node: u32) -> Explanation {
    let explanation = Explanation::new(
        "R: the reflected ray",
        "A mirror shows what a ray sees that leaves at the same angle on the other side of the normal.",
    );
    let Some(surface) = parent_hit(view, node) else {
        return explanation;
    };
    let (i, n) = (-surface.at.to_viewer, surface.at.normal);
    explanation
        .row("I", vec3(i))
        .row("N", vec3(n))
        .row("N.I", num(n.dot(i)))
        .row(
            "R",
            format!(
                "I - 2 (N.I) N = {} + {} {}",
                vec3(i),
                num(-2.0 * n.dot(i)),
                vec3(n)
            ),
        )
}

fn transmitted(view: View, node: u32, sent: &RayRecord) -> Explanation {
    let explanation = Explanation::new(
        "T: the transmitted ray",
        "Light bends where its speed changes: towards the normal into the denser medium, away from it on the way out.",
    );
    let Some(surface) = parent_hit(view, node) else {
        return explanation;
    };
    let Some((n1, n2)) = parent_boundary(view, node) else {
        return explanation;
    };
    let (i, n) = (-surface.at.to_viewer, surface.at.normal);
    let (eta, c) = (n1 / n2, -n.dot(i));
    let k = 1.0 - eta * eta * (1.0 - c * c);
    explanation
        .row("I", vec3(i))
        .row("N", vec3(n))
        .row(
            "eta",
            format!("n1 / n2 = {} / {} = {}", num(n1), num(n2), num(eta)),
        )
        .row("cos I", format!("-N.I = {} ({})", num(c), degrees(c)))
        .row("k", format!("1 - eta^2 (1 - cos^2) = {}", num(k)))
        .row(
            "T",
            format!(
                "eta I + (eta cos - sqrt(k)) N = {} {} + {} {} = {}",
                num(eta),
                vec3(i),
                num(eta * c - k.max(0.0).sqrt()),
                vec3(n),
                vec3(sent.direction)
            ),
        )
        .row(
            "angle",
            format!("{} from -N", degrees(-n.dot(sent.direction))),
        )
}

fn parent_hit(view: View<'_>, node: u32) -> Option<SurfaceHit<'_>> {
    view.surface_hit(view.trace.tree.node(node).parent?)
}

/// The indices of refraction at the surface that sent a ray.
fn parent_boundary(view: View, node: u32) -> Option<(f64, f64)> {
    let tree = &view.trace.tree;
    let parent = tree.node(node).parent?;
    tree.own_events(parent).find_map(|(_, event)| match event {
        Event::Boundary { n1, n2, .. } => Some((*n1, *n2)),
        _ => None,
    })
}
