//! A folder that was handed in. No link in it is followed, and nothing but regular files is opened.

use std::fs::{self, File};
use std::path::Path;

use super::gather::{Gathered, unreadable};
use super::limits::{MAX_ENTRIES, MAX_FOLDERS};
use super::path::is_hidden;
use crate::scene::FileId;

/// Reads all files below a folder.
pub fn read_folder(top: &Path, gathered: &mut Gathered) {
    // Folders still to be read, each with its path from the top and the number of folders around it.
    let mut open = vec![(top.to_path_buf(), String::new(), 0)];
    while let Some((folder, path, depth)) = open.pop() {
        let entries = match fs::read_dir(&folder) {
            Ok(entries) => entries,
            Err(e) => {
                gathered.refuse(path.as_bytes(), &unreadable(&e));
                continue;
            }
        };
        // By name, so that it does not depend on the disk which of two files is refused.
        let mut names: Vec<_> = entries
            .take(MAX_ENTRIES + 1)
            .flatten()
            .map(|entry| entry.file_name())
            .collect();
        names.sort();
        let mut folders = Vec::new();
        for name in names {
            if !gathered.counts() {
                return;
            }
            let inner = [path.as_bytes(), name.as_encoded_bytes()].concat();
            let place = folder.join(&name);
            let kind = match fs::symlink_metadata(&place) {
                Ok(metadata) => metadata.file_type(),
                Err(e) => {
                    gathered.refuse(&inner, &unreadable(&e));
                    continue;
                }
            };
            if kind.is_file() {
                read_file(&place, &inner, gathered);
            } else if kind.is_symlink() {
                gathered.refuse(&inner, "it is a link; hand in the file itself");
            } else if !kind.is_dir() {
                gathered.refuse(&inner, "it is no regular file");
            } else if depth >= MAX_FOLDERS {
                let why = format!("it lies more than {MAX_FOLDERS} folders deep");
                gathered.refuse(&inner, &why);
            } else if let Ok(inner) = String::from_utf8(inner) {
                if !is_hidden(&inner) {
                    folders.push((place, inner + "/", depth + 1));
                }
            } else {
                gathered.refuse(name.as_encoded_bytes(), "its name is not UTF-8");
            }
        }
        open.extend(folders.into_iter().rev());
    }
}

fn read_file(place: &Path, path: &[u8], gathered: &mut Gathered) {
    let Some(name) = gathered.wanted(path) else {
        return;
    };
    match regular_file(place).and_then(|file| gathered.read(file, || None)) {
        Ok(bytes) => gathered.take(name, bytes),
        Err(why) => gathered.refuse(path, &why),
    }
}

/// A regular file, opened: the one that is there and no other that a link leads to.
fn regular_file(place: &Path) -> Result<File, String> {
    let there = FileId::at_link(place).map_err(|e| unreadable(&e))?;
    let file = File::open(place).map_err(|e| unreadable(&e))?;
    let is_regular = file.metadata().is_ok_and(|metadata| metadata.is_file());
    if !is_regular || FileId::of(&file, place).ok() != Some(there) {
        return Err("it is no regular file".to_owned());
    }
    Ok(file)
}
