//! The first pass over a piece of an OBJ file: points, normals and texture coordinates.

use super::tokens::{numbers, rest};
use crate::math::{DVec2, DVec3};
use crate::scene::limits::MAX_COORDINATE;
use crate::scene::read::error::Problem;

/// What the lines `v`, `vt` and `vn` of a piece say.
#[derive(Debug, Default)]
pub struct Vertices {
    /// Points.
    pub points: Vec<DVec3>,
    /// Texture coordinates.
    pub uvs: Vec<DVec2>,
    /// Normals, unit; zero where the file gives a zero.
    pub normals: Vec<DVec3>,
    /// How many lines the piece has.
    pub lines: usize,
    /// The first mistake, by its line in the piece, from 0. Nothing is read from there on.
    pub mistake: Option<(usize, Problem)>,
}

/// Reads a piece.
pub fn read(piece: &str) -> Vertices {
    let mut found = Vertices::default();
    for line in piece.lines() {
        if let Err(problem) = found.line(line) {
            found.mistake = Some((found.lines, problem));
            break;
        }
        found.lines += 1;
    }
    found
}

impl Vertices {
    fn line(&mut self, line: &str) -> Result<(), Problem> {
        let line = line.trim_ascii();
        if line.ends_with('\\') && !line.starts_with('#') {
            return Err(Problem::new(
                "the line goes on in the next one, by `\\`",
                "join the two lines",
            ));
        }
        match line.split_ascii_whitespace().next() {
            Some("v") => self.points.push(point(line)?),
            Some("vt") => {
                let uv = numbers::<2>("vt", rest(line), MAX_COORDINATE)?;
                self.uvs.push(DVec2::from(uv));
            }
            Some("vn") => {
                let normal = numbers::<3>("vn", rest(line), MAX_COORDINATE)?;
                self.normals.push(DVec3::from(normal).normalize_or_zero());
            }
            _ => {}
        }
        Ok(())
    }
}

/// A point. A fourth number that is the last is a weight, which divides; more are a colour and passed over.
fn point(line: &str) -> Result<DVec3, Problem> {
    let mut words = rest(line);
    let point = DVec3::from(numbers::<3>("v", words.by_ref(), MAX_COORDINATE)?);
    let (Some(weight), None) = (words.next(), words.next()) else {
        return Ok(point);
    };
    let [w] = numbers::<1>("the weight of v", std::iter::once(weight), MAX_COORDINATE)?;
    if w.abs() < 1e-9 {
        return Err(Problem::new(
            format!("`v` has the weight {weight}"),
            "write three numbers: `v x y z`",
        ));
    }
    Ok(point / w)
}
