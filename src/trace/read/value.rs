//! Values on the tape as they are asked for: numbers, texts, the fields of objects and the items of lists.

use std::borrow::Cow;

use super::kind::ValueKind;
use super::tape::{Tape, TapeEntry};
use crate::scene::printable::excerpt;

/// A value of a document.
#[derive(Clone, Copy)]
pub struct JsonValue<'a> {
    tape: &'a Tape,
    bytes: &'a [u8],
    index: usize,
}

impl<'a> JsonValue<'a> {
    /// The whole document.
    pub fn top(tape: &'a Tape, bytes: &'a [u8]) -> Self {
        Self {
            tape,
            bytes,
            index: 0,
        }
    }

    fn entry(self) -> TapeEntry {
        self.tape.entries[self.index]
    }

    /// What it is.
    pub fn kind(self) -> ValueKind {
        self.entry().kind
    }

    /// The text that it was read from; of objects and lists nothing.
    fn source(self) -> &'a [u8] {
        let TapeEntry { at, end, kind } = self.entry();
        match kind {
            ValueKind::Object | ValueKind::List => &[],
            _ => &self.bytes[at as usize..end as usize],
        }
    }

    /// Where it begins, in bytes.
    pub fn at(self) -> usize {
        self.entry().at as usize
    }

    /// The index of the entry behind it and all that is inside.
    fn behind(self) -> usize {
        let entry = self.entry();
        match entry.kind {
            ValueKind::Object | ValueKind::List => entry.end as usize,
            _ => self.index + 1,
        }
    }

    /// The values inside: of an object names and values in turn.
    fn inside(self) -> impl Iterator<Item = Self> {
        let has_any = matches!(self.kind(), ValueKind::Object | ValueKind::List);
        let end = if has_any { self.behind() } else { 0 };
        let mut index = self.index + 1;
        std::iter::from_fn(move || {
            let value = Self { index, ..self };
            (index < end).then(|| {
                index = value.behind();
                value
            })
        })
    }

    /// The fields of an object, each with its name; none of all else.
    pub fn fields(self) -> impl Iterator<Item = (Self, Self)> {
        let is_object = self.kind() == ValueKind::Object;
        let mut inside = self.inside();
        std::iter::from_fn(move || Some((inside.next().filter(|_| is_object)?, inside.next()?)))
    }

    /// The items of a list; `None` of all else.
    pub fn items(self) -> Option<impl Iterator<Item = Self>> {
        (self.kind() == ValueKind::List).then(|| self.inside())
    }

    /// The number, or in words why it is none.
    pub fn number(self) -> Result<f64, String> {
        if self.kind() == ValueKind::Number {
            let text = str::from_utf8(self.source()).unwrap_or_default();
            return match text.parse::<f64>() {
                Ok(x) if x.is_finite() => Ok(x),
                _ => Err(format!("is {}, beyond what 64 bits hold", excerpt(text))),
            };
        }
        if self.kind() != ValueKind::NoNumber {
            return Err(format!("is {}, and a number is wanted", self.described()));
        }
        let word = String::from_utf8_lossy(self.source());
        let is_nan =
            word.to_ascii_lowercase().contains("n(") || word.to_ascii_lowercase().contains("nan");
        let guess = if is_nan {
            "a root of a negative number?"
        } else {
            "a division by 0?"
        };
        Err(format!("is {}: {guess}", excerpt(&word)))
    }

    /// The text, or in words why it is none.
    pub fn text(self) -> Result<Cow<'a, str>, String> {
        let text = || str::from_utf8(self.source()).map_err(|_| "is not UTF-8 text".to_owned());
        match self.kind() {
            ValueKind::Text => text().map(Cow::Borrowed),
            ValueKind::EscapedText => unescaped(text()?).map(Cow::Owned),
            _ => Err(format!("is {}, and a text is wanted", self.described())),
        }
    }

    /// What it is, in words.
    pub fn described(self) -> String {
        let source = || {
            excerpt(&String::from_utf8_lossy(
                &self.source()[..self.source().len().min(1000)],
            ))
        };
        match self.kind() {
            ValueKind::Object => "an object".to_owned(),
            ValueKind::List => "a list".to_owned(),
            ValueKind::Text | ValueKind::EscapedText => format!("the text \"{}\"", source()),
            ValueKind::Null => "null".to_owned(),
            _ => source(),
        }
    }
}

/// A text without its escapes. Half of a pair of surrogates, as in `\ud800`, is no letter and becomes U+FFFD.
fn unescaped(text: &str) -> Result<String, String> {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, escape)) = rest.split_once('\\') {
        plain += before;
        let letter = escape.chars().next().unwrap_or(' ');
        rest = escape.get(letter.len_utf8()..).unwrap_or_default();
        let c = match letter {
            '"' | '\\' | '/' => letter,
            'b' => '\u{8}',
            'f' => '\u{c}',
            'n' => '\n',
            'r' => '\r',
            't' => '\t',
            'u' => {
                let (c, behind) =
                    by_number(rest).ok_or("has a \\u without four hexadecimal digits")?;
                rest = behind;
                c
            }
            _ => {
                return Err(format!(
                    "has `\\{}`, which stands for no letter",
                    excerpt(&letter.to_string())
                ));
            }
        };
        plain.push(c);
    }
    Ok(plain + rest)
}

/// The letter of the four digits behind `\u`, and of a second such number if it takes two; and what follows.
fn by_number(rest: &str) -> Option<(char, &str)> {
    let unit = |text: &str| {
        let digits = text.get(..4)?;
        let is_hex = digits.bytes().all(|b| b.is_ascii_hexdigit());
        u32::from_str_radix(digits, 16).ok().filter(|_| is_hex)
    };
    let (first, behind) = (unit(rest)?, &rest[4..]);
    let second = behind.strip_prefix("\\u").and_then(unit);
    match (first, second) {
        (0xd800..0xdc00, Some(second @ 0xdc00..0xe000)) => {
            let code = 0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00);
            Some((char::from_u32(code)?, &behind[6..]))
        }
        _ => Some((char::from_u32(first).unwrap_or('\u{fffd}'), behind)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_are_those_of_json() {
        for (text, plain) in [
            (r#"a\"\\\/\b\f\n\r\t"#, "a\"\\/\u{8}\u{c}\n\r\t"),
            (r"\u00e9\u20ac", "é€"),
            (r"\ud83d\ude00!", "😀!"),
            (r"\ud83d!", "\u{fffd}!"),
            (r"\ud83d\u0041", "\u{fffd}A"),
        ] {
            assert_eq!(unescaped(text).as_deref(), Ok(plain));
            let by_serde: Option<String> = serde_json::from_str(&format!("\"{text}\"")).ok();
            assert!(by_serde.is_none_or(|t| t == plain));
        }
        for bad in [r"\q", r"\u12", r"\u+123", "\\", r"\u"] {
            assert!(unescaped(bad).is_err(), "{bad}");
        }
    }
}
