//! Tables in Markdown: printed, and, if `RAYTREE_BOOK` is set, put into the book.

use std::fmt::Write;

/// The middle of some numbers.
pub fn median(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.into_iter().collect();
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// A table with its head; the first column is text, the others are numbers.
pub fn markdown(head: &[String], rows: &[Vec<String>]) -> String {
    let mut text = format!("| {} |\n", head.join(" | "));
    let _ = writeln!(text, "|---|{}", "---:|".repeat(head.len() - 1));
    for row in rows {
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
    text
}

/// Prints a part of the book, and writes it there if the book is to be made anew.
pub fn publish(name: &str, text: &str) {
    println!("{text}");
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        let place = format!(
            "{}/../book/src/tables/{name}.md",
            env!("CARGO_MANIFEST_DIR")
        );
        let written = std::fs::write(&place, text);
        written.unwrap_or_else(|problem| panic!("{place}: {problem}"));
    }
}
