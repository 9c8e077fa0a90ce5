//! Surfaces: where a ray hits one, goes straight through one, or meets the boundary of a medium.

use super::{Explanation, end, fresnel};
use crate::geometry::{Hit, Offset};
use crate::math::{DVec3, Ray};
use crate::probe::NONE;
use crate::scene::ObjectFrame;
use crate::shading::{ShadingModel, Side};
use crate::trace::format::{degrees, num, vec3};
use crate::trace::{SurfaceHit, View};

/// The point as the sum that it is. What is off the shape by rounding alone is put back onto it; where a law is broken, that may be
/// far.
fn with_point(explanation: Explanation, ray: &Ray, t: f64, point: DVec3) -> Explanation {
    let [origin, direction] = [ray.origin, ray.direction].map(vec3);
    let (sum, point) = (vec3(ray.at(t)), vec3(point));
    let put_back = (sum != point).then(|| format!("onto the shape: {point}"));
    explanation
        .row(
            "point",
            format!("o + t d = {origin} + {} {direction}", num(t)),
        )
        .row("", format!("= {sum}"))
        .row_if("put back", put_back.as_deref())
}

/// A ray hits a surface.
pub fn hit(view: View, node: u32) -> Explanation {
    let Some(surface) = view.surface_hit(node) else {
        return Explanation::new("hit", "The ray ends on a surface.");
    };
    let sent = &view.trace.tree.node(node).ray;
    let SurfaceHit {
        hit,
        at,
        object,
        primitive,
        shading,
        part,
        barycentric,
        gradient,
        material,
    } = surface;
    let kind = match barycentric {
        // A mesh that is kept once is met at one of them.
        Some(_) => "triangle",
        None => view.world.scene.shapes[hit.primitive as usize].kind(),
    };
    let side = match at.side {
        Side::Front => "from outside",
        Side::Back => "from inside",
    };
    let met = Explanation::new(
        format!("hit `{}`", object.name),
        format!(
            "The closest thing on the ray is the {kind} {primitive} of `{}`, met {side} after {} m.",
            object.name,
            num(hit.t)
        ),
    );
    let ray = Ray::new(sent.origin, sent.direction);
    let mut explanation = with_point(met, &ray, hit.t, at.point)
        .row(
            "error",
            match view.settings.arithmetic.offset {
                Offset::Bounded => format!("at most {} per axis", vec3(at.error)),
                other => format!("not asked for: the next ray's offset is {other}"),
            },
        )
        .row_if("part", part)
        .row("material", material.name.clone())
        .row_if("shading", shading.map(ShadingModel::word))
        .row("N", vec3(at.normal));
    if let Some(gradient) = gradient {
        let length = num(gradient.length());
        let told = format!("{}, of length {length}", vec3(gradient));
        explanation = explanation.row("gradient of F", told);
    }
    if at.normal != at.geometric_normal {
        explanation = explanation.row("N of the shape", vec3(at.geometric_normal));
    }
    if let Some([a, b, c]) = barycentric {
        explanation = explanation.row(
            "barycentric",
            format!("({}, {}, {})", num(a), num(b), num(c)),
        );
    }
    for frame in view.world.scene.frames_of(object) {
        explanation = in_frame(explanation, frame, &ray);
    }
    let explanation = explanation
        .row("uv", format!("({}, {})", num(at.uv.x), num(at.uv.y)))
        .row(
            "angle",
            format!("between N and V: {}", degrees(at.normal.dot(at.to_viewer))),
        );
    end::self_hit(view, node, explanation)
}

/// Rows about the frame of a group that an object stands in, and the ray as it is there.
fn in_frame(explanation: Explanation, frame: &ObjectFrame, ray: &Ray) -> Explanation {
    let placed = match frame.placed.as_str() {
        "" => "as it stands",
        placed => placed,
    };
    let there = frame.ray(ray);
    explanation
        .row("stands in", format!("`{}`, {placed}", frame.name))
        .row(
            "ray there",
            format!("{} + t {}", vec3(there.origin), vec3(there.direction)),
        )
}

/// A ray goes straight through a surface.
pub fn passed(view: View, node: u32, hit: &Hit, medium: u32) -> Explanation {
    let scene = &view.world.scene;
    let sent = &view.trace.tree.node(node).ray;
    let ray = Ray::new(sent.origin, sent.direction);
    let at = scene.interaction(&ray, hit);
    let object = scene.owners[hit.primitive as usize];
    let name = |object: u32| {
        let object = scene.objects.get(object as usize);
        object.map_or("air", |o| o.name.as_str())
    };
    let way = match at.side {
        Side::Front => "into",
        Side::Back => "out of",
    };
    let priority = |object: u32| format!("{} of `{}`", scene.medium_priority(object), name(object));
    let explanation = Explanation::new(
        format!("straight {way} `{}`", name(object)),
        format!(
            "Where objects overlap the highest priority decides, of equal ones the smaller object: `{}` before and behind.",
            name(medium)
        ),
    )
    .row("t", num(hit.t))
    .row("point", vec3(at.point));
    if medium == NONE {
        // Crossed together with another surface of the same object, at an edge.
        return explanation;
    }
    explanation.row(
        "priorities",
        format!("{}, {}", priority(object), priority(medium)),
    )
}

/// A transparent surface shares light between R and T.
pub fn boundary(view: View, node: u32, n1: f64, n2: f64, reflectance: f64) -> Explanation {
    let explanation = Explanation::new(
        "the boundary of a medium",
        "A transparent surface reflects a part of the light and lets the rest through; the part grows with the angle.",
    )
    .row("n1", format!("{} on this side", num(n1)))
    .row("n2", format!("{} on the other side", num(n2)))
    .row("F", format!("{}: the share that is reflected", num(reflectance)));
    let Some(SurfaceHit { at, material, .. }) = view.surface_hit(node) else {
        return explanation;
    };
    let [reflected, transmitted] = material.fresnel_weights(reflectance);
    let touching = view.touching(node);
    let explanation = if touching.is_empty() {
        explanation
    } else {
        explanation.row(
            "crossed as one with",
            format!("`{}`", touching.join("`, `")),
        )
    };
    let cosine = at.normal.dot(at.to_viewer);
    let explanation = explanation
        .row("angle", degrees(cosine))
        .row("critical angle", critical_angle(n1, n2));
    fresnel::formula(view.settings.fresnel, cosine, (n1, n2), explanation)
        .color("Wr = Kr + F Kt", reflected)
        .color("Wt = (1 - F) Kt", transmitted)
}

fn critical_angle(n1: f64, n2: f64) -> String {
    if n1 > n2 {
        format!(
            "asin(n2 / n1) = {:.2} degrees",
            libm::asin(n2 / n1).to_degrees()
        )
    } else {
        "none: the other side is denser".to_owned()
    }
}
