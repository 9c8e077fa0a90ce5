//! The ray tree in Graphviz's DOT language.

use std::fmt::{self, Write};

use super::heading;
use super::tree_layout::{Figure, figures, hex, ink};
use crate::scene::printable::printable_lines;
use crate::trace::document::{Document, TestedPrimitive, TraversalStep, VisitedChildren};
use crate::trace::format::{counted, num};

/// Steps through the accelerator that a ray's note tells at most; of more, the first and the last ones.
const MAX_STEPS: usize = 12;
const LAST_STEPS: usize = 4;

/// A document in the DOT language, written by `Display`: a box a ray, dotted lines to the rays that were not sent, and
/// to notes with the steps through the accelerator.
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
            if figure.rays == 0 {
                let label = escape(&format!("{}\n{}", figure.title, figure.end));
                writeln!(
                    f,
                    "  n{i} [label=\"{label}\", shape=plaintext, style=\"\"];"
                )?;
                continue;
            }
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
                let style = if figure.rays == 0 {
                    ", style=dotted"
                } else {
                    ""
                };
                writeln!(f, "  n{parent} -> n{i} [color=\"{color}\"{style}];")?;
            }
        }
        traversals(f, &figures)?;
        if left_out > 0 {
            writeln!(
                f,
                "  more [label=\"{}\", shape=plaintext, style=\"\"];",
                counted(left_out, "more ray")
            )?;
        }
        writeln!(f, "}}")
    }
}

/// The steps of each ray through the accelerator, as a note below the ray.
fn traversals(f: &mut fmt::Formatter, figures: &[Figure]) -> fmt::Result {
    for (i, figure) in figures.iter().enumerate() {
        let steps = figure.steps;
        if steps.is_empty() {
            continue;
        }
        // `\l` ends a line that stands at the left.
        let mut label = String::new();
        for line in note(steps) {
            write!(label, "{}\\l", escape(&line))?;
        }
        writeln!(
            f,
            "  s{i} [label=\"{label}\", shape=note, style=\"\", fontsize=10];"
        )?;
        writeln!(f, "  n{i} -> s{i} [style=dashed, arrowhead=none];")?;
    }
    Ok(())
}

/// The lines of a note: how many steps there are, the first and the last ones, and how many are left out between them.
fn note(steps: &[TraversalStep]) -> Vec<String> {
    let count = steps.len();
    let folded = count.saturating_sub(MAX_STEPS);
    let (first, last) = if folded > 0 {
        (
            &steps[..MAX_STEPS - LAST_STEPS],
            &steps[count - LAST_STEPS..],
        )
    } else {
        (steps, &steps[count..])
    };
    let mut lines = vec![counted(count as u64, "step")];
    lines.extend(first.iter().map(brief));
    lines.extend((folded > 0).then(|| format!("... {folded} more ...")));
    lines.extend(last.iter().map(brief));
    lines
}

/// A step in a few words.
fn brief(step: &TraversalStep) -> String {
    match step {
        TraversalStep::Visit {
            node,
            near,
            far,
            visit,
            reason,
            ..
        } => {
            let child = |id: &Option<u32>| id.map_or("empty".to_owned(), |id| id.to_string());
            match visit {
                VisitedChildren::Near => format!("node {node}: near {}", child(near)),
                VisitedChildren::Far => format!("node {node}: far {}", child(far)),
                VisitedChildren::Both => {
                    format!("node {node}: near {}, then far {}", child(near), child(far))
                }
                VisitedChildren::Children | VisitedChildren::None => {
                    format!("node {node}: {reason}")
                }
            }
        }
        TraversalStep::Test {
            test: TestedPrimitive { object, primitive },
            result,
            t,
            ..
        } => {
            let at = t.map_or(String::new(), |t| format!(" at t = {}", num(t)));
            format!("test {object} {primitive}: {}{at}", result.word())
        }
    }
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
