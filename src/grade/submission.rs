//! What a student hands in: a folder, a zip archive or a file, all of it in memory. Nothing in it is trusted.
//!
//! A file that is refused or broken is told, and costs the others nothing. No link is followed, no device opened, and nothing
//! unpacked onto the disk.

mod archive;
mod folder;
mod gather;
pub mod limits;
mod path;
pub mod picture;

use std::fs::{self, File};
use std::path::Path;

pub use picture::SubmittedPicture;

use archive::read_archive;
use folder::read_folder;
use gather::{Gathered, unreadable};
use path::{cleaned, is_zip};

/// Part of the names of files that hold answers at hidden pixels: what is wrong in them is counted and not told.
pub const HIDDEN: &str = ".hidden.";

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
    /// What was handed in at a path, which the teacher chose: only the path itself may be a link.
    pub fn read(path: &Path) -> Self {
        let mut gathered = Gathered::default();
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => {
                let name = named(path.file_name());
                let name = name.or_else(|| named(path.canonicalize().ok()?.file_name()));
                read_folder(path, &mut gathered);
                return gathered.submission(name.unwrap_or_default());
            }
            // Asked before it is opened: a pipe would wait for ever, a device has no end.
            Ok(metadata) if metadata.is_file() => {
                let file = File::open(path).map_err(|e| unreadable(&e));
                let bytes = file.and_then(|file| gathered.read(file, || None));
                match bytes {
                    Ok(bytes) => {
                        return Self::of_bytes(&named(path.file_name()).unwrap_or_default(), bytes);
                    }
                    Err(why) => gathered.tell(why),
                }
            }
            Ok(_) => gathered.tell("this is neither a folder nor a regular file".to_owned()),
            Err(e) => gathered.tell(unreadable(&e)),
        }
        gathered.submission(named(path.file_stem()).unwrap_or_default())
    }

    /// The submission that is one file with these bytes: a zip archive with all that is in it, or the file itself.
    pub fn of_bytes(file_name: &str, bytes: Vec<u8>) -> Self {
        let mut gathered = Gathered::default();
        if is_zip(file_name, &bytes) {
            read_archive(&bytes, &mut gathered);
        } else {
            match cleaned(file_name.as_bytes()) {
                Ok(name) => gathered.take(name, bytes),
                Err(why) => gathered.refuse(file_name.as_bytes(), why),
            }
        }
        let stem = Path::new(file_name).file_stem();
        gathered.submission(named(stem).unwrap_or_default())
    }

    /// The file of this name.
    pub fn file(&self, name: &str) -> Option<&SubmittedFile> {
        self.files.iter().find(|file| file.name == name)
    }
}

impl SubmittedFile {
    /// Its name without folders.
    pub fn base_name(&self) -> &str {
        self.name
            .rsplit_once('/')
            .map_or(&self.name, |(_, base)| base)
    }
}

fn named(name: Option<&std::ffi::OsStr>) -> Option<String> {
    name.map(|name| name.to_string_lossy().into_owned())
}
