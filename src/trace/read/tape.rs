//! JSON as a tape: one entry a value, in the order of the text. Nothing here recurses, so no depth of brackets is too much for
//! the stack; numbers and texts stay where they are until someone asks for them.

use super::kind::ValueKind;
use super::limits::{MAX_BRACKETS, MAX_TEXT_BYTES, MAX_VALUES};
use super::scalar::{Scalar, scalar};
use crate::scene::read::error::Problem;

/// A value on the tape.
#[derive(Clone, Copy, Debug)]
pub struct TapeEntry {
    /// Where its text begins, in bytes; that of a text behind its quotation mark.
    pub at: u32,
    /// Where its text ends; of objects and lists the index of the entry behind the last that is inside.
    pub end: u32,
    /// What it is.
    pub kind: ValueKind,
}

/// Why a value cannot be read.
#[derive(Clone, Debug)]
pub struct Fault {
    /// Where, in bytes.
    pub at: usize,
    /// False if its brackets can still be followed to its end: it is only too large.
    pub is_syntax: bool,
    /// What is wrong and what to do.
    pub problem: Problem,
}

/// The values of one document.
#[derive(Debug, Default)]
pub struct Tape {
    /// In the order of the text: what is inside of a value follows it.
    pub entries: Vec<TapeEntry>,
    /// The objects and lists that are not closed.
    open: Vec<u32>,
}

/// The byte at a place, 0 behind the end.
fn byte(bytes: &[u8], at: usize) -> u8 {
    bytes.get(at).copied().unwrap_or(0)
}

/// The first place from `at` on that is no white space.
pub fn skip_space(bytes: &[u8], mut at: usize) -> usize {
    while matches!(byte(bytes, at), b' ' | b'\n' | b'\r' | b'\t') {
        at += 1;
    }
    at
}

impl Tape {
    /// Reads the value that begins at `at`; gives the place behind it.
    pub fn read(&mut self, bytes: &[u8], at: usize) -> Result<usize, Fault> {
        self.entries.clear();
        self.open.clear();
        let mut at = at;
        loop {
            // A value is wanted here. If it is one that has others inside, the first of these is next.
            at = skip_space(bytes, at);
            let first = byte(bytes, at);
            let inside = first == b'{' || first == b'[';
            if inside {
                at = self.open(bytes, at, first)?;
            } else {
                at = self.leaf(bytes, at)?;
            }
            // Behind a value: what encloses it goes on or ends.
            let mut is_first = inside;
            loop {
                let Some(&outer) = self.open.last() else {
                    return Ok(at);
                };
                let in_object = self.entries[outer as usize].kind == ValueKind::Object;
                at = skip_space(bytes, at);
                match (byte(bytes, at), in_object) {
                    (b'}', true) | (b']', false) => {
                        self.close();
                        at += 1;
                        is_first = false;
                    }
                    (b',', _) if !is_first => {
                        at = self.next(bytes, at + 1, in_object)?;
                        break;
                    }
                    (_, _) if is_first => {
                        at = self.next(bytes, at, in_object)?;
                        break;
                    }
                    _ => return Err(no_separator(bytes, at, in_object)),
                }
            }
        }
    }

    fn open(&mut self, bytes: &[u8], at: usize, bracket: u8) -> Result<usize, Fault> {
        if self.open.len() >= MAX_BRACKETS {
            let what = format!("has brackets more than {MAX_BRACKETS} deep");
            return Err(too_large(
                at,
                what,
                "stop your tracer at a depth, such as 5",
            ));
        }
        self.open.push(self.entries.len() as u32);
        let kind = match bracket {
            b'{' => ValueKind::Object,
            _ => ValueKind::List,
        };
        self.push(at, at, kind)?;
        debug_assert!(at < bytes.len());
        Ok(at + 1)
    }

    fn close(&mut self) {
        let end = self.entries.len() as u32;
        if let Some(outer) = self.open.pop() {
            self.entries[outer as usize].end = end;
        }
    }

    /// Before the next value inside of an object, which has a key, or of a list.
    fn next(&mut self, bytes: &[u8], at: usize, in_object: bool) -> Result<usize, Fault> {
        if !in_object {
            return Ok(at);
        }
        let at = skip_space(bytes, at);
        if byte(bytes, at) != b'"' {
            let cure =
                "write the names of fields between quotation marks, and no comma behind the last";
            return Err(syntax(
                bytes,
                at,
                "the name of a field is wanted here",
                cure,
            ));
        }
        let at = skip_space(bytes, self.text(bytes, at + 1)?);
        if byte(bytes, at) != b':' {
            let cure = "write a colon between name and value";
            return Err(syntax(bytes, at, "a colon is wanted here", cure));
        }
        Ok(at + 1)
    }

