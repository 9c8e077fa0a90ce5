//! Task files, `raytree-task/1`: what is asked, in which scenes, for how many points. TOML, or the same as JSON.

mod advice;
mod ask;
mod error;
mod load;
pub mod parse;
mod pictures;
mod scene;
mod steady;

pub use ask::{Ask, Asked};
pub use error::TaskError;
pub use load::{Check, CheckKind, SceneReader, Task};
pub use pictures::BentPictures;
pub use scene::{TaskScene, reference};
pub use steady::usual;

use std::collections::BTreeMap;

use serde::Deserialize;

use super::attempts::Attempts;

/// A task as its file has it. Unknown keys are errors.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TaskFile {
    /// Always `raytree-task/1`.
    pub format: String,
    /// What it is called.
    pub name: String,
    /// The scenes, for those who read; each check names its own.
    #[serde(default)]
    pub scenes: Vec<String>,
    /// The size of pictures, `WxH`.
    #[serde(default)]
    pub size: Option<String>,
    /// Settings that students are told to use, by the names of their flags.
    #[serde(default)]
    pub settings: BTreeMap<String, SettingValue>,
    /// Whether numbers that are right given the student's own earlier ones count as right.
    #[serde(default = "yes")]
    pub follow: bool,
    /// How much messages tell.
    #[serde(default)]
    pub say: Say,
    /// Percent that are enough, where a yes or no is needed.
    #[serde(default = "half")]
    pub pass: u32,
    /// Bends that count as right, too.
    #[serde(default)]
    pub accept: Vec<String>,
    /// Which attempts count, where the platform tells the earlier ones.
    #[serde(default)]
    pub attempts: Option<Attempts>,
    /// Tolerances by quantity: the absolute part, or absolute and relative.
    #[serde(default)]
    pub tolerance: BTreeMap<String, ToleranceValue>,
    /// The checks.
    #[serde(rename = "check")]
    pub checks: Vec<CheckFile>,
}

/// A check as its file has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CheckFile {
    /// Unique, of a-z, 0-9 and -.
    pub id: String,
    /// For people.
    #[serde(default)]
    pub title: String,
    /// Points.
    pub points: u32,
    /// Checks of which half of the points must be earned first.
    #[serde(default)]
    pub needs: Vec<String>,
    /// Whether students see values and addresses.
    #[serde(default = "yes")]
    pub visible: bool,
    /// A built-in scene, or a file beside the task.
    pub scene: String,
    /// Effects that are left out, besides those of the task's settings.
    #[serde(default)]
    pub without: Vec<String>,
    /// Pixels whose trees are asked.
    #[serde(default)]
    pub pixels: Option<PixelsFile>,
    /// Quantities that are asked, with weights.
    #[serde(default)]
    pub ask: Vec<AskFile>,
    /// Rays below this depth are not asked.
    #[serde(default)]
    pub depth: Option<u32>,
    /// A picture that is asked.
    #[serde(default)]
    pub picture: Option<PictureFile>,
    /// An estimate that is asked.
    #[serde(default)]
    pub estimate: Option<EstimateFile>,
    /// Points that a student with this bend earns, from and to, for the self-test.
    #[serde(default)]
    pub expect: BTreeMap<String, [f64; 2]>,
}

/// Pixels: a list, or a rule that draws them.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum PixelsFile {
    /// Each column and row.
    List(Vec<[u32; 2]>),
    /// Drawn by chance, the same for all.
    Drawn(DrawnPixels),
}

/// Rule that draws pixels.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DrawnPixels {
    /// How many.
    pub count: usize,
    /// Of the drawing.
    #[serde(default)]
    pub seed: u64,
    /// What their trees must satisfy: a query, as in `raytree find`.
    #[serde(default)]
    pub r#where: Option<String>,
}

/// A quantity by name, or names with weights.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum AskFile {
    /// A name, such as `T.direction`, `core`, `law:refract`, `-radiance`.
    Name(String),
    /// Names with whole weights.
    Weighted(BTreeMap<String, u32>),
}

/// A picture that is asked.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PictureFile {
    /// Its name, in which `*` stands for any letters.
    pub file: String,
    /// `srgb8`, or `linear` for PFM files.
    #[serde(default = "srgb8")]
    pub ask: String,
    /// The share of pixels that must agree for all points.
    pub share: f64,
    /// The share that earns nothing; without, that of a picture of one colour.
    #[serde(default)]
    pub none: Option<f64>,
}

/// An estimate that is asked.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EstimateFile {
    /// The light.
    pub light: String,
    /// Single samples that are asked at least.
    pub samples: u64,
    /// The error that is allowed at most, as a share of the mean.
    pub error: f64,
    /// Whether the values of single samples are asked, or their mean and their number alone.
    #[serde(default)]
    pub ask: AskedEstimate,
}

/// What of an estimate is asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AskedEstimate {
    /// The values of single samples.
    #[default]
    Samples,
    /// Their mean and how many there are: nothing tells whether it is an estimate.
    Mean,
}

/// How much a message tells about what is wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Say {
    /// Where, and no more.
    Nothing,
    /// The law.
    Law,
    /// The mistake with its formula.
    #[default]
    Bend,
}

/// A value of a setting in a task.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum SettingValue {
    /// Whole number.
    Whole(u64),
    /// Any number.
    Real(f64),
    /// Word.
    Text(String),
    /// Words.
    List(Vec<String>),
}

/// A tolerance in a task.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
pub enum ToleranceValue {
    /// Absolute.
    Absolute(f64),
    /// Absolute and relative.
    Both([f64; 2]),
}

impl std::fmt::Display for SettingValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Whole(n) => write!(f, "{n}"),
            Self::Real(x) => write!(f, "{x}"),
            Self::Text(text) => f.write_str(text),
            Self::List(words) => f.write_str(&words.join(",")),
        }
    }
}

fn yes() -> bool {
    true
}

fn half() -> u32 {
    50
}

fn srgb8() -> String {
    "srgb8".to_owned()
}
