//! The ray tree as a diagram: Graphviz DOT, and SVG laid out by ourselves.

use std::fmt::{self, Write};

use super::View;
use super::format::num;
use super::tree::Outcome;
use crate::probe::{Event, RayKind};

pub use crate::scene::limits::MAX_DIAGRAM_NODES as MAX_NODES;

/// A ray as a box of the diagram.
struct Figure {
    id: u32,
    parent: Option<u32>,
    title: String,
    end: String,
    share: String,
    /// What it brings back, as a screen shows it; for L rays grey or black.
    fill: [u8; 3],
    color: &'static str,
}

/// The rays of a pixel as boxes, parents first, and how many were left out.
fn figures(view: View) -> (Vec<Figure>, usize) {
    let tree = &view.trace.tree;
    let count = tree.nodes.len();
    let figures = (0..count.min(MAX_NODES) as u32).map(|id| {
        let node = tree.node(id);
        let name = |primitive| view.world.scene.object_of(primitive).name.clone();
        let light = node.ray.kind == RayKind::Light;
        let fill = match node.outcome {
            Some(Outcome::Lit) => [255, 244, 190],
            Some(Outcome::Blocked(_)) => [60, 60, 60],
            _ => (node.radiance * view.settings.image.exposure).to_srgb8(),
        };
        Figure {
            id,
            parent: node.parent,
            title: if light {
                format!("L {}", view.light_name(node.ray.light))
            } else {
                format!("{} {id}", node.ray.kind.letter())
            },
            end: match node.outcome {
                Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => {
                    format!("{} t={}", name(hit.primitive), num(hit.t))
                }
                Some(Outcome::Miss) => "miss".to_owned(),
                Some(Outcome::Lit) => "lit".to_owned(),
                None => "cut".to_owned(),
            },
            share: format!("{:.1} %", view.fraction(id) * 100.0),
            fill,
            color: match node.ray.kind {
                RayKind::Incident => "#444444",
                RayKind::Light => "#b8860b",
                RayKind::Reflected => "#c03030",
                RayKind::Transmitted => "#2060c0",
            },
        }
    });
    (figures.collect(), count.saturating_sub(MAX_NODES))
}

fn heading(view: View) -> String {
    let trace = view.trace;
    format!(
        "{}, pixel ({}, {}) of {} x {}",
        view.world.scene.name,
        trace.x,
        trace.y,
        view.settings.image.width,
        view.settings.image.height
    )
}

/// The tree in the DOT language, written by `Display`.
pub struct Dot<'a>(pub View<'a>);

impl fmt::Display for Dot<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (figures, left_out) = figures(self.0);
        writeln!(f, "digraph raytree {{")?;
        writeln!(f, "  label=\"{}\";", escape_dot(&heading(self.0)))?;
        writeln!(
            f,
            "  node [shape=box, style=filled, fontname=\"sans-serif\"];"
        )?;
        for figure in &figures {
            let label = format!("{}\n{}\n{}", figure.title, figure.end, figure.share);
            writeln!(
                f,
                "  n{} [label=\"{}\", fillcolor=\"{}\", fontcolor=\"{}\", color=\"{}\"];",
                figure.id,
                escape_dot(&label),
                hex(figure.fill),
                ink(figure.fill),
                figure.color
            )?;
        }
        for figure in &figures {
            if let Some(parent) = figure.parent {
                writeln!(
                    f,
                    "  n{parent} -> n{} [color=\"{}\"];",
                    figure.id, figure.color
                )?;
            }
        }
        for (i, (id, reason)) in absences(self.0).into_iter().enumerate() {
            let reason = escape_dot(&reason);
            writeln!(
                f,
                "  a{i} [label=\"{reason}\", shape=plaintext, style=\"\"];"
            )?;
            writeln!(f, "  n{id} -> a{i} [style=dotted];")?;
        }
        if left_out > 0 {
            writeln!(
                f,
                "  more [label=\"{left_out} more rays\", shape=plaintext, style=\"\"];"
            )?;
        }
        writeln!(f, "}}")
    }
}

/// The rays that were not sent, by the node that would have sent them.
fn absences(view: View) -> Vec<(u32, String)> {
    let tree = &view.trace.tree;
    let shown = tree.nodes.len().min(MAX_NODES) as u32;
    let of_node = |id| {
        tree.own_events(id)
            .filter_map(move |(_, event)| match event {
                Event::Absent { kind, reason, .. } => {
                    Some((id, format!("no {}: {}", kind.letter(), reason.name())))
                }
                _ => None,
            })
    };
    (0..shown).flat_map(of_node).collect()
}

const WIDTH: f64 = 168.0;
const HEIGHT: f64 = 56.0;
const GAP: f64 = 14.0;
const LEVEL: f64 = 92.0;

