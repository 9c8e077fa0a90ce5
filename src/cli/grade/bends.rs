//! `raytree grade --bends`: the catalogue of mistakes.

use crate::cli::output::to_stdout;
use crate::cli::{Completion, Failure};
use crate::scene::Bend;

/// All bends by law.
pub fn list() -> Result<Completion, Failure> {
    let width = Bend::all().map(|bend| bend.name().len()).max().unwrap_or(0);
    let mut law = None;
    let lines = Bend::all().map(|bend| {
        let entry = bend.entry();
        let heading = if law.replace(entry.law) == Some(entry.law) {
            String::new()
        } else {
            format!("{}:\n", entry.law)
        };
        format!(
            "{heading}  {:width$}  {}\n  {:width$}    {}; shows in: {}\n",
            bend.name(),
            entry.note,
            "",
            entry.formula,
            entry.tell
        )
    });
    let text: String = lines.collect();
    to_stdout(text.as_bytes())
}
