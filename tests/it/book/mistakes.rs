//! The page of mistakes: each bend with its formula, made of what `raytree grade --bends` prints.

use std::fmt::Write as _;

use super::made::{cell, shows};
use super::printed;

/// A mistake: its name, what is wrong, its formula, and where it shows.
fn row(name_and_note: &str, rest: &str) -> [String; 4] {
    let (name, note) = name_and_note
        .trim()
        .split_once("  ")
        .unwrap_or_else(|| panic!("`{name_and_note}` has no note"));
    let (formula, shows) = rest
        .trim()
        .split_once("; shows in: ")
        .unwrap_or_else(|| panic!("`{rest}` does not say where it shows"));
    [name, note, formula, shows].map(|text| cell(text.trim()))
}

/// The table of all mistakes, by their laws.
fn tables(list: &str) -> (String, usize) {
    let (mut out, mut count) = (String::new(), 0);
    let mut lines = list
        .lines()
        .filter(|line| !line.trim().is_empty())
        .peekable();
    while let Some(line) = lines.next() {
        if !line.starts_with(' ') {
            let blank = if out.is_empty() { "" } else { "\n" };
            let _ = write!(
                out,
                "{blank}## Law `{}`\n\n| name | what is wrong | formula | shows in |\n|---|---|---|---|\n",
                line.trim_end_matches(':')
            );
            continue;
        }
        let [name, note, formula, place] = row(line, lines.next().unwrap_or_default());
        let _ = writeln!(out, "| `{name}` | {note} | `{formula}` | {place} |");
        count += 1;
    }
    (out, count)
}

#[test]
fn every_mistake_stands_on_its_page() {
    let (tables, count) = tables(&printed(&["grade", "--bends"]));
    assert!(count >= 70, "{count} mistakes");
    shows("mistakes.md", &[("bends".to_owned(), tables)]);
}
