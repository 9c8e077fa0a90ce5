//! Files that are no scene but something else that this program writes or takes, by the format that they name.

use std::cell::Cell;
use std::fmt;

use serde::de::{Deserializer as _, IgnoredAny, MapAccess, Visitor};

use crate::scene::read::error::Problem;

/// What a text is if it names another format than that of scenes, and which command takes it.
pub fn other_format(text: &str) -> Option<Problem> {
    let named = format_of(text)?;
    let (what, cure) = match named.as_str() {
        "raytree/1" => (
            "this is a ray tree, not a scene",
            "compare it with `raytree diff SCENE@X,Y FILE`, or mark it with `raytree grade TASK FILE`",
        ),
        "raytree-flat/1" => (
            "this is a flat scene, which raytree writes for other programs and does not read",
            "name the scene that it was made from, by `raytree scenes SCENE --flat`",
        ),
        "raytree-task/1" => (
            "this is a task for students, not a scene",
            "mark what they hand in with `raytree grade FILE SUBMISSION...`",
        ),
        "raytree-marks/1" => (
            "these are marks that the debugger wrote, not a scene",
            "open them with `raytree view SCENE --marks FILE`",
        ),
        "raytree-grade/1" => (
            "this is what a task came to, not a scene",
            "put it together with others by `raytree grade --merge FILE...`",
        ),
        "raytree-diff/1" | "raytree-find/1" => (
            "this is the result of a command, not a scene",
            "name a built-in scene, or a file in the format raytree-scene/1",
        ),
        _ => return None,
    };
    Some(Problem::new(what, cure))
}

/// What stands in the field `format` of an object, as far as the text can be read.
fn format_of(text: &str) -> Option<String> {
    let found = FormatField(Cell::new(None));
    // The field counts even if what follows it is broken.
    let _ = serde_json::Deserializer::from_str(text).deserialize_map(&found);
    found.0.take()
}

struct FormatField(Cell<Option<String>>);

impl<'de> Visitor<'de> for &FormatField {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            if key == "format" {
                self.0.set(Some(map.next_value()?));
                return Ok(());
            }
            map.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_format_is_found_wherever_it_stands() {
        for text in [
            r#"{"format": "raytree/1", "root": {"#,
            r#"{"scene": {"a": [1, {"format": 2}]}, "format": "raytree/1"}"#,
            "{\"format\": \"raytree/1\"}\n{\"format\": \"other\"}",
        ] {
            let problem = other_format(text).expect(text);
            assert!(problem.what.contains("ray tree"), "{text}");
        }
        for text in [
            "",
            "[]",
            "{}",
            r#"{"format": 1}"#,
            r#"{"format": "raytree-scene/1"}"#,
            r#"{"note": "raytree/1", "format": "raytree-scene/2"}"#,
        ] {
            assert_eq!(other_format(text), None, "{text}");
        }
    }
}
