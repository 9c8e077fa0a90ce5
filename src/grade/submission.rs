//! What a student hands in: a folder, an archive or a file, all of it in memory. Nothing in it is trusted.

/// What one student handed in.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Submission {
    /// Of the folder, archive or file, without an ending.
    pub name: String,
    /// The files that were read, sorted by name.
    pub files: Vec<SubmittedFile>,
    /// What was refused, or could not be read, and why: a sentence each.
    pub problems: Vec<String>,
}

/// A file that was handed in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SubmittedFile {
    /// Its path from the top of the submission, with `/` between folders.
    pub name: String,
    /// All that is in it.
    pub bytes: Vec<u8>,
}

impl Submission {
    /// The file of this name.
    pub fn file(&self, name: &str) -> Option<&SubmittedFile> {
        self.files.iter().find(|file| file.name == name)
    }
}
