//! Files of a course, all of them in memory: the embedded ones, a folder, or a zip archive. Nothing in them is trusted.

use std::collections::BTreeMap;
use std::path::Path;

use include_dir::{Dir, DirEntry, include_dir};
use thiserror::Error;

use crate::grade::submission::Submission;
use crate::scene::printable::excerpt;

/// The course that the program brings along.
static EMBEDDED: Dir = include_dir!("$CARGO_MANIFEST_DIR/lessons");

/// Bytes of a text of a course at most.
const MAX_TEXT_BYTES: usize = 1 << 20;

/// What is wrong with a course: the file, and what is wrong there.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{file}: {what}")]
pub struct CourseError {
    /// The file, by its path in the course.
    pub file: String,
    /// What is wrong, and what to do.
    pub what: String,
}

impl CourseError {
    /// An error in a file.
    pub fn new(file: &str, what: impl Into<String>) -> Self {
        Self {
            file: excerpt(file),
            what: what.into(),
        }
    }
}

/// The files of a course by their paths, with `/` between folders.
#[derive(Clone, Debug, Default)]
pub struct CourseFiles {
    /// How the user names the course; empty for the embedded one.
    pub place: String,
    files: BTreeMap<String, Vec<u8>>,
}

impl CourseFiles {
    /// The embedded course.
    pub fn embedded() -> Self {
        let mut files = BTreeMap::new();
        let mut open = vec![&EMBEDDED];
        while let Some(folder) = open.pop() {
            for entry in folder.entries() {
                match entry {
                    DirEntry::Dir(inner) => open.push(inner),
                    DirEntry::File(file) => {
                        let name = file.path().to_string_lossy().replace('\\', "/");
                        files.insert(name, file.contents().to_vec());
                    }
                }
            }
        }
        Self {
            place: String::new(),
            files,
        }
    }

    /// The files of a folder or of a zip archive, within the limits of what students hand in.
    pub fn read(path: &Path) -> Result<Self, CourseError> {
        let place = path.to_string_lossy().into_owned();
        let handed_in = Submission::read(path);
        if let Some(problem) = handed_in.problems.first() {
            return Err(CourseError::new(&place, problem.clone()));
        }
        let all = handed_in.files.into_iter();
        let mut files: BTreeMap<String, Vec<u8>> =
            all.map(|file| (file.name, file.bytes)).collect();
        // An archive has its folder in it, as many programs pack it.
        if !files.contains_key("course.toml") {
            let top = files
                .keys()
                .find_map(|name| name.strip_suffix("/course.toml"));
            if let Some(top) = top.map(|top| format!("{top}/")) {
                let inside = files
                    .into_iter()
                    .filter_map(|(name, bytes)| Some((name.strip_prefix(&top)?.to_owned(), bytes)));
                files = inside.collect();
            }
        }
        Ok(Self { place, files })
    }

    /// Files in memory, for tests.
    pub fn of(place: &str, files: impl IntoIterator<Item = (String, String)>) -> Self {
        let files = files
            .into_iter()
            .map(|(name, text)| (name, text.into_bytes()));
        Self {
            place: place.to_owned(),
            files: files.collect(),
        }
    }

    /// The names of all files.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    /// True if there is such a file.
    pub fn has(&self, name: &str) -> bool {
        self.files.contains_key(name)
    }

    /// The text of a file.
    pub fn text(&self, name: &str) -> Result<&str, CourseError> {
        let bytes = self.files.get(name).ok_or_else(|| {
            CourseError::new(name, "there is no such file in the course; put it there")
        })?;
        if bytes.len() > MAX_TEXT_BYTES {
            return Err(CourseError::new(
                name,
                "has more than 1 MiB; make it shorter",
            ));
        }
        str::from_utf8(bytes).map_err(|_| CourseError::new(name, "is no text in UTF-8"))
    }

    /// The path of a file that a chapter names: in its folder, or `../other/file` in the course. Nothing leads out of the course.
    pub fn beside(folder: &str, name: &str) -> Result<String, String> {
        let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
        for part in name.split('/') {
            match part {
                ".." if parts.pop().is_some() => {}
                "" | "." | ".." => {
                    return Err(format!("`{}` leads out of the course", excerpt(name)));
                }
                part if part.contains(['\\', ':']) => {
                    return Err(format!("`{}` leads out of the course", excerpt(name)));
                }
                part => parts.push(part),
            }
        }
        Ok(parts.join("/"))
    }
}

/// True for the name of a scene file; other scenes are built in.
pub fn is_scene_file(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|e| e == "json")
}

/// A text without control characters, which would steer the terminal.
pub fn clean(text: &str) -> String {
    let keep = |c: char| c == '\n' || !c.is_control();
    text.chars()
        .map(|c| match c {
            '\t' => ' ',
            c if keep(c) => c,
            _ => char::REPLACEMENT_CHARACTER,
        })
        .collect()
}

/// A TOML file as a value; what is wrong with its line.
pub fn from_toml<T: serde::de::DeserializeOwned>(file: &str, text: &str) -> Result<T, CourseError> {
    toml::from_str(text).map_err(|e| {
        let line = e.span().map_or(1, |span| {
            text[..span.start.min(text.len())].matches('\n').count() + 1
        });
        let message = e.message().replace('\n', ", ");
        CourseError::new(file, format!("line {line}: {}", explained(&message)))
    })
}

/// A message of the reader of TOML, with the name that may be meant.
fn explained(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    let guess = message.starts_with("unknown field").then(|| {
        let wrong = quoted.next()?;
        crate::scene::read::did_you_mean::did_you_mean(wrong, quoted)
    });
    match guess.flatten() {
        Some(near) => format!("{message}; did you mean `{near}`?"),
        None => message.to_owned(),
    }
}
