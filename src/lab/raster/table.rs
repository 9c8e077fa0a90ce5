//! Table of the spans in a row of pixels.

use std::fmt::Write as _;

use super::{FilledSpan, RasterPicture};
use crate::math::Rgb;
use crate::scene::Scene;
use crate::scene::printable::printable;

/// The spans of a row: for each its triangle, its ends with their depths, the pixels that it covers, those of them where it was
/// the nearest so far, and the colours at its ends.
pub fn row_table(scene: &Scene, row: u32, drawn: &RasterPicture) -> String {
    let name = |span: &FilledSpan| {
        let object = printable(&scene.object_of(span.primitive).name);
        format!("{object} {}", span.number)
    };
    let names: Vec<String> = drawn.spans.iter().map(name).collect();
    let longest = names.iter().map(|name| name.chars().count()).max();
    let width = longest.unwrap_or(0).max("triangle".len());
    // Writing to a string cannot fail.
    let mut out = String::new();
    let _ = writeln!(
        out,
        "Row {row} (y = {}), {} spans in the order in which they are filled:\n",
        f64::from(row) + 0.5,
        drawn.spans.len()
    );
    let _ = writeln!(
        out,
        "{:width$}  x from   to  z from    to covers draws color from      to",
        "triangle"
    );
    for (filled, name) in drawn.spans.iter().zip(&names) {
        let [from, to] = [filled.span.from, filled.span.to];
        let _ = writeln!(
            out,
            "{name:width$}  {:5.1} {:5.1}  {:6.2} {:5.2} {:6} {:5} {} {}",
            from.x,
            to.x,
            1.0 / from.inverse_depth,
            1.0 / to.inverse_depth,
            filled.covered,
            filled.drawn,
            color(filled.colors[0]),
            color(filled.colors[1]),
        );
    }
    out
}

fn color(color: Rgb) -> String {
    let [r, g, b] = color.channels();
    format!("{r:.2},{g:.2},{b:.2}")
}
