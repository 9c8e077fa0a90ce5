//! The ray tree as JSON: two spaces a level, arrays of numbers on one line.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{CompactFormatter, Formatter};

use crate::scene::printable::is_printable;

/// Writes a value, and a new line behind it.
pub fn write(mut out: impl Write, value: &impl Serialize) -> io::Result<()> {
    let layout = Layout::default();
    value.serialize(&mut Serializer::with_formatter(&mut out, layout))?;
    writeln!(out)
}

/// Writes a value in one line without blanks, and a new line behind it.
pub fn write_compact(mut out: impl Write, value: &impl Serialize) -> io::Result<()> {
    value.serialize(&mut Serializer::with_formatter(&mut out, Dense))?;
    writeln!(out)
}

/// No line is broken.
struct Dense;

impl Formatter for Dense {
    fn write_string_fragment<W: ?Sized + Write>(
        &mut self,
        out: &mut W,
        fragment: &str,
    ) -> io::Result<()> {
        write_visible(out, fragment)
    }
}

/// Text of a string. What cannot be seen as `\u....`: the same to every reader of JSON, and harmless on a terminal.
fn write_visible<W: ?Sized + Write>(out: &mut W, fragment: &str) -> io::Result<()> {
    let mut rest = fragment;
    while let Some(at) = rest.find(|c| !is_printable(c)) {
        let (before, from) = rest.split_at(at);
        out.write_all(before.as_bytes())?;
        let mut after = from.chars();
        for unit in after.next().unwrap_or_default().encode_utf16(&mut [0; 2]) {
            write!(out, "\\u{unit:04x}")?;
        }
        rest = after.as_str();
    }
    out.write_all(rest.as_bytes())
}

/// Where lines are broken: before every key, and before every item of an array that is neither number nor null.
#[derive(Default)]
struct Layout {
    /// Objects and arrays around here.
    level: usize,
    /// True if a line was broken in the innermost of them.
    is_broken: bool,
    /// If the item of an array comes next, whether it is the first.
    item: Option<bool>,
}

impl Layout {
    fn line<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.is_broken = true;
        write!(out, "\n{:1$}", "", 2 * self.level)
    }

    /// Before a number or a null.
    fn inline<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        match self.item.take() {
            Some(false) => out.write_all(b" "),
            _ => Ok(()),
        }
    }

    /// Before anything else.
    fn block<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        match self.item.take() {
            Some(_) => self.line(out),
            None => Ok(()),
        }
    }

    fn open<W: ?Sized + Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.block(out)?;
        self.level += 1;
        self.is_broken = false;
        out.write_all(bracket)
    }

    fn close<W: ?Sized + Write>(&mut self, out: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.level -= 1;
        self.item = None;
        if self.is_broken {
            self.line(out)?;
        }
        self.is_broken = true;
        out.write_all(bracket)
    }
}

/// Methods of a formatter that write numbers.
macro_rules! numbers {
    ($($name:ident: $number:ty),+) => {$(
        fn $name<W: ?Sized + Write>(&mut self, out: &mut W, value: $number) -> io::Result<()> {
            self.inline(out)?;
            CompactFormatter.$name(out, value)
        }
    )+};
}

impl Formatter for Layout {
    numbers!(write_u8: u8, write_u16: u16, write_u32: u32, write_u64: u64);
    numbers!(write_i8: i8, write_i16: i16, write_i32: i32, write_i64: i64);
    numbers!(write_f32: f32, write_f64: f64);

    fn write_null<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.inline(out)?;
        out.write_all(b"null")
    }

    fn begin_string<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.block(out)?;
        out.write_all(b"\"")
    }

    fn write_string_fragment<W: ?Sized + Write>(
        &mut self,
        out: &mut W,
        fragment: &str,
    ) -> io::Result<()> {
        write_visible(out, fragment)
    }

    fn begin_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.open(out, b"[")
    }

    fn end_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.close(out, b"]")
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.item = Some(first);
        out.write_all(if first { b"".as_slice() } else { b"," })
    }

    fn begin_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.open(out, b"{")
    }

    fn end_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.close(out, b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        out.write_all(if first { b"".as_slice() } else { b"," })?;
        self.line(out)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_share_a_line_and_all_else_has_its_own() {
        let text = r#"{
  "color": [0.5, 1.0, null],
  "empty": [],
  "names": [
    "a",
    "b"
  ],
  "nested": [
    {
      "n": [1, -2]
    },
    {},
    [3]
  ],
  "one": 1
}
"#;
        let value: serde_json::Value = serde_json::from_str(text).expect("JSON");
        let mut out = Vec::new();
        write(&mut out, &value).expect("a buffer takes everything");
        assert_eq!(String::from_utf8(out).expect("UTF-8"), text);
    }
}
