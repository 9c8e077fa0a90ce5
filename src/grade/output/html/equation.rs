//! The shading equation of a hit with both sets of numbers, where a term of it is the cause.

use super::{cell, escape, table};
use crate::grade::compare::Compared;
use crate::grade::marks::CausingTree;
use crate::grade::quantity::field;
use crate::grade::value::{shown, text};
use crate::probe::RayKind;
use crate::trace::facts::{Fact, FactName, PixelFacts};

/// The equation at the hit of a cause; nothing if the cause is not in it.
pub fn table_of(ours: &PixelFacts, kept: &CausingTree, cause: &Compared) -> String {
    if !is_in_equation(&cause.name) {
        return String::new();
    }
    // The weight of R or T stands in the equation of the hit that sent it.
    let ray = match &cause.name {
        FactName::Weight => ours.rays.get(cause.ray).and_then(|ray| ray.parent),
        _ => Some(cause.ray),
    };
    let Some((index, ray)) = ray.and_then(|index| Some((index, ours.rays.get(index)?))) else {
        return String::new();
    };
    let is_own = |name: &FactName| is_in_equation(name) && *name != FactName::Weight;
    let terms = ray.facts.iter().filter(|(name, _)| is_own(name));
    let mut rows: Vec<(String, usize, &FactName, &Fact)> = terms
        .map(|(name, fact)| (field(name), index, name, fact))
        .collect();
    // What R and T bring is added before the sum.
    let sum = rows.pop_if(|(_, _, name, _)| **name == FactName::Radiance);
    let children = ours.children(index);
    for (child, facts) in children.filter(|(_, ray)| ray.kind != RayKind::Light) {
        let kind = facts.kind.letter();
        let told = facts.facts.iter();
        let told = told.filter(|(n, _)| matches!(n, FactName::Weight | FactName::Radiance));
        rows.extend(told.map(|(n, f)| (format!("{} of {kind}", field(n)), child, n, f)));
    }
    let summands: Vec<String> = rows
        .iter()
        .filter_map(|row| summand(row.2, &row.0))
        .collect();
    rows.extend(sum);
    let theirs = |ray: usize, name: &FactName| {
        kept.compared
            .iter()
            .find(|c| c.ray == ray && c.name == *name)
    };
    let rows = rows.iter().map(|(label, ray, name, fact)| {
        let told = theirs(*ray, name).map(|c| c.theirs.as_ref());
        let told = match told {
            Some(Some(theirs)) => text(theirs),
            Some(None) => "not told".to_owned(),
            None => "the same".to_owned(),
        };
        let is_cause = *ray == cause.ray && **name == cause.name;
        let class = if is_cause { "wrong" } else { "" };
        format!(
            "{}{}<td class=\"{class}\">{}</td>",
            cell(&shown(label)),
            cell(&text(fact)),
            escape(&told)
        )
    });
    let formula = format!("radiance = {}", summands.join(" + "));
    let heads = ["term", "expected", "handed in"].map(str::to_owned);
    format!("<p><code>{}</code></p>\n", escape(&formula)) + &table("tree", &heads, rows)
}

/// The summand of a row; the radiance of R and T belongs to that of their weights, and factors are part of their terms.
fn summand(name: &FactName, label: &str) -> Option<String> {
    match name {
        FactName::Term(..) => Some(shown(label.trim_start_matches("terms."))),
        FactName::Weight => {
            let ray = label.rsplit(' ').next().unwrap_or_default();
            Some(format!("weight of {ray} × radiance of {ray}"))
        }
        _ => None,
    }
}

fn is_in_equation(name: &FactName) -> bool {
    matches!(
        name,
        FactName::Term(..)
            | FactName::NDotL(..)
            | FactName::RDotV(..)
            | FactName::CornerValue(..)
            | FactName::Weight
            | FactName::Radiance
    )
}
