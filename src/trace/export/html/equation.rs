//! The shading equation of a hit with its numbers: each summand as a product of its factors, and what they add up to.

use std::fmt::{Formatter, Result};

use crate::probe::RayKind;
use crate::trace::document::{CornerValue, LightSummary, RayNode, TermValue};
use crate::trace::export::xml::escape;
use crate::trace::format::{counted, num, rgb};

/// The equation of a ray's radiance: a line a summand, in the tracer's order but for area lights, each of which is one line.
pub fn equation(f: &mut Formatter, node: &RayNode) -> Result {
    let Some(radiance) = node.radiance else {
        return Ok(());
    };
    write!(f, "<p class=e>radiance {}", rgb(radiance))?;
    let mut sign = '=';
    let terms = node.terms.iter().filter(|term| term.sample.is_none());
    let terms = terms.map(|term| {
        let light = term.light.as_deref().unwrap_or_default();
        let space = if light.is_empty() { "" } else { " " };
        let name = term.term.name();
        format!("{name}{space}{} {}", escape(light), product(term))
    });
    let children = node
        .children
        .iter()
        .filter(|ray| ray.kind != RayKind::Light);
    let children = children.filter_map(|ray| {
        let (weight, radiance) = ray.weight.zip(ray.radiance)?;
        let (letter, product) = (ray.kind.letter(), rgb(weight * radiance));
        let (weight, radiance) = (rgb(weight), rgb(radiance));
        Some(format!(
            "{letter}: weight {weight} × radiance {radiance} = {product}"
        ))
    });
    let summands = terms.chain(node.bundles.iter().map(mean)).chain(children);
    for summand in summands {
        write!(f, "\n{sign} {summand}")?;
        sign = '+';
    }
    if sign == '=' {
        f.write_str(", nothing is added")?;
    }
    f.write_str("\n")
}

/// A term as the product of its factors.
pub fn product(term: &TermValue) -> String {
    let factors = &term.factors;
    let value = rgb(term.value);
    if let Some(corners) = &term.corners {
        let share =
            |corner: &CornerValue| format!("{} × {}", num(corner.weight), rgb(corner.value));
        let shares = corners.each_ref().map(share);
        return format!(
            "blended between the corners: {} = {value}",
            shares.join(" + ")
        );
    }
    let colors = [
        ("Ka", factors.ka),
        ("Ia", factors.ambient_light),
        ("Kd", factors.kd),
        ("Ks", factors.ks),
        ("I", factors.intensity),
    ];
    let colors = colors.into_iter();
    let colors = colors.filter_map(|(name, color)| Some(format!("{name} {}", rgb(color?))));
    let mut all: Vec<String> = colors.collect();
    all.extend(factors.n_dot_l.map(|x| format!("N·L {}", num(x))));
    all.extend(factors.r_dot_v.map(|x| {
        let exponent = factors.shininess.map_or(String::new(), num);
        format!("(R·V {})^{exponent}", num(x))
    }));
    if all.is_empty() {
        return value;
    }
    let light = factors.projected_solid_angle;
    let light = light.map_or(String::new(), |x| {
        format!(" with P {} of the light", num(x))
    });
    format!("{}{light} = {value}", all.join(" × "))
}

/// What an area light adds, in one line.
fn mean(bundle: &LightSummary) -> String {
    let error = bundle
        .standard_error
        .map_or(String::new(), |error| format!(" ± {}", num(error)));
    format!(
        "{}, mean of {}{error}: {}",
        escape(&bundle.light),
        counted(bundle.samples.into(), "sample"),
        rgb(bundle.mean)
    )
}
