//! From text to a scene file, and from the parser's words to those of someone who learns.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};

use super::SceneFile;
use crate::scene::error::{Problem, SceneError};
use crate::scene::limits::MAX_GROUP_DEPTH;
use crate::scene::nearest::nearest;

/// Reads a scene file. `file` is its name in error messages.
pub fn parse(text: &str, file: &str) -> Result<SceneFile, SceneError> {
    if text.trim().is_empty() {
        return Err(Problem::new(
            "the file is empty",
            "start with {\"format\": \"raytree-scene/1\", \"camera\": {\"eye\": [0, 1, 5], \"look_at\": [0, 1, 0]}}",
        )
        .in_file(file));
    }
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let scene = serde_path_to_error::deserialize(&mut deserializer).map_err(|e| {
        let field = match e.path().to_string() {
            path if path == "." => String::new(),
            path => path,
        };
        explained(e.inner(), text, file, field)
    })?;
    deserializer
        .end()
        .map_err(|e| explained(&e, text, file, String::new()))?;
    Ok(scene)
}

/// The parser's error with its place and a cure.
fn explained(error: &serde_json::Error, text: &str, file: &str, field: String) -> SceneError {
    let (line, column) = (error.line(), error.column());
    let message = error.to_string();
    let place = format!(" at line {line} column {column}");
    let what = message.strip_suffix(&place).unwrap_or(&message);
    SceneError {
        position: (line > 0).then_some((line, column)),
        problem: problem(what, word_at(text, line, column), &field),
        field,
        file: file.to_string(),
    }
}

/// The parser's message in plain words, and what to do. `word` is what stands at the place of the error.
fn problem(what: &str, word: &str, field: &str) -> Problem {
    let quoted: Vec<&str> = what.split('`').skip(1).step_by(2).collect();
    let (name, known) = quoted.split_first().map_or(("", &[][..]), |(n, k)| (*n, k));
    let starts = |prefix: &str| what.starts_with(prefix);

    if field == "format" && !starts("missing") {
        return Problem::new(
            format!("the format `{name}` is not known here"),
            "write \"format\": \"raytree-scene/1\"",
        );
    }
    if starts("unknown field") || starts("unknown variant") {
        let kind = if starts("unknown field") {
            "field"
        } else {
            "kind"
        };
        let list = known.join(", ");
        let cure = match nearest(name, known.iter().copied()) {
            Some(near) => format!("did you mean `{near}`? Possible here: {list}"),
            None => format!("possible here: {list}"),
        };
        return Problem::new(format!("there is no {kind} `{name}`"), cure);
    }
    if starts("missing field") {
        return Problem::new(
            format!("the field `{name}` is missing"),
            format!("add \"{name}\": ... to this object"),
        );
    }
    if starts("duplicate field") {
        return Problem::new(
            format!("`{name}` is given twice"),
            "keep one of them, or give the other a different name",
        );
    }
    if matches!(
        word.to_ascii_lowercase().trim_start_matches(['-', '+']),
        "nan" | "inf" | "infinity"
    ) {
        return Problem::new(
            format!("`{word}` is not a number in JSON"),
            "write a finite number, such as 0 or 1.5",
        );
    }
    let (what, cure) = match what {
        _ if starts("EOF") => (
            "the file ends in the middle".to_string(),
            "close every bracket and every quotation mark that was opened; perhaps the file was cut off",
        ),
        _ if starts("number out of range") => (
            "the number is too large".to_string(),
            "write a number between -1e12 and 1e12",
        ),
        _ if starts("recursion limit") => ("the file is nested too deeply".to_string(), TOO_DEEP),
        _ if starts("trailing comma") => (
            "there is a comma before a closing bracket".to_string(),
            "take the comma away: in JSON it stands only between two things",
        ),
        _ if starts("trailing characters") => (
            "something stands after the end of the scene".to_string(),
            "a file holds one object {...}: take away what comes after it",
        ),
        _ if starts("key must be a string") => (
            "a name without quotation marks".to_string(),
            "write names in double quotation marks, such as \"radius\": 1",
        ),
        _ if word.starts_with(['/', '#']) => (
            "JSON has no comments".to_string(),
            "use the field \"note\" of an object instead",
        ),
        _ if word.starts_with('\'') => (
            "JSON has no single quotation marks".to_string(),
            "write \"...\" instead of '...'",
        ),
        _ if starts("expected value") && word.starts_with(',') => (
            "a second field stands beside the kind of an object".to_string(),
            "one object has one kind: put everything inside, such as {\"sphere\": {\"name\": ..., \"note\": ...}}",
        ),
        _ if starts("invalid length") => (
            in_plain_words(what),
            "points, vectors and colours have three numbers, such as [0, 1, 0]",
        ),
        _ if starts("invalid type: map, expected unit") || starts("invalid type: null") => (
            in_plain_words(what),
            "write a value here, or leave the field out",
        ),
        _ if starts("invalid") => (
            in_plain_words(what),
            "change the value to what is expected here",
        ),
        _ if starts("expected `,`") => (
            "a comma or a closing bracket is missing".to_string(),
            "look at the end of the line before, too",
        ),
        _ if starts("expected `:`") => (
            "a colon is missing between a name and its value".to_string(),
            "write \"name\": value",
        ),
        _ if starts("control character") => (
            "a line ends, or a tab stands, inside a string".to_string(),
            "close the quotation mark on the same line; write \\n and \\t for line ends and tabs",
        ),
        _ => (
            format!("this is not JSON: {what}"),
            "compare with a scene that works, such as those in the folder `scenes`",
        ),
    };
    Problem::new(what, cure)
}

