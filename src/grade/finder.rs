//! Which law is broken: the mistakes that explain what a submission has wrong.
//!
//! A quantity is *telling* for a bend where the bend makes another value of the student's own numbers than our law does. A bend
//! explains a submission if the student has the bend's value at three telling quantities or more, at two pixels or more, another
//! one at no more than 2 % of them, and if it accounts for 95 % of all that is wrong. Without this last half of the rule wrong
//! names come easily. A name is given on no less: a wrong diagnosis is worse than none.

mod evidence;

pub use evidence::Evidence;

use super::diff::Cause;
use super::marks::CheckMark;
use super::task::Task;
use crate::scene::{Bend, Bends, Law};

/// Telling quantities that are needed, and the pixels that they must be at.
const TELLING: u64 = 3;
const PIXELS: u64 = 2;

/// Pairs of bends that are tried, and pixels that they are tried at.
const PAIRS: usize = 200;

/// Mistakes that explain a submission; of several any may be the one.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// The mistakes; two together where no single one explains.
    pub candidates: Vec<Bends>,
    /// Telling quantities of the first candidate, and how many of them the student has.
    pub telling: u64,
    /// See `telling`.
    pub explained: u64,
}

/// How far a bend explains a submission.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Telling quantities.
    pub telling: u64,
    /// Of these, those that the student has as the bend makes them.
    pub explained: u64,
    /// Pixels with an explained telling quantity.
    pub pixels: u64,
    /// What is wrong in all.
    pub errors: u64,
    /// Of these, those that the bend accounts for.
    pub accounted: u64,
}

impl Tally {
    /// True if the bend explains the submission, which has so many pixels.
    fn explains(&self, pixels: u64) -> bool {
        let enough =
            self.explained >= TELLING.min(self.telling.max(1)) && self.pixels >= PIXELS.min(pixels);
        let contradicted = self.telling - self.explained;
        enough
            && self.explained > 0
            && 50 * contradicted <= self.telling
            && 20 * self.accounted >= 19 * self.errors
    }

    /// True if it cannot explain any more, whatever follows.
    fn is_lost(&self, all_errors: u64) -> bool {
        20 * (self.errors - self.accounted) > all_errors
    }
}

/// The mistakes that explain a submission; `None` if nothing does. Trees say most and are asked first; pictures and colours of
/// pixels are asked where the trees have no errors, since each candidate takes a picture or a tree of its own.
pub fn find(task: &Task, evidence: &[Evidence]) -> Option<Diagnosis> {
    let (trees, others): (Vec<_>, Vec<_>) = evidence.iter().partition(|e| e.is_tree());
    let errors: u64 = trees.iter().map(|tree| tree.errors()).sum();
    explain(task, if errors > 0 { &trees } else { &others })
}

/// The mistakes that explain all of this evidence.
fn explain(task: &Task, evidence: &[&Evidence]) -> Option<Diagnosis> {
    let errors: u64 = evidence.iter().map(|evidence| evidence.errors()).sum();
    if errors == 0 {
        return None;
    }
    // What has most errors first: there most candidates are lost.
    let mut order = evidence.to_vec();
    order.sort_by_key(|evidence| std::cmp::Reverse(evidence.errors()));
    let singles: Vec<Bends> = Bend::all().map(Bends::from).collect();
    let tallies = tally(task, &order, &singles, errors);
    let pixels = evidence.len() as u64;
    let found: Vec<(Bends, Tally)> = tallies
        .iter()
        .filter(|(_, t)| t.explains(pixels))
        .copied()
        .collect();
    if let Some(diagnosis) = diagnosis(found) {
        return Some(diagnosis);
    }
    let pairs = pairs(task, &order, errors);
    let tallies = tally(task, &order, &pairs, errors);
    diagnosis(
        tallies
            .into_iter()
            .filter(|(_, t)| t.explains(pixels))
            .collect(),
    )
}

/// What each candidate explains; those that cannot explain are left out as soon as that is known.
fn tally(
    task: &Task,
    order: &[&Evidence],
    candidates: &[Bends],
    errors: u64,
) -> Vec<(Bends, Tally)> {
    let mut open: Vec<(Bends, Tally)> = candidates.iter().map(|b| (*b, Tally::default())).collect();
    for evidence in order {
        for (bends, tally) in &mut open {
            evidence.add(task, *bends, tally);
        }
        open.retain(|(_, tally)| !tally.is_lost(errors));
    }
    open
}

/// Pairs of bends of different laws, each of which accounts for a fifth of the errors where there are most of them.
fn pairs(task: &Task, order: &[&Evidence], errors: u64) -> Vec<Bends> {
    let most = &order[..order.len().min(4)];
    let there: u64 = most.iter().map(|evidence| evidence.errors()).sum();
    if there == 0 || errors < TELLING {
        return Vec::new();
    }
    let some: Vec<Bend> = Bend::all()
        .filter(|bend| {
            let mut tally = Tally::default();
            for evidence in most {
                evidence.add(task, (*bend).into(), &mut tally);
            }
            5 * tally.accounted >= there
        })
        .collect();
    let mut pairs = Vec::new();
    for (index, a) in some.iter().enumerate() {
        for b in &some[index + 1..] {
            if a.law() != b.law() && pairs.len() < PAIRS {
                pairs.push(Bends([Some(*a), Some(*b)]));
            }
        }
    }
    pairs
}

/// The candidates with the most telling quantities first.
fn diagnosis(mut found: Vec<(Bends, Tally)>) -> Option<Diagnosis> {
    found.sort_by_key(|(_, tally)| std::cmp::Reverse(tally.explained));
    let (_, best) = found.first()?;
    Some(Diagnosis {
        telling: best.telling,
        explained: best.explained,
        candidates: found.iter().map(|(bends, _)| *bends).collect(),
    })
}

/// The key by which causes that nothing explains are grouped over a batch: the law, the quantity, and the student's value over
/// ours to two digits.
pub fn unknown_key(cause: &Cause) -> (Law, String, String) {
    let first = &cause.first;
    let ratio = match (first.theirs.as_ref().and_then(size), size(&first.ours)) {
        (Some(theirs), Some(ours)) if ours != 0.0 => format!("{:.1e}", theirs / ours),
        _ => "-".to_owned(),
    };
    (first.law, first.quantity.name().to_owned(), ratio)
}

/// One number for a value.
fn size(fact: &crate::trace::facts::Fact) -> Option<f64> {
    use crate::trace::facts::Fact;
    match fact {
        Fact::Number(x) => Some(*x),
        Fact::Color(color) => Some(color.luminance()),
        Fact::Vector(v) => v
            .iter()
            .copied()
            .reduce(|a, b| if b.abs() > a.abs() { b } else { a }),
        _ => None,
    }
}

/// True if points were lost, so that it is worth to look for the reason.
pub fn is_worth_it(marks: &[CheckMark]) -> bool {
    marks.iter().any(|mark| mark.score < mark.most)
}
