//! Identity of a file, whatever path leads to it.

use std::fs::File;
use std::io;
use std::path::Path;

/// What tells a file from all others: its device and its number there.
#[cfg(unix)]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileId {
    device: u64,
    inode: u64,
}

/// What tells a file from all others: its path without links.
#[cfg(not(unix))]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileId {
    path: std::path::PathBuf,
}

#[cfg(unix)]
impl FileId {
    /// Identity of the file at a path.
    pub fn at(path: &Path) -> io::Result<Self> {
        path.metadata().map(|metadata| Self::of_metadata(&metadata))
    }

    /// Identity of what is at a path; of a link that of the link.
    pub fn at_link(path: &Path) -> io::Result<Self> {
        path.symlink_metadata()
            .map(|metadata| Self::of_metadata(&metadata))
    }

    /// Identity of a file that was opened at a path.
    pub fn of(file: &File, _: &Path) -> io::Result<Self> {
        file.metadata().map(|metadata| Self::of_metadata(&metadata))
    }

    fn of_metadata(metadata: &std::fs::Metadata) -> Self {
        use std::os::unix::fs::MetadataExt;
        Self {
            device: metadata.dev(),
            inode: metadata.ino(),
        }
    }
}

#[cfg(not(unix))]
impl FileId {
    /// Identity of the file at a path.
    pub fn at(path: &Path) -> io::Result<Self> {
        path.canonicalize().map(|path| Self { path })
    }

    /// Identity of what is at a path; of a link that of the link.
    pub fn at_link(path: &Path) -> io::Result<Self> {
        let path = std::path::absolute(path)?;
        if path.is_symlink() {
            return Ok(Self { path });
        }
        Self::at(&path)
    }

    /// Identity of a file that was opened at a path.
    pub fn of(_: &File, path: &Path) -> io::Result<Self> {
        Self::at(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_the_same_by_every_path() {
        let folder = tempfile::tempdir().expect("a folder");
        let [a, b, other] = ["a", "b", "other"].map(|name| folder.path().join(name));
        let file = File::create(&a).expect("a file");
        File::create(&other).expect("a file");
        let id = FileId::of(&file, &a).expect("it is there");
        assert_eq!(
            FileId::at(&folder.path().join(".").join("a")).ok(),
            Some(id.clone())
        );
        assert_ne!(FileId::at(&other).ok(), Some(id.clone()));
        assert!(FileId::at(&b).is_err());
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("a", &b).expect("a link");
            assert_eq!(FileId::at(&b).ok(), Some(id.clone()));
            assert_eq!(FileId::at_link(&a).ok(), Some(id.clone()));
            assert_ne!(FileId::at_link(&b).ok(), Some(id));
        }
    }
}
