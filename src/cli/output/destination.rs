//! Destination of a result: opened before the work that makes the result, so that it is known to be possible.

use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::Failure;
use super::place::TargetPlace;
use crate::cli::new_file::NewFile;

/// Destination of a result.
pub struct Destination {
    path: PathBuf,
    way: Way,
}

/// How a result gets there.
enum Way {
    /// Into a device or a pipe, as it comes.
    Into(File),
    /// In place of the file of this path, when it is whole.
    Replaces(PathBuf, NewFile),
}

impl Destination {
    /// Opens what is needed to write there; nothing of an old file is touched.
    pub fn open(place: TargetPlace) -> Result<Self, Failure> {
        let TargetPlace {
            path, file, old, ..
        } = place;
        match open(file, old) {
            Ok(way) => Ok(Self { path, way }),
            Err(source) => Err(Failure::output(&path, source)),
        }
    }

    /// The path that the user gave.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the result: a file is whole afterwards, or untouched.
    pub fn write(
        self,
        produce: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let written = match self.way {
            Way::Into(mut file) => buffered(&mut file, produce),
            Way::Replaces(path, mut new) => {
                buffered(new.file(), produce).and_then(|()| new.replace(&path))
            }
        };
        written.map_err(|source| Failure::output(&self.path, source))
    }
}

fn buffered(
    file: &mut File,
    produce: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = io::BufWriter::new(file);
    produce(&mut out)?;
    out.flush()
}

fn open(path: PathBuf, old: Option<Metadata>) -> io::Result<Way> {
    let Some(old) = old else {
        let new = NewFile::in_folder(path.parent().unwrap_or(Path::new(".")))?;
        return Ok(Way::Replaces(path, new));
    };
    if !old.is_file() {
        if !takes_text(&old) {
            return Err(io::Error::new(
                io::ErrorKind::InvalidInput,
                "this is neither a file nor a pipe; give the name of a file",
            ));
        }
        return OpenOptions::new().write(true).open(path).map(Way::Into);
    }
    // By the rights on a folder alone a file could be replaced that may not be written.
    if old.permissions().readonly() {
        return Err(io::Error::new(
            io::ErrorKind::PermissionDenied,
            "the file is read-only; make it writable, or give another name",
        ));
    }
    OpenOptions::new().write(true).open(&path)?;
    let mut new = NewFile::in_folder(path.parent().unwrap_or(Path::new(".")))?;
    take_over(new.file(), &old)?;
    Ok(Way::Replaces(path, new))
}

/// Whether bytes can be written one after the other to what is no file: to a pipe or a terminal, not to a disk.
#[cfg(unix)]
fn takes_text(old: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    let kind = old.file_type();
    kind.is_fifo() || kind.is_char_device()
}

#[cfg(not(unix))]
fn takes_text(_: &Metadata) -> bool {
    true
}

/// Gives a new file the owner, where that is permitted, and the mode of an old one.
fn take_over(new: &File, old: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt as _, fchown};
        // Only the superuser may give files away.
        let _ = fchown(new, Some(old.uid()), Some(old.gid()));
    }
    new.set_permissions(old.permissions())
}
