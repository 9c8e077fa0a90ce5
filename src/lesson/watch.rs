//! Watching a folder: whether a file below it has changed, told once it rests.
//!
//! Times and sizes are polled, and what looks changed is hashed: so it works on network drives, where files are replaced by others
//! of the same name, and where an editor writes what was there before.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// How often files are looked at.
pub const POLL: Duration = Duration::from_millis(250);
/// How long nothing must have changed before a change is told: programs write a file in parts, and several at once.
pub const REST: Duration = Duration::from_millis(200);

/// Entries that are looked at, and folders inside of each other, at most.
const MAX_ENTRIES: usize = 5000;
const MAX_FOLDERS: usize = 16;
/// Of a longer file time and size alone are compared.
const MAX_HASHED_BYTES: u64 = 16 << 20;
/// Folders of what programs are built into: hidden ones, and these.
const BUILT: [&str; 4] = ["target", "node_modules", "__pycache__", "build"];

/// A file as it was seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Seen {
    changed: Option<SystemTime>,
    bytes: u64,
    /// Of what is in it; none if it could not be read, or is too long.
    hash: Option<[u8; 32]>,
}

/// The files below a folder, or one file, as they were seen last.
pub struct FolderWatch {
    top: PathBuf,
    files: BTreeMap<PathBuf, Seen>,
    /// When the last change was seen, if it was not told yet.
    changed: Option<Instant>,
}

impl FolderWatch {
    /// Watches what is there now.
    pub fn new(top: &Path) -> Self {
        let mut watch = Self {
            top: top.to_owned(),
            files: BTreeMap::new(),
            changed: None,
        };
        watch.look();
        watch
    }

    /// Looks again. True once for each change, when nothing has changed since [`REST`].
    pub fn poll(&mut self, now: Instant) -> bool {
        if self.look() {
            self.changed = Some(now);
            return false;
        }
        let rests = |since: &Instant| now.duration_since(*since) >= REST;
        self.changed.take_if(|since| rests(since)).is_some()
    }

    /// How long to wait before the next look.
    pub fn pause(&self) -> Duration {
        self.changed.map_or(POLL, |_| REST)
    }

    /// Looks at all files; true if one is another, has gone or has come.
    fn look(&mut self) -> bool {
        let mut files = BTreeMap::new();
        for (path, changed, bytes) in entries(&self.top) {
            let before = self.files.get(&path);
            let is_as_before = |seen: &&Seen| seen.changed == changed && seen.bytes == bytes;
            let hash = match before.filter(is_as_before) {
                Some(seen) => seen.hash,
                None => hash(&path, bytes),
            };
            let seen = Seen {
                changed,
                bytes,
                hash,
            };
            files.insert(path, seen);
        }
        let is_same = |(path, seen): (&PathBuf, &Seen)| {
            let before = self.files.get(path);
            before.is_some_and(|before| match (before.hash, seen.hash) {
                (Some(before), Some(now)) => before == now,
                _ => before == seen,
            })
        };
        let same = files.len() == self.files.len() && files.iter().all(is_same);
        self.files = files;
        !same
    }
}

/// The regular files below a folder, each with its time and size; the file itself, if it is one. No link is followed.
fn entries(top: &Path) -> Vec<(PathBuf, Option<SystemTime>, u64)> {
    let mut files = Vec::new();
    let mut open = vec![(top.to_owned(), 0)];
    let mut looked_at = 0;
    while let Some((path, depth)) = open.pop() {
        looked_at += 1;
        let Ok(metadata) = fs::symlink_metadata(&path) else {
            continue;
        };
        if metadata.is_file() {
            files.push((path, metadata.modified().ok(), metadata.len()));
        } else if metadata.is_dir() && depth < MAX_FOLDERS {
            let left = MAX_ENTRIES.saturating_sub(looked_at + open.len());
            let inner = fs::read_dir(&path).into_iter().flatten().flatten();
            let inner = inner
                .map(|entry| entry.path())
                .filter(|path| is_watched(path));
            open.extend(inner.take(left).map(|path| (path, depth + 1)));
        }
    }
    files
}

