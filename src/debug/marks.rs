//! Marks: places in ray trees with notes, in a small file: what a student hands in with a question.

use serde::{Deserialize, Serialize};

use crate::scene::printable::printable;
use crate::trace::Address;

/// Name of the format.
const FORMAT: &str = "raytree-marks/1";

/// Marks of a file, and letters of a note, at most.
const MOST_MARKS: usize = 10_000;
const MOST_LETTERS: usize = 2_000;

/// Bytes of a file of marks at most.
pub const MAX_MARKS_BYTES: u64 = 4 << 20;

/// Marks in the pictures of a scene, in the order in which they were made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Marks {
    /// Always `raytree-marks/1`.
    format: String,
    /// The scene, as on the command line.
    pub scene: String,
    /// Width and height of the picture.
    pub size: [u32; 2],
    /// The marks.
    pub marks: Vec<Mark>,
}

/// A place with a note.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// The pixel, the ray and the event.
    pub address: String,
    /// What is said of it.
    #[serde(default)]
    pub note: String,
    /// The command that opens the debugger there, with the settings of that time.
    #[serde(default)]
    pub command: String,
}

impl Marks {
    /// No marks in a picture of this size.
    pub fn new(scene: &str, (width, height): (u32, u32)) -> Self {
        Self {
            format: FORMAT.to_owned(),
            scene: scene.to_owned(),
            size: [width, height],
            marks: Vec::new(),
        }
    }

    /// Reads a file of marks. Nothing in it is trusted: an error says what is wrong.
    pub fn from_json(text: &str) -> Result<Self, String> {
        let marks: Self = serde_json::from_str(text)
            .map_err(|error| printable(&error.to_string()).into_owned())?;
        if marks.format != FORMAT {
            return Err(format!("`format` is not {FORMAT}"));
        }
        if marks.marks.len() > MOST_MARKS {
            return Err(format!("has more than {MOST_MARKS} marks"));
        }
        for (number, mark) in marks.marks.iter().enumerate() {
            let parsed = mark.address.parse::<Address>();
            parsed.map_err(|error| format!("mark {number}: {error}"))?;
            if mark.note.chars().count() > MOST_LETTERS {
                return Err(format!(
                    "mark {number}: its note has more than {MOST_LETTERS} letters"
                ));
            }
        }
        Ok(marks)
    }

    /// The file.
    pub fn to_json(&self) -> String {
        // Plain data without maps: it cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// A mark in words: its number, of how many, and its note.
    pub fn told(&self, number: usize) -> String {
        let note = self.marks.get(number).map_or("", |mark| &mark.note);
        let note = printable(note);
        format!("mark {} of {}: {note}", number + 1, self.marks.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_read_as_they_are_written() {
        let mut marks = Marks::new("whitted", (80, 42));
        let mark = Mark {
            address: "45,31/R#27".to_owned(),
            note: "why so dark?".to_owned(),
            command: "raytree view whitted".to_owned(),
        };
        marks.marks.push(mark);
        assert_eq!(Marks::from_json(&marks.to_json()), Ok(marks.clone()));
        assert_eq!(marks.told(0), "mark 1 of 1: why so dark?");
    }

    #[test]
    fn what_is_no_file_of_marks_is_told() {
        let with = |marks: &str| {
            format!(
                r#"{{"format": "raytree-marks/1", "scene": "a", "size": [1, 2], "marks": {marks}}}"#
            )
        };
        for (text, told) in [
            ("[".to_owned(), "EOF"),
            (with("[]").replace("marks/1", "marks/9"), "`format` is not"),
            (with(r#"[{"address": "x"}]"#), "mark 0: `x` is no pixel"),
            (with(r#"[{"address": "1,2", "more": 1}]"#), "unknown field"),
            (
                with(&format!(
                    r#"[{{"address": "1,2", "note": "{}"}}]"#,
                    "a".repeat(3000)
                )),
                "more than 2000",
            ),
        ] {
            let error = Marks::from_json(&text).expect_err("refused");
            assert!(error.contains(told), "{error}");
        }
        assert!(Marks::from_json(&with("[]")).is_ok());
    }
}
