//! Rays that are not sent, and why.

use strum::IntoDiscriminant;

use super::Explanation;
use crate::probe::{Absence, RayKind};
use crate::trace::View;
use crate::trace::format::{degrees, num};

/// A ray is not sent.
pub fn absent(view: View, node: u32, kind: RayKind, light: u32, reason: Absence) -> Explanation {
    let what = match kind {
        RayKind::Light => format!("no L ray to `{}`", view.light_name(light)),
        _ => format!("no {} ray", kind.letter()),
    };
    let (name, value) = number(view, node, reason);
    Explanation::new(what, reason.discriminant().sentence()).row(name, value)
}

/// The quantity that decided, by its name, and its value.
fn number(view: View, node: u32, reason: Absence) -> (&'static str, String) {
    let settings = view.settings;
    let black = || "(0, 0, 0)".to_owned();
    match reason {
        Absence::TotalInternalReflection { k } => {
            let sign = if k < 0.0 { " < 0" } else { "" };
            ("k", format!("1 - (n1/n2)^2 sin^2 = {}{sign}", num(k)))
        }
        Absence::NoReflection => ("Wr", black()),
        Absence::NoTransmission => ("Wt", black()),
        Absence::NoLocalLight => ("Kd, Ks", black()),
        Absence::FacingAway { n_dot_l } => ("N.L", format!("{} <= 0", num(n_dot_l))),
        Absence::OutsideCone { cos_angle } => {
            ("angle", format!("{} from the axis", degrees(cos_angle)))
        }
        Absence::BelowSurface { n_dot_r } => ("N.R", num(n_dot_r)),
        Absence::MinWeight { weight } => {
            let threshold = num(settings.recursion.min_weight);
            (
                "weight",
                format!("{} < {threshold}, the threshold", num(weight)),
            )
        }
        Absence::DepthLimit => {
            let depth = view.trace.tree.node(node).ray.depth;
            ("depth", format!("{depth} of {}", settings.recursion.depth))
        }
        Absence::EffectOff => ("effect", "off".to_owned()),
        Absence::RayBudget => ("rays a pixel", settings.rays_per_pixel().to_string()),
    }
}
