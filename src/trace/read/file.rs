//! A file of documents: where each begins and ends, and which lines are about one pixel.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use super::error::ReadError;
use super::limits::{MAX_DOCUMENTS, MAX_ERRORS, MAX_FILE_RAYS, MAX_LINE_BYTES};
use super::lines::LineIndex;
use super::notes::Broken;
use super::pixel::{PixelName, PixelRead, pixel};
use super::tape::{Fault, Tape, skip_space, skip_value};
use super::value::JsonValue;
use crate::scene::read::error::Problem;
use crate::trace::facts::PixelFacts;

type Answer = Result<PixelFacts, ReadError>;

/// What was read of a pixel so far.
enum Found {
    Done(Answer),
    /// Lines of flat rays; more may come.
    Lines(PixelName, Box<PixelRead>),
}

/// Reads a file.
pub struct FileReader<'a> {
    bytes: &'a [u8],
    name: &'a str,
    lines: &'a LineIndex<'a>,
    found: Vec<Found>,
    /// Where the lines about a pixel are gathered.
    gathered: HashMap<PixelName, usize>,
    rays: usize,
    errors: usize,
    /// The end of the line that the document begins on.
    line_end: usize,
    /// Once something broke, no document goes beyond the next line that begins with a bracket; this is the start of that line.
    chunk_end: Option<usize>,
}

impl<'a> FileReader<'a> {
    /// A reader at the start of a file.
    pub fn new(bytes: &'a [u8], name: &'a str, lines: &'a LineIndex<'a>) -> Self {
        Self {
            bytes,
            name,
            lines,
            found: Vec::new(),
            gathered: HashMap::new(),
            rays: 0,
            errors: 0,
            line_end: 0,
            chunk_end: None,
        }
    }

    /// All that the file tells.
    pub fn read(mut self) -> Vec<Answer> {
        let mut tape = Tape::default();
        let mut at = if self.bytes.starts_with(b"\xef\xbb\xbf") {
            3
        } else {
            0
        };
        let mut cut = loop {
            at = start_of_document(self.bytes, at);
            if at == self.bytes.len() {
                break None;
            }
            if let Some(problem) = self.too_much() {
                break Some(problem);
            }
            at = self.document(&mut tape, at);
        };
        let (file, lines) = (self.name, self.lines);
        let finished = self.found.into_iter().map(|found| match found {
            Found::Done(answer) => answer,
            Found::Lines(name, read) => read.finish(false).map_err(|broken| {
                ReadError::new(file, lines, broken.at, broken.field, broken.problem).of(&name)
            }),
        });
        // Whether the lines about a pixel fit together is known only now, and counts as well.
        let mut errors = 0;
        let mut answers: Vec<_> = finished
            .filter(|answer| {
                errors += usize::from(answer.is_err());
                answer.is_ok() || errors <= MAX_ERRORS
            })
            .collect();
        if errors > MAX_ERRORS {
            cut = cut.or_else(|| Some(too_many_errors()));
        }
        let cut = cut.map(|problem| ReadError::new(file, lines, at, String::new(), problem));
        answers.extend(cut.map(|error| Err(error.of(&PixelName::default()))));
        answers
    }

    /// Why nothing more of the file is read.
    fn too_much(&self) -> Option<Problem> {
        let (what, cure) = if self.found.len() >= MAX_DOCUMENTS {
            (
                format!("tells of more than {MAX_DOCUMENTS} pixels"),
                "write only those that are asked for",
            )
        } else if self.rays > MAX_FILE_RAYS {
            (
                format!("has more than {MAX_FILE_RAYS} rays"),
                "write only the pixels that are asked for",
            )
        } else if self.errors >= MAX_ERRORS {
            return Some(too_many_errors());
        } else {
            return None;
        };
        Some(Problem::new(what, cure))
    }

