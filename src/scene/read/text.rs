//! Text of OBJ and MTL files: bytes of any encoding, lines that are joined where `\` says so, words without comments.

use std::borrow::Cow;

use memchr::memchr2;

/// Text of a model, in which `\u{fffd}` stands for what is none.
#[derive(Debug)]
pub struct Decoded {
    /// The text.
    pub text: String,
    /// How often something was replaced.
    pub replaced: u64,
}

/// Bytes of a model as text: UTF-8, or UTF-16 with its mark. Exporters write names in the encoding of their system.
pub fn decoded(bytes: Vec<u8>) -> Decoded {
    let wide = |bytes: &[u8], of: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.as_chunks().0.iter().map(|unit| of(*unit)).collect();
        Err(String::from_utf16_lossy(&units))
    };
    let text = match &bytes[..] {
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        _ => {
            String::from_utf8(bytes).map_err(|e| String::from_utf8_lossy(e.as_bytes()).into_owned())
        }
    };
    let replaced = match &text {
        Ok(_) => 0,
        Err(text) => text.matches(char::REPLACEMENT_CHARACTER).count() as u64,
    };
    let text = text.unwrap_or_else(|text| text);
    let text = match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_string(),
        None => text,
    };
    Decoded { text, replaced }
}

/// Iterator over lines that are joined, each with the number of its first line in the file, from 1.
pub struct Lines<'a> {
    rest: Option<&'a str>,
    /// Lines of the file so far.
    number: usize,
}

impl<'a> Lines<'a> {
    /// The lines of a text.
    pub fn new(text: &'a str) -> Self {
        Self {
            rest: (!text.is_empty()).then_some(text),
            number: 0,
        }
    }

    /// A line of the file. It ends with LF, CR LF or CR.
    fn single(&mut self) -> Option<&'a str> {
        let rest = self.rest?;
        self.number += 1;
        let end = memchr2(b'\n', b'\r', rest.as_bytes());
        let line = &rest[..end.unwrap_or(rest.len())];
        let next = end.map(|end| {
            &rest[end
                + if rest[end..].starts_with("\r\n") {
                    2
                } else {
                    1
                }..]
        });
        self.rest = next.filter(|next| !next.is_empty());
        Some(line)
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, Cow<'a, str>);

    fn next(&mut self) -> Option<Self::Item> {
        let first = self.single()?;
        let number = self.number;
        let Some(open) = continued(first) else {
            return Some((number, Cow::Borrowed(first)));
        };
        let mut joined = open.to_owned();
        while let Some(line) = self.single() {
            joined.push(' ');
            let open = continued(line);
            joined.push_str(open.unwrap_or(line));
            if open.is_none() {
                break;
            }
        }
        Some((number, Cow::Owned(joined)))
    }
}

/// What stands before the `\` that ends a line. A comment ends with its line, whatever stands in it.
fn continued(line: &str) -> Option<&str> {
    let open = line.trim_end().strip_suffix('\\')?;
    let comment = open.split_whitespace().any(|word| word.starts_with('#'));
    (!comment).then_some(open)
}

/// The words of a line up to a comment.
pub fn words(line: &str) -> impl Iterator<Item = &str> + Clone {
    let mut rest = line;
    std::iter::from_fn(move || {
        rest = rest.trim_ascii_start();
        let end = rest.bytes().position(|byte| byte.is_ascii_whitespace());
        let (word, behind) = rest.split_at(end.unwrap_or(rest.len()));
        let is_word = !word.is_empty() && !word.starts_with('#');
        is_word.then(|| {
            rest = behind;
            word
        })
    })
}

/// A whole number with an optional sign, of at most 18 digits: none is larger than an `isize`.
pub fn whole(word: &[u8]) -> Option<isize> {
    let (sign, digits) = match word {
        [b'-', digits @ ..] => (-1, digits),
        [b'+', digits @ ..] | digits => (1, digits),
    };
    let is_whole = (1..=18).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    let add = |sum: isize, byte: &u8| 10 * sum + isize::from(byte - b'0');
    is_whole.then(|| sign * digits.iter().fold(0, add))
}

/// True if a word is for sure a number, and smaller than 10^12: digits, in which there can be a point. What many lines have is
/// seen without its value.
pub fn is_plain_number(word: &str) -> bool {
    let rest = word.strip_prefix('-').unwrap_or(word);
    let digits = rest.bytes().filter(u8::is_ascii_digit).count();
    let has_point = rest.len() == digits + 1 && rest.contains('.');
    (1..=12).contains(&digits) && (rest.len() == digits || has_point)
}

/// The name after the first word of a line, which may have blanks in it. `Material #25` is one: a number is no comment.
pub fn name(line: &str) -> String {
    let is_comment = |word: &str| {
        let mut letters = word.chars();
        letters.next() == Some('#') && !letters.next().is_some_and(|c| c.is_ascii_digit())
    };
    let words = line.split_whitespace().skip(1);
    let words: Vec<&str> = words.take_while(|word| !is_comment(word)).collect();
    words.join(" ")
}

/// A number that is finite and at most `max`, whatever its sign.
pub fn number(word: &str, max: f64) -> Option<f64> {
    let number = word.parse::<f64>().ok();
    number.filter(|x| x.is_finite() && x.abs() <= max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_those_between_blanks_and_before_a_comment() {
        let found: Vec<&str> = words(" \tf 1/2  é#3\u{a0}\r # 4 5").collect();
        assert_eq!(found, ["f", "1/2", "é#3\u{a0}"]);
        assert_eq!(words("").chain(words(" #")).count(), 0);
    }

    #[test]
    fn numbers_are_those_of_the_language() {
        let pieces = [
            "", "-", "+", "--", ".", "0", "7", "12", "0.5", "5.", ".5", "1.2.3", "1e3", "nan",
            "1 ", "-0", "+3", "x",
        ];
        let long = [
            "999999999999",
            "1000000000000",
            "9223372036854775807",
            "9223372036854775808",
            "-9223372036854775809",
        ];
        for a in pieces.into_iter().chain(long) {
            for b in pieces {
                let word = format!("{a}{b}");
                let is_short = word.trim_start_matches(['-', '+']).len() <= 18;
                let parsed = word.parse().ok().filter(|_| is_short);
                assert_eq!(whole(word.as_bytes()), parsed, "{word}");
                let known = number(&word, 1e12).is_some();
                assert!(known || !is_plain_number(&word), "{word}");
            }
        }
        assert!(
            ["7", "-0.5", "5.", ".5", "999999999999"]
                .iter()
                .all(|word| is_plain_number(word))
        );
    }
}
