//! Texts of a chapter: they evaluate, are of the subset of Markdown, hold no number by hand, and offer every exercise once.

use super::CheckName;
use crate::lesson::chapter::Chapter;
use crate::lesson::course::Course;
use crate::lesson::directive::filled;
use crate::lesson::markdown::{TextBlock, blocks};
use crate::lesson::page::{PagePart, page};

/// Digits that a number of a text may have.
const MAX_DIGITS: usize = 3;

/// What is wrong with a text.
pub fn wrong(course: &Course, chapter: &Chapter) -> Vec<(CheckName, String)> {
    let mut wrong = Vec::new();
    let mut tell = |what: String| wrong.push((CheckName::Directives, what));
    match page(course, chapter) {
        Err(error) => tell(error.what),
        Ok(parts) => {
            for part in &parts {
                match part {
                    PagePart::Text(text) => {
                        if let Err(what) = blocks(text) {
                            tell(what);
                        }
                    }
                    PagePart::Picture(picture) => {
                        if let Err(error) = picture.stage(course, chapter) {
                            tell(format!("a picture: {error}"));
                        }
                    }
                    _ => {}
                }
            }
            for exercise in &chapter.exercises {
                let offered = parts
                    .iter()
                    .filter(|part| **part == PagePart::Exercise(exercise.id.clone()))
                    .count();
                if offered != 1 {
                    tell(format!(
                        "exercise `{}` is offered {offered} times; write {{{{exercise {}}}}} once",
                        exercise.id, exercise.id
                    ));
                }
            }
        }
    }
    for (number, what) in by_hand(&chapter.text) {
        tell(format!(
            "line {number}: the number {what} stands there by hand; let a directive tell it"
        ));
    }
    let texts = chapter.exercises.iter().map(|e| &e.text);
    for text in texts {
        if let Err(what) = blocks(text) {
            tell(what);
        }
    }
    wrong
}

/// Numbers of more digits than anybody types, outside of directives and of code, with their lines.
pub fn by_hand(text: &str) -> Vec<(usize, String)> {
    let lines: Vec<String> = text
        .lines()
        .map(|line| {
            let is_block = line.trim_start().starts_with("{{");
            let emptied = filled(line, |_| Ok(String::new()));
            if is_block {
                String::new()
            } else {
                emptied.unwrap_or_default()
            }
        })
        .collect();
    let shown = blocks(&lines.join("\n")).unwrap_or_default();
    let words = shown.iter().flat_map(|block| match block {
        TextBlock::Heading(_, words)
        | TextBlock::Paragraph(words)
        | TextBlock::Item(_, _, words)
        | TextBlock::Quote(words) => vec![words],
        TextBlock::Table(rows) => rows.iter().flatten().collect(),
        TextBlock::Code(_) => Vec::new(),
    });
    let plain = words
        .flatten()
        .filter(|(_, style)| *style != crate::lesson::markdown::WordStyle::Code);
    let numbers = plain.flat_map(|(text, _)| long_numbers(text));
    let line_of = |number: &str| lines.iter().position(|line| line.contains(number));
    numbers
        .map(|number| (line_of(&number).map_or(1, |line| line + 1), number))
        .collect()
}

/// Numbers with more digits than a text may have: a point inside belongs to them.
fn long_numbers(text: &str) -> Vec<String> {
    let numbers = text.split(|c: char| !c.is_ascii_digit() && c != '.');
    let numbers = numbers.map(|number| number.trim_matches('.'));
    let digits = |number: &&str| number.bytes().filter(u8::is_ascii_digit).count() > MAX_DIGITS;
    numbers.filter(digits).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::by_hand;

    #[test]
    fn numbers_by_hand_are_found_outside_of_code_and_directives() {
        let text = "At {{trace 1,2.t digits=4}} it is 4.0131.\n\n    t = 2.7135\n\nAnd `1.2345`, 320, 2.5.\n\n| a | 12345 |\n|---|---|\n";
        let found = by_hand(text);
        let told: Vec<(usize, &str)> = found.iter().map(|(line, n)| (*line, n.as_str())).collect();
        assert_eq!(told, [(1, "4.0131"), (7, "12345")]);
    }
}
