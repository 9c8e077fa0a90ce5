//! A grader for Gradescope out of a task: the archive that its harness unpacks into `/autograder/source`.
//!
//! The harness runs `setup.sh` once, and `run_autograder` for each submission: that lies in `/autograder/submission`, and the
//! result is to be in `/autograder/results/results.json`.

use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::{fs, io};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::task::Task;
use crate::scene::FileId;
use crate::scene::printable::{excerpt, shell_word};

/// The folder of the task in the archive.
const FOLDER: &str = "task";

/// Files of a task's folder that are looked at.
const MOST_FILES: usize = 20_000;

/// What may go wrong.
#[derive(Debug, thiserror::Error)]
pub enum ArchiveError {
    /// A file of the task is not in its folder.
    #[error(
        "scene `{0}` has a file outside of the task's folder; put all files of the scene beside the task"
    )]
    Outside(String),
    /// A file cannot be read.
    #[error("{}: cannot be read: {}", excerpt(&.0.to_string_lossy()), .1)]
    Unreadable(PathBuf, io::Error),
    /// The archive cannot be made.
    #[error("the archive cannot be made: {0}")]
    Zip(#[from] zip::result::ZipError),
    /// The archive cannot be written.
    #[error("the archive cannot be made: {0}")]
    Io(#[from] io::Error),
}

/// The archive, with this program in it: `task`, which was loaded from `path`, and all files of its scenes. The same bytes for the
/// same files.
pub fn gradescope(path: &Path, task: &Task, program: &Path) -> Result<Vec<u8>, ArchiveError> {
    let read = |path: &Path| {
        fs::read(path).map_err(|error| ArchiveError::Unreadable(path.to_owned(), error))
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let mut zip = Archive(ZipWriter::new(Cursor::new(Vec::new())));
    zip.add("setup.sh", 0o755, SETUP.as_bytes())?;
    let run = RUN.replace("TASK", &shell_word(&format!("{FOLDER}/{name}")));
    zip.add("run_autograder", 0o755, run.as_bytes())?;
    zip.add("raytree", 0o755, &read(program)?)?;
    zip.add(&format!("{FOLDER}/{name}"), 0o644, &read(path)?)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    for file in scene_files(folder, task)? {
        let inside = file.strip_prefix(folder).unwrap_or(&file);
        let parts = inside.components().map(|p| p.as_os_str().to_string_lossy());
        let inside: Vec<_> = parts.collect();
        zip.add(
            &format!("{FOLDER}/{}", inside.join("/")),
            0o644,
            &read(&file)?,
        )?;
    }
    Ok(zip.0.finish()?.into_inner())
}

/// An archive in the making.
struct Archive(ZipWriter<Cursor<Vec<u8>>>);

impl Archive {
    fn add(&mut self, name: &str, mode: u32, bytes: &[u8]) -> Result<(), ArchiveError> {
        // Without a time of its own a file is of 1980, whenever the archive is made.
        let options = SimpleFileOptions::default()
            .compression_method(zip::CompressionMethod::Deflated)
            .last_modified_time(zip::DateTime::default())
            .unix_permissions(mode);
        self.0.start_file(name, options)?;
        Ok(self.0.write_all(bytes)?)
    }
}

/// The files that the scenes were read from, in the order of their names.
fn scene_files(folder: &Path, task: &Task) -> Result<Vec<PathBuf>, ArchiveError> {
    let here = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    let mut all = Vec::new();
    walk(here, &mut all);
    let mut found: Vec<PathBuf> = Vec::new();
    for scene in &task.scenes {
        for id in &scene.world.scene.files {
            let at = all.iter().find(|(_, file)| file == id);
            let (path, _) = at.ok_or_else(|| ArchiveError::Outside(excerpt(&scene.label)))?;
            found.push(path.strip_prefix(".").unwrap_or(path).to_owned());
        }
    }
    found.sort();
    found.dedup();
    Ok(found)
}

/// All files below a folder, with what tells them apart.
fn walk(folder: &Path, all: &mut Vec<(PathBuf, FileId)>) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut entries: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    entries.sort();
    for path in entries {
        if all.len() >= MOST_FILES {
            return;
        }
        // A link to a folder may lead in a circle.
        let is_link = path.is_symlink();
        if path.is_dir() && !is_link {
            walk(&path, all);
        } else if let Ok(id) = FileId::at(&path) {
            all.push((path, id));
        }
    }
}

/// Made once, when the image is built.
const SETUP: &str = "\
#!/bin/sh
# Looks whether the program runs on this image: nothing has to be installed.
set -eu
source=$(dirname \"$0\")
chmod +x \"$source/raytree\" \"$source/run_autograder\"
\"$source/raytree\" --version || {
    echo 'raytree does not run on this image; export again with --program FILE, a program that was built for it' >&2
    exit 1
}
";

/// Run for each submission. AUTOGRADER_ROOT is for trying it out elsewhere.
const RUN: &str = "\
#!/bin/sh
set -eu
root=${AUTOGRADER_ROOT:-/autograder}
mkdir -p \"$root/results\"
exec \"$root/source/raytree\" grade \"$root/source/\"TASK \"$root/submission\" --output gradescope=\"$root/results/results.json\"
";
