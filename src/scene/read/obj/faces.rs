//! The second pass over a piece of an OBJ file: faces, cut into triangles, and what parts them.

use super::polygon;
use super::tokens::{index, rest};
use crate::math::DVec3;
use crate::scene::limits::MAX_CORNERS;
use crate::scene::read::error::Problem;

/// How many there are: points, texture coordinates, normals.
pub type VertexCounts = [usize; 3];

/// A corner of a triangle that has no normal, or no texture coordinates.
pub const NONE: [u32; 3] = [u32::MAX; 3];

/// What the lines of a piece that are about faces say. Indices count from 0 in the whole file.
#[derive(Debug, Default)]
pub struct Faces {
    /// The points of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Its texture coordinates, or [`NONE`]; empty if the file has none.
    pub uvs: Vec<[u32; 3]>,
    /// Its normals likewise.
    pub normals: Vec<[u32; 3]>,
    /// The line of its face, from 1.
    pub lines: Vec<u32>,
    /// What comes between: before how many triangles of the piece, on which line, and what.
    pub marks: Vec<(usize, usize, Mark)>,
    /// Faces with one or two corners, which have no surface: how many, and the line of the first.
    pub edges: (usize, usize),
    /// The first mistake, with its line.
    pub mistake: Option<(usize, Problem)>,
}

/// A line that says something about the faces after it.
#[derive(Debug)]
pub enum Mark {
    /// `o` or `g`: their name.
    Name(String),
    /// `usemtl`: their material.
    Material(String),
    /// `mtllib`: a file of materials.
    Library(String),
}

/// A piece with what comes before it.
pub struct Chunk<'a> {
    /// Its text.
    pub text: &'a str,
    /// The number of its first line, from 1.
    pub line: usize,
    /// What the file has before it.
    pub before: VertexCounts,
}

/// Reads a piece; `points` are those of the whole file, `totals` what the whole file has.
pub fn read(piece: &Chunk, points: &[DVec3], totals: VertexCounts) -> Faces {
    let mut found = Faces::default();
    let (mut counts, mut corners) = (piece.before, Vec::new());
    for (number, line) in (piece.line..).zip(piece.text.lines()) {
        let key = line.split_ascii_whitespace().next().unwrap_or("");
        if let Some(kind) = ["v", "vt", "vn"].iter().position(|known| *known == key) {
            counts[kind] += 1;
            continue;
        }
        let read = if key == "f" {
            outline(line, counts, &mut corners)
                .map(|()| found.face(number, &corners, points, totals))
        } else {
            found.mark(number, key, line)
        };
        if let Err(problem) = read {
            found.mistake = Some((number, problem));
            break;
        }
    }
    found
}

/// The corners of a face: of each the point, the texture coordinates and the normal, if it has them.
fn outline(
    line: &str,
    counts: VertexCounts,
    corners: &mut Vec<[Option<u32>; 3]>,
) -> Result<(), Problem> {
    corners.clear();
    for corner in rest(line) {
        let mut parts = corner.split('/');
        let mut found = [None; 3];
        for (i, what) in ["vertex", "texture coordinate", "normal"]
            .into_iter()
            .enumerate()
        {
            match parts.next() {
                Some(part) if i == 0 || !part.is_empty() => {
                    found[i] = Some(index(corner, part, what, counts[i])?);
                }
                _ => {}
            }
        }
        if parts.next().is_some() {
            return Err(Problem::new(
                format!("the corner `{corner}` has too many parts"),
                "write v, v/vt, v//vn or v/vt/vn",
            ));
        }
        corners.push(found);
    }
    match corners.len() {
        0 => Err(Problem::new(
            "the face has no corners",
            "write `f a b c`, or take the line away",
        )),
        n if n > MAX_CORNERS => Err(Problem::new(
            format!("the face has {n} corners; {MAX_CORNERS} are possible"),
            "cut it into triangles in the program that made it",
        )),
        _ => Ok(()),
    }
}

impl Faces {
    fn face(
        &mut self,
        line: usize,
        corners: &[[Option<u32>; 3]],
        points: &[DVec3],
        totals: VertexCounts,
    ) {
        match corners.len() {
            0..3 => {
                let first = if self.edges.0 == 0 {
                    line
                } else {
                    self.edges.1
                };
                self.edges = (self.edges.0 + 1, first);
            }
            3 => self.triangle(line, corners, [0, 1, 2], totals),
            _ => {
                let place = |corner: &[Option<u32>; 3]| points.get(corner[0]? as usize).copied();
                let outline: Vec<DVec3> = corners.iter().filter_map(place).collect();
                for cut in polygon::triangulate(&outline) {
                    self.triangle(line, corners, cut, totals);
                }
            }
        }
    }

    /// Three corners of a face. It has normals only if all corners of the face have one; texture coordinates as well.
    fn triangle(
        &mut self,
        line: usize,
        corners: &[[Option<u32>; 3]],
        cut: [usize; 3],
        totals: VertexCounts,
    ) {
        let of = |kind: usize| {
            let all = corners.iter().all(|corner| corner[kind].is_some());
            if all {
                cut.map(|i| corners[i][kind].unwrap_or(u32::MAX))
            } else {
                NONE
            }
        };
        self.triangles.push(of(0));
        self.lines.push(line as u32);
        if totals[1] > 0 {
            self.uvs.push(of(1));
        }
        if totals[2] > 0 {
            self.normals.push(of(2));
        }
    }

    fn mark(&mut self, line: usize, key: &str, text: &str) -> Result<(), Problem> {
        let kind = match key {
            "o" | "g" => Mark::Name,
            "usemtl" => Mark::Material,
            "mtllib" => Mark::Library,
            _ => return Ok(()),
        };
        let name = rest(text).collect::<Vec<_>>().join(" ");
        if key == "usemtl" && name.is_empty() {
            return Err(Problem::new(
                "`usemtl` names no material",
                "write `usemtl name`, or take the line away",
            ));
        }
        self.marks.push((self.triangles.len(), line, kind(name)));
        Ok(())
    }
}
