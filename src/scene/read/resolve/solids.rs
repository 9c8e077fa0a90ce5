//! Solids of a scene file: each stands in a space of its own, with its axis along y, and is carried from there.

use glam::{DAffine3, DMat3};

use super::checks::{direction, number, point, positive};
use super::shapes::{in_world, placed};
use crate::geometry::{
    Aabb, Body, BoxedQuadric, Cuboid, Quadric, QuadricForm, Quartic, Shape, Sheets, Sphere, Torus,
};
use crate::math::{DVec3, Frame, Transform};
use crate::scene::limits::MAX_COORDINATE;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{
    BoxFile, ConeFile, CylinderFile, EllipsoidFile, HyperboloidFile, ParaboloidFile, QuadricFile,
    QuarticFile, SphereFile, TorusFile, Triple,
};

/// What a solid gives, or why it is refused.
type Resolved = Result<Shape, SceneError>;

pub fn sphere<M>(s: &SphereFile<M>, path: &FieldPath) -> Resolved {
    let center = point(s.center, &path.key("center"))?;
    let radius = positive(s.radius, &path.key("radius"))?;
    Ok(Shape::Sphere(Sphere { center, radius }))
}

pub fn cuboid<M>(b: &BoxFile<M>, path: &FieldPath) -> Resolved {
    let bounds = bounds(b.min, b.max, path)?;
    Ok(Shape::Cuboid(Cuboid { bounds }))
}

pub fn cylinder<M>(c: &CylinderFile<M>, path: &FieldPath) -> Resolved {
    let axis = Axis::new([("base", c.base), ("top", c.top)], path)?;
    let radius = positive(c.radius, &path.key("radius"))?;
    Ok(axis.place(Quadric::cylinder(radius, axis.half_height), c.open))
}

pub fn cone<M>(c: &ConeFile<M>, path: &FieldPath) -> Resolved {
    let axis = Axis::new([("base", c.base), ("top", c.top)], path)?;
    let radius = positive(c.radius, &path.key("radius"))?;
    let top = number(c.top_radius, [0.0, MAX_COORDINATE], &path.key("top_radius"))?;
    Ok(axis.place(Quadric::cone(radius, top, axis.half_height), c.open))
}

pub fn paraboloid<M>(p: &ParaboloidFile<M>, path: &FieldPath) -> Resolved {
    let axis = Axis::new([("vertex", p.vertex), ("top", p.top)], path)?;
    let radius = positive(p.radius, &path.key("radius"))?;
    Ok(axis.place(Quadric::paraboloid(radius, axis.half_height), p.open))
}

pub fn hyperboloid<M>(h: &HyperboloidFile<M>, path: &FieldPath) -> Resolved {
    let axis = Axis::new([("base", h.base), ("top", h.top)], path)?;
    let radius = positive(h.radius, &path.key("radius"))?;
    let waist_path = path.key("waist");
    let sheets = match h.sheets {
        1 => Sheets::One,
        2 => Sheets::Two,
        other => {
            return Err(path.key("sheets").error(
                format!("there is no hyperboloid of {other} sheets"),
                "write 1 (with a waist) or 2 (two bowls)",
            ));
        }
    };
    let waist = match sheets {
        Sheets::One => positive(h.waist, &waist_path)?,
        Sheets::Two => number(h.waist, [0.0, MAX_COORDINATE], &waist_path)?,
    };
    if sheets == Sheets::Two && waist >= axis.half_height {
        return Err(waist_path.error(
            format!(
                "half the gap is {waist}, half the height {}",
                axis.half_height
            ),
            "make the gap smaller than the distance from base to top",
        ));
    }
    let quadric = Quadric::hyperboloid(waist, radius, axis.half_height, sheets);
    Ok(axis.place(quadric, h.open))
}

/// A unit sphere that is stretched.
pub fn ellipsoid<M>(e: &EllipsoidFile<M>, path: &FieldPath) -> Resolved {
    let center = point(e.center, &path.key("center"))?;
    let radii = path.key("radii");
    for (i, radius) in e.radii.into_iter().enumerate() {
        positive(radius, &radii.index(i))?;
    }
    let map = DAffine3::from_translation(center) * DAffine3::from_scale(e.radii.into());
    let unit = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let map = Transform::new(map).ok_or_else(|| {
        radii.error(
            "the radii are of sizes that numbers cannot hold together",
            "make the largest less than a million times as large as the smallest",
        )
    })?;
    Ok(in_world(Shape::Sphere(unit), Some(&map)))
}

