//! Access to the files of a scene: on disk, in memory or inside the program.
//!
//! A scene from elsewhere names other files. It may name those in its own folder and below, and nothing else:
//! relative paths without `..`, regular files, of a bounded size, and symbolic links only if they stay inside.

use std::collections::BTreeMap;
use std::fs;
use std::io::{Read, StdinLock};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use super::error::Problem;
use super::text::{Decoded, decoded};
use crate::scene::FileId;
use crate::scene::limits::{MAX_FILE_BYTES, MAX_SCENE_BYTES};

/// The files of one scene.
#[derive(Clone, Debug)]
pub struct Files {
    folder: Folder,
    /// Bytes read so far.
    bytes: u64,
    hash: blake3::Hasher,
    /// The files on disk that were read so far.
    pub read_from: Vec<FileId>,
}

/// Where paths in a scene file start.
#[derive(Clone, Debug)]
enum Folder {
    /// Inside the program: the text of a file by its name.
    Embedded(fn(&str) -> Option<&'static str>),
    /// On disk.
    Disk(PathBuf),
    /// In memory.
    Memory(Arc<BTreeMap<String, Vec<u8>>>),
}

impl Files {
    /// The files inside the program, each by its name.
    pub fn embedded(text: fn(&str) -> Option<&'static str>) -> Self {
        Self::new(Folder::Embedded(text))
    }

    /// The files in the folder of the file at `path`.
    pub fn beside(path: &Path) -> Self {
        let folder = path.parent().unwrap_or(Path::new(""));
        let folder = if folder.as_os_str().is_empty() {
            Path::new(".")
        } else {
            folder
        };
        Self::new(Folder::Disk(folder.to_path_buf()))
    }

    /// Files in memory, path and bytes of each.
    pub fn in_memory(files: BTreeMap<String, Vec<u8>>) -> Self {
        Self::new(Folder::Memory(Arc::new(files)))
    }

    fn new(folder: Folder) -> Self {
        Self {
            folder,
            bytes: 0,
            hash: blake3::Hasher::new(),
            read_from: Vec::new(),
        }
    }

    /// Label in messages of a file that the scene names: its path as the user would write it.
    pub fn label(&self, name: &str) -> String {
        match &self.folder {
            Folder::Disk(folder) if folder != Path::new(".") => {
                folder.join(name).display().to_string()
            }
            _ => name.to_string(),
        }
    }

    /// BLAKE3 hash of all that was read so far: 64 hexadecimal digits.
    pub fn hash(&self) -> String {
        self.hash.finalize().to_string()
    }

    /// These files, of a scene whose own file has another text.
    #[must_use]
    pub fn of_other_text(&self, text: &str) -> Self {
        let mut files = self.clone();
        files.hash = blake3::Hasher::new();
        files.take(text.as_bytes());
        files
    }

    /// Takes the bytes of a file into the hash.
    pub fn take(&mut self, bytes: &[u8]) {
        self.hash.update(bytes);
    }

    /// Text of the file at `path`, which the user chose and which may be anywhere.
    pub fn open(&mut self, path: &Path) -> Result<String, Problem> {
        if let Folder::Memory(files) = &self.folder {
            let bytes = path.to_str().and_then(|name| files.get(name));
            let bytes = bytes.ok_or_else(missing)?.clone();
            return text(self.accept(bytes)?);
        }
        text(self.open_bytes(path)?)
    }

    fn open_bytes(&mut self, path: &Path) -> Result<Vec<u8>, Problem> {
        let (file, length) = regular(path, SCENES)?;
        self.check_size(length)?;
        self.read_from.extend(FileId::of(&file, path));
        let mut bytes = Vec::with_capacity(length as usize + 1);
        file.take(MAX_FILE_BYTES + 1)
            .read_to_end(&mut bytes)
            .map_err(|e| unreadable(&e))?;
        self.accept(bytes)
    }

    /// Text on standard input. If that is a file, it is one that was read.
    pub fn read_stdin(&mut self, stdin: StdinLock) -> Result<String, Problem> {
        #[cfg(unix)]
        if let Ok(owned) = std::os::fd::AsFd::as_fd(&stdin).try_clone_to_owned() {
            self.read_from
                .extend(FileId::of(&fs::File::from(owned), Path::new("")));
        }
        let mut bytes = Vec::new();
        let read = stdin.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes);
        read.map_err(|e| unreadable(&e))?;
        text(self.accept(bytes)?)
    }

    /// Takes a text that is there already into account, as if it had been read.
    pub fn check_text(&mut self, text: &str) -> Result<(), Problem> {
        self.check_size(text.len() as u64)?;
        self.bytes += text.len() as u64;
        self.take(text.as_bytes());
        Ok(())
    }

    /// Bytes of a file that were read.
    fn accept(&mut self, bytes: Vec<u8>) -> Result<Vec<u8>, Problem> {
        // It may have grown since its length was read.
        self.check_size(bytes.len() as u64)?;
        self.bytes += bytes.len() as u64;
        self.take(&bytes);
        Ok(bytes)
    }

    /// Refuses a file that is too long, by itself or together with those read before.
    fn check_size(&self, length: u64) -> Result<(), Problem> {
        if length > MAX_FILE_BYTES {
            return Err(too_large(MAX_FILE_BYTES, "a file"));
        }
        if self.bytes.saturating_add(length) > MAX_SCENE_BYTES {
            return Err(too_large(MAX_SCENE_BYTES, "all files of a scene together"));
        }
        Ok(())
    }

    /// Text of a model or of its materials that a scene names; `None` if there is no such file. Its bytes may be anything.
    pub fn read_model(&mut self, name: &str) -> Result<Option<Decoded>, Problem> {
        Ok(self.read(name)?.map(decoded))
    }

