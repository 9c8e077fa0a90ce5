//! Parsing of a scene file from its text.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{
    Deserialize, DeserializeSeed as _, Deserializer, Error, IgnoredAny, MapAccess, Visitor,
};
use serde_json::error::Category;

use super::SceneFile;
use super::other_format::other_format;
use super::shape::{Comparison, Part};
use super::syntax::{self, word_at};
use crate::scene::read::error::{Problem, SceneError};

/// Reads a scene file. `file` is its name in error messages.
pub fn parse(text: &str, file: &str) -> Result<SceneFile, SceneError> {
    if text.trim().is_empty() {
        return Err(Problem::new(
            "the file is empty",
            "start with {\"format\": \"raytree-scene/1\", \"camera\": {\"eye\": [0, 1, 5], \"look_at\": [0, 1, 0]}}",
        )
        .in_file(file));
    }
    if !text.trim_start().starts_with('{') {
        return Err(Problem::new(
            "this is not a scene: a scene is one object {...}",
            "check that it is the right file; a scene begins with {\"format\": \"raytree-scene/1\", ...",
        )
        .in_file(file));
    }
    let mut deserializer = serde_json::Deserializer::from_str(text);
    SceneFile::deserialize(&mut deserializer)
        .and_then(|scene| deserializer.end().map(|()| scene))
        .map_err(|error| explained(&error, text, file))
}

/// The parser's error with its line, its path and a cure.
fn explained(error: &serde_json::Error, text: &str, file: &str) -> SceneError {
    if let Some(problem) = other_format(text) {
        return problem.in_file(file);
    }
    let place = Comparison::default();
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let compared = Part::scene(&place)
        .deserialize(&mut deserializer)
        .and_then(|()| deserializer.end());
    let error = compared.as_ref().err().unwrap_or(error);
    // A field that is missing may stand behind a bracket that is: that is told first.
    if error.classify() == Category::Data
        && let Err(broken) = serde_json::from_str::<IgnoredAny>(text)
    {
        return unreadable(&broken, text, file);
    }
    let problem = place.problem.take();
    let problem = problem.unwrap_or_else(|| syntax_problem(error, text));
    SceneError {
        position: position(error, text),
        problem,
        field: place.path(),
        file: file.to_string(),
    }
}

/// The error of a text that is no JSON.
fn unreadable(error: &serde_json::Error, text: &str, file: &str) -> SceneError {
    SceneError {
        position: position(error, text),
        problem: syntax_problem(error, text),
        field: String::new(),
        file: file.to_string(),
    }
}

/// Line and column of an error; of a text that breaks off those behind its last letter.
fn position(error: &serde_json::Error, text: &str) -> Option<(usize, usize)> {
    if error.classify() == Category::Eof {
        let text = text.trim_end();
        let last = text.lines().last().unwrap_or_default();
        return Some((text.lines().count().max(1), last.len() + 1));
    }
    let (line, column) = (error.line(), error.column());
    (line > 0).then_some((line, column))
}

/// What the parser says, in plain words.
fn syntax_problem(error: &serde_json::Error, text: &str) -> Problem {
    let (line, column) = (error.line(), error.column());
    let message = error.to_string();
    let position = format!(" at line {line} column {column}");
    let what = message.strip_suffix(&position).unwrap_or(&message);
    syntax::problem(what, word_at(text, line, column))
}

/// A JSON object as a map, in which no name may stand twice (serde would keep the last).
pub fn map_without_duplicates<'de, D, T>(deserializer: D) -> Result<BTreeMap<String, T>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    struct Unique<T>(std::marker::PhantomData<T>);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for Unique<T> {
        type Value = BTreeMap<String, T>;

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str("an object {...} with a name for each entry")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
            let mut map = BTreeMap::new();
            while let Some(name) = entries.next_key::<String>()? {
                if map.contains_key(&name) {
                    return Err(A::Error::custom(format!("duplicate field `{name}`")));
                }
                map.insert(name, entries.next_value()?);
            }
            Ok(map)
        }
    }

    deserializer.deserialize_map(Unique(std::marker::PhantomData))
}
