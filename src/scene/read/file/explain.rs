//! The parser's messages, put so that someone who learns knows what to do.

use crate::scene::limits::MAX_GROUP_DEPTH;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::Problem;

/// The parser's message in plain words, and what to do. `word` is what stands at the place of the error, `field` the
/// path of the field.
pub fn problem(what: &str, word: &str, field: &str) -> Problem {
    if field == "format" && !what.starts_with("missing") {
        let given = what.split('`').nth(1).unwrap_or(word);
        return Problem::new(
            format!("the format `{given}` is not known here"),
            "write \"format\": \"raytree-scene/1\"",
        );
    }
    by_name(what)
        .or_else(|| by_word(what, word, field))
        .or_else(|| by_start(what))
        .unwrap_or_else(|| by_value(what))
}

/// Mistakes about a field or kind whose name the parser tells in `...`, the possible ones after it.
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

/// Mistakes that are known by what stands at their place.
fn by_word(what: &str, word: &str, field: &str) -> Option<Problem> {
    let number = word.to_ascii_lowercase();
    let number = number.trim_start_matches(['-', '+']);
    let in_list = what.starts_with("expected value") && field.ends_with(']') && word != "]";
    Some(match word.chars().next() {
        _ if ["nan", "inf", "infinity"].contains(&number) => Problem::new(
            format!("`{word}` is not a number in JSON"),
            "write a finite number, such as 0 or 1.5",
        ),
        Some('/' | '#') => Problem::new(
            "JSON has no comments",
            "use the field \"note\" of an object instead",
        ),
        Some('\'') => Problem::new(
            "JSON has no single quotation marks",
            "write \"...\" instead of '...'",
        ),
        Some('.' | '+') => Problem::new(
            format!("`{word}` is not a number in JSON"),
            "write a digit first, such as 0.5",
        ),
        _ if in_list && word == "{}" => Problem::new(
            "the object {} does not say what it is",
            "name its kind, such as {\"sphere\": {\"name\": ...}}",
        ),
        _ if in_list => Problem::new(
            "a second field stands beside the kind of an object",
            "one object has one kind: put everything inside, such as {\"sphere\": {\"name\": ..., \"note\": ...}}",
        ),
        _ if what.starts_with("invalid type") && is_list_for_object(field) => Problem::new(
            "a list [...] stands here instead of an object with named fields",
            "name the fields, such as {\"axis\": [0, 1, 0], \"degrees\": 90}",
        ),
        _ => return None,
    })
}

/// Mistakes that the parser's message begins with: its words, what to say, what to do.
const STARTS: [(&str, &str, &str); 14] = [
    (
        "EOF",
        "the file ends in the middle",
        "close every bracket and every quotation mark that was opened; perhaps the file was cut off",
    ),
    (
        "number out of range",
        "the number is too large",
        "write a number between -1e12 and 1e12",
    ),
    ("recursion limit", "the file is nested too deeply", TOO_DEEP),
    (
        "expected value",
        "a value is missing here, or is none that JSON has",
        "write a number, a text in double quotation marks, true, false, a list [...] or an object {...}",
    ),
    (
        "expected ident",
        "here stands a word that JSON does not have",
        "write true, false or null in full, and any other text in double quotation marks",
    ),
    (
        "invalid number",
        "the number is not whole, or has a sign too many",
        "write it as in 0.5, -2 or 1e6",
    ),
    (
        "invalid escape",
        "a `\\` in a string stands before a letter that it cannot stand before",
        "write \\\\ for the sign itself, and / between the folders of a path",
    ),
    (
        "trailing comma",
        "there is a comma before a closing bracket",
        "take the comma away: in JSON it stands only between two things",
    ),
    (
        "trailing characters",
        "something stands after the end of the scene",
        "a file holds one object {...}: take away what comes after it",
    ),
    (
        "key must be a string",
        "a name stands without quotation marks",
        "write names in double quotation marks, such as \"radius\": 1",
    ),
    (
        "invalid type: unit variant",
        "the kind stands here without its fields",
        "write an object, such as {\"sphere\": {\"name\": ...}}",
    ),
    (
        "expected `,`",
        "a comma or a closing bracket is missing",
        "look at the end of the line before, too",
    ),
    (
        "expected `:`",
        "a colon is missing between a name and its value",
        "write \"name\": value",
    ),
    (
        "control character",
        "a line ends, or a tab stands, inside a string",
        "close the quotation mark on the same line; write \\n and \\t for line ends and tabs",
    ),
];

