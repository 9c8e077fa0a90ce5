//! A leaf of a solid that is cut from others.

use super::{HalfSpace, Polyhedron};
use crate::geometry::{Aabb, Shape, Spans, SurfacePoint};
use crate::math::Ray;

/// A solid that others are cut from or with.
#[derive(Clone, Debug)]
pub enum Solid {
    /// A shape that is a solid: a sphere, a box, and so on, each possibly transformed.
    Shape(Shape),
    /// All that lies behind a plane.
    HalfSpace(Box<HalfSpace>),
    /// A convex solid with flat faces.
    Polyhedron(Box<Polyhedron>),
}

impl Solid {
    /// The spans of the ray's line inside; none for a shape that is no solid.
    pub fn spans(&self, ray: &Ray) -> Spans {
        match self {
            Self::Shape(shape) => shape.spans(ray).unwrap_or_default(),
            Self::HalfSpace(half_space) => half_space.span(ray).into(),
            Self::Polyhedron(polyhedron) => polyhedron.span(ray).into(),
        }
    }

    /// The point at which `ray` crosses the leaf at `t`, one of its spans' ends.
    pub fn surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        match self {
            Self::Shape(shape) => shape.surface(ray, t, [0.0; 3], part),
            _ => self.bare_surface(ray, t, part),
        }
    }

    /// That point without u and v where these take time.
    pub fn bare_surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        match self {
            Self::Shape(shape) => shape.bare_surface(ray, t, part),
            Self::HalfSpace(half_space) => half_space.surface(ray, t),
            Self::Polyhedron(polyhedron) => polyhedron.surface(ray, t),
        }
    }

    /// The box around it; with infinite coordinates where it has no end.
    pub fn bounds(&self) -> Aabb {
        match self {
            Self::Shape(shape) => shape.bounds().unwrap_or(HalfSpace::EVERYWHERE),
            Self::HalfSpace(half_space) => half_space.bounds(),
            Self::Polyhedron(polyhedron) => polyhedron.bounds(),
        }
    }

    /// What it is called in what a user reads.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Shape(shape) => shape.kind(),
            Self::HalfSpace(_) => "half-space",
            Self::Polyhedron(_) => "polyhedron",
        }
    }

    /// True if it has an inside.
    pub(super) fn has_inside(&self) -> bool {
        match self {
            Self::Shape(shape) => shape.is_solid(),
            Self::HalfSpace(_) | Self::Polyhedron(_) => true,
        }
    }
}
