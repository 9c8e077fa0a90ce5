//! Text that is no JSON: what is wrong in plain words, and what to do.

use crate::scene::limits::MAX_GROUP_DEPTH;
use crate::scene::read::error::Problem;

/// The parser's message `what` in plain words. `word` is what stands where the parser stopped.
pub fn problem(what: &str, word: &str) -> Problem {
    by_word(word).or_else(|| by_start(what)).unwrap_or_else(|| {
        Problem::new(
            format!("this is not JSON: {what}"),
            "compare with a scene that works, such as those in the folder `scenes`",
        )
    })
}

/// Mistakes that show in the word at which the parser stopped.
fn by_word(word: &str) -> Option<Problem> {
    let number = word.to_ascii_lowercase();
    let no_number = format!("`{word}` is not a number in JSON");
    if ["nan", "inf", "infinity"].contains(&number.trim_start_matches(['-', '+'])) {
        let cure = "write a finite number, such as 0 or 1.5";
        return Some(Problem::new(no_number, cure));
    }
    let (what, cure) = match word.chars().next()? {
        '/' | '#' => (
            "JSON has no comments",
            "use the field \"note\" of an object instead",
        ),
        '\'' => (
            "JSON has no single quotation marks",
            "write \"...\" instead of '...'",
        ),
        '.' | '+' => (&*no_number, "write a digit first, such as 0.5"),
        _ => return None,
    };
    Some(Problem::new(what, cure))
}

/// Mistakes that the parser's message begins with: its words, what to say, what to do.
#[rustfmt::skip]
const STARTS: [(&str, &str, &str); 13] = [
    ("EOF", "the file ends in the middle",
        "close every bracket and every quotation mark that was opened; perhaps the file was cut off"),
    ("number out of range", "the number is too large",
        "write a number between -1e12 and 1e12"),
    ("recursion limit", "the file is nested too deeply",
        "put groups at most 32 deep into each other"),
    ("expected value", "a value is missing here, or is none that JSON has",
        "write a number, a text in double quotation marks, true, false, a list [...] or an object {...}"),
    ("expected ident", "here stands a word that JSON does not have",
        "write true, false or null in full, and any other text in double quotation marks"),
    ("invalid number", "the number is not whole, or has a sign too many",
        "write it as in 0.5, -2 or 1e6"),
    ("invalid escape", "a `\\` in a string stands before a letter that it cannot stand before",
        "write \\\\ for the sign itself, and / between the folders of a path"),
    ("trailing comma", "there is a comma before a closing bracket",
        "take the comma away: in JSON it stands only between two things"),
    ("trailing characters", "something stands after the end of the scene",
        "a file holds one object {...}: take away what comes after it"),
    ("key must be a string", "a name stands without quotation marks",
        "write names in double quotation marks, such as \"radius\": 1"),
    ("expected `,`", "a comma or a closing bracket is missing",
        "look at the end of the line before, too"),
    ("expected `:`", "a colon is missing between a name and its value",
        "write \"name\": value"),
    ("control character", "a line ends, or a tab stands, inside a string",
        "close the quotation mark on the same line; write \\n and \\t for line ends and tabs"),
];
const _: () = assert!(MAX_GROUP_DEPTH == 32, "a sentence above says so");

fn by_start(what: &str) -> Option<Problem> {
    let (_, what, cure) = STARTS.iter().find(|(start, ..)| what.starts_with(start))?;
    Some(Problem::new(*what, *cure))
}

/// The word, number or sign at a line and column, from 1.
pub fn word_at(text: &str, line: usize, column: usize) -> &str {
    let Some(line) = text.lines().nth(line.saturating_sub(1)) else {
        return "";
    };
    let bytes = line.as_bytes();
    let in_word = |i: usize| {
        bytes
            .get(i)
            .is_some_and(|b| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'+' | b'.'))
    };
    let mut start = column.saturating_sub(1).min(bytes.len());
    while start > 0 && in_word(start) && in_word(start - 1) {
        start -= 1;
    }
    let mut end = start + 1;
    while in_word(start) && in_word(end) {
        end += 1;
    }
    line.get(start..end).unwrap_or("")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_word_at_a_line_and_column_is_found() {
        let text = "{\n  \"a\": -Infinity,\n}";
        assert_eq!(word_at(text, 2, 8), "-Infinity");
        assert_eq!(word_at(text, 2, 12), "-Infinity");
        assert_eq!(word_at(text, 2, 17), ",");
        assert_eq!(word_at(text, 9, 9), "");
        assert_eq!(word_at("é", 1, 2), "");
    }
}
