//! Picture that somebody else made, to measure against.

use std::io::Read as _;
use std::path::{Path, PathBuf};

use crate::cli::Failure;
use crate::scene::FileId;
use crate::scene::error::Problem;
use crate::scene::limits::{MAX_FILE_BYTES, MAX_REFERENCE_PIXELS};
use crate::scene::read::files::regular;
use crate::tracer::Film;
use crate::tracer::image::{pfm, png};

/// A picture's file, read but not decoded: that can take long, and all that its first bytes tell is looked at before.
pub struct GivenPicture {
    path: PathBuf,
    id: Option<FileId>,
    bytes: Vec<u8>,
}

impl GivenPicture {
    /// Reads a regular file that is not too large.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let mut picture = Self {
            path: path.to_owned(),
            id: None,
            bytes: Vec::new(),
        };
        let (file, _) = regular(path, ".pfm or .png").map_err(|p| picture.failure(p))?;
        picture.id = FileId::of(&file, path).ok();
        let read = file
            .take(MAX_FILE_BYTES + 1)
            .read_to_end(&mut picture.bytes);
        if let Err(e) = read {
            return Err(picture.problem(format!("cannot be read: {e}"), "name a PFM or PNG file"));
        }
        if picture.bytes.len() as u64 > MAX_FILE_BYTES {
            let what = format!("has more than {} MiB", MAX_FILE_BYTES >> 20);
            return Err(picture.problem(what, "take a smaller picture"));
        }
        Ok(picture)
    }

    /// What tells its file from others.
    pub fn id(&self) -> Option<FileId> {
        self.id.clone()
    }

    fn is_png(&self) -> bool {
        self.bytes.starts_with(b"\x89PNG")
    }

    /// Its size, which is that of the pictures that are measured; an error if another one is asked for.
    pub fn size(&self, asked: Option<(u32, u32)>) -> Result<(u32, u32), Failure> {
        let size = if self.is_png() { png::size } else { pfm::size };
        let (w, h) = size(&self.bytes).map_err(|what| self.unknown(what))?;
        if let Some((width, height)) = asked.filter(|asked| *asked != (w, h)) {
            let what = format!("has {w}x{h} pixels, and the pictures are to have {width}x{height}");
            return Err(self.problem(what, "leave out --size, or take a picture of that size"));
        }
        if u64::from(w) * u64::from(h) > MAX_REFERENCE_PIXELS {
            let what =
                format!("has {w}x{h} pixels; what is measured has {MAX_REFERENCE_PIXELS} at most");
            return Err(self.problem(
                what,
                "take a smaller picture: many of its size are rendered",
            ));
        }
        Ok((w, h))
    }

    /// The film of a PFM file, or of a PNG file that shows linear radiance with this exposure.
    pub fn film(&self, exposure: f64) -> Result<Film, Failure> {
        let film = if self.is_png() {
            png::decode(&self.bytes, exposure)
        } else {
            pfm::decode(&self.bytes)
        };
        film.map_err(|what| self.unknown(what))
    }

    fn unknown(&self, what: String) -> Failure {
        self.problem(
            what,
            "`raytree render SCENE -o FILE.pfm` writes one that can be read",
        )
    }

    fn problem(&self, what: String, cure: &str) -> Failure {
        self.failure(Problem::new(what, cure))
    }

    fn failure(&self, problem: Problem) -> Failure {
        Failure::Scene(problem.in_file(&self.path.display().to_string()))
    }
}
