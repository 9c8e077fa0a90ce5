//! Surfaces: where a ray arrived, and the terms of the shading equation.

use super::{Explanation, ray};
use crate::geometry::{Hit, Offset};
use crate::math::{Ray, Rgb};
use crate::probe::{Absence, NONE, RayKind, Term};
use crate::shading::Side;
use crate::trace::format::{degrees, num, rgb, vec3};
use crate::trace::{Lighting, SurfaceHit, View};

/// A ray hits a surface.
pub fn hit(view: View, node: u32) -> Explanation {
    let Some(arrival) = view.surface_hit(node) else {
        return Explanation::new("hit", "The ray ends on a surface.");
    };
    let sent = &view.trace.tree.node(node).ray;
    let SurfaceHit {
        hit,
        at,
        object,
        primitive,
        material,
    } = arrival;
    let shape = &view.world.scene.shapes[hit.primitive as usize];
    let side = match at.side {
        Side::Front => "from outside",
        Side::Back => "from inside",
    };
    let mut explanation = Explanation::new(
        format!("hit `{}`", object.name),
        format!(
            "The closest thing on the ray is the {} {primitive} of `{}`, met {side} after {} m.",
            shape.kind(),
            object.name,
            num(hit.t)
        ),
    )
    .row(
        "point",
        format!(
            "o + t d = {} + {} {}",
            vec3(sent.origin),
            num(hit.t),
            vec3(sent.direction)
        ),
    )
    .row("", vec3(at.point))
    .row(
        "error",
        match view.settings.arithmetic.offset {
            Offset::Bounded => format!("at most {} per axis", vec3(at.error)),
            other => format!("not asked for: the next ray's offset is {other}"),
        },
    )
    .row("material", material.name.clone())
    .row("N", vec3(at.normal));
    if at.normal != at.geometric_normal {
        explanation = explanation.row("N of the shape", vec3(at.geometric_normal));
    }
    let [a, b, c] = hit.barycentric;
    if hit.barycentric != [0.0; 3] {
        explanation = explanation.row(
            "barycentric",
            format!("({}, {}, {})", num(a), num(b), num(c)),
        );
    }
    let explanation = explanation
        .row("uv", format!("({}, {})", num(at.uv.x), num(at.uv.y)))
        .row(
            "angle",
            format!("between N and V: {}", degrees(at.normal.dot(at.to_viewer))),
        );
    ray::self_hit(view, node, explanation)
}

/// A term of the shading equation.
pub fn term(view: View, node: u32, term: Term, light: (u32, u32), value: Rgb) -> Explanation {
    let explanation = base_term(view, node, term, light);
    let throughput = view.trace.tree.node(node).throughput;
    explanation.color(term.name(), value).row(
        "in the pixel",
        format!(
            "{} x {} = {}",
            rgb(throughput),
            rgb(value),
            rgb(throughput * value)
        ),
    )
}

fn base_term(view: View, node: u32, term: Term, light: (u32, u32)) -> Explanation {
    let mut name = view.light_name(light.0).to_owned();
    if view.is_area(light.0) {
        name = format!("{name}, sample {}", light.1);
    }
    let arrival = view.surface_hit(node);
    let lighting = view.lighting(node, light);
    match (term, arrival, lighting) {
        (Term::Ambient, Some(arrival), _) => Explanation::new(
            "ambient term",
            "Light that comes from everywhere is guessed by a constant, once a hit.",
        )
        .color("Ka", arrival.material.ambient_at(arrival.at.uv))
        .color("Ia", view.world.scene.ambient)
        .row("", "Ka Ia"),
        (Term::Diffuse, Some(_), Some(Lighting { light: seen, projected: Some(area), kd, .. })) => Explanation::new(
            format!("diffuse term of `{name}`"),
            "The place on the light was chosen in proportion to what it brings, so every sample brings the same: the whole light's share.",
        )
        .color("Kd", kd)
        .row("P", format!("{}, the light's projected solid angle", num(area)))
        .color("Le P / (pi samples)", seen.irradiance.unwrap_or(Rgb::BLACK))
        .row("", "Kd Le P / (pi samples)"),
        (Term::Diffuse, Some(arrival), Some(l)) => Explanation::new(
            format!("diffuse term of `{name}`"),
            "A matt surface is the brighter the straighter the light falls on it, seen from everywhere alike.",
        )
        .color("Kd", l.kd)
        .color("I", l.light.intensity)
        .row("N", vec3(arrival.at.normal))
        .row("L", vec3(l.light.direction))
        .row("N.L", format!("{} ({})", num(l.n_dot_l), degrees(l.n_dot_l)))
        .row("", "Kd I (N.L)"),
        (Term::Specular, Some(arrival), Some(l)) => Explanation::new(
            format!("specular term of `{name}`"),
            "The highlight: how near the mirrored light comes to the viewer, sharpened by the exponent.",
        )
        .color("Ks", arrival.material.specular)
        .color("I", l.light.intensity)
        .row("R.V", format!("{} ({})", num(l.r_dot_v), degrees(l.r_dot_v)))
        .row("n", num(arrival.material.shininess))
        .row(
            "(R.V)^n",
            num(libm::pow(l.r_dot_v.max(0.0), arrival.material.shininess)),
        )
        .row("", "Ks I (R.V)^n"),
        (Term::Emission, ..) => {
            Explanation::new("emission", "The surface shines by itself.")
        }
        (Term::Background, ..) => {
            Explanation::new("background", "Behind everything stands this colour.")
        }
        _ => Explanation::new(format!("{} term", term.name()), "A term of the shading equation."),
    }
}

