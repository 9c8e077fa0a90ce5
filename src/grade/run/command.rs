//! The command that a teacher gives, with blanks for what differs between scenes and pixels.

use strum::VariantNames as _;

/// What a blank is filled in with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, strum::EnumString, strum::VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Blank {
    /// The path of a copy of the scene file.
    Scene,
    /// The path of the flat scene in JSON.
    Flat,
    /// The path of the flat scene as lines of words.
    FlatText,
    /// The column of a pixel: then each pixel has a process of its own.
    X,
    /// The row of a pixel.
    Y,
    /// Columns of the picture.
    Width,
    /// Rows of the picture.
    Height,
    /// The path of a file with the pixels, `x y` a line.
    Pixels,
    /// The path of a folder for files.
    Out,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    Text(String),
    Blank(Blank),
}

/// A command: its words, each of texts and blanks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommandLine(Vec<Vec<Part>>);

impl CommandLine {
    /// Splits a command into words as a shell does, and finds the blanks in them.
    pub fn new(command: &str) -> Result<Self, String> {
        let words = split(command)?;
        if words.is_empty() {
            return Err("the command has no words; write one such as 'python3 tracer.py {flat} {width} {height} {pixels}'".to_owned());
        }
        let words: Result<_, String> = words.iter().map(|word| parts(word)).collect();
        let line = Self(words?);
        if line.is_for_one_pixel() && line.has(Blank::Pixels) {
            return Err("the command has both {pixels} and {x} {y}: take {pixels} for one process a scene, {x} {y} for one a pixel".to_owned());
        }
        Ok(line)
    }

    /// True if a blank is in it.
    pub fn has(&self, blank: Blank) -> bool {
        self.0
            .iter()
            .flatten()
            .any(|part| *part == Part::Blank(blank))
    }

    /// True if each pixel has a process of its own.
    pub fn is_for_one_pixel(&self) -> bool {
        self.has(Blank::X) || self.has(Blank::Y)
    }

    /// The words with their blanks filled in.
    pub fn filled(&self, value: impl Fn(Blank) -> String) -> Vec<String> {
        let fill = |part: &Part| match part {
            Part::Text(text) => text.clone(),
            Part::Blank(blank) => value(*blank),
        };
        self.0
            .iter()
            .map(|word| word.iter().map(fill).collect())
            .collect()
    }
}

/// The words of a command, as a shell splits it.
pub fn split(command: &str) -> Result<Vec<String>, String> {
    shlex::split(command).ok_or_else(|| format!("a quote in `{command}` has no end"))
}

/// The texts and blanks of a word. `${name}` is left to the shell that the command may start, and so are braces around anything but
/// small letters.
fn parts(word: &str) -> Result<Vec<Part>, String> {
    let mut parts = Vec::new();
    let mut text = String::new();
    let mut rest = word;
    while let Some(at) = rest.find('{') {
        let (before, inside) = (&rest[..at], &rest[at + 1..]);
        text += before;
        let end = inside.find(|c: char| !(c.is_ascii_lowercase() || c == '-'));
        let name = end.filter(|end| *end > 0 && inside[*end..].starts_with('}'));
        match name.map(|end| &inside[..end]) {
            Some(name) if !text.ends_with('$') => {
                let blank = name.parse().map_err(|_| unknown(name))?;
                parts.push(Part::Text(std::mem::take(&mut text)));
                parts.push(Part::Blank(blank));
                rest = &inside[name.len() + 1..];
            }
            _ => {
                text.push('{');
                rest = inside;
            }
        }
    }
    parts.push(Part::Text(text + rest));
    parts.retain(|part| *part != Part::Text(String::new()) || word.is_empty());
    Ok(parts)
}

fn unknown(name: &str) -> String {
    let known: Vec<String> = Blank::VARIANTS
        .iter()
        .map(|name| format!("{{{name}}}"))
        .collect();
    format!(
        "`{{{name}}}` in the command is unknown; there are {}",
        known.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(command: &str) -> Vec<String> {
        let line = CommandLine::new(command).expect("a command");
        line.filled(|blank| format!("<{blank:?}>"))
    }

    #[test]
    fn words_are_split_as_a_shell_does_before_they_are_filled_in() {
        assert_eq!(
            filled("python3 'my tracer.py' {flat} --size={width}x{height} \"\" a\\ b"),
            [
                "python3",
                "my tracer.py",
                "<Flat>",
                "--size=<Width>x<Height>",
                "",
                "a b"
            ]
        );
        assert_eq!(
            filled("sh -c 'a ${x} {print $1} {} {X} {flat-text}{'"),
            ["sh", "-c", "a ${x} {print $1} {} {X} <FlatText>{"]
        );
    }

    #[test]
    fn what_is_wrong_with_a_command_is_told() {
        let told = |command| CommandLine::new(command).expect_err("no command");
        assert!(told("a 'b").contains("has no end"));
        assert!(told(" ").contains("no words"));
        assert!(told("a {pixel}").contains(
            "`{pixel}` in the command is unknown; there are {scene}, {flat}, {flat-text}, {x}"
        ));
        assert!(told("a {x} {y} {pixels}").contains("both"));
    }
}
