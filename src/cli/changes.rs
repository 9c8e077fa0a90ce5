//! Changes of the scene on the command line: `--patch FILE`, then each `--change` in its order.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use crate::scene::{Edit, FileId, Patch};

/// What is changed of the scene.
#[derive(Args, Clone, Debug, Default)]
pub struct ChangeArgs {
    /// Change a value of the scene, such as material.glass.ior=1.3, camera.eye=[0,1,5] or light.lamp.intensity*=2 (more than once if
    /// wanted)
    #[arg(long, value_name = "PATH=VALUE")]
    change: Vec<String>,
    /// Change the scene by the patch in this file, as the debugger writes it: a JSON merge patch in which lights and objects stand by
    /// their names
    #[arg(long, value_name = "FILE.json")]
    patch: Option<PathBuf>,
}

impl ChangeArgs {
    /// The changes, and the file that was read.
    pub fn edits(&self) -> Result<(Vec<Edit>, Option<FileId>), Failure> {
        let read = self.patch.as_deref().map(Patch::read).transpose()?;
        let (patch, file) = read.unzip();
        let typed = self.change.iter().cloned().map(Edit::Typed);
        let edits = patch.map(Edit::Patch).into_iter().chain(typed);
        Ok((edits.collect(), file.flatten()))
    }
}
