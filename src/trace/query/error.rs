//! Errors of queries: at which letter, what is wrong, what to do.

use std::fmt;

use crate::scene::read::error::shown;

/// Why a text is no query.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QueryError {
    /// The number of letters before the mistake.
    pub at: usize,
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub cure: String,
}

impl fmt::Display for QueryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A query may come from a file: nothing of it steers a terminal.
        let text = format!("letter {}: {}; {}", self.at + 1, self.what, self.cure);
        f.write_str(&shown(&text))
    }
}

impl std::error::Error for QueryError {}

/// An error behind so many letters.
pub fn error(at: usize, what: impl Into<String>, cure: impl Into<String>) -> QueryError {
    QueryError {
        at,
        what: what.into(),
        cure: cure.into(),
    }
}
