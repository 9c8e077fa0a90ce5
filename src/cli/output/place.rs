//! TargetPlace of a result: where a path that the user gave leads, and whether it may be written there.

use std::fs::{self, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use super::{Failure, shown};
use crate::scene::FileId;

/// File that a flag asks for.
#[derive(Clone, Copy)]
pub struct Target<'a> {
    /// The flag, for messages.
    pub flag: &'static str,
    /// Its value, if it is given.
    pub path: Option<&'a Path>,
    /// Endings of names that say what is written there.
    pub endings: &'static [&'static str],
}

/// Endings that say what is in a file: something else under such a name would deceive its reader.
const TELLING: [&str; 27] = [
    "png", "pfm", "jpg", "jpeg", "gif", "bmp", "tif", "tiff", "webp", "avif", "ppm", "exr", "hdr",
    "svg", "html", "htm", "pdf", "json", "csv", "dot", "gv", "obj", "txt", "xml", "toml", "zip",
    "mtl",
];

/// Links that are followed at most, as by the system.
const MAX_LINKS: usize = 40;

/// TargetPlace of a result.
pub struct TargetPlace {
    /// As the user gave it.
    pub path: PathBuf,
    /// The file behind all links.
    pub file: PathBuf,
    /// What is there now, if anything is.
    pub old: Option<Metadata>,
    id: Option<FileId>,
}

impl TargetPlace {
    /// The place of a target, if it is given.
    pub fn of(target: &Target) -> Result<Option<Self>, Failure> {
        let Some(path) = target.path else {
            return Ok(None);
        };
        let place = Self::find(path).map_err(|source| Failure::output(path, source))?;
        Ok(Some(place))
    }

    fn find(path: &Path) -> io::Result<Self> {
        let old = match path.metadata() {
            Ok(metadata) => Some(metadata),
            Err(e) if e.kind() == io::ErrorKind::NotFound => None,
            Err(e) => return Err(e),
        };
        let is_folder = old.as_ref().is_some_and(Metadata::is_dir);
        if is_folder || path.as_os_str().as_encoded_bytes().ends_with(b"/") {
            return Err(told(
                io::ErrorKind::IsADirectory,
                "this is a folder; give the name of a file",
            ));
        }
        let file = match &old {
            Some(old) if old.is_file() => path.canonicalize()?,
            Some(_) => path.to_owned(),
            None => new_file(path)?,
        };
        Ok(Self {
            path: path.to_owned(),
            id: FileId::at(&file).ok().filter(|_| old.is_some()),
            file,
            old,
        })
    }

    /// Whether it is a file that is to be made or replaced, not a device or a pipe.
    pub fn is_file(&self) -> bool {
        self.old.as_ref().is_none_or(Metadata::is_file)
    }

    /// An error if the name of a file says that something else is in it.
    pub fn check_ending(&self, target: &Target) -> Result<(), Failure> {
        let ending = self.path.extension().and_then(|e| e.to_str());
        let ending = ending.unwrap_or_default().to_ascii_lowercase();
        let tells = self.is_file() && TELLING.contains(&ending.as_str());
        if !tells || target.endings.contains(&ending.as_str()) {
            return Ok(());
        }
        let (flag, path) = (target.flag, shown(Some(&self.path)));
        let possible = target.endings.join(" or .");
        Err(Failure::Usage(format!(
            "{flag} {path}: what is written there is no .{ending} file; give a name that ends in .{possible}"
        )))
    }

    /// Whether it is one of these files.
    pub fn is_among(&self, files: &[FileId]) -> bool {
        self.id.as_ref().is_some_and(|id| files.contains(id))
    }

    /// Whether two results would be written to one file.
    pub fn is_same(&self, other: &Self) -> bool {
        let same = self.file == other.file || self.id.is_some() && self.id == other.id;
        self.is_file() && same
    }
}

/// The path of a file that is not there yet: that to which links lead, in a folder that is there.
fn new_file(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MAX_LINKS {
        let Ok(next) = fs::read_link(&path) else {
            break;
        };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    let name = path
        .file_name()
        .ok_or_else(|| told(io::ErrorKind::InvalidInput, "a file needs a name"))?;
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    match folder.canonicalize() {
        Ok(folder) => Ok(folder.join(name)),
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            Err(told(e.kind(), "its folder does not exist; make it first"))
        }
        Err(e) => Err(e),
    }
}

fn told(kind: io::ErrorKind, what: &str) -> io::Error {
    io::Error::new(kind, what)
}
