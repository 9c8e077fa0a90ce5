//! A grader for a platform out of a task: an archive with scripts, this program, the task and its scenes.
//!
//! Gradescope unpacks it into `/autograder/source`, runs `setup.sh` once, and `run_autograder` for each submission: that lies in
//! `/autograder/submission`, and the result is to be in `/autograder/results/results.json`. Classroom 50 has its files in a folder
//! of the assignment, and runs `autograder.py` in the student's repository, where `result.json` is to be.

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

/// Gradescope's archive, with this program in it: `task`, which was loaded from `path`, and all files of its scenes. The same bytes
/// for the same files.
pub fn gradescope(path: &Path, task: &Task, program: &Path) -> Result<Vec<u8>, ArchiveError> {
    let run = RUN.replace("TASK", &shell_word(&inside(path)));
    let scripts = [("setup.sh", SETUP), ("run_autograder", &run)];
    archive(&scripts, (path, task), program)
}

/// What goes into the folder `autograders/ASSIGNMENT` of a classroom of Classroom 50.
pub fn classroom50(path: &Path, task: &Task, program: &Path) -> Result<Vec<u8>, ArchiveError> {
    // A string of JSON is one of Python.
    let run = AUTOGRADER.replace("TASK", &serde_json::Value::from(inside(path)).to_string());
    archive(&[("autograder.py", &run)], (path, task), program)
}

/// Where the task lies in an archive.
fn inside(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    format!("{FOLDER}/{name}")
}

/// Scripts, the program, the task and the files of its scenes.
fn archive(
    scripts: &[(&str, &str)],
    (path, task): (&Path, &Task),
    program: &Path,
) -> Result<Vec<u8>, ArchiveError> {
    let read = |path: &Path| {
        fs::read(path).map_err(|error| ArchiveError::Unreadable(path.to_owned(), error))
    };
    let mut zip = Archive(ZipWriter::new(Cursor::new(Vec::new())));
    for (name, text) in scripts {
        zip.add(name, 0o755, text.as_bytes())?;
    }
    zip.add("raytree", 0o755, &read(program)?)?;
    zip.add(&inside(path), 0o644, &read(path)?)?;
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
const SETUP: &str = include_str!("archive/setup.sh");

/// Run for each submission, with the earlier attempts if the platform tells them. AUTOGRADER_ROOT is for trying it out elsewhere.
const RUN: &str = include_str!("archive/run_autograder");

/// Run by Classroom 50 in the student's repository, for each submission. It finds the program beside itself.
/// Source: <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>.
const AUTOGRADER: &str = include_str!("archive/autograder.py");