/// False for hidden files, and for folders of what programs are built into.
fn is_watched(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    !name.starts_with('.') && !BUILT.contains(&name.as_ref())
}

/// The hash of a file, if it is there and not too long.
fn hash(path: &Path, bytes: u64) -> Option<[u8; 32]> {
    if bytes > MAX_HASHED_BYTES {
        return None;
    }
    let mut hasher = blake3::Hasher::new();
    let mut file = File::open(path).ok()?.take(MAX_HASHED_BYTES);
    let mut part = vec![0; 1 << 16];
    loop {
        match file.read(&mut part).ok()? {
            0 => return Some(*hasher.finalize().as_bytes()),
            read => hasher.update(&part[..read]),
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A watch on a folder with a file, and the file.
    fn watched() -> (tempfile::TempDir, PathBuf, FolderWatch) {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("tracer.py");
        fs::write(&file, "print(1)").expect("written");
        let watch = FolderWatch::new(folder.path());
        (folder, file, watch)
    }

    /// What polls at these milliseconds tell.
    fn told(watch: &mut FolderWatch, since: Instant, at: &[u64]) -> Vec<bool> {
        let at = at.iter();
        at.map(|ms| watch.poll(since + Duration::from_millis(*ms)))
            .collect()
    }

    #[test]
    fn a_change_is_told_once_and_only_when_it_rests() {
        let (_folder, file, mut watch) = watched();
        let start = Instant::now();
        assert_eq!(told(&mut watch, start, &[0, 250]), [false; 2]);
        fs::write(&file, "print(12)").expect("written");
        assert_eq!(told(&mut watch, start, &[500, 699]), [false; 2]);
        assert_eq!(watch.pause(), REST);
        // It goes on: the rest begins anew.
        fs::write(&file, "print(123)").expect("written");
        assert_eq!(
            told(&mut watch, start, &[700, 899, 900, 1150]),
            [false, false, true, false]
        );
        assert_eq!(watch.pause(), POLL);
    }

    #[test]
    fn files_that_come_go_and_are_replaced_are_changes_and_a_new_time_is_none() {
        let (folder, file, mut watch) = watched();
        let mut now = Instant::now();
        let mut tells = |watch: &mut FolderWatch, change: &dyn Fn()| {
            change();
            now += Duration::from_secs(1);
            let changed = told(watch, now, &[0, 250]);
            assert!(!changed[0]);
            changed[1]
        };
        let inner = folder.path().join("a/b");
        assert!(!tells(&mut watch, &|| fs::create_dir_all(&inner).expect("made")));
        assert!(tells(&mut watch, &|| fs::write(inner.join("x"), "1")
            .expect("written")));
        assert!(tells(&mut watch, &|| fs::remove_file(inner.join("x"))
            .expect("removed")));
        // The same size, and another file in the place of the first.
        let other = folder.path().join("other");
        assert!(tells(&mut watch, &|| fs::write(&other, "print(2)")
            .expect("written")));
        assert!(tells(&mut watch, &|| fs::rename(&other, &file).expect("renamed")));
        let past = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
        let touch = || {
            let file = File::options().write(true).open(&file).expect("opened");
            file.set_modified(past).expect("set");
        };
        assert!(!tells(&mut watch, &touch));
        // What is built there, and what is hidden, is not watched.
        for name in [".git", "target", "__pycache__"] {
            let folder = folder.path().join(name);
            let write = || {
                fs::create_dir_all(&folder).expect("made");
                fs::write(folder.join("x"), "1").expect("written");
            };
            assert!(!tells(&mut watch, &write), "{name}");
        }
    }

    #[test]
    fn one_file_can_be_watched_and_one_that_is_not_there_yet() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("scene.json");
        let mut watch = FolderWatch::new(&file);
        let start = Instant::now();
        assert_eq!(told(&mut watch, start, &[0, 250]), [false; 2]);
        fs::write(&file, "{}").expect("written");
        assert_eq!(told(&mut watch, start, &[500, 750]), [false, true]);
    }
}
