//! Knob: a setting that users name, with its values and how it is read and written.

use std::fmt;
use std::ops::RangeInclusive;

use serde::Serialize;

use super::Settings;
use crate::scene::limits::{MAX_RADIANCE, size_problem};

/// Row of the table of knobs.
#[allow(clippy::struct_excessive_bools)] // Each is a column of the table.
#[derive(Clone, Copy, Debug)]
pub struct Knob {
    /// Name on the command line, without its dashes.
    pub flag: &'static str,
    /// Name of its value in help texts.
    pub value_name: &'static str,
    /// What it does.
    pub doc: &'static str,
    /// Heading in help texts.
    pub heading: &'static str,
    /// Kind of its values.
    pub kind: Kind,
    /// How it is read and written.
    pub field: Field,
    /// Path in the settings of a ray tree in JSON; empty for what stands elsewhere.
    pub json: &'static str,
    /// Whether scene files can set it; in them `_` stands for `-` in its name.
    pub in_files: bool,
    /// Whether it changes the picture.
    pub changes_picture: bool,
    /// Whether help texts tell the default.
    pub shows_default: bool,
    /// Flag that must be given with it.
    pub requires: Option<&'static str>,
    /// Flag that must not be given with it.
    pub conflicts_with: Option<&'static str>,
    /// Whether it sets other knobs, too, unless they are given.
    pub implies_others: bool,
    /// Values that `raytree cost` tries, the cheapest first; of a choice all.
    pub steps: &'static [&'static str],
}

/// Getter and setter of a knob.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The value now; `None` where the knob has none.
    pub get: fn(&Settings) -> Option<Value>,
    /// Sets it to a value of its kind.
    pub set: fn(&mut Settings, &Value),
}

/// Kinds of values.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Width and height in pixels.
    Size,
    /// Whole number of 32 bits.
    Count {
        /// The smallest and the largest.
        range: [u32; 2],
        /// What is counted, for messages.
        of: &'static str,
    },
    /// Whole number of 64 bits, at least this.
    Whole(u64),
    /// Number.
    Real {
        /// Whether a number is possible.
        possible: fn(f64) -> bool,
        /// Which numbers are, for messages.
        must_be: &'static str,
    },
    /// One of a few words.
    Choice(fn() -> Vec<Word>),
    /// Some of a few words.
    Choices(fn() -> Vec<Word>),
    /// Text, with what is wrong with it if anything is.
    Text(fn(&str) -> Result<(), String>),
}

/// Word that users may choose.
#[derive(Clone, Copy, Debug)]
pub struct Word {
    /// The word.
    pub name: &'static str,
    /// What it means; empty where the knob's own text says so.
    pub doc: &'static str,
}

/// Value of a knob, in JSON as users write it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// Width and height.
    Size([u32; 2]),
    /// Whole number.
    Whole(u64),
    /// Any number.
    Real(f64),
    /// Word or text.
    Text(String),
    /// Some words.
    List(Vec<String>),
}

impl Knob {
    /// Name in scene files.
    pub fn key(&self) -> String {
        self.flag.replace('-', "_")
    }

    /// Values that `raytree cost` tries, the cheapest first.
    pub fn steps(&self) -> Vec<Value> {
        match self.kind {
            Kind::Choice(words) => words().iter().map(|w| Value::Text(w.name.into())).collect(),
            kind => self
                .steps
                .iter()
                .filter_map(|text| kind.parse(text).ok())
                .collect(),
        }
    }

    /// What is wrong with a value in a scene file, and what to do; `None` if nothing is.
    pub fn problem(&self, value: &Value) -> Option<(String, String)> {
        match (self.kind, value) {
            (Kind::Size, Value::Size([width, height])) => {
                let cure = "write [width, height], such as [320, 240]";
                size_problem(*width, *height).map(|problem| (problem, cure.to_owned()))
            }
            (
                Kind::Count {
                    range: [least, most],
                    of,
                },
                Value::Whole(n),
            ) => {
                let possible = (u64::from(least)..=u64::from(most)).contains(n);
                let cure = format!("write a whole number from {least} to {most}");
                (!possible).then(|| (format!("{n} {of} are not possible"), cure))
            }
            _ => None,
        }
    }
}

impl Kind {
    /// Numbers of at least 0.
    pub const NOT_NEGATIVE: Self = Self::Real {
        possible: |x| x.is_finite() && x >= 0.0,
        must_be: "a number of at least 0",
    };

    /// Numbers above 0.
    pub const POSITIVE: Self = Self::Real {
        possible: |x| x.is_finite() && x > 0.0,
        must_be: "a number above 0",
    };

    /// Range of numbers in scene files.
    pub const FILE_RANGE: [f64; 2] = [0.0, MAX_RADIANCE];

    /// A value as users write it on a command line.
    pub fn parse(self, text: &str) -> Result<Value, String> {
        match self {
            Self::Size => parse_size(text).map(Value::Size),
            Self::Real { possible, must_be } => match text.parse::<f64>() {
                Ok(x) if possible(x) => Ok(Value::Real(x)),
                _ => Err(format!("must be {must_be}")),
            },
            Self::Count { range, .. } => {
                let [least, most] = range.map(u64::from);
                parse_whole(text, least..=most).map(Value::Whole)
            }
            Self::Whole(least) => parse_whole(text, least..=u64::MAX).map(Value::Whole),
            Self::Text(check) => check(text).map(|()| Value::Text(text.to_owned())),
            Self::Choice(_) | Self::Choices(_) => Ok(Value::Text(text.to_owned())),
        }
    }
}

impl Value {
    /// True for this word.
    pub fn is(&self, word: &str) -> bool {
        matches!(self, Self::Text(text) if text == word)
    }
}

/// A whole number of this range, or which numbers are possible.
pub fn parse_whole(text: &str, range: RangeInclusive<u64>) -> Result<u64, String> {
    let number = text.parse().ok().filter(|n| range.contains(n));
    number.ok_or_else(|| match (*range.start(), *range.end()) {
        (0, u64::MAX) => format!("must be a whole number, {} at most", u64::MAX),
        (least, u64::MAX) => format!("must be a whole number, at least {least}"),
        (least, most) => format!("must be a whole number from {least} to {most}"),
    })
}

fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let wrong = || format!("`{text}` is no size; write WIDTHxHEIGHT, such as 320x240");
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
    let number = |digits: &str| digits.trim().parse::<u32>().map_err(|_| wrong());
    let (width, height) = (number(width)?, number(height)?);
    size_problem(width, height).map_or(Ok([width, height]), Err)
}

/// As on the command line.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Size([width, height]) => write!(f, "{width}x{height}"),
            Self::Whole(number) => number.fmt(f),
            Self::Real(number) => number.fmt(f),
            Self::Text(text) => f.write_str(text),
            Self::List(words) => f.write_str(&words.join(",")),
        }
    }
}
