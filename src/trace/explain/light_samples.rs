//! The samples of an area light: an estimate and its standard error.

use super::{Explanation, UNKNOWN};
use crate::trace::View;
use crate::trace::format::{counted, num};

/// The shadow rays to an area light, taken together.
pub fn light_samples(view: View, node: u32, light: u32) -> Explanation {
    let name = view.light_name(light);
    let n = view.settings.rays_to_area();
    let estimate = view.light_estimate(node, light);
    let explanation = Explanation::new(
        format!("{} to `{name}`", counted(n.into(), "ray")),
        "How much of the light can be seen from here is guessed from places on it: the more, the nearer to the truth.",
    )
    .row("", "Kd/pi integral of Le V cos cos' / r^2 over the light's area")
    .row(
        "samples",
        format!("{n}, chosen by the sampler `{}`", view.settings.light.sampler.name()),
    )
    .row("chosen", in_proportion_to(view, node, light));
    if !view.trace.is_whole() && !view.trace.tree.is_done(node) {
        return explanation.row("lit", format!("{UNKNOWN} of {n}"));
    }
    let explanation = explanation
        .row("lit", format!("{} of {n}", estimate.lit))
        .row("blocked", estimate.blocked.to_string())
        .row(
            "not sent",
            format!("{}: no light comes from there", estimate.absent),
        )
        .color("mean", estimate.mean);
    let Some(error) = estimate.standard_error else {
        return explanation;
    };
    let mean = estimate.mean.luminance();
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

/// How points on a light are chosen at the hit of a node.
fn in_proportion_to(view: View, node: u32, light: u32) -> String {
    match view.projected_solid_angle(node, light) {
        Some(area) => format!(
            "by what they bring: all the same, with a projected solid angle P = {}",
            num(area)
        ),
        None => "by the light's area".to_owned(),
    }
}