/// Many rays to an area light.
pub fn bundle(view: View, node: u32, light: u32) -> Explanation {
    let name = view.light_name(light);
    let n = view.settings.rays_to_area();
    let bundle = view.light_estimate(node, light);
    let explanation = Explanation::new(
        format!("{n} rays to `{name}`"),
        "How much of the light can be seen from here is guessed from places on it: the more, the nearer to the truth.",
    )
    .row("", "Kd/pi integral of Le V cos cos' / r^2 over the light's area")
    .row(
        "samples",
        format!("{n}, chosen by the sampler `{}`", view.settings.light.sampler.name()),
    )
    .row("lit", format!("{} of {n}", bundle.lit))
    .row("chosen", in_proportion_to(view, node, light))
    .row("blocked", bundle.blocked.to_string())
    .row("not sent", format!("{}: no light comes from there", bundle.absent))
    .color("mean", bundle.mean);
    let Some(error) = bundle.standard_error else {
        return explanation;
    };
    let mean = bundle.mean.luminance();
    let part = if mean > 0.0 { error / mean } else { 0.0 };
    explanation
        .row(
            "standard error",
            format!(
                "{} of {} ({:.1} %), in luminance",
                num(error),
                num(mean),
                part * 100.0
            ),
        )
        .row(
            "half the error",
            format!("{} rays, if they are chosen at random", 4 * u64::from(n)),
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
            "Where objects overlap the highest priority decides, of equal ones the innermost: `{}` before and behind.",
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

/// How places on a light are chosen at the hit of a node.
fn in_proportion_to(view: View, node: u32, light: u32) -> String {
    match view.projected(node, light) {
        Some(area) => format!(
            "by what they bring: all the same, with a projected solid angle P = {}",
            num(area)
        ),
        None => "by the light's area".to_owned(),
    }
}

/// A transparent surface shares light between R and T.
pub fn boundary(view: View, node: u32, n1: f64, n2: f64, reflectance: f64) -> Explanation {
    let explanation = Explanation::new(
        "the boundary of a medium",
        "A transparent surface reflects a part of the light and lets the rest through; the part grows with the angle.",
    )
    .row("n1", format!("{} on this side", num(n1)))
    .row("n2", format!("{} on the other side", num(n2)))
    .row(
        "F",
        format!("{} by the model `{:?}`", num(reflectance), view.settings.fresnel).to_lowercase(),
    );
    let Some(SurfaceHit { at, material, .. }) = view.surface_hit(node) else {
        return explanation;
    };
    let (kr, kt) = (material.mirror, material.transmission);
    let touching = view.touching(node);
    let explanation = if touching.is_empty() {
        explanation
    } else {
        explanation.row(
            "crossed as one with",
            format!("`{}`", touching.join("`, `")),
        )
    };
    explanation
        .row("angle", degrees(at.normal.dot(at.to_viewer)))
        .row("critical angle", critical_angle(n1, n2))
        .color("Wr = Kr + F Kt", kr + kt * reflectance)
        .color("Wt = (1 - F) Kt", kt * (1.0 - reflectance))
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

/// A ray is not sent.
pub fn absent(view: View, node: u32, kind: RayKind, light: u32, reason: Absence) -> Explanation {
    let name = view.light_name(light);
    let what = match kind {
        RayKind::Light => format!("no L ray to `{name}`"),
        _ => format!("no {} ray", kind.letter()),
    };
    let settings = view.settings;
    let depth = view.trace.tree.node(node).ray.depth;
    let (why, name, text) = match reason {
        Absence::TotalInternalReflection { k } => (
            "The ray meets the boundary too flat: Snell's law has no answer, and all light is reflected.",
            "k",
            format!("1 - (n1/n2)^2 sin^2 = {} < 0", num(k)),
        ),
        Absence::NoReflection => (
            "The material reflects nothing.",
            "Wr",
            "(0, 0, 0)".to_owned(),
        ),
        Absence::NoTransmission => (
            "Nothing passes through the material.",
            "Wt",
            "(0, 0, 0)".to_owned(),
        ),
        Absence::NoLocalLight => (
            "The material has neither a diffuse nor a specular coefficient, so lights do not matter.",
            "Kd, Ks",
            "(0, 0, 0)".to_owned(),
        ),
        Absence::FacingAway { n_dot_l } => (
            "The light is behind the surface, which shades itself.",
            "N.L",
            format!("{} <= 0", num(n_dot_l)),
        ),
        Absence::OutsideCone { cos_angle } => (
            "The point lies outside the cone of the spot light.",
            "angle",
            format!("{} from the axis", degrees(cos_angle)),
        ),
        Absence::BelowSurface { n_dot_r } => (
            "The blended normal leans so far that the ray would run through the surface it leaves.",
            "N.R",
            num(n_dot_r),
        ),
        Absence::MinWeight { weight } => (
            "Whatever it would bring back could not be seen in the pixel.",
            "weight",
            format!(
                "{} < {}, the threshold",
                num(weight),
                num(settings.recursion.min_weight)
            ),
        ),
        Absence::DepthLimit => (
            "The depth limit ends the recursion here: what it would bring back is missing in the pixel.",
            "depth",
            format!("{depth} of {}", settings.recursion.depth),
        ),
        Absence::EffectOff => (
            "This effect was switched off: the picture is not that of the whole scene.",
            "effect",
            "off".to_owned(),
        ),
        Absence::RayBudget => (
            "The pixel has used up its share of the ray budget: the picture is cut short here.",
            "rays a pixel",
            settings.rays_per_pixel().to_string(),
        ),
    };
    Explanation::new(what, why).row(name, text)
}
