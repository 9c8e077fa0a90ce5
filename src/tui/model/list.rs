//! List over the panes, one line of which is chosen: places to go to.

use crate::trace::Address;

/// A list with its title.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaceList {
    /// What it lists.
    pub title: String,
    /// What stands above it.
    pub head: String,
    /// The lines.
    pub lines: Vec<PlaceLine>,
    /// The number of the chosen one.
    pub chosen: usize,
}

/// A line of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaceLine {
    /// What it says.
    pub text: String,
    /// Where it leads.
    pub place: LineGoal,
}

/// Where a line leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LineGoal {
    /// To an event of the open tree.
    Event(usize),
    /// To an address.
    Address(Address),
    /// To the answer of a question: the law with this number.
    Law(usize),
    /// To nothing that can be shown here: what is said instead.
    Told(String),
}

impl PlaceList {
    /// A list of which the first line is chosen.
    pub fn new(title: impl Into<String>, lines: Vec<PlaceLine>) -> Self {
        Self {
            title: title.into(),
            head: String::new(),
            lines,
            chosen: 0,
        }
    }

    /// What Enter does with the chosen line.
    pub fn verb(&self) -> &'static str {
        match self.lines.first().map(|line| &line.place) {
            Some(LineGoal::Law(_)) => "answers",
            _ => "goes there",
        }
    }

    /// Chooses a line so many further down.
    pub fn choose(&mut self, by: i32) {
        let last = self.lines.len().saturating_sub(1);
        self.chosen = self.chosen.saturating_add_signed(by as isize).min(last);
    }
}