    /// Bytes of a file that a scene file names; `None` if there is no such file.
    fn read(&mut self, name: &str) -> Result<Option<Vec<u8>>, Problem> {
        check_name(name)?;
        let folder = match &self.folder {
            Folder::Embedded(text) => {
                let Some(text) = text(name) else {
                    return Ok(None);
                };
                self.take(text.as_bytes());
                return Ok(Some(text.as_bytes().to_vec()));
            }
            Folder::Memory(files) => {
                let Some(bytes) = files.get(name.trim_start_matches("./")) else {
                    return Ok(None);
                };
                let bytes = bytes.clone();
                return self.accept(bytes).map(Some);
            }
            Folder::Disk(folder) => folder,
        };
        // Both without symbolic links, so that none leads out.
        let root = folder.canonicalize().map_err(|e| unreadable(&e))?;
        let path = match root.join(name).canonicalize() {
            Ok(path) => path,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(unreadable(&e)),
        };
        if !path.starts_with(&root) {
            return Err(Problem::new(
                format!("`{name}` is a link to a place outside the scene's folder"),
                "copy the file into the folder of the scene",
            ));
        }
        self.open_bytes(&path).map(Some)
    }
}

/// Endings of the names of scenes and models.
pub const SCENES: &str = ".json or .obj";

/// Regular file, opened, and its length. `endings` are those of the files that are looked for.
pub fn regular(path: &Path, endings: &str) -> Result<(fs::File, u64), Problem> {
    let metadata = fs::metadata(path).map_err(|e| unreadable(&e))?;
    if metadata.is_dir() {
        return Err(Problem::new(
            "this is a folder",
            format!("name a file in it that ends in {endings}"),
        ));
    }
    // Asked before it is opened: a pipe would wait for ever, a device has no end.
    if !metadata.is_file() {
        return Err(Problem::new(
            "this is not a regular file",
            "save it to a file first",
        ));
    }
    let file = fs::File::open(path).map_err(|e| unreadable(&e))?;
    Ok((file, metadata.len()))
}

fn too_large(limit: u64, of: &str) -> Problem {
    Problem::new(
        format!("{of} may have {} MiB at most", limit >> 20),
        "use a model with fewer triangles",
    )
}

/// Refuses a path that leads out of the scene's folder, or means different things on different systems.
fn check_name(name: &str) -> Result<(), Problem> {
    let cure = "copy the file into the folder of the scene and write its path from there, like `models/cup.obj`";
    let refused = |why: &str| Err(Problem::new(format!("the path `{name}` {why}"), cure));
    let outside = |c: Component| !matches!(c, Component::Normal(_) | Component::CurDir);
    if name.is_empty() {
        refused("is empty")
    } else if name.contains(['\\', '\0']) {
        refused("has a character that is not portable (use `/` between folders)")
    } else if Path::new(name).components().any(outside) {
        refused("leads out of the scene's folder")
    } else {
        Ok(())
    }
}

/// Bytes as text; a byte order mark at the start is left out.
fn text(bytes: Vec<u8>) -> Result<String, Problem> {
    let text = String::from_utf8(bytes).map_err(|e| {
        let good = e.utf8_error().valid_up_to();
        let line = e.as_bytes()[..good].split(|b| *b == b'\n').count();
        Problem::new(
            format!("this is not UTF-8 text (line {line}, byte {good})"),
            "save it with the encoding UTF-8 in your editor, or check that it is the right file",
        )
    })?;
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_string(),
        None => text,
    })
}

fn missing() -> Problem {
    Problem::new(
        "there is no such file",
        "check the spelling, and the folder that you are in",
    )
}

/// Problem for an error of the operating system.
pub fn unreadable(error: &std::io::Error) -> Problem {
    match error.kind() {
        std::io::ErrorKind::NotFound => missing(),
        std::io::ErrorKind::PermissionDenied => {
            Problem::new("reading is not permitted", "check who may read the file")
        }
        _ => Problem::new(
            format!("it cannot be read: {error}"),
            "check the file and the disk it is on",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_inside() {
        for bad in [
            "",
            "/etc/passwd",
            "../a.mtl",
            "a/../../b",
            "a\\b",
            "a\0b",
            "..",
        ] {
            assert!(check_name(bad).is_err(), "{bad:?}");
        }
        for good in ["a.mtl", "models/a b.mtl", "./a.mtl", "..a"] {
            assert_eq!(check_name(good), Ok(()), "{good:?}");
        }
    }

    #[test]
    fn all_files_of_a_scene_have_a_limit_together() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.mtl");
        fs::write(&path, "newmtl a\nKd 1 1 1\n").expect("a file");
        let held = BTreeMap::from([("a.mtl".to_owned(), fs::read(&path).expect("written"))]);
        let length = fs::metadata(&path).expect("written").len();
        for mut files in [Files::beside(&path), Files::in_memory(held)] {
            // As if files of so many bytes had been read before.
            files.bytes = MAX_SCENE_BYTES - 2 * length;
            for _ in 0..2 {
                assert!(files.read("a.mtl").is_ok_and(|text| text.is_some()));
            }
            let refused = files.read("a.mtl").expect_err("no byte is left");
            assert!(
                format!("{refused:?}").contains("512 MiB at most"),
                "{refused:?}"
            );
        }
    }

    #[test]
    fn the_hash_is_blake3() {
        // Published test vector for no input.
        let mut files = Files::embedded(|_| None);
        let empty = "af1349b9f5f9a1a6a0404dea36dcc9499bcb25c9adc112b7cc9a93cae41f3262";
        assert_eq!(files.hash(), empty);
        files.take(b"abc");
        assert_eq!(files.hash(), blake3::hash(b"abc").to_string());
    }
}
