//! Errors of queries: at which letter, what is wrong, what to do.

use std::fmt;

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
        write!(f, "letter {}: {}; {}", self.at + 1, self.what, self.cure)
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
