//! Where results go, and what can go wrong on the way.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::Completion;
use crate::scene::SceneError;
use crate::tracer::Film;
use crate::tracer::image::png;

/// Why a command could not do what it was asked to.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene is wrong.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The command line is wrong in a way that only shows with the scene.
    #[error("{0}")]
    Usage(String),
    /// A result could not be written.
    #[error("{}: cannot be written: {source}", place(.path.as_deref()))]
    Output {
        /// The file; `None` for standard output.
        path: Option<PathBuf>,
        /// What the system says.
        source: io::Error,
    },
    /// The terminal does not do what the debugger needs.
    #[error("{0}")]
    Terminal(io::Error),
}

fn place(path: Option<&Path>) -> String {
    path.map_or("standard output".to_owned(), |p| p.display().to_string())
}

impl Failure {
    /// 1 if the input is wrong, 2 if the command line is.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Usage(_) => ExitCode::from(2),
            Self::Scene(_) | Self::Output { .. } | Self::Terminal(_) => ExitCode::from(1),
        }
    }
}

/// Writes a result to standard output.
pub fn to_stdout(bytes: &[u8]) -> Result<Completion, Failure> {
    let mut out = io::stdout().lock();
    out.write_all(bytes)
        .and_then(|()| out.flush())
        .map_err(|source| Failure::Output { path: None, source })?;
    Ok(Completion::Whole)
}

/// Writes a result to standard output or, if there is a path, to a file: first beside it, then renamed, so that a file
/// is either whole or untouched.
pub fn write(
    path: Option<&Path>,
    produce: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<Completion, Failure> {
    let result = match path {
        None => {
            let mut out = io::BufWriter::new(io::stdout().lock());
            produce(&mut out).and_then(|()| out.flush())
        }
        Some(path) => replace(path, produce),
    };
    result.map_err(|source| Failure::Output {
        path: path.map(Path::to_owned),
        source,
    })?;
    Ok(Completion::Whole)
}

/// Writes a film to a PNG file.
pub fn write_png(path: &Path, film: &Film, exposure: f64) -> Result<Completion, Failure> {
    let png = png::encode(film, exposure).map_err(io::Error::other);
    write(Some(path), |out| out.write_all(&png?))
}

fn replace(path: &Path, produce: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    // Something that is no regular file, such as /dev/null or a pipe, cannot be replaced: write into it.
    if path.exists() && !path.is_file() {
        let mut out = io::BufWriter::new(std::fs::File::create(path)?);
        return produce(&mut out).and_then(|()| out.flush());
    }
    let folder = path
        .parent()
        .filter(|p| !p.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    // As any other new file: readable for all, if the user's mask allows it.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    let mut out = io::BufWriter::new(&mut file);
    produce(&mut out)?;
    out.flush()?;
    drop(out);
    file.persist(path).map_err(|e| e.error)?;
    Ok(())
}
