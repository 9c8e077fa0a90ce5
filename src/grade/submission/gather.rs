//! What was read so far of a submission, within its limits.

use std::collections::HashMap;
use std::io::{self, Read};

use super::limits::{
    MAX_ENTRIES, MAX_FILES, MAX_RATIO, MAX_SUBMITTED_BYTES, MAX_TOLD, MAX_UNPACKED_BYTES,
    SMALL_ENTRY_BYTES,
};
use super::path::{archive_kind, cleaned, is_hidden};
use super::{Submission, SubmittedFile};
use crate::scene::printable::excerpt;
use crate::trace::format::counted;

/// What was read so far.
#[derive(Debug, Default)]
pub struct Gathered {
    files: Vec<SubmittedFile>,
    problems: Vec<String>,
    untold: usize,
    bytes: u64,
    entries: usize,
    /// The names by their small letters.
    names: HashMap<String, String>,
}

impl Gathered {
    /// Tells that a file is refused.
    pub fn refuse(&mut self, path: &[u8], why: &str) {
        let shown = excerpt(&String::from_utf8_lossy(&path[..path.len().min(1000)]));
        self.tell(format!("`{shown}` is refused: {why}"));
    }

    /// Tells a problem.
    pub fn tell(&mut self, problem: String) {
        if self.problems.len() < MAX_TOLD {
            self.problems.push(problem);
        } else {
            self.untold += 1;
        }
    }

    /// Counts an entry; false, and a problem, once there are too many.
    pub fn counts(&mut self) -> bool {
        self.entries += 1;
        if self.entries == MAX_ENTRIES + 1 {
            self.tell(format!(
                "has more than {MAX_ENTRIES} entries; the others are not looked at"
            ));
        }
        self.entries <= MAX_ENTRIES
    }

    /// The path as it is written here if a file of this name is wanted; hidden ones are passed in silence, others are refused
    /// in words.
    pub fn wanted(&mut self, path: &[u8]) -> Option<String> {
        let name = match cleaned(path) {
            Ok(name) => name,
            Err(why) => {
                self.refuse(path, why);
                return None;
            }
        };
        if is_hidden(&name) {
            return None;
        }
        if let Some(other) = self.names.get(&name.to_lowercase()) {
            let why = if *other == name {
                "another file has its name".to_owned()
            } else {
                format!(
                    "its name differs from `{}` in nothing but capitals",
                    excerpt(other)
                )
            };
            self.refuse(path, &why);
            return None;
        }
        if self.files.len() >= MAX_FILES {
            self.refuse(path, &format!("a submission has {MAX_FILES} files at most"));
            return None;
        }
        Some(name)
    }

    /// Takes a file in; an archive is refused.
    pub fn take(&mut self, name: String, bytes: Vec<u8>) {
        if let Some(kind) = archive_kind(&name, &bytes) {
            let why = format!(
                "it is an archive ({kind}), and only a .zip that is handed in alone is opened"
            );
            self.refuse(name.as_bytes(), &why);
            return;
        }
        self.bytes += bytes.len() as u64;
        self.names.insert(name.to_lowercase(), name.clone());
        self.files.push(SubmittedFile { name, bytes });
    }

    /// Reads a file to its end; an error if it is too long, by itself or together with those before, or made of much less.
    /// `packed` tells from how many bytes it was unpacked so far, if it was packed.
    pub fn read(
        &self,
        mut file: impl Read,
        packed: impl Fn() -> Option<u64>,
    ) -> Result<Vec<u8>, String> {
        let left = MAX_UNPACKED_BYTES - self.bytes;
        let mut bytes = Vec::new();
        loop {
            let before = bytes.len();
            let read = file.by_ref().take(1 << 16).read_to_end(&mut bytes);
            read.map_err(|e| unreadable(&e))?;
            let length = bytes.len() as u64;
            if length > MAX_SUBMITTED_BYTES {
                return Err(format!(
                    "it has more than {} MiB",
                    MAX_SUBMITTED_BYTES >> 20
                ));
            }
            if length > left {
                return Err(format!(
                    "with it the submission has more than {} MiB",
                    MAX_UNPACKED_BYTES >> 20
                ));
            }
            if length > SMALL_ENTRY_BYTES
                && packed().is_some_and(|packed| length > MAX_RATIO * packed)
            {
                return Err(format!(
                    "it unpacks to more than {MAX_RATIO} times its size"
                ));
            }
            if bytes.len() == before {
                return Ok(bytes);
            }
        }
    }

    /// All of it, sorted.
    pub fn submission(mut self, name: String) -> Submission {
        self.files.sort_by(|a, b| a.name.cmp(&b.name));
        if self.untold > 0 {
            self.problems
                .push(counted(self.untold as u64, "more problem"));
        }
        Submission {
            name,
            files: self.files,
            problems: self.problems,
        }
    }
}

/// An error of the operating system, or of an archive, in words.
pub fn unreadable(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "reading it is not permitted".to_owned(),
        io::ErrorKind::UnexpectedEof => "it ends too early; was it cut on its way?".to_owned(),
        _ => format!("it cannot be read: {}", excerpt(&error.to_string())),
    }
}
