//! Self-test of a task: every bend hands in what its tracer gives, and so do a right tracer, one in single precision with a fixed
//! offset, and nobody. It tells whether the task can be passed, whether it can be failed, and which mistakes it names.

mod write;

use rayon::prelude::*;

use super::estimate::{self, EstimateReference};
use super::marks::Given;
use super::output::points;
use super::report::Marked;
use super::task::{Check, CheckKind, Task, TaskScene, reference, usual};
use crate::scene::{Bend, Bends};
use crate::trace::facts::{Fact, FactName, PixelFacts};
use crate::tracer::image::{pfm, png};

/// What a self-test found.
pub struct SelfTest {
    /// Ours, and ours in single precision with a fixed offset.
    pub right: [Marked; 2],
    /// Nothing handed in, and a tracer that misses everything.
    pub wrong: [Marked; 2],
    /// What each bend that changes something earns.
    pub bends: Vec<(Bend, Marked)>,
    /// Bends that earn all points: nothing that is asked tells them from ours.
    pub unseen: Vec<Bend>,
    /// What must be mended.
    pub failures: Vec<String>,
    /// What may be meant.
    pub warnings: Vec<String>,
}

/// How a bend fared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// It alone is named.
    Named,
    /// It is one of several that are named.
    Among,
    /// Nothing is named.
    Unnamed,
    /// Another one is named.
    Misnamed,
}

impl SelfTest {
    /// Tests a task, on the threads of the present pool.
    pub fn new(tasks: &[Task]) -> Option<Self> {
        let task = tasks.first()?;
        let mark =
            |name: &str, given: &Given| Marked::of_given(tasks, task, name.to_owned(), given);
        let single = task_in_single(task);
        let right = [
            mark("ours", &handed_in(task, Bends::default())),
            mark("single precision", &handed_in(&single, Bends::default())),
        ];
        let wrong = [
            mark("nothing", &Given::default()),
            mark("misses", &misses(task)),
        ];
        let all: Vec<Bend> = Bend::all().collect();
        let marked: Vec<(Bend, Marked)> = all
            .par_iter()
            .map(|bend| (*bend, mark(bend.name(), &handed_in(task, (*bend).into()))))
            .collect();
        let differs = |marked: &Marked| marked.score() < marked.most();
        let (bends, same): (Vec<_>, Vec<_>) = marked.into_iter().partition(|(_, m)| differs(m));
        let mut test = Self {
            right,
            wrong,
            bends,
            unseen: same.into_iter().map(|(bend, _)| bend).collect(),
            failures: Vec::new(),
            warnings: Vec::new(),
        };
        test.judge(task);
        Some(test)
    }

    fn judge(&mut self, task: &Task) {
        for marked in &self.right {
            if marked.score() < marked.most() {
                let text = format!(
                    "a right tracer ({}) earns {} of {}",
                    marked.name,
                    points(marked.score()),
                    points(marked.most())
                );
                self.failures.push(text);
            }
        }
        for marked in &self.wrong {
            if marked.score() > 0 {
                self.failures.push(format!(
                    "one who hands in {} earns {}",
                    marked.name,
                    points(marked.score())
                ));
            }
        }
        for check in &task.checks {
            self.expectations(task, check);
        }
        for (bend, marked) in &self.bends {
            if naming(*bend, marked) == Naming::Misnamed {
                self.warnings
                    .push(format!("`{bend}` is taken for another mistake"));
            }
        }
        if let Some(problem) = power(task).err() {
            self.failures.push(problem);
        }
    }

    fn expectations(&mut self, task: &Task, check: &Check) {
        let index = task.checks.iter().position(|c| c.id == check.id);
        for (bend, [from, to]) in &check.expect {
            let marked = self.bends.iter().find(|(b, _)| b == bend);
            let mark = marked.and_then(|(_, marked)| marked.marks.get(index?));
            let earned = mark.map_or(check.points, |mark| mark.score);
            if !(*from..=*to).contains(&(earned as f64 / 1000.0)) {
                self.failures.push(format!(
                    "check `{}`: `{bend}` earns {}, and {from} to {to} are expected",
                    check.id,
                    points(earned)
                ));
            }
        }
    }
}

