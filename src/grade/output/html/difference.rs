//! The difference of two trees as a page: what is wrong and why, the equation if the first cause is in it, both trees side by side.

use super::{equation, escape, page, tree};
use crate::grade::diff::{Sides, TreeDiff};
use crate::grade::marks::CausingTree;
use crate::grade::task::Say;
use crate::grade::value::shown;
use crate::trace::facts::PixelFacts;

/// The page, with at most so many causes. `ours` is the right tree; `kept` is what was compared of it.
pub fn difference(
    (sides, diff): (Sides, &TreeDiff),
    ours: &PixelFacts,
    kept: &CausingTree,
    most: usize,
) -> String {
    let told = diff.to_text(sides, most);
    let told: Vec<_> = told.lines().map(escape).collect();
    let equation = diff.causes.first();
    let equation = equation.map(|cause| equation::table_of(ours, kept, &cause.first));
    let body = [
        format!("<p>Expected: <code>{}</code>. ", escape(&shown(sides.a))),
        format!("Handed in: <code>{}</code>.</p>\n", escape(&shown(sides.b))),
        format!("<pre>{}</pre>\n", told.join("\n")),
        equation
            .filter(|table| !table.is_empty())
            .map_or(String::new(), |table| {
                format!("<h2>The equation at the first cause</h2>\n{table}")
            }),
        format!(
            "<h2>Both trees</h2>\n{}",
            tree::table_of(Say::Bend, ours, kept)
        ),
    ];
    let (x, y) = sides.pixel;
    let title = format!("{}, pixel ({x}, {y})", shown(sides.scene));
    page(&title, &body.concat())
}
