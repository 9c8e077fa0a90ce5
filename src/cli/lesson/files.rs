//! `raytree lesson start`, `new` and `book`: files that are written into a folder.

use std::fmt::Write as _;
use std::fs::{self, OpenOptions};
use std::io::{self, Write as _};
use std::path::Path;

use super::wrong;
use crate::cli::output::to_stdout;
use crate::cli::{Completion, Failure};
use crate::lesson::Course;
use crate::lesson::book::pages;
use crate::lesson::template::template;
use crate::lesson::workspace::start_files;

/// Puts the files of exercises into a folder; what is there stays.
pub fn start(course: &Course, dir: &Path) -> Result<Completion, Failure> {
    let files = start_files(course).map_err(Failure::Input)?;
    let mut out = String::new();
    for (name, bytes) in &files {
        let path = dir.join(name);
        match write_new(&path, bytes) {
            Ok(()) => {
                let _ = writeln!(out, "{}", path.display());
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                let _ = writeln!(
                    out,
                    "{} is there already, and stays as it is",
                    path.display()
                );
            }
            Err(source) => return Err(failed(&path, source)),
        }
    }
    to_stdout(out.as_bytes())
}

/// Makes a small course in a folder that is not there yet.
pub fn new(dir: &Path) -> Result<Completion, Failure> {
    if dir.exists() {
        let what = format!("{} is there already; name a new folder", dir.display());
        return Err(Failure::Usage(what));
    }
    for (name, text) in template() {
        let path = dir.join(name);
        write_new(&path, text.as_bytes()).map_err(|source| failed(&path, source))?;
    }
    let dir = dir.display();
    to_stdout(
        format!(
            "{dir} has a course of one chapter. Change it, then:\n\
             raytree lesson check {dir}\nraytree lesson --lessons {dir}\n"
        )
        .as_bytes(),
    )
}

/// Writes the pages of a course; what is there is replaced.
pub fn book(course: &Course, dir: &Path) -> Result<Completion, Failure> {
    let pages = pages(course).map_err(|e| wrong(&e))?;
    for (name, bytes) in &pages {
        let path = dir.join(name);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&path, bytes))
            .map_err(|source| failed(&path, source))?;
    }
    to_stdout(format!("{} files in {}\n", pages.len(), dir.display()).as_bytes())
}

/// Writes a file that is not there yet.
fn write_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(bytes)
}

fn failed(path: &Path, source: io::Error) -> Failure {
    Failure::Output {
        path: Some(path.to_owned()),
        source,
    }
}
