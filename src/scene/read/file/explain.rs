//! Messages of the JSON parser in plain words, each with what to do.

use serde_path_to_error::Path;

use super::expected::Expected;
use crate::scene::limits::MAX_GROUP_DEPTH;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::Problem;

/// The parser's message `what` in plain words. `word` is what stands where the parser stopped, `field` the path of the
/// value, `path` the same in parts, if it is about one.
pub fn problem(what: &str, word: &str, field: &str, path: Option<&Path>) -> Problem {
    if field == "format" && !what.starts_with("missing") {
        let given = what.split('`').nth(1).unwrap_or(word);
        return Problem::new(
            format!("the format `{given}` is not known here"),
            "write \"format\": \"raytree-scene/1\"",
        );
    }
    by_name(what)
        .or_else(|| by_word(word))
        .or_else(|| by_shape(what, word, path?))
        .or_else(|| by_start(what))
        .unwrap_or_else(|| {
            Problem::new(
                format!("this is not JSON: {what}"),
                "compare with a scene that works, such as those in the folder `scenes`",
            )
        })
}

/// Mistakes about a field or kind whose name the parser writes in `...`, those that are possible after it.
fn by_name(what: &str) -> Option<Problem> {
    let mut quoted = what.split('`').skip(1).step_by(2);
    let name = quoted.next()?;
    let known: Vec<&str> = quoted.collect();
    if what.starts_with("missing field") {
        return Some(Problem::new(
            format!("the field `{name}` is missing"),
            format!("add \"{name}\": ... to this object"),
        ));
    }
    if what.starts_with("duplicate field") {
        return Some(Problem::new(
            format!("`{name}` is given twice"),
            "keep one of them, or give the other a different name",
        ));
    }
    let kind = match what {
        _ if what.starts_with("unknown field") => "field",
        _ if what.starts_with("unknown variant") => "kind",
        _ => return None,
    };
    let list = known.join(", ");
    let guess = did_you_mean(name, known);
    let cure = guess.map_or(format!("possible here: {list}"), |near| {
        format!("did you mean `{near}`? Possible here: {list}")
    });
    Some(Problem::new(format!("there is no {kind} `{name}`"), cure))
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

/// Values that are JSON, but not what the schema has at their path.
fn by_shape(what: &str, word: &str, path: &Path) -> Option<Problem> {
    let (expected, list_for_object) = Expected::at(path)?;
    let too_long = what.starts_with("trailing characters");
    let wrong_length = too_long || what.starts_with("invalid length");
    if expected.fields().is_some() && (list_for_object || wrong_length) {
        return Some(Problem::new(
            "a list [...] stands here instead of an object with named fields",
            format!("name the fields, such as {}", expected.example()),
        ));
    }
    if what.starts_with("invalid type: unit variant") {
        let path = path.to_string();
        let kind = path.rsplit('.').next().unwrap_or_default();
        return Some(Problem::new(
            "the kind stands here without its fields",
            format!(
                "write an object, such as {{\"{kind}\": {}}}",
                expected.example()
            ),
        ));
    }
    let no_value = what.starts_with("expected value") && expected.is_choice();
    if no_value && !expected.kinds().is_empty() {
        return Some(no_kind(word, expected));
    }
    let words = expected.in_words();
    let found = match found(what) {
        Some(found) => found,
        None if too_long && expected.length().is_some() => "a longer list".to_string(),
        None if no_value => format!("`{word}`"),
        None => return None,
    };
    let cure = match expected.length() {
        _ if what.starts_with("invalid type: null") => "write a value here, or leave the field out",
        Some(3) if wrong_length => {
            "points, vectors and colours have three numbers, such as [0, 1, 0]"
        }
        _ => "change the value to what is expected here",
    };
    let problem = format!("here stands {found}; what is expected is {words}");
    Some(Problem::new(problem, cure))
}

/// Something else than an object {...} that names one kind. After a second field the parser stops at the end of the
/// first.
fn no_kind(word: &str, expected: Expected) -> Problem {
    let what = match word {
        "{}" => {
            let cure = format!("name its kind, such as {}", expected.example());
            return Problem::new("the object {} does not say what it is", cure);
        }
        "}" | "]" | "," | "" => "a second field stands beside the kind of an object",
        _ => "here is not an object {...} with one kind",
    };
    let example = expected.example();
    let cure = format!("one object has one kind: put everything inside, such as {example}");
    Problem::new(what, cure)
}

/// What stands where the parser expected something else, without its names of types.
fn found(what: &str) -> Option<String> {
    const WORDS: [(&str, &str); 6] = [
        ("floating point ", "the number "),
        ("integer ", "the number "),
        ("string ", "the text "),
        ("boolean ", "the value "),
        ("sequence", "a list [...]"),
        ("map", "an object {...}"),
    ];
    let (found, _) = what.rsplit_once(", expected ")?;
    if let Some(length) = found.strip_prefix("invalid length ") {
        return Some(format!("a list of length {length}"));
    }
    let found = ["invalid type: ", "invalid value: "]
        .iter()
        .find_map(|start| found.strip_prefix(start))?;
    let word = WORDS.iter().find(|(from, _)| found.starts_with(from));
    Some(word.map_or(found.to_string(), |(from, to)| found.replacen(from, to, 1)))
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
    if what.starts_with("a scale is") {
        return Some(Problem::new(what, "write 2, or [1, 2, 1]"));
    }
    let (_, what, cure) = STARTS.iter().find(|(start, ..)| what.starts_with(start))?;
    Some(Problem::new(*what, *cure))
}

/// The word, number or sign at a line and column, from 1; "{}" at the end of an empty object.
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
    let word = line.get(start..end).unwrap_or("");
    let empty = word == "}" && line[..start].trim_end().ends_with('{');
    if empty { "{}" } else { word }
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
        assert_eq!(word_at("[{ }]", 1, 4), "{}");
    }
}
