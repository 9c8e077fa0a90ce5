//! Printable text: what names, paths and messages look like where people read them.
//!
//! Files come from anywhere. A character that cannot be seen, or that changes how others are seen, is shown by its number: so no
//! text steers a terminal, and none looks like another one.

use std::borrow::Cow;
use std::fmt::Write as _;
use std::ops::RangeInclusive;

/// Characters without a shape of their own beside control characters and spaces. Source: The Unicode Standard 16,
/// `DerivedCoreProperties.txt` (Default_Ignorable_Code_Point), `PropList.txt` (Bidi_Control); then the marks around annotations and
/// the empty Braille pattern.
const INVISIBLE: [RangeInclusive<char>; 18] = [
    '\u{ad}'..='\u{ad}',
    '\u{34f}'..='\u{34f}',
    '\u{61c}'..='\u{61c}',
    '\u{115f}'..='\u{1160}',
    '\u{17b4}'..='\u{17b5}',
    '\u{180b}'..='\u{180f}',
    '\u{200b}'..='\u{200f}',
    '\u{202a}'..='\u{202e}',
    '\u{2060}'..='\u{206f}',
    '\u{2800}'..='\u{2800}',
    '\u{3164}'..='\u{3164}',
    '\u{fe00}'..='\u{fe0f}',
    '\u{feff}'..='\u{feff}',
    '\u{ffa0}'..='\u{ffa0}',
    '\u{fff0}'..='\u{fffb}',
    '\u{1bca0}'..='\u{1bca3}',
    '\u{1d173}'..='\u{1d17a}',
    '\u{e0000}'..='\u{e0fff}',
];

/// Whether a character is shown as it is.
pub fn is_printable(c: char) -> bool {
    let is_odd_space = c.is_whitespace() && c != ' ';
    c.is_ascii_graphic()
        || !(c.is_control() || is_odd_space || INVISIBLE.iter().any(|range| range.contains(&c)))
}

/// Text on one line, where all that cannot be seen is shown by its number, as `\u{202e}`.
pub fn printable(text: &str) -> Cow<'_, str> {
    if text.chars().all(is_printable) {
        return text.into();
    }
    let mut shown = String::with_capacity(2 * text.len());
    for c in text.chars() {
        if is_printable(c) {
            shown.push(c);
        } else {
            // `\n` and `\t` where there is such a short form.
            shown.extend(c.escape_default());
        }
    }
    shown.into()
}

/// Characters of an excerpt at most.
pub const EXCERPT: usize = 200;

/// The beginning of a text that someone else wrote, printable and on one line: 200 characters at most, three dots if it goes on.
/// Whatever is shown of what students hand in goes through here; HTML, XML and CSV are escaped behind it.
pub fn excerpt(text: &str) -> String {
    // All that can be shown, and one more to know whether there is more.
    let start: String = text.chars().take(EXCERPT + 1).collect();
    let shown = printable(&start);
    if shown.chars().count() <= EXCERPT {
        return shown.into_owned();
    }
    let mut cut = String::new();
    let mut length = 0;
    for c in start.chars() {
        let letter = c.to_string();
        let letter = printable(&letter);
        length += letter.chars().count();
        if length > EXCERPT - 3 {
            break;
        }
        cut += &letter;
    }
    cut + "..."
}

/// Printable text whose line ends are meant.
pub fn printable_lines(text: &str) -> String {
    let lines: Vec<Cow<str>> = text.split('\n').map(printable).collect();
    lines.join("\n")
}

/// A word of a command line as a shell takes it. What cannot be seen is in the form `$'...'` of Bash and others.
pub fn shell_word(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./:,+=@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    if word.chars().all(is_printable) {
        return format!("'{}'", word.replace('\'', "'\\''"));
    }
    let mut quoted = "$'".to_owned();
    for c in word.chars() {
        // Writing to a string cannot fail.
        let _ = match c {
            '\'' | '\\' => write!(quoted, "\\{c}"),
            c if is_printable(c) => write!(quoted, "{c}"),
            c if c.is_ascii() => write!(quoted, "\\x{:02x}", c as u32),
            c => write!(quoted, "\\U{:08x}", c as u32),
        };
    }
    quoted + "'"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_seen_is_shown_by_its_number() {
        for (text, shown) in [
            ("ball 1", "ball 1"),
            ("Kugel für Übung, 球, шар, ☃", "Kugel für Übung, 球, шар, ☃"),
            ("e\u{301}", "e\u{301}"),
            ("\u{1b}[2J", "\\u{1b}[2J"),
            ("a\u{202e}b\u{2066}c", "a\\u{202e}b\\u{2066}c"),
            ("a\u{200b}b\u{a0}c", "a\\u{200b}b\\u{a0}c"),
            ("a\u{2028}b\nc\td", "a\\u{2028}b\\nc\\td"),
            (
                "\u{e0041}\u{feff}\u{3164}\u{ad}",
                "\\u{e0041}\\u{feff}\\u{3164}\\u{ad}",
            ),
        ] {
            assert_eq!(printable(text), shown);
        }
        assert_eq!(printable_lines("a\nb\u{9b}"), "a\nb\\u{9b}");
    }

    #[test]
    fn an_excerpt_is_short_whatever_is_in_it() {
        let texts = ["a", "\u{202e}", "\u{1b}", "é", "\u{e0041}"];
        for text in texts {
            for times in [0, 1, 22, 199, 200, 201, 70_000] {
                let shown = excerpt(&text.repeat(times));
                assert!(shown.chars().count() <= EXCERPT, "{text:?} x {times}");
                assert!(shown.chars().all(is_printable));
                // No number of a character is cut in two.
                let whole = printable(&text.repeat(times)).into_owned();
                let start = shown.strip_suffix("...").unwrap_or(&shown);
                assert!(whole.starts_with(start));
                assert!(start.is_empty() || start.ends_with(printable(text).as_ref()));
                assert_eq!(shown == whole, whole.chars().count() <= EXCERPT);
            }
        }
    }

    #[test]
    fn a_shell_reads_its_word_back() {
        for word in [
            "a.json",
            "",
            "a b",
            "it's",
            "\u{1b}[2J'\\ \n",
            "a\u{202e}b\u{e0041}.png",
        ] {
            let command = format!("printf %s {}", shell_word(word));
            assert!(command.chars().all(is_printable), "{command}");
            let Ok(output) = std::process::Command::new("bash")
                .args(["-c", &command])
                .env("LC_ALL", "C.UTF-8")
                .output()
            else {
                return;
            };
            assert_eq!(String::from_utf8_lossy(&output.stdout), word, "{command}");
        }
    }
}
