//! What is not understood in a document: fields that hold no value of their kind, fields that are unknown. The rest is read.

use super::limits::MAX_PROBLEMS;
use super::place::FieldPlace;
use super::value::JsonValue;
use crate::scene::printable::excerpt;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::{Problem, shortened};

/// What was met in a document.
#[derive(Debug, Default)]
pub struct ReadNotes {
    told: Vec<String>,
    untold: usize,
    unknown: usize,
    /// The first unknown field, with a guess.
    first_unknown: String,
}

/// Why a pixel cannot be read at all.
#[derive(Debug)]
pub struct Broken {
    /// The path of the field.
    pub field: String,
    /// Where, in bytes.
    pub at: usize,
    /// What is wrong and what to do.
    pub problem: Problem,
}

impl Broken {
    /// About a value at a place.
    pub fn new(value: JsonValue, place: &FieldPlace, what: impl Into<String>, cure: &str) -> Self {
        Self {
            field: place.to_string(),
            at: value.at(),
            problem: Problem::new(what, cure),
        }
    }
}

impl ReadNotes {
    /// Notes what a field is in the place of what is wanted.
    pub fn wrong(&mut self, place: &FieldPlace, what: impl FnOnce() -> String) {
        if self.told.len() >= MAX_PROBLEMS {
            self.untold += 1;
            return;
        }
        let path = excerpt(&shortened(&place.to_string()));
        self.told.push(format!("`{path}` {}", what()));
    }

    /// Notes a field that the format does not have.
    pub fn unknown(&mut self, place: &FieldPlace, name: &str, known: &[&str]) {
        self.unknown += 1;
        if self.unknown == 1 {
            let path = excerpt(&shortened(&place.key(name).to_string()));
            let guess = did_you_mean(name, known.iter().copied());
            let guess = guess.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
            self.first_unknown = format!("`{path}`{guess}");
        }
    }

    /// All of it in sentences.
    pub fn sentences(self) -> Vec<String> {
        let mut told = self.told;
        if self.untold > 0 {
            told.push(format!(
                "{} more fields hold no value of their kind",
                self.untold
            ));
        }
        match self.unknown {
            0 => {}
            1 => told.push(format!("1 unknown field: {}", self.first_unknown)),
            n => told.push(format!(
                "{n} unknown fields, the first is {}",
                self.first_unknown
            )),
        }
        told
    }

    /// Adds the notes of another line about the same pixel.
    pub fn add(&mut self, other: Self) {
        for told in other.told {
            if self.told.len() < MAX_PROBLEMS {
                self.told.push(told);
            } else {
                self.untold += 1;
            }
        }
        self.untold += other.untold;
        if self.unknown == 0 {
            self.first_unknown = other.first_unknown;
        }
        self.unknown += other.unknown;
    }
}
