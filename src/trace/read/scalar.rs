//! Numbers and words of JSON, and the words that programs write where they have no number.

use super::kind::ValueKind;
use crate::scene::printable::excerpt;
use crate::scene::read::error::Problem;

/// What stands at a place.
pub enum Scalar {
    /// A number or a word, and the place behind it.
    Value(ValueKind, usize),
    /// A word or a number that JSON does not have.
    Unknown(Problem),
    /// Neither.
    Nothing,
}

/// The number or word at `at`.
pub fn scalar(bytes: &[u8], at: usize) -> Scalar {
    let end = number(bytes, at);
    if let Some(end) = end.filter(|end| !is_word(bytes.get(*end))) {
        return Scalar::Value(ValueKind::Number, end);
    }
    let rest = &bytes[at.min(bytes.len())..];
    let length = rest
        .iter()
        .position(|b| !is_word(Some(b)))
        .unwrap_or(rest.len());
    let word = &rest[..length];
    let kind = match word {
        b"" => return Scalar::Nothing,
        b"null" => ValueKind::Null,
        b"true" | b"false" => ValueKind::Truth,
        _ if is_no_number(word) => ValueKind::NoNumber,
        _ => return Scalar::Unknown(unknown(word)),
    };
    Scalar::Value(kind, at + length)
}

fn is_word(byte: Option<&u8>) -> bool {
    byte.is_some_and(|b| b.is_ascii_alphanumeric() || b"+-.#()_".contains(b))
}

/// The end of a number as JSON writes it: a sign, digits, a fraction, an exponent.
fn number(bytes: &[u8], at: usize) -> Option<usize> {
    let byte = |at: usize| bytes.get(at).copied().unwrap_or(0);
    let digits = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default();
        let count = rest.iter().take_while(|b| b.is_ascii_digit()).count();
        (count > 0).then_some(from + count)
    };
    let first = at + usize::from(byte(at) == b'-');
    let mut end = digits(first)?;
    if byte(first) == b'0' && end > first + 1 {
        return None;
    }
    if byte(end) == b'.' {
        end = digits(end + 1)?;
    }
    if matches!(byte(end), b'e' | b'E') {
        let signed = matches!(byte(end + 1), b'+' | b'-');
        end = digits(end + 1 + usize::from(signed))?;
    }
    Some(end)
}

/// What C, C++, Java, JavaScript and Python write for NaN and infinity.
fn is_no_number(word: &[u8]) -> bool {
    const WORDS: [&str; 5] = ["nan", "inf", "infinity", "nan(ind)", "nan(snan)"];
    let plain = word
        .strip_prefix(b"-")
        .or(word.strip_prefix(b"+"))
        .unwrap_or(word);
    let is = |known: &&str| plain.eq_ignore_ascii_case(known.as_bytes());
    plain.starts_with(b"1.#") || WORDS.iter().any(is)
}

fn unknown(word: &[u8]) -> Problem {
    let shown = excerpt(&String::from_utf8_lossy(&word[..word.len().min(400)]));
    let is_number = word.iter().any(u8::is_ascii_digit) && !word[0].is_ascii_alphabetic();
    let (is, cure) = if is_number {
        (
            "no number of JSON",
            "write it like 0.5, -2 or 1e-9: a digit before and behind the point, no + before it",
        )
    } else {
        (
            "no value of JSON",
            "write texts between quotation marks; true, false and null in small letters",
        )
    };
    Problem::new(format!("`{shown}` is {is}"), cure)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(text: &str) -> Option<(ValueKind, usize)> {
        match scalar(text.as_bytes(), 0) {
            Scalar::Value(kind, end) => Some((kind, end)),
            _ => None,
        }
    }

    #[test]
    fn numbers_are_those_of_json() {
        for good in ["0", "-0", "1.5", "-12.25e-3", "1E9", "1e999", "100"] {
            assert_eq!(
                kind(&format!("{good},")),
                Some((ValueKind::Number, good.len())),
                "{good}"
            );
        }
        for bad in [
            "01",
            ".5",
            "5.",
            "+1",
            "1e",
            "--1",
            "0x10",
            "1_000",
            "-",
            "True",
            "None",
            "undefined",
        ] {
            assert_eq!(kind(bad), None, "{bad}");
        }
    }

    #[test]
    fn words_for_no_number_are_known() {
        for word in [
            "NaN",
            "nan",
            "-nan",
            "Infinity",
            "-Infinity",
            "inf",
            "-inf",
            "+inf",
            "-nan(ind)",
            "-1.#IND00",
        ] {
            assert_eq!(
                kind(word),
                Some((ValueKind::NoNumber, word.len())),
                "{word}"
            );
        }
        assert_eq!(kind("null]"), Some((ValueKind::Null, 4)));
        assert_eq!(kind("true}"), Some((ValueKind::Truth, 4)));
    }
}
