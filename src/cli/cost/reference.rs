//! A picture that somebody else made, to measure against.

use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use crate::cli::Failure;
use crate::scene::error::Problem;
use crate::scene::limits::MAX_FILE_BYTES;
use crate::tracer::Film;
use crate::tracer::image::{pfm, png};

/// Reads a PFM file, or a PNG file that shows linear radiance with this exposure.
pub fn read(path: &Path, exposure: f64) -> Result<Film, Failure> {
    let problem = |what: String, cure: &str| {
        let problem = Problem::new(what, cure);
        Failure::Scene(problem.in_file(&path.display().to_string()))
    };
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes))
        .map_err(|e| problem(format!("cannot be read: {e}"), "name a PFM or PNG file"))?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        let what = format!("has more than {} MiB", MAX_FILE_BYTES >> 20);
        return Err(problem(what, "take a smaller picture"));
    }
    let film = if bytes.starts_with(b"\x89PNG") {
        png::decode(&bytes, exposure)
    } else {
        pfm::decode(&bytes)
    };
    film.map_err(|what| {
        problem(
            what,
            "`raytree render SCENE -o FILE.pfm` writes one that can be read",
        )
    })
}

/// An error if a reference is not of the size that is asked for.
pub fn check_size(path: &Path, film: &Film, wanted: Option<(u32, u32)>) -> Result<(), Failure> {
    let size = (film.width, film.height);
    let Some((width, height)) = wanted.filter(|wanted| *wanted != size) else {
        return Ok(());
    };
    let (w, h) = size;
    let problem = Problem::new(
        format!("has {w}x{h} pixels, and the pictures are to have {width}x{height}"),
        "leave out --size, or take a picture of that size",
    );
    Err(Failure::Scene(problem.in_file(&path.display().to_string())))
}
