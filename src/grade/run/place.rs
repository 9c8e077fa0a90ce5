//! Folders in which a submission runs: its copy, and for each scene what it reads and where it writes.

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use tempfile::{Builder, TempDir};

use super::asked::AskedScene;
use super::command::Blank;
use crate::grade::submission::{Submission, SubmittedFile};

/// A copy of a submission in a temporary folder, where its processes run one after the other.
pub struct SubmissionCopy {
    top: TempDir,
    path: PathBuf,
}

impl SubmissionCopy {
    /// Writes all files.
    pub fn new(files: &[SubmittedFile]) -> io::Result<Self> {
        // Without links: a sandbox names the same folder.
        let around = std::env::temp_dir().canonicalize()?;
        let top = Builder::new().prefix("raytree-").tempdir_in(around)?;
        let path = top.path().join("submission");
        fs::create_dir(&path)?;
        for file in files {
            let name = Path::new(&file.name);
            // They are so already: what is written to the disk is looked at twice.
            if !name
                .components()
                .all(|part| matches!(part, Component::Normal(_)))
            {
                continue;
            }
            let target = path.join(name);
            if let Some(folder) = target.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::write(&target, &file.bytes)?;
            make_executable(&target)?;
        }
        Ok(Self { top, path })
    }

    /// The copy.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The folder around it and all others.
    pub fn top(&self) -> &Path {
        self.top.path()
    }

    /// A new folder with what a program reads of a scene.
    pub fn folder(&self, scene: &AskedScene, pixels: &[(u32, u32)]) -> io::Result<RunFolder> {
        let given = Builder::new().prefix("scene-").tempdir_in(self.top())?;
        let out = Builder::new().prefix("out-").tempdir_in(self.top())?;
        for (_, name, bytes) in &scene.files {
            fs::write(given.path().join(name), bytes)?;
        }
        let lines = pixels.iter().map(|(x, y)| format!("{x} {y}\n"));
        let list = lines.collect::<Vec<_>>().concat();
        fs::write(given.path().join("pixels"), list)?;
        Ok(RunFolder { given, out })
    }
}

/// What a program reads of a scene, and where it may write.
pub struct RunFolder {
    given: TempDir,
    out: TempDir,
}

impl RunFolder {
    /// The folder for files.
    pub fn out(&self) -> &Path {
        self.out.path()
    }

    /// What a blank of the command stands for.
    pub fn value(&self, blank: Blank, scene: &AskedScene, pixel: Option<(u32, u32)>) -> String {
        let path = |name: &str| self.given.path().join(name).to_string_lossy().into_owned();
        let (x, y) = pixel.unwrap_or_default();
        match blank {
            Blank::Scene | Blank::Flat | Blank::FlatText => {
                let file = scene.files.iter().find(|(kind, ..)| *kind == blank);
                file.map(|(_, name, _)| path(name)).unwrap_or_default()
            }
            Blank::X => x.to_string(),
            Blank::Y => y.to_string(),
            Blank::Width => scene.size.0.to_string(),
            Blank::Height => scene.size.1.to_string(),
            Blank::Pixels => path("pixels"),
            Blank::Out => self.out().to_string_lossy().into_owned(),
        }
    }

    /// What the program wrote, read with the care that any submission is read with.
    pub fn written(&self) -> Submission {
        Submission::read(self.out())
    }
}

#[cfg(unix)]
fn make_executable(path: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    // Archives and memory keep no permissions, and a program that is handed in is there to be run.
    fs::set_permissions(path, fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn make_executable(_: &Path) -> io::Result<()> {
    Ok(())
}
