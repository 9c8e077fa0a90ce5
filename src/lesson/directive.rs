//! Directives: what stands in `{{...}}` in a chapter's text.

use std::fmt::Write as _;
use std::str::FromStr;

use super::stage::Stage;
use crate::debug::asked::asked;
use crate::grade::diff::{Sides, TreeDiff};
use crate::grade::follow::PixelReference;
use crate::grade::pixel_tree::traced;
use crate::grade::tolerance::Tolerances;
use crate::probe::Event;
use crate::scene::printable::excerpt;
use crate::trace::address::{AddressPart, node_at, subtree};
use crate::trace::export::Text;
use crate::trace::{Address, Explanation, document, explain};

/// Causes that a difference tells.
const CAUSES: usize = 5;

/// A directive that becomes a block of text.
#[derive(Clone, Debug, PartialEq)]
pub enum BlockDirective {
    /// The tree of a ray.
    Tree(Address),
    /// The steps of a ray through the accelerator.
    Steps(Address),
    /// What differs between our tree and that of a tracer with a bend.
    Diff(Address),
    /// The arithmetic of a ray's terms, or of one field.
    Equation(Address),
}

impl FromStr for BlockDirective {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (first, rest) = text.split_once(' ').unwrap_or((text, ""));
        let make = match first {
            "tree" => Self::Tree,
            "steps" => Self::Steps,
            "diff" => Self::Diff,
            "equation" => Self::Equation,
            _ => {
                return Err(format!(
                    "`{}` is no directive; there are trace, count, rays, nodes, tests, tree, steps, diff, equation, \
                     picture, console, exercise, file",
                    excerpt(first)
                ));
            }
        };
        Ok(make(rest.trim().parse()?))
    }
}

/// The inside of a directive that stands alone on its line.
pub fn alone(line: &str) -> Option<&str> {
    let inner = line.trim().strip_prefix("{{")?.strip_suffix("}}")?;
    (!inner.contains("}}")).then_some(inner.trim())
}

/// True for the directives that become blocks.
pub fn is_block(inner: &str) -> bool {
    const BLOCKS: [&str; 8] = [
        "tree", "steps", "diff", "equation", "picture", "console", "exercise", "file",
    ];
    BLOCKS.contains(&inner.split(' ').next().unwrap_or_default())
}

/// A line with its directives replaced by their values.
pub fn filled(
    line: &str,
    mut value: impl FnMut(&str) -> Result<String, String>,
) -> Result<String, String> {
    let mut out = String::new();
    let mut rest = line;
    while let Some((before, behind)) = rest.split_once("{{") {
        let (inner, after) = behind
            .split_once("}}")
            .ok_or("a directive does not end; write }} behind it")?;
        let inner = inner.trim();
        if is_block(inner) {
            return Err(format!(
                "{{{{{}}}}} becomes a block; put it on a line of its own",
                excerpt(inner)
            ));
        }
        out += before;
        out += &value(inner)?;
        rest = after;
    }
    Ok(out + rest)
}

impl BlockDirective {
    /// What stands above its text.
    pub fn title(&self, settings: &[(String, String)]) -> String {
        let (what, at) = match self {
            Self::Tree(at) => ("The ray tree of pixel", at),
            Self::Steps(at) => ("The search for the hit of the ray through pixel", at),
            Self::Diff(at) => ("What differs at pixel", at),
            Self::Equation(at) => ("The sum at pixel", at),
        };
        let with: Vec<String> = settings.iter().map(|(n, v)| format!("{n} {v}")).collect();
        let with = if with.is_empty() {
            String::new()
        } else {
            format!(" with {}", with.join(", "))
        };
        format!("{what} {at}{with}:")
    }

    /// Its text, with these settings.
    pub fn text(&self, stage: &Stage, settings: &[(String, String)]) -> Result<String, String> {
        if let Self::Diff(at) = self {
            return diff(stage, at, settings);
        }
        let stage = &stage.with(settings)?;
        let (Self::Tree(at) | Self::Steps(at) | Self::Equation(at) | Self::Diff(at)) = self;
        let trace = stage.traced(at.pixel)?;
        let view = stage.view(&trace);
        let node = node_at(view, &at.path)?;
        let own = || trace.tree.own_events(node);
        Ok(match self {
            Self::Tree(_) | Self::Diff(_) => {
                let mut all = document::of(view);
                for sample in &mut all.samples {
                    sample.root.iter_mut().for_each(without_steps);
                }
                Text(&subtree(all, &at.path)?).to_string()
            }
            Self::Steps(_) => {
                let steps = own()
                    .filter(|(_, event)| matches!(event, Event::Visit(_) | Event::Test { .. }));
                steps
                    .map(|(at, _)| in_lines(&explain(view, at), false))
                    .collect()
            }
            Self::Equation(_) => {
                let events: Vec<usize> = match &at.part {
                    Some(AddressPart::Field(name)) => {
                        let part = Some(AddressPart::Field(name.clone()));
                        vec![asked(view, &Address { part, ..at.clone() })?.answer]
                    }
                    Some(AddressPart::Event(event)) => vec![*event],
                    None => own()
                        .filter(|(_, e)| matches!(e, Event::Term { .. } | Event::Return { .. }))
                        .map(|(at, _)| at)
                        .collect(),
                };
                let told = events
                    .into_iter()
                    .map(|at| in_lines(&explain(view, at), true));
                told.collect()
            }
        })
    }
}

/// An explanation in lines: its title, and its rows.
pub fn in_lines(told: &Explanation, rows: bool) -> String {
    let mut out = format!("{}: {}\n", told.title, told.sentence);
    if rows {
        let width = told.rows.iter().map(|row| row.name.chars().count()).max();
        let width = width.unwrap_or(0);
        for row in &told.rows {
            let _ = writeln!(out, "    {:width$}  {}", row.name, row.text);
        }
    }
    out
}

/// Leaves out the steps through the accelerator.
fn without_steps(node: &mut crate::trace::document::RayNode) {
    let mut open = vec![node];
    while let Some(node) = open.pop() {
        node.traversal.clear();
        open.extend(&mut node.children);
    }
}

/// What differs between our tree and that with other settings, such as `bend=far-root`.
fn diff(stage: &Stage, at: &Address, settings: &[(String, String)]) -> Result<String, String> {
    stage.traced(at.pixel)?;
    let bent = stage.with(settings)?;
    let ours = traced(&stage.world, &stage.settings, at.pixel);
    let theirs = traced(&bent.world, &bent.settings, at.pixel);
    let of = PixelReference {
        scene: Some((&stage.world, &stage.settings)),
        pixel: at.pixel,
        facts: &ours,
    };
    let found = TreeDiff::new(of, &theirs, &Tolerances::default(), &|_| true);
    let (x, y) = at.pixel;
    let open = |compared: &crate::grade::compare::Compared| format!("{x},{y}{}", compared.path);
    let sides = Sides {
        scene: &stage.world.scene.name,
        pixel: at.pixel,
        a: "ours",
        b: "theirs",
        open: &open,
    };
    Ok(found.to_text(sides, CAUSES))
}
