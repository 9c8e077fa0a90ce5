//! The search: input after input, each made from its number alone, and what is done when one breaks a law.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::dice::Dice;
use super::laws::{Broken, Case, check_picture};
use super::{bytes, documents, models};

/// What a search met.
#[derive(Clone, Copy, Debug, Default)]
pub struct Met {
    pub inputs: u64,
    pub bytes: u64,
    pub accepted: u64,
    pub rendered: u64,
    /// The largest peak of memory, in bytes for each byte of an input of at least 4 KiB.
    pub memory: f64,
    /// The longest time that one input took, and its number.
    pub slowest: (Duration, u64),
}

/// Where inputs come from.
pub struct Search {
    /// All inputs follow from it and their numbers.
    pub seed: u64,
    /// Well-formed and once broken files, to be changed.
    pub corpus: Vec<Case>,
    /// What well-formed files cost: bytes of memory in all for each byte of input.
    pub work: f64,
    /// Of so many accepted inputs one is rendered and traced, which takes a hundred times as long as reading.
    pub rendered: usize,
}

impl Search {
    /// Input number `number`.
    pub fn input(&self, number: u64) -> Case {
        let dice = &mut Dice::new(self.seed, number);
        let mut files = BTreeMap::new();
        let kind = dice.below(8);
        if kind < 3 {
            let known = &self.corpus[dice.below(self.corpus.len())];
            files.clone_from(&known.files);
        }
        if kind >= 5 {
            files.insert(
                "scene.json".to_string(),
                documents::document(dice).into_bytes(),
            );
        }
        let mut beside = |name: &str, text: String| {
            files.entry(name.to_string()).or_insert(text.into_bytes());
        };
        beside("m.obj", models::obj(dice));
        if dice.one_in(2) {
            beside("x.mtl", models::mtl(dice));
        }
        // What was made by rule is changed half of the time, what is known always.
        if kind < 3 || dice.one_in(2) {
            let names: Vec<_> = files.keys().cloned().collect();
            let name = &names[dice.below(names.len())];
            let other = &self.corpus[dice.below(self.corpus.len())];
            let other = other.files.get(&other.main).cloned().unwrap_or_default();
            if let Some(file) = files.get_mut(name) {
                bytes::change(dice, file, &other);
            }
        }
        Case::new(files)
    }

    /// All laws on one input.
    fn check(&self, case: &Case, number: u64, met: &mut Met) -> Result<(), Broken> {
        let start = Instant::now();
        let (scene, outcome) = case.read(Some(self.work))?;
        let size = case.size();
        met.inputs += 1;
        met.bytes += size as u64;
        if size >= 4096 {
            met.memory = met.memory.max(outcome.memory.peak as f64 / size as f64);
        }
        if let Some(scene) = scene {
            met.accepted += 1;
            if met.accepted.is_multiple_of(self.rendered as u64) {
                met.rendered += 1;
                check_picture(&scene, Dice::new(number, 1).below(usize::MAX))?;
            }
        }
        met.slowest = met.slowest.max((start.elapsed(), number));
        Ok(())
    }

    /// The inputs `first`, `first + step`, and so on: `count` of them, or until `end`. The first that breaks each law is
    /// made smaller, kept in tests/corpus, and told.
    pub fn run(&self, [first, step, count]: [u64; 3], end: Option<Instant>) -> (Met, Vec<String>) {
        let (mut met, mut broken_laws) = (Met::default(), BTreeMap::new());
        for i in 0..count {
            if end.is_some_and(|end| Instant::now() > end) {
                break;
            }
            let number = first + i * step;
            let case = self.input(number);
            if let Err(broken) = self.check(&case, number, &mut met)
                && !broken_laws.contains_key(broken.law)
            {
                broken_laws.insert(broken.law, self.report(&case, number, &broken));
            }
        }
        (met, broken_laws.into_values().collect())
    }

    /// Keeps a small version of what broke a law.
    fn report(&self, case: &Case, number: u64, broken: &Broken) -> String {
        let still = |case: &Case| {
            let all = Search {
                corpus: Vec::new(),
                rendered: 1,
                ..*self
            };
            let again = all.check(case, number, &mut Met::default());
            again.is_err_and(|again| again.law == broken.law)
        };
        let small = if still(case) {
            smaller(case.clone(), &still)
        } else {
            case.clone()
        };
        let folder =
            corpus_folder().join(format!("found-{}-{number}", broken.law.replace(' ', "-")));
        let kept =
            keep(&folder, &small).map_or_else(|e| e.to_string(), |()| folder.display().to_string());
        format!(
            "input {number} of seed {}: {}: {}\nkept in {kept}",
            self.seed, broken.law, broken.how
        )
    }
}

/// The case with pieces taken out as long as `still` holds (after Zeller and Hildebrandt 2002): halves, quarters, and so
/// on of each file, at most for some seconds.
fn smaller(mut case: Case, still: &dyn Fn(&Case) -> bool) -> Case {
    let end = Instant::now() + Duration::from_secs(20);
    let names: Vec<String> = case.files.keys().cloned().collect();
    for name in names {
        let mut without = case.clone();
        without.files.remove(&name);
        if name != case.main && still(&without) {
            case = without;
            continue;
        }
        let mut piece = case.files[&name].len();
        while piece > 0 {
            let mut start = 0;
            while start < case.files[&name].len() && Instant::now() < end {
                let mut without = case.clone();
                if let Some(file) = without.files.get_mut(&name) {
                    let stop = (start + piece).min(file.len());
                    file.drain(start..stop);
                }
                if still(&without) {
                    case = without;
                } else {
                    start += piece;
                }
            }
            piece /= 2;
        }
    }
    case
}

/// The folder of all failures that were ever found: a folder each.
pub fn corpus_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus")
}

fn keep(folder: &Path, case: &Case) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    case.files
        .iter()
        .try_for_each(|(name, bytes)| fs::write(folder.join(name), bytes))
}

/// All cases in tests/corpus, by name.
pub fn found() -> Vec<(String, Case)> {
    let folders = fs::read_dir(corpus_folder()).expect("tests/corpus is there");
    let folders = folders
        .map(|f| f.expect("readable").path())
        .filter(|f| f.is_dir());
    let mut cases: Vec<_> = folders
        .map(|folder| {
            let files = fs::read_dir(&folder)
                .expect("a folder")
                .map(|f| f.expect("readable").path());
            let name = |path: &Path| {
                path.file_name()
                    .expect("a name")
                    .to_string_lossy()
                    .into_owned()
            };
            let files = files
                .map(|path| (name(&path), fs::read(&path).expect("a file")))
                .collect();
            (name(&folder), Case::new(files))
        })
        .collect();
    cases.sort_by(|a, b| a.0.cmp(&b.0));
    cases
}
