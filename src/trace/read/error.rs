//! Errors of documents: where, which pixel, what is wrong, and what to do.

use std::fmt;

use super::lines::LineIndex;
use super::pixel::PixelName;
use crate::scene::read::error::{Problem, shortened, shown};

/// Why a pixel, or a file, cannot be read. Its text has two lines: where and what, then what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// The file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The byte in the line, from 1.
    pub column: usize,
    /// The path of the field, such as `root.children[1].kind`; empty if it is about none.
    pub field: String,
    /// The scene, if it was read before the error was met.
    pub scene: Option<String>,
    /// Column and row of the pixel, if they were read before the error was met.
    pub pixel: Option<(u32, u32)>,
    /// What is wrong and what to do.
    pub problem: Box<Problem>,
}

impl ReadError {
    /// About the field at a place in bytes.
    pub(super) fn new(
        file: &str,
        lines: &LineIndex,
        at: usize,
        field: String,
        problem: Problem,
    ) -> Self {
        let (line, column) = lines.position(at);
        Self {
            file: file.to_owned(),
            line,
            column,
            field,
            scene: None,
            pixel: None,
            problem: Box::new(problem),
        }
    }

    /// The error in a line, for lists of problems.
    pub fn in_a_line(&self) -> String {
        self.to_string().replacen("\n  ", "; ", 1)
    }

    /// The error as one of this pixel.
    pub(super) fn of(self, name: &PixelName) -> Self {
        Self {
            scene: name.scene.clone(),
            pixel: name.pixel,
            ..self
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let field = match shortened(&self.field) {
            field if field.is_empty() => field,
            field => format!(": {field}"),
        };
        let Self {
            file,
            line,
            column,
            problem,
            ..
        } = self;
        let what = shown(&format!("{file}:{line}:{column}{field}: {}", problem.what));
        write!(f, "{what}\n  {}", shown(&problem.cure))
    }
}

impl std::error::Error for ReadError {}
