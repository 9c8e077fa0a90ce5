//! What to do where the text of a task is none: an example of the field that is missing, the field that may be meant.

use crate::scene::read::did_you_mean::did_you_mean;

/// Examples of the fields that a task, a check or a part of one must have.
const EXAMPLES: [(&str, &str); 13] = [
    ("format", "format = \"raytree-task/1\""),
    ("name", "name = \"Hits\""),
    ("check", "a table [[check]] for each question"),
    ("id", "id = \"hits\""),
    ("points", "points = 4"),
    ("scene", "scene = \"whitted\""),
    ("count", "pixels = { count = 8, where = \"hit\" }"),
    ("file", "picture = { file = \"*.png\", share = 0.95 }"),
    ("share", "picture = { file = \"*.png\", share = 0.95 }"),
    (
        "light",
        "estimate = { light = \"lamp\", samples = 64, error = 0.1 }",
    ),
    (
        "samples",
        "estimate = { light = \"lamp\", samples = 64, error = 0.1 }",
    ),
    (
        "error",
        "estimate = { light = \"lamp\", samples = 64, error = 0.1 }",
    ),
    ("kind", "kind = \"best\""),
];

/// The parser's message with what to do.
pub fn explained(message: &str) -> String {
    // The fields that there are make a long list: where one of them is near, it says enough.
    let (what, _) = message.split_once(", expected").unwrap_or((message, ""));
    match advice(message) {
        guess if guess.ends_with('?') => format!("{what}; {guess}"),
        cure => format!("{message}; {cure}"),
    }
}

fn advice(message: &str) -> String {
    let mut names = message.split('`').skip(1).step_by(2);
    let field = names.next().unwrap_or_default();
    if message.starts_with("missing field") {
        let example = EXAMPLES.iter().find(|(name, _)| *name == field);
        if let Some((_, example)) = example {
            return format!("write {example}");
        }
    }
    if message.starts_with("unknown field")
        && let Some(near) = did_you_mean(field, names)
    {
        return format!("did you mean `{near}`?");
    }
    if message.contains("duplicate key") {
        return "write it once".to_owned();
    }
    "compare with a task that works, such as lessons/tasks/hits.toml".to_owned()
}
