//! Marks as a document, `raytree-grade/1`, for programs. The order is that of the task and of the command line; no time, no path,
//! no host: the same bytes everywhere.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::grade::marks::QuantityCounts;

/// The name of the format.
pub const FORMAT: &str = "raytree-grade/1";

/// Marks of submissions of a task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradeDocument {
    /// Always `raytree-grade/1`.
    pub format: String,
    /// Whom it is for.
    pub r#for: Readers,
    /// Which part of all submissions this is, and of how many parts; none if it is all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shard: Option<[usize; 2]>,
    /// The task.
    pub task: TaskName,
    /// The program that marked them.
    pub program: String,
    /// The submissions.
    pub submissions: Vec<GradedSubmission>,
    /// Mistakes that nothing explains and that several submissions share.
    pub unknown: Vec<UnknownGroup>,
}

/// Whom a document is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Readers {
    /// Everything is in it.
    Teachers,
    /// Hidden checks have points alone.
    Students,
}

/// Which task it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TaskName {
    /// Its name.
    pub name: String,
    /// BLAKE3 of its file.
    pub hash: String,
}

/// A submission with its marks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradedSubmission {
    /// Its name.
    pub name: String,
    /// The student's id in the course's list.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// Points.
    pub score: Milli,
    /// Points at most.
    pub max: Milli,
    /// Percent, rounded down.
    pub percent: u64,
    /// One for each check of the task.
    pub checks: Vec<GradedCheck>,
    /// The mistakes that explain it.
    pub bends: Vec<NamedBends>,
    /// What is said of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// What could not be read.
    pub problems: Vec<String>,
}

/// A check with its mark.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradedCheck {
    /// Its name.
    pub id: String,
    /// For people.
    pub title: String,
    /// Points.
    pub score: Milli,
    /// Points at most.
    pub max: Milli,
    /// `full`, `partial`, `none`, `skipped` or `broken`.
    pub status: String,
    /// Whether students see values and addresses.
    pub visible: bool,
    /// The rest; not there if it is hidden from the reader.
    #[serde(flatten)]
    pub shown: Option<ShownCheck>,
}

/// What is told of a check that is not hidden.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShownCheck {
    /// Quantities by what they came to.
    pub counts: QuantityCounts,
    /// Why it is broken or skipped, how a picture agrees.
    pub note: String,
    /// First causes.
    pub causes: Vec<GradedCause>,
}

/// A law that is broken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradedCause {
    /// Where.
    pub address: String,
    /// The law; not there if the task does not tell it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub law: Option<String>,
    /// The quantity.
    pub quantity: String,
    /// Our value.
    pub ours: Value,
    /// The student's value.
    pub theirs: Value,
    /// Their value over ours, to two digits; `-` if there is none.
    pub ratio: String,
    /// How far it is off.
    pub off: Option<f64>,
    /// The unit of `off`.
    pub unit: Option<String>,
    /// The mistakes that give just that.
    pub as_if: Vec<String>,
}

/// Mistakes that explain a submission.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct NamedBends {
    /// Any of these may be it.
    pub names: Vec<String>,
    /// Numbers that tell the first from a right tracer.
    pub telling: u64,
    /// Of these, those that it explains.
    pub explained: u64,
}

/// A cause that several submissions share.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct UnknownGroup {
    /// The law.
    pub law: String,
    /// The quantity.
    pub quantity: String,
    /// The students' value over ours, to two digits.
    pub ratio: String,
    /// The submissions.
    pub submissions: Vec<String>,
    /// Where it shows first.
    pub address: String,
}

/// Thousandths of a point; written in points: `4`, `6.536`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Milli(pub u64);

impl Serialize for Milli {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        if self.0.is_multiple_of(1000) {
            to.serialize_u64(self.0 / 1000)
        } else {
            to.serialize_f64(self.0 as f64 / 1000.0)
        }
    }
}

impl<'de> Deserialize<'de> for Milli {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let points = f64::deserialize(from)?;
        Ok(Self((points * 1000.0).round() as u64))
    }
}
