//! Small files of text that grading takes beside the task: lists of students, what a platform tells.

use std::io::Read as _;
use std::path::Path;

use crate::cli::Failure;
use crate::scene::error::Problem;
use crate::scene::printable::excerpt;
use crate::scene::read::files::{regular, unreadable};

/// Bytes of such a file at most.
const MAX_BYTES: u64 = 16 << 20;

/// The text of a regular file of at most 16 MiB; `what` it should be is told where it is larger.
pub fn text_of(path: &Path, what: &str) -> Result<String, Failure> {
    let wrong = |problem: Problem| Failure::Scene(problem.in_file(&path.to_string_lossy()));
    let (mut file, length) = regular(path, ".csv, .txt or .json").map_err(wrong)?;
    if length > MAX_BYTES {
        let problem = format!("is no file of at most 16 MiB: no {what}");
        return Err(broken(path, &problem));
    }
    let mut text = String::new();
    let read = file.read_to_string(&mut text);
    read.map_err(|error| wrong(unreadable(&error)))?;
    Ok(text)
}

/// What is wrong with such a file.
pub fn broken(path: &Path, problem: &str) -> Failure {
    let shown = excerpt(&path.to_string_lossy());
    Failure::Input(format!("{shown}: {problem}"))
}
