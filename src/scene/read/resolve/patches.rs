//! Parametric surfaces of a scene file, cut into leaves in the world.

use super::checks::{number, points};
use super::header::Header;
use super::resolver::Resolver;
use crate::geometry::patch::open_edges;
use crate::geometry::{BezierSurface, NurbsSurface, Shape, SurfacePatch};
use crate::math::DVec3;
use crate::scene::limits::MAX_COORDINATE;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{BezierFile, NurbsFile, Triple};

/// u and v at the first corner of a patch and at its last.
type Range = [[f64; 2]; 2];

/// Rows of points along u.
type Rows = Vec<Vec<DVec3>>;

impl Resolver {
    /// Adds Bezier patches.
    pub fn add_bezier(
        &mut self,
        file: &BezierFile,
        material: u32,
        header: &Header,
    ) -> Result<(), SceneError> {
        let path = header.path.key("patches");
        let mut patches = Vec::with_capacity(file.patches.len());
        for (i, rows) in file.patches.iter().enumerate() {
            patches.push(placed(rows, header, &path.index(i))?);
        }
        let mut weights = file.weights.clone();
        for rows in weights.iter_mut().flatten() {
            turned(rows, header);
        }
        let surface = BezierSurface {
            degree: file.degree.map(|d| d as usize),
            patches,
            weights,
            ranges: self::ranges(file, &header.path)?,
        };
        self.add_leaves(surface.leaves(), file.closed, material, header)
    }

    /// Adds a NURBS surface.
    pub fn add_nurbs(
        &mut self,
        file: &NurbsFile,
        material: u32,
        header: &Header,
    ) -> Result<(), SceneError> {
        let path = header.path.key("knots");
        let mut knots = file.knots.clone();
        for (i, list) in knots.iter().enumerate() {
            for (j, knot) in list.iter().enumerate() {
                let path = path.index(i).index(j);
                number(*knot, [-MAX_COORDINATE, MAX_COORDINATE], &path)?;
            }
        }
        let mut weights = file.weights.clone();
        if let Some(rows) = &mut weights {
            turned(rows, header);
        }
        if is_mirrored(header) {
            knots[0].reverse();
            knots[0].iter_mut().for_each(|knot| *knot = -*knot);
        }
        let surface = NurbsSurface {
            degree: file.degree.map(|d| d as usize),
            knots,
            points: placed(&file.points, header, &header.path.key("points"))?,
            weights,
        };
        self.add_leaves(surface.leaves(), file.closed, material, header)
    }

    fn add_leaves(
        &mut self,
        leaves: Result<Vec<SurfacePatch>, String>,
        closed: bool,
        material: u32,
        header: &Header,
    ) -> Result<(), SceneError> {
        let path = &header.path;
        let leaves = leaves.map_err(|problem| {
            let what = format!("the surface `{}` cannot be made: {problem}", header.name);
            path.error(what, "see the format of scenes in the book: bezier, nurbs")
        })?;
        let open = if closed { open_edges(&leaves) } else { 0 };
        if open > 0 {
            let what = format!(
                "the surface `{}` is told to be closed, but {open} edges of its leaves are open",
                header.name
            );
            let cure = "give both patches at an edge the same points to the last digit, or leave out `closed`";
            return Err(path.key("closed").error(what, cure));
        }
        self.begin(header, material)?;
        for leaf in leaves {
            self.add_shape(Shape::Patch(Box::new(leaf)), path)?;
        }
        Ok(())
    }
}

fn ranges(file: &BezierFile, path: &FieldPath) -> Result<Option<Vec<Range>>, SceneError> {
    let path = path.key("ranges");
    for (i, range) in file.ranges.iter().flatten().enumerate() {
        for (j, x) in range.iter().flatten().enumerate() {
            number(
                *x,
                [-MAX_COORDINATE, MAX_COORDINATE],
                &path.index(i).index(j / 2),
            )?;
        }
    }
    Ok(file.ranges.clone())
}

/// Points in the world. In a mirror u runs the other way, so that the front stays in front.
fn placed(rows: &[Vec<Triple>], header: &Header, path: &FieldPath) -> Result<Rows, SceneError> {
    let mut all = Vec::with_capacity(rows.len());
    for (i, row) in rows.iter().enumerate() {
        let row = points(row, &path.index(i))?;
        let carried = |p: DVec3| header.to_world.as_ref().map_or(p, |map| map.point(p));
        all.push(row.into_iter().map(carried).collect());
    }
    turned(&mut all, header);
    Ok(all)
}

/// Turns rows along u around if the transform mirrors.
fn turned<T>(rows: &mut [Vec<T>], header: &Header) {
    if is_mirrored(header) {
        for row in rows {
            row.reverse();
        }
    }
}

fn is_mirrored(header: &Header) -> bool {
    header.to_world.is_some_and(|map| map.flips_handedness())
}
