//! Marks of one submission: what each check earns, in thousandths of a point.
//!
//! Everything is counted in whole numbers, so that the sum depends on no order, thread or machine, and right everywhere is exactly
//! all points.

mod estimate;
mod given;
mod picture;
mod trees;

pub use given::Given;
pub use picture::agree as agree_in_picture;

use serde::{Deserialize, Serialize};

use super::compare::{Compared, TreeComparison};
use super::diff::Cause;
use super::task::{Check, CheckKind, Task};
use crate::trace::facts::TreePath;

/// What a check came to.
#[derive(Clone, Debug, Default)]
pub struct CheckMark {
    /// Thousandths of a point.
    pub score: u64,
    /// Thousandths of a point at most.
    pub most: u64,
    /// All, some, none; not asked, or not to be read.
    pub status: CheckStatus,
    /// Quantities by what they came to.
    pub counts: QuantityCounts,
    /// First causes, with the pixel of each.
    pub causes: Vec<((u32, u32), Cause)>,
    /// The tree of the first cause.
    pub tree: Option<CausingTree>,
    /// In words: why it is broken or skipped, how a picture agrees.
    pub note: String,
}

/// The tree in which a law is broken first: what of it is not ours, and all of the ray of the cause.
#[derive(Clone, Debug)]
pub struct CausingTree {
    /// Its pixel.
    pub pixel: (u32, u32),
    /// The quantities.
    pub compared: Vec<Compared>,
    /// Rays that ours does not have.
    pub extra: Vec<TreePath>,
}

/// What a check came to, in a word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "lowercase")]
pub enum CheckStatus {
    /// All points.
    Full,
    /// Some points.
    Partial,
    /// No points.
    #[default]
    None,
    /// Not asked: a check that it needs did not earn half of its points.
    Skipped,
    /// Could not be read.
    Broken,
}

/// Quantities by what they came to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub struct QuantityCounts {
    /// Equal to ours.
    pub right: u64,
    /// Right given the student's own numbers.
    pub right_given: u64,
    /// First causes.
    pub wrong: u64,
    /// Consequences that cannot be computed.
    pub follows: u64,
    /// Not told.
    pub missing: u64,
    /// Rays that should not be.
    pub extra: u64,
}

impl CausingTree {
    /// What is kept of a comparison: the quantities for which `is_kept` holds, and all rays too many.
    pub fn new(
        pixel: (u32, u32),
        comparison: TreeComparison,
        is_kept: &dyn Fn(&Compared) -> bool,
    ) -> Self {
        let mut compared = comparison.all;
        compared.retain(is_kept);
        Self {
            pixel,
            compared,
            extra: comparison.extra.into_iter().map(|(path, _)| path).collect(),
        }
    }
}

impl CheckMark {
    /// The mark for a share of the points, `earned` of `asked`.
    fn of_share(check: &Check, earned: u64, asked: u64) -> Self {
        let score = if asked == 0 {
            check.points
        } else {
            (u128::from(check.points) * u128::from(earned.min(asked)) / u128::from(asked)) as u64
        };
        Self {
            score,
            most: check.points,
            status: status(score, check.points),
            ..Self::default()
        }
    }

    /// A check that could not be read, and why.
    pub fn broken(check: &Check, note: String) -> Self {
        Self {
            most: check.points,
            status: CheckStatus::Broken,
            note,
            ..Self::default()
        }
    }
}

/// The word for a score.
pub fn status(score: u64, most: u64) -> CheckStatus {
    match score {
        _ if score == most => CheckStatus::Full,
        0 => CheckStatus::None,
        _ => CheckStatus::Partial,
    }
}

/// Marks all checks of a task.
pub fn marks(task: &Task, given: &Given) -> Vec<CheckMark> {
    let mut marks: Vec<CheckMark> = Vec::new();
    for check in &task.checks {
        let unmet = check.needs.iter().find(|index| {
            let needed: &CheckMark = &marks[**index];
            2 * needed.score < needed.most
        });
        if let Some(index) = unmet {
            marks.push(CheckMark {
                most: check.points,
                status: CheckStatus::Skipped,
                note: format!("needs half of the points of `{}`", task.checks[*index].id),
                ..CheckMark::default()
            });
            continue;
        }
        marks.push(match &check.kind {
            CheckKind::Trees { pixels, ask, depth } => {
                trees::mark(task, check, (pixels, ask, *depth), given)
            }
            CheckKind::Picture { asked, pictures } => {
                picture::mark(task, check, asked, &pictures.right, given)
            }
            CheckKind::Estimate { asked, references } => {
                estimate::mark(check, asked, references, given)
            }
        });
    }
    marks
}
