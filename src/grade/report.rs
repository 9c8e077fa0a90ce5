//! The result of grading: what every output is made from.

use rayon::prelude::*;

use super::attempts::CountedScore;
use super::diff::Cause;
use super::finder::{self, Diagnosis, Evidence};
use super::marks::{CheckMark, Given, marks};
use super::submission::Submission;
use super::task::{Say, Task};

/// Marks of all submissions of a task.
#[derive(Clone, Debug)]
pub struct Report {
    /// One each, in the order of the command line.
    pub submissions: Vec<Marked>,
    /// Which part of all submissions these are, and of how many parts; none if they are all.
    pub shard: Option<[usize; 2]>,
}

/// A submission with its marks.
#[derive(Clone, Debug)]
pub struct Marked {
    /// Its name.
    pub name: String,
    /// The student's number or mail address in the course's list.
    pub id: Option<String>,
    /// One for each check.
    pub marks: Vec<CheckMark>,
    /// The mistakes that explain it.
    pub diagnosis: Option<Diagnosis>,
    /// The score that counts, if it is that of another attempt.
    pub counted: Option<CountedScore>,
    /// What could not be read.
    pub problems: Vec<String>,
}

impl Marked {
    /// Marks a submission; of the bends that count as right the one that gives most. `tasks` are the task, and the task with each
    /// of them.
    pub fn new(tasks: &[Task], submission: Submission) -> Self {
        let name = submission.name.clone();
        let Some(task) = tasks.first() else {
            return Self {
                name,
                id: None,
                marks: Vec::new(),
                diagnosis: None,
                counted: None,
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
            id: None,
            marks,
            diagnosis: diagnosis.flatten(),
            counted: None,
            problems,
        }
    }

    /// What its student may see.
    fn for_students(&self, task: &Task) -> Self {
        let checks = task.checks.iter().zip(&self.marks);
        let marks = checks.map(|(check, mark)| {
            if check.visible {
                return mark.clone();
            }
            CheckMark {
                score: mark.score,
                most: mark.most,
                status: mark.status,
                ..CheckMark::default()
            }
        });
        let says = task.say != Say::Nothing;
        Self {
            name: self.name.clone(),
            id: self.id.clone(),
            marks: marks.collect(),
            diagnosis: self.diagnosis.clone().filter(|_| says),
            counted: self.counted.clone(),
            problems: self.problems.clone(),
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
        Self {
            submissions,
            shard: None,
        }
    }

    /// What students may see: of hidden checks the points alone, of mistakes as much as the task says.
    pub fn for_students(&self, task: &Task) -> Self {
        Self {
            submissions: self
                .submissions
                .iter()
                .map(|m| m.for_students(task))
                .collect(),
            shard: self.shard,
        }
    }
}