const TOO_DEEP: &str = "put groups at most 32 deep into each other";
const _: () = assert!(MAX_GROUP_DEPTH == 32, "the sentence above says so");

/// The parser's names of types, for people who do not write Rust.
fn in_plain_words(what: &str) -> String {
    const WORDS: [(&str, &str); 16] = [
        ("invalid type: ", "here stands "),
        ("invalid value: ", "here stands "),
        ("invalid length ", "the list has the length "),
        (", expected an array of length ", " instead of "),
        (", expected ", ", where this is expected: "),
        ("struct SceneFile", "a scene {...}"),
        ("struct SettingsFile", "an object {...}"),
        ("struct ", "an object {...} for "),
        ("floating point ", "the number "),
        ("integer ", "the number "),
        ("a sequence", "a list"),
        ("sequence", "a list [...]"),
        ("map", "an object {...}"),
        ("f64", "a number"),
        ("u32", "a whole number from 0 to 4294967295"),
        ("u64", "a whole number from 0 up"),
    ];
    WORDS
        .iter()
        .fold(what.to_string(), |text, (from, to)| text.replace(from, to))
}

/// The word, number or sign at a place in the text, counted from 1.
fn word_at(text: &str, line: usize, column: usize) -> &str {
    let Some(line) = text.lines().nth(line.saturating_sub(1)) else {
        return "";
    };
    let bytes = line.as_bytes();
    let in_word = |i: usize| {
        bytes
            .get(i)
            .is_some_and(|b| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'+' | b'.'))
    };
    let mut start = column.saturating_sub(1).min(bytes.len());
    while start > 0 && in_word(start) && in_word(start - 1) {
        start -= 1;
    }
    let mut end = start + 1;
    while in_word(start) && in_word(end) {
        end += 1;
    }
    line.get(start..end).unwrap_or("")
}

/// A JSON object as a map, in which no name may stand twice: by itself, the parser would keep the last.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_word_at_a_place_is_found() {
        let text = "{\n  \"a\": -Infinity,\n}";
        assert_eq!(word_at(text, 2, 8), "-Infinity");
        assert_eq!(word_at(text, 2, 12), "-Infinity");
        assert_eq!(word_at(text, 2, 17), ",");
        assert_eq!(word_at(text, 9, 9), "");
        assert_eq!(word_at("é", 1, 2), "");
    }
}
