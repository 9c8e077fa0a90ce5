//! The ray tree as an SVG picture.

use std::fmt;

use super::tree_layout::{Corner, Figure, GAP, HEIGHT, WIDTH, figures, hex, ink, layout};
use super::{heading, xml};
use crate::trace::document::Document;
use crate::trace::format::counted;

/// Letters of a line in a box.
const LETTERS: usize = 26;

/// A document as a picture, written by `Display`: one box a ray, filled with the colour that it brings back; dashed ones were not sent.
pub struct Svg<'a>(pub &'a Document);

impl fmt::Display for Svg<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (figures, left_out) = figures(self.0);
        let corners = layout(&figures);
        let edge = |least: f64, end: fn(&Corner) -> f64| {
            let ends = corners.iter().map(end);
            ends.fold(least, |most: f64, end| most.max(end + GAP))
        };
        let width = edge(320.0, |c| c.x + WIDTH);
        let height = edge(80.0, |c| c.y + HEIGHT);
        writeln!(
            f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\" font-size=\"12\">"
        )?;
        writeln!(f, "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>")?;
        let more = match left_out {
            0 => String::new(),
            _ => format!(" ({} not shown)", counted(left_out, "more ray")),
        };
        let heading = xml::escape(&heading(self.0));
        writeln!(f, "<text x=\"{GAP}\" y=\"24\">{heading}{more}</text>")?;
        for (figure, to) in figures.iter().zip(&corners) {
            if let Some(from) = figure.parent.and_then(|parent| corners.get(parent)) {
                writeln!(
                    f,
                    "<path d=\"M{} {} L{} {}\" stroke=\"{}\" stroke-width=\"2\"{} fill=\"none\"/>",
                    from.x + WIDTH / 2.0,
                    from.y + HEIGHT,
                    to.x + WIDTH / 2.0,
                    to.y,
                    figure.color,
                    dashes(figure)
                )?;
            }
        }
        for (figure, corner) in figures.iter().zip(&corners) {
            boxed(f, figure, *corner)?;
        }
        writeln!(f, "</svg>")
    }
}

/// The box of a ray, with its three lines.
fn boxed(f: &mut fmt::Formatter, figure: &Figure, Corner { x, y }: Corner) -> fmt::Result {
    writeln!(
        f,
        "<rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" rx=\"6\" fill=\"{}\" \
         stroke=\"{}\" stroke-width=\"2\"{}/>",
        hex(figure.fill),
        figure.color,
        dashes(figure)
    )?;
    let ink = ink(figure.fill);
    let lines = [&figure.title, &figure.end, &figure.percent];
    for (text, line) in lines.into_iter().zip([17.0, 33.0, 49.0]) {
        let text = xml::escape(&shorten(text));
        let (x, y) = (x + WIDTH / 2.0, y + line);
        writeln!(
            f,
            "<text x=\"{x}\" y=\"{y}\" fill=\"{ink}\" text-anchor=\"middle\">{text}</text>"
        )?;
    }
    Ok(())
}

/// Lines of rays that were not sent are dashed.
fn dashes(figure: &Figure) -> &'static str {
    if figure.rays == 0 {
        " stroke-dasharray=\"4 4\""
    } else {
        ""
    }
}

/// The text, or its beginning if it has too many letters for a box.
fn shorten(text: &str) -> String {
    if text.chars().count() <= LETTERS {
        return text.to_owned();
    }
    text.chars().take(LETTERS - 1).chain(['…']).collect()
}
