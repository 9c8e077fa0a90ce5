//! All faces of an OBJ file, read in two passes over pieces of its text that are read side by side. The first finds
//! the points; only then is it known what the faces' numbers, which may count backwards, stand for.

use rayon::prelude::*;

use super::faces::{self, Chunk, Faces, VertexCounts};
use super::vertices;
use crate::math::{DVec2, DVec3};
use crate::scene::limits::MAX_PRIMITIVES;
use crate::scene::read::error::Problem;

/// Bytes of a piece: enough that its own price does not matter.
const PIECE: usize = 1 << 18;

/// Pieces whose faces are read side by side, before their triangles are counted.
const AT_ONCE: usize = 64;

/// The surface that an OBJ file describes, before it is parted.
#[derive(Debug, Default)]
pub struct ObjSurface {
    /// Points.
    pub points: Vec<DVec3>,
    /// Texture coordinates.
    pub uvs: Vec<DVec2>,
    /// Normals, unit or zero.
    pub normals: Vec<DVec3>,
    /// Triangles, and all that was said between them.
    pub faces: Faces,
}

/// Reads the text of an OBJ file; an error tells the line of its first mistake, from 1.
pub fn read(text: &str) -> Result<ObjSurface, (usize, Problem)> {
    read_in_pieces(text, PIECE)
}

/// Reads the text in pieces of about `size` bytes, whose number changes nothing.
pub fn read_in_pieces(text: &str, size: usize) -> Result<ObjSurface, (usize, Problem)> {
    let texts = split(text, size);
    let mut vertices: Vec<_> = texts.par_iter().map(|text| vertices::read(text)).collect();
    let mut pieces = Vec::with_capacity(texts.len());
    let (mut line, mut counts) = (1, [0; 3]);
    let mut mistake = None;
    for (&text, found) in texts.iter().zip(&mut vertices) {
        let before = counts;
        pieces.push(Chunk { text, line, before });
        let more: VertexCounts = [found.points.len(), found.uvs.len(), found.normals.len()];
        counts = std::array::from_fn(|i| counts[i] + more[i]);
        // What comes after the first mistake is of no interest, and could not be numbered.
        if let Some((number, problem)) = found.mistake.take() {
            mistake = Some((line + number, problem));
            break;
        }
        line += found.lines;
    }
    let mut surface = ObjSurface::default();
    for found in vertices {
        surface.points.extend(found.points);
        surface.uvs.extend(found.uvs);
        surface.normals.extend(found.normals);
    }
    let points = &surface.points;
    let read = |piece: &Chunk| faces::read(piece, points, counts);
    let mut all = Faces::default();
    for some in pieces.chunks(AT_ONCE) {
        let mut faces: Vec<_> = some.par_iter().map(read).collect();
        // The mistakes of both passes: the first line counts.
        let mut mistakes = faces.iter_mut().filter_map(|found| found.mistake.take());
        if let Some((line, problem)) = mistakes.next() {
            let first = mistake.filter(|(earlier, _)| *earlier <= line);
            return Err(first.unwrap_or((line, problem)));
        }
        let total: usize = faces.iter().map(|found| found.triangles.len()).sum();
        // Asked before there are many more: a face is a few letters, a triangle in memory a hundred bytes.
        if all.triangles.len() + total > MAX_PRIMITIVES {
            let problem = Problem::new(
                format!("here are more than {MAX_PRIMITIVES} triangles"),
                "use a model with fewer triangles",
            );
            return Err((some[0].line, problem));
        }
        all.triangles.reserve_exact(total);
        all.lines.reserve_exact(total);
        for found in faces {
            all.append(found);
        }
    }
    surface.faces = all;
    mistake.map_or(Ok(surface), Err)
}

/// Pieces of about `size` bytes that end where lines end.
fn split(mut text: &str, size: usize) -> Vec<&str> {
    let mut pieces = Vec::with_capacity(text.len() / size + 1);
    while text.len() > size {
        let Some(end) = text.as_bytes()[size..].iter().position(|b| *b == b'\n') else {
            break;
        };
        let (piece, rest) = text.split_at(size + end + 1);
        pieces.push(piece);
        text = rest;
    }
    pieces.push(text);
    pieces
}

impl Faces {
    /// Puts those of the next piece behind these.
    fn append(&mut self, next: Self) {
        let before = self.triangles.len();
        let shifted = |(at, line, mark)| (before + at, line, mark);
        self.marks.extend(next.marks.into_iter().map(shifted));
        self.triangles.extend(next.triangles);
        self.lines.extend(next.lines);
        self.uvs.extend(next.uvs);
        self.normals.extend(next.normals);
        if self.edges.0 == 0 {
            self.edges.1 = next.edges.1;
        }
        self.edges.0 += next.edges.0;
    }
}