/// How a bend fared.
pub fn naming(bend: Bend, marked: &Marked) -> Naming {
    let Some(diagnosis) = &marked.diagnosis else {
        return Naming::Unnamed;
    };
    match &diagnosis.candidates[..] {
        [one] if *one == bend.into() => Naming::Named,
        all if all.iter().any(|bends| bends.has(bend)) => Naming::Among,
        _ => Naming::Misnamed,
    }
}

/// What a tracer with these bends hands in.
pub fn handed_in(task: &Task, bends: Bends) -> Given {
    let mut given = Given::default();
    for check in &task.checks {
        let scene = &task.scenes[check.scene];
        let settings = scene.settings.with(|s| s.bends = bends);
        match &check.kind {
            CheckKind::Trees { pixels, .. } => {
                for ours in pixels {
                    let at = ours.pixel.unwrap_or_default();
                    given.add(check.scene, at, reference(scene, &settings, at));
                }
            }
            CheckKind::Picture { asked, pictures } => {
                let film = match bends {
                    Bends([Some(bend), None]) => pictures.bent(bend),
                    _ => &pictures.right,
                };
                let linear = asked.ask == "linear";
                let bytes = if linear {
                    Some(pfm::encode(film))
                } else {
                    png::encode(film, settings.image.exposure).ok()
                };
                let name = asked.file.replace('*', if linear { "pfm" } else { "png" });
                given.pictures.extend(bytes.map(|bytes| (name, bytes)));
            }
            CheckKind::Estimate { asked, references } => {
                for EstimateReference { pixel, .. } in references {
                    let samples = samples(scene, bends, *pixel, asked);
                    let facts = PixelFacts {
                        estimates: samples,
                        ..PixelFacts::default()
                    };
                    given.add(check.scene, *pixel, facts);
                }
            }
        }
    }
    given
}

/// As many single samples as are asked.
fn samples(
    scene: &TaskScene,
    bends: Bends,
    pixel: (u32, u32),
    asked: &super::task::EstimateFile,
) -> Vec<f64> {
    let settings = estimate::sampled(&scene.settings, bends);
    let mut values = Vec::new();
    let mut seed = 1 << 20;
    while (values.len() as u64) < asked.samples {
        seed += 1;
        values.extend(estimate::samples_of(
            scene,
            &settings.with(|s| s.seed = seed),
            pixel,
            &asked.light,
        ));
    }
    values.truncate(asked.samples as usize);
    values
}

/// One who prints eye rays that miss everywhere.
fn misses(task: &Task) -> Given {
    let mut given = Given::default();
    for check in &task.checks {
        if let CheckKind::Trees { pixels, .. } = &check.kind {
            for ours in pixels {
                let mut theirs = ours.clone();
                theirs.rays.truncate(1);
                for ray in &mut theirs.rays {
                    ray.facts = vec![(FactName::Outcome, Fact::Word("miss".to_owned()))];
                    ray.absent.clear();
                }
                theirs.color = Some(Fact::BLACK);
                theirs.srgb8 = None;
                given.add(check.scene, ours.pixel.unwrap_or_default(), theirs);
            }
        }
    }
    given
}

/// The task with scenes that a usual right tracer computes.
fn task_in_single(task: &Task) -> Task {
    Task {
        scenes: task.scenes.iter().map(usual).collect(),
        ..task.clone()
    }
}

/// Whether every estimate can tell a mistake from a right tracer.
fn power(task: &Task) -> Result<(), String> {
    for check in &task.checks {
        let CheckKind::Estimate { asked, references } = &check.kind else {
            continue;
        };
        for reference in references {
            let allowed = reference.allowed(asked.samples as f64, references.len());
            if allowed > asked.error * reference.mean {
                let (x, y) = reference.pixel;
                return Err(format!(
                    "check `{}`: with {} samples the mean at {x},{y} may be off by {:.0} %, and `error` says {:.0} %; ask for more samples",
                    check.id,
                    asked.samples,
                    100.0 * allowed / reference.mean,
                    100.0 * asked.error
                ));
            }
        }
    }
    Ok(())
}
