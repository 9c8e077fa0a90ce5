//! Where results go, and what can go wrong on the way.

mod destination;
mod place;

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::{Completion, end_signals};
use crate::scene::printable::printable;
use crate::scene::{FileId, SceneError};
use crate::tracer::Film;
use crate::tracer::image::png;
pub use destination::Destination;
pub use place::Target;
use place::TargetPlace;

/// Why a command could not do what it was asked to.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene is wrong.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The command line cannot be read, which is told already.
    #[error("the command line cannot be read")]
    CommandLine,
    /// The command line is wrong in a way that only shows with the scene.
    #[error("{0}")]
    Usage(String),
    /// A file that was handed in is wrong.
    #[error("{0}")]
    Input(String),
    /// A result could not be written.
    #[error("{}: cannot be written: {}", shown(.path.as_deref()), cause(source))]
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

/// What the system says, in plain words where its own are none.
fn cause(error: &io::Error) -> String {
    match error.kind() {
        // What this program says itself is plain.
        _ if error.get_ref().is_some() => error.to_string(),
        io::ErrorKind::NotFound => {
            "no file can be made there; give a name in another folder".to_owned()
        }
        io::ErrorKind::PermissionDenied => {
            "writing there is not permitted; give a name in another folder".to_owned()
        }
        _ => error.to_string(),
    }
}

fn shown(path: Option<&Path>) -> String {
    path.map_or("standard output".into(), |p| {
        printable(&p.to_string_lossy()).into_owned()
    })
}

impl Failure {
    /// A result could not be written to this file.
    fn output(path: &Path, source: io::Error) -> Self {
        Self::Output {
            path: Some(path.to_owned()),
            source,
        }
    }

    /// 1 if the input is wrong, 2 if the command line is.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::CommandLine | Self::Usage(_) => ExitCode::from(2),
            Self::Scene(_) | Self::Input(_) | Self::Output { .. } | Self::Terminal(_) => {
                ExitCode::from(1)
            }
        }
    }
}

/// Writes a result to standard output.
pub fn to_stdout(bytes: &[u8]) -> Result<Completion, Failure> {
    to_stdout_by(|out| out.write_all(bytes))?;
    Ok(Completion::Whole)
}

/// Writes a result to standard output piece by piece.
pub fn to_stdout_by(produce: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    produce(&mut out)
        .and_then(|()| out.flush())
        .map_err(|source| Failure::Output { path: None, source })
}

/// Opens the files that flags ask for, before any work is done for them. None of them may be one that was `read`, nor two of
/// them the same.
pub fn open<const N: usize>(
    read: &[FileId],
    targets: [Target; N],
) -> Result<[Option<Destination>; N], Failure> {
    let mut opened = [const { None }; N];
    for (destination, slot) in open_all(read, &targets)?.into_iter().zip(&mut opened) {
        *slot = destination;
    }
    Ok(opened)
}

/// As [`open`], for any number of files.
pub fn open_all(read: &[FileId], targets: &[Target]) -> Result<Vec<Option<Destination>>, Failure> {
    let mut places: Vec<Option<TargetPlace>> = Vec::with_capacity(targets.len());
    for target in targets {
        let place = TargetPlace::of(target)?;
        let clash = |what: String| {
            let path = shown(target.path);
            Err(Failure::Usage(format!(
                "{} {path}: {what}; give another name",
                target.flag
            )))
        };
        if let Some(place) = &place {
            if place.is_among(read) {
                return clash("this file is read, and would be replaced".to_owned());
            }
            let is_same =
                |other: &Option<TargetPlace>| other.as_ref().is_some_and(|o| o.is_same(place));
            if let Some(first) = places.iter().position(is_same) {
                return clash(format!(
                    "this is the file of {} already",
                    targets[first].flag
                ));
            }
        }
        if let Some(place) = &place {
            place.check_ending(target)?;
        }
        places.push(place);
    }
    if places.iter().any(Option::is_some) {
        end_signals::watch();
    }
    let opened = places.into_iter();
    opened
        .map(|place| place.map(Destination::open).transpose())
        .collect()
}

/// Writes a film to a PNG file.
pub fn write_png(to: Destination, film: &Film, exposure: f64) -> Result<(), Failure> {
    let png = png::encode(film, exposure).map_err(io::Error::other);
    to.write(|out| out.write_all(&png?))
}
