//! From radiance to the screen: the sample's weight, the sum of the samples, exposure, clamping, the curve of sRGB, 8 bits.

use super::Explanation;
use crate::math::Rgb;
use crate::trace::View;
use crate::trace::format::{num, triple};

/// Adds what becomes of an eye ray's radiance, up to the numbers on the screen.
pub fn to_screen(
    view: View,
    node: u32,
    radiance: Rgb,
    mut explanation: Explanation,
) -> Explanation {
    let (pixel, count) = (&view.trace.pixel, view.trace.tree.samples.len());
    let weight = view.sample_weight(node);
    if count > 1 || weight != 1.0 {
        explanation = explanation
            .row("weight of the sample", num(weight))
            .color("weight x radiance", radiance * weight)
            .color(format!("sum of {count} samples"), pixel.color);
    }
    let exposure = view.settings.image.exposure;
    let exposed = pixel.color * exposure;
    if exposure != 1.0 {
        explanation = explanation.color(format!("exposure x {}", num(exposure)), exposed);
    }
    let clamped = exposed.channels().map(|c| c.clamp(0.0, 1.0));
    if clamped != exposed.channels() {
        explanation = explanation.row("clamped to 0..1", triple(clamped));
    }
    let [r, g, b] = exposed.to_srgb8();
    explanation
        .row("curve of sRGB", triple(exposed.encoded()))
        .row(
            "x 255, rounded",
            format!("({r}, {g}, {b}), which is on the screen"),
        )
}
