//! The arithmetic of a ray's test against a leaf of a parametric surface: the parts that were looked at, and Newton's steps.

use super::Explanation;
use crate::geometry::patch::SearchStep;
use crate::geometry::{Shear, SurfacePatch};
use crate::trace::format::num;

/// Steps that are shown one by one.
const SHOWN: usize = 40;

/// Adds the search for the places of a patch that the ray meets.
pub fn add(explanation: Explanation, patch: &SurfacePatch, shear: &Shear) -> Explanation {
    let [m, n] = patch.degree();
    let [low, high] = patch.range();
    let told = patch.arithmetic(shear);
    let mut explanation = explanation
        .row("degree", format!("{m} along u, {n} along v"))
        .row(
            "leaf",
            format!(
                "u {} to {}, v {} to {} of the surface; below they run from 0 to 1",
                num(low[0]),
                num(high[0]),
                num(low[1]),
                num(high[1])
            ),
        )
        .row("", "seen along the ray, S(u, v) = 0 is sought");
    for step in told.steps.iter().take(SHOWN) {
        explanation = match step {
            SearchStep::Newton { place, residual } => explanation.row(
                "Newton",
                format!(
                    "u = {}, v = {}: |S| = {}",
                    num(place[0]),
                    num(place[1]),
                    num(*residual)
                ),
            ),
            SearchStep::Part(part, fate) => {
                let word: &str = (*fate).into();
                explanation.row(
                    "part",
                    format!(
                        "from u = {}, v = {}, halved {} and {} times: {}",
                        num(part.low[0]),
                        num(part.low[1]),
                        part.halvings[0],
                        part.halvings[1],
                        word.replace('-', " ")
                    ),
                )
            }
        };
    }
    if told.steps.len() > SHOWN {
        explanation = explanation.row("", format!("and {} more steps", told.steps.len() - SHOWN));
    }
    for crossing in &told.crossings {
        let way = if crossing.enters { "front" } else { "back" };
        explanation = explanation.row(
            "crossed",
            format!(
                "t = {} at u = {}, v = {}, from the {way}",
                num(crossing.t),
                num(crossing.place[0]),
                num(crossing.place[1])
            ),
        );
    }
    if told.crossings.is_empty() {
        return explanation.row("", "no place: the ray misses the patch");
    }
    explanation
}
