//! Warnings about a scene's files.

use super::error::printable;
use crate::scene::limits::MAX_WARNINGS;

/// The first warnings, and the number of further ones.
#[derive(Clone, Debug, Default)]
pub struct Warnings {
    kept: Vec<String>,
    more: usize,
}

impl Warnings {
    /// Adds a warning; its text is made only if it is kept.
    pub fn add(&mut self, words: impl FnOnce() -> String) {
        if self.kept.len() < MAX_WARNINGS {
            self.kept.push(printable(&words()));
        } else {
            self.more += 1;
        }
    }

    /// The warnings, with a last line for those that were not kept.
    pub fn into_lines(self) -> Vec<String> {
        let mut lines = self.kept;
        if self.more > 0 {
            lines.push(format!("and {} more warnings", self.more));
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_are_kept_and_the_others_counted() {
        let lines = |count: usize| {
            let mut warnings = Warnings::default();
            (0..count).for_each(|i| warnings.add(|| format!("{i}\n")));
            warnings.into_lines()
        };
        assert_eq!(lines(MAX_WARNINGS).len(), MAX_WARNINGS);
        assert_eq!(lines(MAX_WARNINGS)[1], "1\u{fffd}");
        let more = lines(MAX_WARNINGS + 3);
        assert_eq!(more.len(), MAX_WARNINGS + 1);
        assert_eq!(more[MAX_WARNINGS], "and 3 more warnings");
    }
}
