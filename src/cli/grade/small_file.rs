//! Small files of text that grading takes beside the task: lists of students, what a platform tells.

use std::fs;
use std::path::Path;

use crate::cli::Failure;
use crate::scene::printable::excerpt;

/// Bytes of such a file at most.
const MAX_BYTES: u64 = 16 << 20;

/// The text of a regular file of at most 16 MiB; `what` it should be is told where it is larger.
pub fn text_of(path: &Path, what: &str) -> Result<String, Failure> {
    let metadata = fs::metadata(path).map_err(|error| unreadable(path, &error))?;
    if !metadata.is_file() || metadata.len() > MAX_BYTES {
        let problem = format!("is no file of at most 16 MiB: no {what}");
        return Err(broken(path, &problem));
    }
    fs::read_to_string(path).map_err(|error| unreadable(path, &error))
}

/// What is wrong with such a file.
pub fn broken(path: &Path, problem: &str) -> Failure {
    let shown = excerpt(&path.to_string_lossy());
    Failure::Input(format!("{shown}: {problem}"))
}

fn unreadable(path: &Path, error: &std::io::Error) -> Failure {
    broken(path, &format!("cannot be read: {error}"))
}
