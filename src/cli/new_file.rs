//! New file: without a name, or with one that nobody sees, until it is whole.
//!
//! Where the system can make a file without a name, nothing of it is left whatever ends the program. Elsewhere it has a temporary
//! name, which is removed when the program is told to end.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Seek as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile};

/// Temporary names in use. Who holds the lock keeps others from giving or taking away a name.
static NAMES: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn names() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    NAMES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all files with temporary names, then does what ends the program: no such name is made meanwhile.
pub fn remove_all_then(end: impl FnOnce()) {
    let names = names();
    for name in names.iter() {
        // Nobody is left to be told that it cannot be removed.
        let _ = fs::remove_file(name);
    }
    end();
}

/// New file in the making.
pub enum NewFile {
    /// It has no name.
    Unnamed(File),
    /// It has a temporary one.
    Named(NamedTempFile),
}

impl NewFile {
    /// Empty file that is to be in this folder.
    pub fn in_folder(folder: &Path) -> io::Result<Self> {
        if let Some(file) = without_name(folder) {
            return Ok(Self::Unnamed(file));
        }
        Self::named(folder)
    }

    fn named(folder: &Path) -> io::Result<Self> {
        let mut builder = Builder::new();
        // As any other new file: readable for all, if the user's mask allows it.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut names = names();
        let file = builder.tempfile_in(folder).map_err(|e| without_path(&e))?;
        names.insert(file.path().to_owned());
        Ok(Self::Named(file))
    }

    /// The open file.
    pub fn file(&mut self) -> &mut File {
        match self {
            Self::Unnamed(file) => file,
            Self::Named(file) => file.as_file_mut(),
        }
    }

    /// Gives it the name `path`, in its folder, in place of what is there.
    pub fn replace(mut self, path: &Path) -> io::Result<()> {
        // What is named before it is on the disk may be empty after a power cut.
        self.file().sync_all()?;
        match self {
            Self::Unnamed(file) => replace_unnamed(file, path),
            Self::Named(file) => {
                let mut names = names();
                let name = file.path().to_owned();
                let done = file.persist(path).map_err(|e| without_path(&e.error));
                names.remove(&name);
                done.map(drop)
            }
        }
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new("."))
}

fn replace_unnamed(mut file: File, path: &Path) -> io::Result<()> {
    let guard = names();
    if give_name(&file, path).is_ok() {
        return Ok(());
    }
    // There is an old file: a name cannot be given in its place, but one that is given already can.
    let linked = Builder::new().make_in(folder_of(path), |name| give_name(&file, name));
    if let Ok(linked) = linked {
        let renamed = linked.into_temp_path().persist(path);
        return renamed.map_err(|e| without_path(&e.error));
    }
    drop(guard);
    // No name can be given, as where /proc is not there: copy it.
    let mut copy = NewFile::named(folder_of(path))?;
    file.rewind()?;
    io::copy(&mut file, copy.file())?;
    copy.file()
        .set_permissions(file.metadata()?.permissions())?;
    copy.replace(path)
}

/// File without a name in a folder, if the system makes such files there.
#[cfg(target_os = "linux")]
fn without_name(folder: &Path) -> Option<File> {
    use rustix::fs::{Mode, OFlags, open};
    let flags = OFlags::TMPFILE | OFlags::RDWR | OFlags::CLOEXEC;
    open(folder, flags, Mode::from_raw_mode(0o666))
        .ok()
        .map(File::from)
}

#[cfg(not(target_os = "linux"))]
fn without_name(_: &Path) -> Option<File> {
    None
}

/// Gives a file without a name its first one.
#[cfg(target_os = "linux")]
fn give_name(file: &File, path: &Path) -> io::Result<()> {
    use rustix::fs::{AtFlags, CWD, linkat};
    use std::os::fd::AsRawFd as _;
    // The way that needs no privilege: see open(2), O_TMPFILE.
    let open = format!("/proc/self/fd/{}", file.as_raw_fd());
    Ok(linkat(CWD, open, CWD, path, AtFlags::SYMLINK_FOLLOW)?)
}

#[cfg(not(target_os = "linux"))]
fn give_name(_: &File, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// The error without the temporary name that is in its text: it means nothing to a user.
fn without_path(error: &io::Error) -> io::Error {
    error
        .raw_os_error()
        .map_or_else(|| error.kind().into(), io::Error::from_raw_os_error)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    /// The files of a folder.
    fn listed(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder");
        let name = |entry: io::Result<fs::DirEntry>| entry.expect("an entry").file_name();
        entries
            .map(|e| name(e).to_string_lossy().into_owned())
            .collect()
    }

    #[test]
    fn with_and_without_a_name_it_takes_its_place_when_it_is_whole() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.png");
        for (make, text) in [
            (
                NewFile::in_folder as fn(&Path) -> io::Result<NewFile>,
                "one",
            ),
            (NewFile::in_folder, "two"),
            (NewFile::named, "three"),
        ] {
            let mut new = make(folder.path()).expect("a file");
            new.file().write_all(text.as_bytes()).expect("room");
            assert_ne!(fs::read_to_string(&path).ok().as_deref(), Some(text));
            new.replace(&path).expect("in its place");
            assert_eq!(fs::read_to_string(&path).expect("a file"), text);
            assert_eq!(listed(folder.path()), ["a.png"]);
        }
    }

    #[test]
    fn what_is_not_whole_is_removed() {
        let folder = tempfile::tempdir().expect("a folder");
        drop(NewFile::in_folder(folder.path()).expect("a file"));
        drop(NewFile::named(folder.path()).expect("a file"));
        assert!(listed(folder.path()).is_empty());
        let _new = NewFile::named(folder.path()).expect("a file");
        assert_eq!(listed(folder.path()).len(), 1);
        remove_all_then(|| assert!(listed(folder.path()).is_empty()));
        assert!(
            NewFile::named(&folder.path().join("none"))
                .is_err_and(|e| !e.to_string().contains(".tmp"))
        );
    }
}