    /// Reads the document that begins at `at`; gives the place behind it.
    fn document(&mut self, tape: &mut Tape, at: usize) -> usize {
        let all = self.bytes;
        if at >= self.line_end {
            self.line_end =
                memchr::memchr(b'\n', &all[at..]).map_or(all.len(), |length| at + length);
        }
        if self.line_end - at > MAX_LINE_BYTES {
            let what = format!(
                "a line has {} MiB; {} at most",
                (self.line_end - at) >> 20,
                MAX_LINE_BYTES >> 20
            );
            let problem = Problem::new(what, "write one document a line");
            self.fail(at, String::new(), problem, &PixelName::default());
            return self.line_end;
        }
        if let Some(end) = &mut self.chunk_end
            && at >= *end
        {
            *end = end_of_chunk(all, at);
        }
        let bytes = &all[..self.chunk_end.unwrap_or(all.len())];
        match tape.read(bytes, at) {
            Ok(end) => {
                self.take(JsonValue::top(tape, bytes));
                end
            }
            Err(fault) => self.after(fault, at),
        }
    }

    /// The place where to go on after a document that cannot be read.
    fn after(&mut self, fault: Fault, at: usize) -> usize {
        let whole = skip_value(
            &self.bytes[..self.chunk_end.unwrap_or(self.bytes.len())],
            at,
        );
        self.fail(
            fault.at,
            String::new(),
            fault.problem,
            &PixelName::default(),
        );
        match whole.filter(|end| *end > at) {
            Some(end) if !fault.is_syntax => end,
            _ => {
                let end = *self
                    .chunk_end
                    .get_or_insert_with(|| end_of_chunk(self.bytes, at));
                whole
                    .filter(|whole| (at + 1..=end).contains(whole))
                    .unwrap_or(end)
            }
        }
    }

    /// Takes a document in.
    fn take(&mut self, top: JsonValue) {
        let mut name = PixelName::default();
        let read = pixel(top, &mut name);
        self.rays += read.as_ref().map_or(0, |read| read.list.rays.len());
        match read {
            Ok(read) if read.has_tree => match read.finish(true) {
                Ok(facts) => self.found.push(Found::Done(Ok(facts))),
                Err(broken) => self.fail(broken.at, broken.field, broken.problem, &name),
            },
            Ok(read) => self.gather(name, read, top),
            Err(broken) => {
                let known = self
                    .gathered
                    .get(&name)
                    .copied()
                    .filter(|_| name.pixel.is_some());
                let Broken { field, at, problem } = broken;
                self.fail(at, field, problem, &name);
                // The other lines about this pixel are a part of what it told.
                if let Some(known) = known
                    && let Some(error) = self.found.pop()
                {
                    self.found[known] = error;
                }
            }
        }
    }

    /// Puts a line to the others about its pixel.
    fn gather(&mut self, name: PixelName, read: PixelRead, top: JsonValue) {
        let index = match self.gathered.entry(name.clone()) {
            Entry::Vacant(vacant) => {
                vacant.insert(self.found.len());
                self.found.push(Found::Lines(name, Box::new(read)));
                return;
            }
            Entry::Occupied(known) => *known.get(),
        };
        if let Found::Lines(_, known) = &mut self.found[index]
            && let Err(broken) = known.add(read, top)
        {
            let error = ReadError::new(
                self.name,
                self.lines,
                broken.at,
                broken.field,
                broken.problem,
            );
            self.found[index] = Found::Done(Err(error.of(&name)));
            self.errors += 1;
        }
    }

    fn fail(&mut self, at: usize, field: String, problem: Problem, name: &PixelName) {
        let error = ReadError::new(self.name, self.lines, at, field, problem);
        self.found.push(Found::Done(Err(error.of(name))));
        self.errors += 1;
    }
}

/// Why no more errors are told.
fn too_many_errors() -> Problem {
    let what = format!("has more than {MAX_ERRORS} errors; the rest is not read");
    Problem::new(what, "mend the first ones")
}

/// Where the next document begins: behind white space, and behind the brackets and commas of a list of documents.
fn start_of_document(bytes: &[u8], mut at: usize) -> usize {
    loop {
        at = skip_space(bytes, at);
        match bytes.get(at) {
            Some(b'[' | b',' | b']') => at += 1,
            Some(_) => return at,
            None => return bytes.len(),
        }
    }
}

/// The start of the next line that begins with a bracket.
fn end_of_chunk(bytes: &[u8], at: usize) -> usize {
    let ends = memchr::memchr_iter(b'\n', &bytes[at..]).map(|end| at + end + 1);
    let mut starts = ends.filter(|start| matches!(bytes.get(*start), Some(b'{' | b'[')));
    starts.next().unwrap_or(bytes.len())
}
