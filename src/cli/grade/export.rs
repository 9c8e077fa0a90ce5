//! `raytree grade --export`: a grader for a platform out of a task.

use std::path::Path;

use clap::ValueEnum;

use crate::cli::output::{Target, open_all};
use crate::cli::{Completion, Failure};
use crate::grade::archive;
use crate::grade::task::Task;
use crate::scene::FileId;

/// Platforms that mark with this program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ExportKind {
    /// The archive that Gradescope takes as an autograder
    Gradescope,
    /// The files of an assignment of Classroom 50, for its folder below `autograders`
    Classroom50,
}

impl ExportKind {
    /// Writes the archive; without `program` this very program is in it.
    pub fn write(
        self,
        path: &str,
        task: &Task,
        to: &Path,
        program: Option<&Path>,
    ) -> Result<Completion, Failure> {
        for warning in &task.warnings {
            eprintln!("warning: {warning}");
        }
        let scenes = task.scenes.iter();
        let scenes = scenes.flat_map(|scene| scene.world.scene.files.iter().cloned());
        let read: Vec<FileId> = FileId::at(Path::new(path))
            .into_iter()
            .chain(scenes)
            .collect();
        let target = Target {
            flag: "-o",
            path: Some(to),
            endings: &["zip"],
        };
        let places = open_all(&read, &[target])?;
        let own = std::env::current_exe();
        let program = match (program, &own) {
            (Some(program), _) => program,
            (None, Ok(own)) => own,
            (None, Err(error)) => {
                return Err(Failure::Input(format!(
                    "this program cannot find itself ({error}); name it with --program FILE"
                )));
            }
        };
        let bytes = match self {
            Self::Gradescope => archive::gradescope(Path::new(path), task, program),
            Self::Classroom50 => archive::classroom50(Path::new(path), task, program),
        };
        let bytes = bytes.map_err(|error| Failure::Input(error.to_string()))?;
        for place in places.into_iter().flatten() {
            place.write(|out| out.write_all(&bytes))?;
        }
        Ok(Completion::Whole)
    }
}