    /// A value with nothing inside.
    fn leaf(&mut self, bytes: &[u8], at: usize) -> Result<usize, Fault> {
        if byte(bytes, at) == b'"' {
            return self.text(bytes, at + 1);
        }
        let (kind, end) = match scalar(bytes, at) {
            Scalar::Value(kind, end) => (kind, end),
            Scalar::Unknown(problem) => {
                return Err(Fault {
                    at,
                    is_syntax: true,
                    problem,
                });
            }
            Scalar::Nothing => {
                let cure = "write a number, a text, true, false, null, a list or an object, and no comma behind the last";
                return Err(syntax(bytes, at, "a value is wanted here", cure));
            }
        };
        self.push(at, end, kind)?;
        Ok(end)
    }

    /// A text whose first letter is at `at`; gives the place behind its quotation mark.
    fn text(&mut self, bytes: &[u8], at: usize) -> Result<usize, Fault> {
        let (mut end, mut kind) = (at, ValueKind::Text);
        loop {
            match bytes.get(end) {
                Some(b'"') => break,
                Some(b'\\') => {
                    kind = ValueKind::EscapedText;
                    end += 2;
                }
                Some(0..0x20) => {
                    let cure =
                        "write `\\n` for a line end, `\\t` for a tab; is a quotation mark missing?";
                    return Err(syntax(
                        bytes,
                        end,
                        "a text has a control character or a line end in it",
                        cure,
                    ));
                }
                Some(_) => end += 1,
                None => {
                    return Err(syntax(
                        bytes,
                        end,
                        "a text has no end",
                        "close it with a quotation mark",
                    ));
                }
            }
        }
        if end - at > MAX_TEXT_BYTES {
            let what = format!("a text has {} bytes; {MAX_TEXT_BYTES} at most", end - at);
            return Err(too_large(at, what, "write names, not messages"));
        }
        self.push(at, end, kind)?;
        Ok(end + 1)
    }

    fn push(&mut self, at: usize, end: usize, kind: ValueKind) -> Result<(), Fault> {
        if self.entries.len() >= MAX_VALUES {
            let what = format!("has more than {MAX_VALUES} values");
            return Err(too_large(at, what, "write fewer rays a pixel"));
        }
        let (at, end) = (at as u32, end as u32);
        self.entries.push(TapeEntry { at, end, kind });
        Ok(())
    }
}

fn too_large(at: usize, what: String, cure: &str) -> Fault {
    let problem = Problem::new(what, cure);
    Fault {
        at,
        is_syntax: false,
        problem,
    }
}

/// What is there in the place of what is wanted.
fn syntax(bytes: &[u8], at: usize, what: &str, cure: &str) -> Fault {
    let at = at.min(bytes.len());
    let problem = if at == bytes.len() {
        let cure = "close every bracket; was the program stopped before it had written all?";
        Problem::new("the text ends inside of a document", cure)
    } else {
        Problem::new(what, cure)
    };
    Fault {
        at,
        is_syntax: true,
        problem,
    }
}

fn no_separator(bytes: &[u8], at: usize, in_object: bool) -> Fault {
    let (what, cure) = if in_object {
        (
            "a comma or `}` is wanted here",
            "write a comma between two fields",
        )
    } else {
        (
            "a comma or `]` is wanted here",
            "write a comma between two values",
        )
    };
    syntax(bytes, at, what, cure)
}

/// The place behind the value that begins at `at`, by its brackets alone; `None` if they do not close before the end.
pub fn skip_value(bytes: &[u8], at: usize) -> Option<usize> {
    let (mut depth, mut at) = (0usize, skip_space(bytes, at));
    loop {
        match *bytes.get(at)? {
            b'{' | b'[' => depth += 1,
            b'}' | b']' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at + 1);
                }
            }
            b'"' => {
                at += 1;
                loop {
                    match *bytes.get(at)? {
                        b'"' => break,
                        b'\\' => at += 2,
                        _ => at += 1,
                    }
                }
            }
            b',' | b'\n' if depth == 0 => return Some(at),
            _ => {}
        }
        at += 1;
    }
}
