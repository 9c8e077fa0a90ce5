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

/// What to do about the parser's message.
pub fn advice(message: &str) -> String {
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

#[cfg(test)]
mod tests {
    use crate::grade::task::parse::parse;

    #[test]
    fn what_is_wrong_with_a_task_is_told_with_a_cure() {
        for (text, what, cure) in [
            ("", "`format`", "write format = \"raytree-task/1\""),
            ("format = \"raytree-task/1\"", "`name`", "write name = "),
            (
                "format = \"raytree-task/1\"\nname = \"a\"",
                "`check`",
                "[[check]]",
            ),
            (
                "format = \"raytree-task/1\"\nname = \"a\"\n[[check]]\nid = \"a\"\nscene = \"b\"",
                "`points`",
                "write points = 4",
            ),
            ("nam = \"a\"", "`nam`", "did you mean `name`?"),
            ("{\"nam\": 1}", "`nam`", "did you mean `name`?"),
            ("{\"name\": \"a\"}", "`format`", "raytree-task/1"),
            ("name = ", "line 1", "lessons/tasks/hits.toml"),
            ("{\"name\": 1", "is no JSON", "lessons/tasks/hits.toml"),
        ] {
            let said = parse(text).expect_err(text);
            assert!(said.contains(what) && said.contains(cure), "{text}: {said}");
            assert!(!said.contains('\n'), "{said}");
        }
    }
}
