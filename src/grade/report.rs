//! The result of grading: what every output is made from.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::diff::Cause;
use super::finder::{self, Diagnosis, Evidence, unknown_key};
use super::marks::{CheckMark, Given, marks};
use super::submission::Submission;
use super::task::Task;

/// Submissions that must share a cause that nothing explains, for it to be listed.
const COMMON: usize = 5;

/// Marks of all submissions of a task.
#[derive(Clone, Debug)]
pub struct Report {
    /// One each, in the order of the command line.
    pub submissions: Vec<Marked>,
    /// Causes that no bend explains and that several submissions share.
    pub unknown: Vec<UnknownCause>,
}

/// A submission with its marks.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Its name.
    pub name: String,
    /// One for each check.
    pub marks: Vec<CheckMark>,
    /// The mistakes that explain it.
    pub diagnosis: Option<Diagnosis>,
    /// What could not be read.
    pub problems: Vec<String>,
}

/// A cause that several submissions share.
#[derive(Clone, Debug)]
pub struct UnknownCause {
    /// The law.
    pub law: &'static str,
    /// The quantity.
    pub quantity: String,
    /// The student's value over ours, to two digits.
    pub ratio: String,
    /// The submissions.
    pub names: Vec<String>,
    /// Where it shows first.
    pub address: String,
}

impl Marked {
    /// Marks a submission; of the bends that count as right the one that gives most. `tasks` are the task, and the task with each
    /// of them.
    pub fn new(tasks: &[Task], submission: Submission) -> Self {
        let name = submission.name.clone();
        let Some(task) = tasks.first() else {
            return Self {
                name,
                marks: Vec::new(),
                diagnosis: None,
                problems: submission.problems,
            };
        };
        let given = Given::new(task, submission);
        Self::of_given(tasks, task, name, &given)
    }

    /// Marks what was given.
    pub fn of_given(tasks: &[Task], task: &Task, name: String, given: &Given) -> Self {
        let mut all: Vec<(usize, Vec<CheckMark>)> = Vec::new();
        for (index, alternative) in tasks.iter().enumerate() {
            let marked = marks(alternative, given);
            let is_full = marked.iter().all(|mark| mark.score == mark.most);
            all.push((index, marked));
            if is_full {
                break;
            }
        }
        let total = |marks: &[CheckMark]| marks.iter().map(|mark| mark.score).sum::<u64>();
        let best = all
            .into_iter()
            .max_by_key(|(index, marks)| (total(marks), usize::MAX - index));
        let (index, marks) = best.unwrap_or_default();
        let mut problems = given.problems.clone();
        if index > 0 {
            let bend = task.accept.get(index - 1);
            problems.extend(bend.map(|bend| {
                format!(
                    "marked with `{bend}`, which counts as right: {}",
                    bend.entry().note
                )
            }));
        }
        let diagnosis =
            finder::is_worth_it(&marks).then(|| finder::find(task, &Evidence::of(task, given)));
        Self {
            name,
            marks,
            diagnosis: diagnosis.flatten(),
            problems,
        }
    }

    /// Thousandths of a point.
    pub fn score(&self) -> u64 {
        self.marks.iter().map(|mark| mark.score).sum()
    }

    /// Thousandths of a point at most.
    pub fn most(&self) -> u64 {
        self.marks.iter().map(|mark| mark.most).sum()
    }

    /// Percent, rounded down.
    pub fn percent(&self) -> u64 {
        (100 * self.score()).checked_div(self.most()).unwrap_or(100)
    }

    /// All causes, with their pixels and the indices of their checks.
    pub fn causes(&self) -> impl Iterator<Item = (usize, (u32, u32), &Cause)> {
        let checks = self.marks.iter().enumerate();
        checks.flat_map(|(index, mark)| {
            mark.causes
                .iter()
                .map(move |(at, cause)| (index, *at, cause))
        })
    }
}

impl Report {
    /// Marks submissions, each read by `read` when its turn comes, on the threads of the present pool. The result does not depend on
    /// their number.
    pub fn new<S: Sync>(
        tasks: &[Task],
        submissions: &[S],
        read: impl Fn(&S) -> Submission + Sync,
    ) -> Self {
        let marked: Vec<Marked> = submissions
            .par_iter()
            .map(|s| Marked::new(tasks, read(s)))
            .collect();
        Self::of(marked)
    }

    /// The report of submissions that were marked.
    pub fn of(submissions: Vec<Marked>) -> Self {
        let mut groups: BTreeMap<(&'static str, String, String), (Vec<String>, String)> =
            BTreeMap::new();
        for marked in submissions
            .iter()
            .filter(|marked| marked.diagnosis.is_none())
        {
            for (_, at, cause) in marked.causes().filter(|(.., cause)| cause.as_if.is_empty()) {
                let (law, quantity, ratio) = unknown_key(cause);
                let address = cause.first.address(at);
                let group = groups
                    .entry((law.name(), quantity, ratio))
                    .or_insert((Vec::new(), address));
                if group.0.last() != Some(&marked.name) {
                    group.0.push(marked.name.clone());
                }
            }
        }
        let common = groups
            .into_iter()
            .filter(|(_, (names, _))| names.len() >= COMMON);
        let unknown = common.map(|((law, quantity, ratio), (names, address))| UnknownCause {
            law,
            quantity,
            ratio,
            names,
            address,
        });
        Self {
            unknown: unknown.collect(),
            submissions,
        }
    }
}
