//! A page as plain lines, for pipes, screen readers and exercises on the command line.

use textwrap::{Options, wrap};

use super::markdown::{TextBlock, WordStyle, Words};

/// A block in lines of at most so many columns, with a blank line behind it.
pub fn lines(block: &TextBlock, width: usize) -> Vec<String> {
    let mut lines = match block {
        TextBlock::Heading(level, words) => heading(*level, &told(words), width),
        TextBlock::Paragraph(words) => wrapped(&told(words), width, "", ""),
        TextBlock::Item(depth, mark, words) => {
            let indent = "  ".repeat(*depth);
            let first = format!("{}{mark} ", &indent[2..]);
            let next = " ".repeat(first.chars().count());
            // Items of a list stand together.
            return wrapped(&told(words), width, &first, &next);
        }
        TextBlock::Quote(words) => wrapped(&told(words), width, "> ", "> "),
        TextBlock::Code(code) => code.iter().map(|line| format!("    {line}")).collect(),
        TextBlock::Table(rows) => table(rows),
    };
    lines.push(String::new());
    lines
}

fn heading(level: usize, text: &str, width: usize) -> Vec<String> {
    let mut lines = wrapped(text, width, "", "");
    let sign = if level == 1 { "=" } else { "-" };
    let longest = lines.iter().map(|line| line.chars().count()).max();
    lines.push(sign.repeat(longest.unwrap_or(0)));
    lines
}

/// The rows of a table, each cell as wide as its column.
pub fn table(rows: &[Vec<Words>]) -> Vec<String> {
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().map(told).collect())
        .collect();
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let all = cells.iter().filter_map(|row| row.get(column));
        all.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let padded: Vec<String> = row
            .iter()
            .zip(&widths)
            .map(|(cell, width)| format!("{cell:width$}"))
            .collect();
        padded.join("  ").trim_end().to_owned()
    };
    let mut lines: Vec<String> = cells.iter().map(line).collect();
    if lines.len() > 1 {
        let rule: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
        lines.insert(1, rule.join("  "));
    }
    lines
}

/// Words with signs that tell their style: `code` in backquotes.
fn told(words: &Words) -> String {
    let word = |(text, style): &(String, WordStyle)| match style {
        WordStyle::Code => format!("`{text}`"),
        WordStyle::Strong => format!("*{text}*"),
        _ => text.clone(),
    };
    words.iter().map(word).collect()
}

fn wrapped(text: &str, width: usize, first: &str, next: &str) -> Vec<String> {
    let options = Options::new(width.max(20))
        .initial_indent(first)
        .subsequent_indent(next)
        .break_words(false);
    wrap(text, options)
        .into_iter()
        .map(std::borrow::Cow::into_owned)
        .collect()
}