/// The tree as a picture, written by `Display`: one box a ray, filled with the colour it brings back.
pub struct Svg<'a>(pub View<'a>);

impl fmt::Display for Svg<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let view = self.0;
        let (figures, left_out) = figures(view);
        let places = layout(&figures);
        let width = places
            .iter()
            .fold(320.0, |w: f64, p| w.max(p.0 + WIDTH + GAP));
        let height = places
            .iter()
            .fold(80.0, |h: f64, p| h.max(p.1 + HEIGHT + GAP));
        writeln!(
            f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\" font-size=\"12\">"
        )?;
        writeln!(f, "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>")?;
        let more = if left_out > 0 {
            format!(" ({left_out} more rays not shown)")
        } else {
            String::new()
        };
        writeln!(
            f,
            "<text x=\"{GAP}\" y=\"24\">{}{more}</text>",
            escape_xml(&heading(view))
        )?;
        for figure in &figures {
            if let Some(parent) = figure.parent {
                let (from, to) = (places[parent as usize], places[figure.id as usize]);
                writeln!(
                    f,
                    "<path d=\"M{} {} L{} {}\" stroke=\"{}\" stroke-width=\"2\" fill=\"none\"/>",
                    from.0 + WIDTH / 2.0,
                    from.1 + HEIGHT,
                    to.0 + WIDTH / 2.0,
                    to.1,
                    figure.color
                )?;
            }
        }
        for (figure, place) in figures.iter().zip(&places) {
            boxed(f, figure, *place)?;
        }
        writeln!(f, "</svg>")
    }
}

fn boxed(f: &mut fmt::Formatter, figure: &Figure, (x, y): (f64, f64)) -> fmt::Result {
    writeln!(
        f,
        "<rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" rx=\"6\" fill=\"{}\" \
         stroke=\"{}\" stroke-width=\"2\"/>",
        hex(figure.fill),
        figure.color
    )?;
    let ink = ink(figure.fill);
    for (text, line) in [
        (&figure.title, 17.0),
        (&figure.end, 33.0),
        (&figure.share, 49.0),
    ] {
        let text = escape_xml(&shorten(text, 24));
        let (x, y) = (x + WIDTH / 2.0, y + line);
        writeln!(
            f,
            "<text x=\"{x}\" y=\"{y}\" fill=\"{ink}\" text-anchor=\"middle\">{text}</text>"
        )?;
    }
    Ok(())
}

/// Places of the boxes' top left corners: leaves side by side in order, parents above the middle of their children.
fn layout(figures: &[Figure]) -> Vec<(f64, f64)> {
    let mut places = vec![(0.0, 0.0); figures.len()];
    let mut spans: Vec<Option<(f64, f64)>> = vec![None; figures.len()];
    let mut depths = vec![0.0; figures.len()];
    for (i, figure) in figures.iter().enumerate() {
        depths[i] = figure.parent.map_or(0.0, |p| depths[p as usize] + 1.0);
    }
    // Parents stand before their children, so from the back every child is placed before its parent. Leaves are
    // met from the last to the first: they are counted from the right, and turned over at the end.
    let mut from_right = 0.0;
    for (i, figure) in figures.iter().enumerate().rev() {
        let x = spans[i].map_or_else(
            || {
                from_right += WIDTH + GAP;
                -from_right
            },
            |(left, right)| f64::midpoint(left, right),
        );
        places[i] = (x, 40.0 + depths[i] * LEVEL);
        if let Some(parent) = figure.parent {
            let span = &mut spans[parent as usize];
            *span = Some(span.map_or((x, x), |(left, right): (f64, f64)| {
                (left.min(x), right.max(x))
            }));
        }
    }
    for place in &mut places {
        place.0 += from_right + GAP;
    }
    places
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Black or white, whichever can be read on the colour.
fn ink([r, g, b]: [u8; 3]) -> &'static str {
    let brightness = 2 * u32::from(r) + 5 * u32::from(g) + u32::from(b);
    if brightness > 8 * 140 {
        "#000000"
    } else {
        "#ffffff"
    }
}

fn shorten(text: &str, length: usize) -> String {
    if text.chars().count() <= length {
        return text.to_owned();
    }
    text.chars().take(length - 1).chain(['…']).collect()
}

fn escape_xml(text: &str) -> String {
    text.chars().fold(String::new(), |mut out, c| {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
        out
    })
}

fn escape_dot(text: &str) -> String {
    text.chars().fold(String::new(), |mut out, c| {
        match c {
            '\n' => out.push_str("\\n"),
            '"' | '\\' => {
                let _ = write!(out, "\\{c}");
            }
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
        out
    })
}