pub fn quadric<M>(q: &QuadricFile<M>, path: &FieldPath) -> Resolved {
    let bounds = bounds(q.min, q.max, path)?;
    coefficients(&q.coefficients, path)?;
    let form = QuadricForm(q.coefficients);
    Ok(body(Body::BoxedQuadric(BoxedQuadric::new(form, bounds))))
}

pub fn torus<M>(t: &TorusFile<M>, path: &FieldPath) -> Resolved {
    let center = point(t.center, &path.key("center"))?;
    let axis = direction(t.axis, &path.key("axis"))?;
    let torus = Torus {
        major: positive(t.major, &path.key("major"))?,
        minor: positive(t.minor, &path.key("minor"))?,
    };
    Ok(at(center, axis, Body::Torus(torus)))
}

pub fn quartic<M>(q: &QuarticFile<M>, path: &FieldPath) -> Resolved {
    let bounds = bounds(q.min, q.max, path)?;
    let found = q.coefficients.len();
    let coefficients_of = <[f64; 35]>::try_from(q.coefficients.as_slice()).map_err(|_| {
        path.key("coefficients").error(
            format!("there are {found} coefficients"),
            "write 35, from that of x^4 to the constant",
        )
    })?;
    coefficients(&coefficients_of, path)?;
    Ok(body(Body::Quartic(Quartic {
        coefficients: coefficients_of,
        bounds,
    })))
}

/// A box from its smallest to its largest corner.
fn bounds(min: Triple, max: Triple, path: &FieldPath) -> Result<Aabb, SceneError> {
    let min = point(min, &path.key("min"))?;
    let max = point(max, &path.key("max"))?;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if min[axis] >= max[axis] {
            return Err(path.error(
                format!(
                    "along {name} the box goes from min {} to max {}",
                    min[axis], max[axis]
                ),
                "make every number of `min` smaller than that of `max`; for a flat thing use a quad",
            ));
        }
    }
    Ok(Aabb { min, max })
}

/// Refuses coefficients that are all 0 but the constant, and those that are too large.
fn coefficients(list: &[f64], path: &FieldPath) -> Result<(), SceneError> {
    let path = path.key("coefficients");
    for (i, x) in list.iter().enumerate() {
        number(*x, [-MAX_COORDINATE, MAX_COORDINATE], &path.index(i))?;
    }
    let but_last = list.split_last().map_or(list, |(_, rest)| rest);
    if but_last.iter().all(|x| *x == 0.0) {
        return Err(path.error(
            "all coefficients but the last are 0: there is no surface",
            "write at least one of them",
        ));
    }
    Ok(())
}

/// The axis of a solid, from one end to the other.
struct Axis {
    middle: DVec3,
    direction: DVec3,
    half_height: f64,
}

impl Axis {
    fn new(ends: [(&str, Triple); 2], path: &FieldPath) -> Result<Self, SceneError> {
        let [from, to] = ends;
        let base = point(from.1, &path.key(from.0))?;
        let top = point(to.1, &path.key(to.0))?;
        let along = top - base;
        let Some(direction) = along.try_normalize() else {
            return Err(path.key(to.0).error(
                format!("`{}` and `{}` are the same point", from.0, to.0),
                "move one of them: the axis runs from one to the other",
            ));
        };
        Ok(Self {
            middle: base + 0.5 * along,
            direction,
            half_height: 0.5 * along.length(),
        })
    }

    fn place(&self, quadric: Quadric, open: bool) -> Shape {
        let quadric = if open { quadric.open() } else { quadric };
        at(self.middle, self.direction, Body::Quadric(quadric))
    }
}

/// A body whose own y axis runs along `axis` in the world, from its middle.
fn at(middle: DVec3, axis: DVec3, own: Body) -> Shape {
    let Frame { u, v, w } = Frame::around(axis);
    let turn = DMat3::from_cols(u, w, -v);
    let map = DAffine3::from_mat3_translation(turn, middle);
    match Transform::new(map) {
        Some(map) if map.to_world() != DAffine3::IDENTITY => placed(body(own), &map),
        _ => body(own),
    }
}

fn body(body: Body) -> Shape {
    Shape::Body(Box::new(body))
}
