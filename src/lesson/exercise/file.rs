//! An exercise as `chapter.toml` has it, and what it becomes.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::{ChangeTask, Choices, Exercise, ExerciseKind, Goal, Must, Rightness, Solution, Wanted};
use crate::grade::task::SettingValue;
use crate::lab::show::ShowMode;
use crate::lesson::files::{CourseFiles, clean};
use crate::lesson::names::{is_id, pairs, scene_path};
use crate::lesson::value::LessonValue;
use crate::scene::printable::excerpt;
use crate::scene::{Bend, Bends};

/// Options of a choice, and goals of a change, at most: options are named by letters.
const MAX_OPTIONS: usize = 9;
const MAX_GOALS: usize = 20;

/// An exercise as `chapter.toml` has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExerciseFile {
    /// Unique in the course.
    pub id: String,
    kind: String,
    #[serde(default)]
    text: String,
    #[serde(default)]
    hints: Vec<String>,
    #[serde(default)]
    gate: bool,
    #[serde(default)]
    optional: bool,
    #[serde(default)]
    scene: Option<String>,
    #[serde(default)]
    settings: BTreeMap<String, SettingValue>,
    #[serde(default)]
    at: Option<String>,
    #[serde(default)]
    value: Option<String>,
    #[serde(default)]
    tolerance: Option<f64>,
    #[serde(default)]
    r#where: Option<String>,
    #[serde(default)]
    differs: Option<BTreeMap<String, SettingValue>>,
    #[serde(default)]
    show: Option<String>,
    #[serde(default)]
    between: Option<[f64; 2]>,
    #[serde(default)]
    keep: Vec<String>,
    #[serde(default)]
    goal: Vec<GoalFile>,
    #[serde(default)]
    start: Vec<String>,
    #[serde(default)]
    solution: Option<SolutionFile>,
    #[serde(default)]
    bend: Option<String>,
    #[serde(default)]
    among: Vec<String>,
    #[serde(default)]
    says: String,
    #[serde(default)]
    options: Vec<OptionFile>,
    #[serde(default)]
    task: Option<String>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct GoalFile {
    #[serde(default)]
    at: Option<String>,
    #[serde(default)]
    is: Option<SettingValue>,
    #[serde(default)]
    r#where: Option<String>,
    #[serde(default)]
    count: Option<[u64; 2]>,
    #[serde(default)]
    value: Option<String>,
    #[serde(default)]
    between: Option<[f64; 2]>,
    #[serde(default)]
    tolerance: Option<f64>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum SolutionFile {
    Changes(Vec<String>),
    File(String),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct OptionFile {
    text: String,
    #[serde(default)]
    right: bool,
    #[serde(default)]
    when: Option<String>,
    #[serde(default)]
    say: String,
}

impl ExerciseFile {
    /// The exercise; `folder` is that of its chapter.
    pub fn exercise(self, folder: &str) -> Result<Exercise, String> {
        if !is_id(&self.id) {
            return Err("its `id` is not of a-z, 0-9 and -".to_owned());
        }
        let scene = self.scene.as_deref();
        let scene = scene.map(|scene| scene_path(folder, scene)).transpose()?;
        let kind = match self.kind.as_str() {
            "predict" => self.predict()?,
            "find" => ExerciseKind::Find(self.wanted()?),
            "change" => ExerciseKind::Change(self.change(folder)?),
            "bug" => self.bug()?,
            "slide" | "choose" => self.choose()?,
            "write" => ExerciseKind::Write {
                task: CourseFiles::beside(folder, &self.needed("task", self.task.as_ref())?)?,
            },
            other => {
                return Err(format!(
                    "`kind` is `{}`; there are predict, find, change, bug, slide, choose, write",
                    excerpt(other)
                ));
            }
        };
        Ok(Exercise {
            id: self.id,
            text: clean(&self.text),
            hints: self.hints.iter().map(|hint| clean(hint)).collect(),
            gate: self.gate,
            optional: self.optional,
            scene,
            settings: pairs(&self.settings),
            kind,
        })
    }

    fn needed(&self, name: &str, field: Option<&String>) -> Result<String, String> {
        let cure = || format!("`{name}` is missing; {} needs it", excerpt(&self.kind));
        field.cloned().ok_or_else(cure)
    }

    fn predict(&self) -> Result<ExerciseKind, String> {
        let asked = match (&self.at, &self.value) {
            (Some(at), None) => LessonValue::field(at)?,
            (None, Some(value)) => LessonValue::parse(value)?,
            _ => return Err("predict needs either `at` or `value`".to_owned()),
        };
        of_own_scene(&asked)?;
        Ok(ExerciseKind::Predict {
            asked,
            tolerance: self.tolerance,
        })
    }

    fn wanted(&self) -> Result<Wanted, String> {
        let query = self.r#where.as_deref().map(str::parse);
        let query = query.transpose().map_err(|e| format!("`where`: {e}"))?;
        let shown = match (&self.show, self.between) {
            (Some(name), Some(range)) => Some((shown(name)?, range)),
            (None, None) => None,
            _ => return Err("`show` and `between` belong together".to_owned()),
        };
        let wanted = Wanted {
            query,
            text: clean(self.r#where.as_deref().unwrap_or_default()),
            differs: self.differs.as_ref().map(pairs).unwrap_or_default(),
            shown,
        };
        if wanted.query.is_none() && wanted.differs.is_empty() && wanted.shown.is_none() {
            return Err("find needs `where`, `differs`, or `show` and `between`".to_owned());
        }
        Ok(wanted)
    }

    fn change(&self, folder: &str) -> Result<ChangeTask, String> {
        if self.goal.is_empty() || self.goal.len() > MAX_GOALS {
            return Err(format!("change needs 1 to {MAX_GOALS} goals"));
        }
        let solution = match &self.solution {
            Some(SolutionFile::Changes(changes)) => Solution::Changes(changes.clone()),
            Some(SolutionFile::File(file)) => Solution::File(CourseFiles::beside(folder, file)?),
            None => return Err("`solution` is missing; change needs one".to_owned()),
        };
        let goals = self.goal.iter().map(GoalFile::goal);
        Ok(ChangeTask {
            keep: self.keep.clone(),
            goals: goals.collect::<Result<_, _>>()?,
            start: self.start.clone(),
            solution,
        })
    }

    fn bug(&self) -> Result<ExerciseKind, String> {
        let bend = bend(&self.needed("bend", self.bend.as_ref())?)?;
        let among = self.among.iter().map(|name| self::bend(name));
        let mut among: Vec<Bend> = among.collect::<Result<_, _>>()?;
        among.sort_by_key(|bend| bend.name());
        if !among.contains(&bend) || among.len() < 2 {
            return Err("`among` lists the bend and at least one other".to_owned());
        }
        let at = self.needed("at", self.at.as_ref())?;
        let address: crate::trace::Address = at.parse()?;
        Ok(ExerciseKind::Bug {
            bend,
            among,
            at: address.pixel,
        })
    }

    fn choose(&self) -> Result<ExerciseKind, String> {
        if !(2..=MAX_OPTIONS).contains(&self.options.len()) {
            return Err(format!("it needs 2 to {MAX_OPTIONS} options"));
        }
        let bend = self.bend.as_deref().map(self::bend).transpose()?;
        let options = self.options.iter().map(OptionFile::option);
        let mut options: Vec<Choices> = options.collect::<Result<_, _>>()?;
        // Authors write the right one first; who reads should not know. The order is the same each time.
        let place = |option: &Choices| {
            let told = format!("{} {}", self.id, option.text);
            *blake3::hash(told.as_bytes()).as_bytes()
        };
        options.sort_by_key(place);
        Ok(ExerciseKind::Choose {
            says: clean(&self.says),
            bend,
            options,
        })
    }
}

impl GoalFile {
    fn goal(&self) -> Result<Goal, String> {
        let asked = match (&self.at, &self.r#where, &self.value) {
            (Some(at), None, None) => LessonValue::field(at)?,
            (None, Some(query), None) => LessonValue::parse(&format!("count {query}"))?,
            (None, None, Some(value)) => LessonValue::parse(value)?,
            _ => return Err("a goal has one of `at`, `where` and `value`".to_owned()),
        };
        of_own_scene(&asked)?;
        let must = match (&self.is, self.count, self.between) {
            (Some(SettingValue::Text(word)), None, None) if word == "start" => Must::Same,
            (Some(SettingValue::Text(word)), None, None) => Must::Word(word.clone()),
            (Some(value), None, None) => {
                let number: f64 = value.to_string().parse().map_err(|_| "`is` is a list")?;
                Must::Near(number, self.tolerance.unwrap_or(0.01 * number.abs()))
            }
            (None, Some([least, most]), None) => Must::Between([least as f64, most as f64]),
            (None, None, Some(range)) => Must::Between(range),
            _ => return Err("a goal has one of `is`, `count` and `between`".to_owned()),
        };
        Ok(Goal { asked, must })
    }
}

impl OptionFile {
    fn option(&self) -> Result<Choices, String> {
        let right = match &self.when {
            None => Rightness::Fixed(self.right),
            Some(when) => {
                let compared = [
                    (" < ", std::cmp::Ordering::Less),
                    (" > ", std::cmp::Ordering::Greater),
                    (" = ", std::cmp::Ordering::Equal),
                ];
                let found = compared.iter().find_map(|(sign, order)| {
                    let (a, b) = when.split_once(sign)?;
                    Some((a, *order, b))
                });
                let (a, order, b) =
                    found.ok_or("`when` compares two values by <, > or = between blanks")?;
                Rightness::When(
                    Box::new(LessonValue::parse(a)?),
                    order,
                    Box::new(LessonValue::parse(b)?),
                )
            }
        };
        Ok(Choices {
            text: clean(&self.text),
            right,
            say: clean(&self.say),
        })
    }
}

/// An error if a value names a scene: an exercise has one of its own.
fn of_own_scene(asked: &LessonValue) -> Result<(), String> {
    match &asked.scene {
        Some(scene) => Err(format!(
            "write scene = \"{}\" in the place of S=",
            clean(scene)
        )),
        None => Ok(()),
    }
}

/// What is shown of pixels, by its name.
pub fn shown(name: &str) -> Result<ShowMode, String> {
    <ShowMode as clap::ValueEnum>::from_str(name, false).map_err(|_| {
        format!(
            "`show` is `{}`, which is nothing that is shown",
            excerpt(name)
        )
    })
}

fn bend(name: &str) -> Result<Bend, String> {
    let bends: Bends = name.parse()?;
    bends.iter().next().ok_or_else(|| "no bend".to_owned())
}
