//! Reading of ray trees that anyone wrote: format `raytree/1` with many freedoms, as facts. Nothing in them is trusted.
//!
//! A file is one document, one a line (NDJSON), a list of documents, or flat rays, one a line. All fields but `kind` may be
//! missing; a field that holds no value of its kind is told as nothing, and the rest is read. What breaks a document breaks this
//! one alone. The book has the whole list, and the limits.
//!
//! A document becomes a tape of values (`tape`), these become rays (`ray`, `tree`), and rays in any order become a tree
//! (`assemble`). No step recurses, and none takes time or memory that grows faster than the file.

mod assemble;
mod error;
mod fields;
mod file;
mod kind;
pub mod limits;
mod lines;
mod notes;
mod parts;
mod pixel;
mod place;
mod ray;
mod scalar;
mod tape;
#[cfg(test)]
mod tests;
mod tree;
mod typed;
mod value;

pub use error::ReadError;

use super::facts::PixelFacts;
use crate::scene::read::error::Problem;
use file::FileReader;
use limits::MAX_TREE_FILE_BYTES;
use lines::LineIndex;

/// The pixels that a file tells of, in its order; of one that cannot be read the error. `name` is that of the file in errors.
///
/// A file that has no document, or that is too long, is one error. Two documents of one pixel are two answers.
pub fn read_trees(bytes: &[u8], name: &str) -> Vec<Result<PixelFacts, ReadError>> {
    let lines = LineIndex::new(bytes);
    let whole = |what: String, cure: &str| {
        let problem = Problem::new(what, cure);
        vec![Err(ReadError::new(name, &lines, 0, String::new(), problem))]
    };
    if bytes.len() > MAX_TREE_FILE_BYTES {
        let what = format!(
            "has {} MiB; {} at most",
            bytes.len() >> 20,
            MAX_TREE_FILE_BYTES >> 20
        );
        return whole(what, "write several files");
    }
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        let cure = "save it as UTF-8; `>` of an old PowerShell writes UTF-16, `| Out-File -Encoding utf8` does not";
        return whole("is UTF-16 text, and UTF-8 is wanted".to_owned(), cure);
    }
    let answers = FileReader::new(bytes, name, &lines).read();
    if answers.is_empty() {
        return whole(
            "has no ray tree in it".to_owned(),
            "write a document, or a line for each ray",
        );
    }
    answers
}
