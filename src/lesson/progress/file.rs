//! File of progress: read, changed and written whole under a lock.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use super::CourseProgress;
use crate::grade::output::utc;

/// Bytes of a file of progress at most.
const MAX_BYTES: u64 = 4 << 20;

/// How often and how long the lock of another window is waited for.
const TRIES: u32 = 50;
const WAIT: Duration = Duration::from_millis(20);

/// Where progress is kept, and what is known of it.
#[derive(Debug)]
pub struct ProgressFile {
    path: Option<PathBuf>,
    course: String,
    now: CourseProgress,
    is_lost: bool,
    notices: Vec<String>,
}

impl ProgressFile {
    /// The progress in a file; without one it is kept in memory. What cannot be read is put aside and told.
    pub fn open(path: Option<PathBuf>, course: &str) -> Self {
        let mut file = Self {
            path,
            course: course.to_owned(),
            now: CourseProgress::new(course),
            is_lost: false,
            notices: Vec::new(),
        };
        if file.path.is_none() {
            file.cannot_keep("no folder for it is known; name a file with --state FILE");
        }
        file.now = file.read();
        file
    }

    /// What is done so far.
    pub fn progress(&self) -> &CourseProgress {
        &self.now
    }

    /// What is to be told once: each only for the first time.
    pub fn take_notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }

    /// Changes the progress as the file has it now, and writes it. If that fails it goes on in memory, and says so once.
    pub fn change<T>(&mut self, change: impl FnOnce(&mut CourseProgress) -> T) -> T {
        let lock = self.lock();
        if !self.is_lost {
            self.now = self.read();
        }
        let result = change(&mut self.now);
        if let Err(error) = self.write() {
            self.cannot_keep(&error.to_string());
        }
        drop(lock);
        result
    }

    fn cannot_keep(&mut self, why: &str) {
        if !self.is_lost {
            let place = self
                .path
                .as_ref()
                .map_or(String::new(), |path| format!(" in {}", path.display()));
            self.notices.push(format!(
                "your progress cannot be kept{place}: {why}; it lasts until you leave"
            ));
        }
        self.is_lost = true;
    }

    /// The progress in the file. One that is broken, or of another course, is renamed, so that nothing is overwritten.
    fn read(&mut self) -> CourseProgress {
        let new = CourseProgress::new(&self.course);
        let Some(path) = &self.path else {
            return self.now.clone();
        };
        let bytes = match bytes_of(path) {
            Ok(Some(bytes)) => bytes,
            Ok(None) => return new,
            Err(error) => {
                self.cannot_keep(&error.to_string());
                return self.now.clone();
            }
        };
        let read: Result<CourseProgress, _> = serde_json::from_slice(&bytes);
        match read {
            Ok(progress) if progress.format == new.format && progress.course == new.course => {
                progress
            }
            read => {
                let what = match read {
                    Ok(_) => "is that of another course",
                    Err(_) => "cannot be read",
                };
                let aside = aside(path);
                let moved = fs::rename(path, &aside);
                self.notices.push(match moved {
                    Ok(()) => format!(
                        "the file of your progress {what}; it is kept as {}, and the lessons begin anew",
                        aside.display()
                    ),
                    Err(error) => format!("the file of your progress {what}: {error}"),
                });
                new
            }
        }
    }

    fn write(&self) -> io::Result<()> {
        let Some(path) = &self.path else {
            return Ok(());
        };
        if self.is_lost {
            return Ok(());
        }
        let text = serde_json::to_string_pretty(&self.now)?;
        let new = beside(path, "new");
        let mut file = File::create(&new)?;
        let written = file
            .write_all(text.as_bytes())
            .and_then(|()| file.write_all(b"\n"))
            .and_then(|()| file.sync_all())
            .and_then(|()| fs::rename(&new, path));
        if written.is_err() {
            // Nobody needs the half of it.
            let _ = fs::remove_file(&new);
        }
        written
    }

    /// The lock that windows share. Where there are no locks, or another window holds it too long, it goes on without.
    fn lock(&self) -> Option<File> {
        let path = self.path.as_ref()?;
        if let Some(folder) = path.parent() {
            // Whether it is there shows when the file is written.
            let _ = fs::create_dir_all(folder);
        }
        let mut options = OpenOptions::new();
        options.create(true).truncate(false).write(true);
        let file = options.open(beside(path, "lock")).ok()?;
        for _ in 0..TRIES {
            match file.try_lock() {
                Ok(()) => return Some(file),
                Err(fs::TryLockError::WouldBlock) => std::thread::sleep(WAIT),
                Err(fs::TryLockError::Error(_)) => return None,
            }
        }
        None
    }
}

/// All bytes of a file; none if it is not there.
fn bytes_of(path: &Path) -> io::Result<Option<Vec<u8>>> {
    match fs::metadata(path) {
        Ok(metadata) if !metadata.is_file() => Err(io::Error::other("it is no regular file")),
        Ok(metadata) if metadata.len() > MAX_BYTES => Err(io::Error::other("it is too long")),
        Ok(_) => fs::read(path).map(Some),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// The path with an ending behind its name.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}

/// A name for a broken file that no earlier one has.
fn aside(path: &Path) -> PathBuf {
    let first = beside(path, "broken");
    let more = (2..100).map(|n| beside(path, &format!("broken{n}")));
    let mut names = std::iter::once(first.clone()).chain(more);
    names.find(|name| !name.exists()).unwrap_or(first)
}

/// The folder where programs keep their state, by the environment: XDG's, that of the home folder, or that of Windows.
pub fn default_folder(variable: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
    let absolute = |name: &str| variable(name).filter(|path| path.is_absolute());
    let folder = absolute("XDG_STATE_HOME")
        .or_else(|| absolute("LOCALAPPDATA").filter(|_| cfg!(windows)))
        .or_else(|| Some(absolute("HOME")?.join(".local/state")))?;
    Some(folder.join("raytree"))
}

/// The date of today, as 2026-11-29, in universal time.
pub fn today() -> String {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let text = utc(now.map_or(0, |since| since.as_secs()));
    text.chars().take(10).collect()
}
