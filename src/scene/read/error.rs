//! Errors of scenes: where, what is wrong, and what to do.

use std::fmt;

use crate::scene::printable::printable;

/// Error of a scene. Its text has two lines: where and what, then what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// The file, or the name of the built-in scene.
    pub file: String,
    /// Line and column, from 1, if they are known; a column of 0 stands for the whole line.
    pub position: Option<(usize, usize)>,
    /// The path of the field, such as `objects[3].sphere.radius`; empty if it is not about a field.
    pub field: String,
    /// What is wrong and what to do.
    pub problem: Problem,
}

/// What is wrong, and what to do about it, as plain sentences without a full stop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub cure: String,
}

impl Problem {
    /// A problem and its cure.
    pub fn new(what: impl Into<String>, cure: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            cure: cure.into(),
        }
    }

    /// The problem as one of a whole file.
    pub fn in_file(self, file: &str) -> SceneError {
        SceneError {
            file: file.to_string(),
            position: None,
            field: String::new(),
            problem: self,
        }
    }

    /// The problem as one of a line of a file.
    pub fn in_line(self, file: &str, line: usize) -> SceneError {
        SceneError {
            position: Some((line, 0)),
            ..self.in_file(file)
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n  {}", first_line(self), shown(&self.problem.cure))
    }
}

/// Where and what.
pub fn first_line(error: &SceneError) -> String {
    let position = match error.position {
        Some((line, 0)) => format!(":{line}"),
        Some((line, column)) => format!(":{line}:{column}"),
        None => String::new(),
    };
    let field = match shortened(&error.field) {
        field if field.is_empty() => field,
        field => format!(": {field}"),
    };
    shown(&format!(
        "{}{position}{field}: {}",
        error.file, error.problem.what
    ))
}

impl std::error::Error for SceneError {}

/// Long path, shortened to its beginning and its end.
pub fn shortened(path: &str) -> String {
    const ENDS: usize = 60;
    let letters: Vec<char> = path.chars().collect();
    if letters.len() <= 2 * ENDS + 3 {
        return path.to_string();
    }
    let start: String = letters[..ENDS].iter().collect();
    let end: String = letters[letters.len() - ENDS..].iter().collect();
    format!("{start}...{end}")
}

/// Printable text of a message, cut at 600 letters.
pub fn shown(text: &str) -> String {
    const LENGTH: usize = 600;
    match text.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{}...", printable(&text[..end])),
        None => printable(text).into_owned(),
    }
}

/// Path of a field in a scene file, such as `objects[3].sphere.radius`, from which longer paths are made.
#[derive(Clone, Debug)]
pub struct FieldPath<'a> {
    file: &'a str,
    path: String,
}

impl<'a> FieldPath<'a> {
    /// The whole file.
    pub fn root(file: &'a str) -> Self {
        Self {
            file,
            path: String::new(),
        }
    }

    /// The path as text.
    pub fn text(&self) -> &str {
        &self.path
    }

    /// The field `key` of the object at this path.
    pub fn key(&self, key: &str) -> Self {
        let dot = if self.path.is_empty() { "" } else { "." };
        Self {
            file: self.file,
            path: format!("{}{dot}{key}", self.path),
        }
    }

    /// The element `index` of the list at this path.
    pub fn index(&self, index: usize) -> Self {
        Self {
            file: self.file,
            path: format!("{}[{index}]", self.path),
        }
    }

    /// Error about this field.
    pub fn error(&self, what: impl Into<String>, cure: impl Into<String>) -> SceneError {
        self.wrap(Problem::new(what, cure))
    }

    /// The problem as one of this field.
    pub fn wrap(&self, problem: Problem) -> SceneError {
        SceneError {
            field: self.path.clone(),
            ..problem.in_file(self.file)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_says_where_what_and_the_cure() {
        let path = FieldPath::root("a.json")
            .key("objects")
            .index(3)
            .key("radius");
        let error = path.error("is 0", "make it larger");
        assert_eq!(
            error.to_string(),
            "a.json: objects[3].radius: is 0\n  make it larger"
        );
        let line = Problem::new("odd", "mend it").in_line("b.obj", 7);
        assert_eq!(line.to_string(), "b.obj:7: odd\n  mend it");
    }

    #[test]
    fn no_escape_sequence_reaches_a_terminal() {
        let error = Problem::new("\u{1b}[2J", "\u{202e}").in_file("a\nb");
        let shown = "a\\nb: \\u{1b}[2J\n  \\u{202e}";
        assert_eq!(error.to_string(), shown);
    }
}
