//! Values that are asked of the tracer, in the language of directives: `trace 100,160/L:lamp.t`, `count hits:sail`,
//! `tests-per-ray accel=bvh`. Settings for it stand behind as NAME=VALUE.

use super::files::clean;
use crate::scene::printable::excerpt;
use crate::scene::settings::knobs::knob;
use crate::trace::address::AddressPart;
use crate::trace::{Address, TreeQuery};

/// A value, and the settings that it is computed with.
#[derive(Clone, Debug, PartialEq)]
pub struct LessonValue {
    /// What is asked.
    pub what: AskedValue,
    /// What is asked, as it is written.
    pub words: String,
    /// Another scene, as it is written.
    pub scene: Option<String>,
    /// Settings by the names of flags.
    pub settings: Vec<(String, String)>,
    /// Digits behind the point, where it is shown.
    pub digits: Option<usize>,
}

/// What is asked.
#[derive(Clone, Debug, PartialEq)]
pub enum AskedValue {
    /// A field of a ray.
    Field(Address, String),
    /// The number of pixels that satisfy a query.
    Count(TreeQuery),
    /// A counter of the whole picture.
    Counter(Counter),
}

/// A counter of the whole picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Counter {
    /// Rays of all kinds.
    Rays,
    /// Nodes visited.
    Nodes,
    /// Shapes tested.
    Tests,
    /// Rays over pixels.
    RaysPerPixel,
    /// Nodes over rays.
    NodesPerRay,
    /// Tests over rays.
    TestsPerRay,
}

impl LessonValue {
    /// The field of a ray by its address, such as `100,160/L:lamp.lit`.
    pub fn field(address: &str) -> Result<Self, String> {
        Self::parse(&format!("trace {address}"))
    }

    /// A value from its text.
    pub fn parse(text: &str) -> Result<Self, String> {
        let (words, settings) = words_and_settings(text);
        let mut asked = Self {
            what: what(&words)?,
            words,
            scene: None,
            settings: Vec::new(),
            digits: None,
        };
        for (name, value) in settings {
            match name.as_str() {
                "S" => asked.scene = Some(value),
                "digits" => {
                    let digits: Option<usize> = value.parse().ok().filter(|n| *n <= 15);
                    asked.digits = Some(digits.ok_or("`digits` is a number from 0 to 15")?);
                }
                _ => asked.settings.push((name, value)),
            }
        }
        Ok(asked)
    }

    /// What is asked, for a sentence.
    pub fn name(&self) -> String {
        match &self.what {
            AskedValue::Field(address, _) => address.to_string(),
            AskedValue::Count(_) => {
                let query = self.words.strip_prefix("count ").unwrap_or(&self.words);
                format!("the number of pixels with {}", clean(query))
            }
            AskedValue::Counter(counter) => {
                let name: &'static str = counter.into();
                name.replace('-', " ")
            }
        }
    }
}

/// What the words of a value ask.
fn what(words: &str) -> Result<AskedValue, String> {
    let (first, rest) = words.split_once(' ').unwrap_or((words, ""));
    match first {
        "trace" => {
            let address: Address = rest.trim().parse()?;
            match &address.part {
                Some(AddressPart::Field(name)) => {
                    let name = name.clone();
                    Ok(AskedValue::Field(address, name))
                }
                _ => Err(format!(
                    "`{}` names no field; write one behind the ray, such as 160,120.t",
                    excerpt(rest)
                )),
            }
        }
        "count" => {
            let query = rest.trim().parse();
            let query = query.map_err(|e: crate::trace::query::QueryError| e.to_string())?;
            Ok(AskedValue::Count(query))
        }
        "error" => what(&format!("trace {}.error", rest.trim())),
        _ if rest.is_empty() && first.parse::<Counter>().is_ok() => {
            let counter = first.parse().map_err(|_| String::new())?;
            Ok(AskedValue::Counter(counter))
        }
        _ => Err(format!(
            "`{}` is no value; there are trace RAY.FIELD, count QUERY, error X,Y, rays, nodes, tests, rays-per-pixel, \
             nodes-per-ray, tests-per-ray",
            excerpt(words)
        )),
    }
}

/// A text without the settings behind it, and these. (In a query, `t=1` compares: settings are those with names of flags.)
pub fn words_and_settings(text: &str) -> (String, Vec<(String, String)>) {
    let mut words: Vec<&str> = text.split_whitespace().collect();
    let mut settings = Vec::new();
    while let Some((name, value)) = words.last().and_then(|word| word.split_once('=')) {
        let is_setting =
            matches!(name, "S" | "digits" | "show" | "mark" | "raster") || knob(name).is_some();
        if !is_setting || words.len() == 1 {
            break;
        }
        settings.insert(0, (name.to_owned(), value.to_owned()));
        words.pop();
    }
    (words.join(" "), settings)
}