const TOO_DEEP: &str = "put groups at most 32 deep into each other";
const _: () = assert!(MAX_GROUP_DEPTH == 32, "the sentence above says so");

fn by_start(what: &str) -> Option<Problem> {
    let (_, what, cure) = STARTS.iter().find(|(start, ..)| what.starts_with(start))?;
    Some(Problem::new(*what, *cure))
}

/// Values that are not what is expected; and all that is no JSON in other ways.
fn by_value(what: &str) -> Problem {
    if what.starts_with("invalid length") {
        Problem::new(
            in_plain_words(what),
            "points, vectors and colours have three numbers, such as [0, 1, 0]",
        )
    } else if what.starts_with("invalid type: null") {
        Problem::new(
            in_plain_words(what),
            "write a value here, or leave the field out",
        )
    } else if what.starts_with("invalid") {
        Problem::new(
            in_plain_words(what),
            "change the value to what is expected here",
        )
    } else if what.starts_with("a scale") {
        Problem::new(what, "write 2, or [1, 2, 1]")
    } else {
        Problem::new(
            format!("this is not JSON: {what}"),
            "compare with a scene that works, such as those in the folder `scenes`",
        )
    }
}

/// True for a path such as `rotate[0]`: a part of something that has named fields and no list of parts.
fn is_list_for_object(field: &str) -> bool {
    const OBJECTS: [&str; 15] = [
        "camera",
        "settings",
        "checker",
        "rotate",
        "sphere",
        "plane",
        "triangle",
        "quad",
        "box",
        "mesh",
        "obj",
        "group",
        "point",
        "directional",
        "spot",
    ];
    let last = field.rsplit('.').next().unwrap_or("");
    last.split_once('[')
        .is_some_and(|(key, _)| OBJECTS.contains(&key))
}

/// The parser's names of types, for people who do not write Rust.
fn in_plain_words(what: &str) -> String {
    const WORDS: [(&str, &str); 16] = [
        ("invalid type: ", "here stands "),
        ("invalid value: ", "here stands "),
        ("invalid length ", "here stands a list of length "),
        (", expected struct ", ", expected an object {...}\0"),
        (", expected ", "; what is expected is "),
        ("an array of length ", "a list of length "),
        ("floating point ", "the number "),
        ("integer ", "the number "),
        ("string ", "the text "),
        ("boolean ", "the value "),
        ("a sequence", "a list"),
        ("sequence", "a list [...]"),
        ("map", "an object {...}"),
        ("f64", "a number"),
        ("u32", "a whole number from 0 to 4294967295"),
        ("u64", "a whole number from 0 up"),
    ];
    let text = WORDS
        .iter()
        .fold(what.to_string(), |text, (from, to)| text.replace(from, to));
    // The name of a type in this program says nothing.
    text.split('\0').next().unwrap_or("").to_string()
}

/// The word, number or sign at a place in the text, counted from 1; "{}" at the end of an empty object.
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
    fn the_word_at_a_place_is_found() {
        let text = "{\n  \"a\": -Infinity,\n}";
        assert_eq!(word_at(text, 2, 8), "-Infinity");
        assert_eq!(word_at(text, 2, 12), "-Infinity");
        assert_eq!(word_at(text, 2, 17), ",");
        assert_eq!(word_at(text, 9, 9), "");
        assert_eq!(word_at("é", 1, 2), "");
        assert_eq!(word_at("[{ }]", 1, 4), "{}");
    }
}
