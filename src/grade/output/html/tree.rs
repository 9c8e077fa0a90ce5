//! The tree of a pixel, ours beside the student's.

use std::collections::HashMap;

use super::{cell, escape, table};
use crate::grade::compare::{Compared, Status};
use crate::grade::marks::CausingTree;
use crate::grade::quantity::field;
use crate::grade::task::{Check, CheckKind, Say};
use crate::grade::value::{shown, text};
use crate::trace::facts::{FactName, PixelFacts, RayFacts};

/// Rays that are shown at most.
const MOST_RAYS: usize = 200;

/// Our tree of a pixel of a check.
pub fn ours(check: &Check, at: (u32, u32)) -> Option<&PixelFacts> {
    match &check.kind {
        CheckKind::Trees { pixels, .. } => pixels.iter().find(|p| p.pixel == Some(at)),
        _ => None,
    }
}

/// A row a ray, and one for each of its quantities that is not ours.
pub fn table_of(say: Say, ours: &PixelFacts, kept: &CausingTree) -> String {
    let mut by_ray: HashMap<usize, Vec<&Compared>> = HashMap::new();
    let differing = kept.compared.iter().filter(|c| c.status != Status::Right);
    for compared in differing {
        by_ray.entry(compared.ray).or_default().push(compared);
    }
    let mut rows = Vec::new();
    for (index, ray) in ours.rays.iter().take(MOST_RAYS).enumerate() {
        let compared = by_ray.remove(&index).unwrap_or_default();
        rows.push(ray_row(ray, &compared));
        rows.extend(compared.iter().map(|c| quantity_row(say, c)));
    }
    for path in &kept.extra {
        let path = shown(&path.to_string());
        rows.push(cell(&path) + &cell("no such ray") + &cell("a ray too many") + WRONG);
    }
    let heads = ["ray", "expected", "handed in", ""].map(str::to_owned);
    let table = table("tree", &heads, rows.into_iter());
    match ours.rays.len().saturating_sub(MOST_RAYS) {
        0 => table,
        more => format!("{table}<p>Rays that are not shown: {more}.</p>\n"),
    }
}

const WRONG: &str = "<td class=\"wrong\">wrong</td>";

fn ray_row(ray: &RayFacts, differing: &[&Compared]) -> String {
    let name = ray
        .path
        .steps
        .last()
        .map_or("I".to_owned(), ToString::to_string);
    let is_not_told =
        !differing.is_empty() && differing.iter().all(|c| c.status == Status::Missing);
    let (class, word) = match differing {
        [] => ("right", "agrees"),
        _ if is_not_told => ("missing", "not told"),
        _ => ("", "differs"),
    };
    let fact = |name: FactName| ray.get(&name).map(text).unwrap_or_default();
    let t = ray.get(&FactName::T).map(|t| format!("t = {}", text(t)));
    let (outcome, object) = (fact(FactName::Outcome), fact(FactName::Object));
    let summary = [outcome, object, t.unwrap_or_default()].join(" ");
    format!(
        "<td style=\"padding-left:{}rem\"><b>{}</b></td>{}<td></td><td class=\"{class}\">{word}</td>",
        ray.path.depth() + 1,
        escape(&shown(&name)),
        cell(summary.trim_end())
    )
}

fn quantity_row(say: Say, compared: &Compared) -> String {
    let (class, word) = match compared.status {
        Status::Right => ("right", "agrees".to_owned()),
        Status::RightGiven => ("follows", "right for its own numbers".to_owned()),
        Status::Follows => ("follows", "follows".to_owned()),
        Status::Missing => ("missing", "not told".to_owned()),
        Status::Wrong if say == Say::Nothing => ("wrong", "wrong".to_owned()),
        Status::Wrong => ("wrong", format!("wrong: law {}", compared.law)),
    };
    let theirs = compared.theirs.as_ref().map(text).unwrap_or_default();
    format!(
        "<td style=\"padding-left:{}rem\">{}</td>{}{}<td class=\"{class}\">{}</td>",
        compared.path.depth() + 2,
        escape(&shown(&field(&compared.name))),
        cell(&text(&compared.ours)),
        cell(&theirs),
        escape(&word)
    )
}
