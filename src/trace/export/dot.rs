//! The ray tree in Graphviz's DOT language.

use std::fmt::{self, Write};

use super::heading;
use super::tree_layout::{Figure, figures, hex, ink};
use crate::scene::printable::printable_lines;
use crate::trace::document::Document;
use crate::trace::format::counted;

/// A document in the DOT language, written by `Display`: a box a ray, dotted lines to the rays that were not sent.
pub struct Dot<'a>(pub &'a Document);

impl fmt::Display for Dot<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (figures, left_out) = figures(self.0);
        writeln!(f, "digraph raytree {{")?;
        writeln!(f, "  label=\"{}\";", escape(&heading(self.0)))?;
        writeln!(
            f,
            "  node [shape=box, style=filled, fontname=\"sans-serif\"];"
        )?;
        for (i, figure) in figures.iter().enumerate() {
            let label = format!("{}\n{}\n{}", figure.title, figure.end, figure.percent);
            writeln!(
                f,
                "  n{i} [label=\"{}\", fillcolor=\"{}\", fontcolor=\"{}\", color=\"{}\"];",
                escape(&label),
                hex(figure.fill),
                ink(figure.fill),
                figure.color
            )?;
        }
        for (i, figure) in figures.iter().enumerate() {
            if let Some(parent) = figure.parent {
                let color = figure.color;
                writeln!(f, "  n{parent} -> n{i} [color=\"{color}\"];")?;
            }
        }
        absences(f, &figures)?;
        if left_out > 0 {
            writeln!(
                f,
                "  more [label=\"{}\", shape=plaintext, style=\"\"];",
                counted(left_out as u64, "more ray")
            )?;
        }
        writeln!(f, "}}")
    }
}

/// The rays that were not sent, each below the ray that would have sent it.
fn absences(f: &mut fmt::Formatter, figures: &[Figure]) -> fmt::Result {
    let figures = figures.iter().enumerate();
    let absent = figures.flat_map(|(i, figure)| figure.node.absent.iter().map(move |a| (i, a)));
    for (number, (i, absent)) in absent.enumerate() {
        let reason = absent.reason.words();
        let label = escape(&format!("no {}: {reason}", absent.kind.letter()));
        writeln!(
            f,
            "  a{number} [label=\"{label}\", shape=plaintext, style=\"\"];"
        )?;
        writeln!(f, "  n{i} -> a{number} [style=dotted];")?;
    }
    Ok(())
}

/// The text, fit for a string of the language.
fn escape(text: &str) -> String {
    printable_lines(text)
        .chars()
        .fold(String::new(), |mut out, c| {
            match c {
                '\n' => out.push_str("\\n"),
                '"' | '\\' => {
                    let _ = write!(out, "\\{c}");
                }
                c => out.push(c),
            }
            out
        })
}
