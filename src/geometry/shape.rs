//! The shapes of a scene: the closed set of what a ray can hit.

mod body;
mod csg;
mod faces;
mod naive;
mod transformed;

pub use body::Body;
pub use csg::{Csg, CsgCut, CsgCuts, CsgNode, CsgOp, CsgTree, HalfSpace, Polyhedron, Solid};
pub use naive::Naive;
pub use transformed::Transformed;

use std::sync::Arc;

use super::{
    Aabb, Arithmetic, Cuboid, Disc, Intersection, Plane, Polygon, SharedMesh, Shear, Span, Spans,
    Sphere, SurfacePatch, SurfacePoint, Triangle,
};
use crate::math::{DVec3, Interval, Ray};

/// A shape in the world: the closed set of what can be hit. Those that are larger than a triangle are boxed, since
/// there may be millions of triangles.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A flat triangle.
    Triangle(Triangle),
    /// A sphere.
    Sphere(Sphere),
    /// An endless plane.
    Plane(Box<Plane>),
    /// A box with faces along the axes.
    Cuboid(Cuboid),
    /// A disc.
    Disc(Box<Disc>),
    /// A flat polygon.
    Polygon(Box<Polygon>),
    /// A leaf of a parametric surface.
    Patch(Box<SurfacePatch>),
    /// A solid with parts, or the open wall of one.
    Body(Box<Body>),
    /// A mesh that is kept once, in its own space.
    Mesh(Arc<SharedMesh>),
    /// A sphere, box, disc, body or kept mesh that was turned or stretched: tested in its own space.
    Transformed(Box<Transformed>),
    /// Any of these, tested with other arithmetic: only where a user asked to see it.
    Naive(Box<Naive>),
}

// There may be millions.
const _: () = assert!(size_of::<Shape>() == 80);

/// Whether a ray goes into a solid at `t`, one of the two t at which it crosses it.
fn enters_solid([enter, exit]: [f64; 2], t: f64) -> Option<bool> {
    (enter < exit).then_some(t < exit)
}

/// The spans of a convex solid, from the two t at which it is crossed.
fn between(crossings: Option<[f64; 2]>) -> Spans {
    let span = crossings.filter(|[enter, leave]| enter < leave);
    span.map(|[enter, leave]| Span::between(enter, leave))
        .into()
}

impl Shape {
    /// Whether it is tested in the ray's own view ([`Shear`]).
    #[inline]
    pub fn needs_view(&self) -> bool {
        match self {
            Self::Triangle(_) | Self::Polygon(_) | Self::Patch(_) | Self::Naive(_) => true,
            Self::Sphere(_)
            | Self::Plane(_)
            | Self::Cuboid(_)
            | Self::Disc(_)
            | Self::Body(_)
            | Self::Mesh(_)
            | Self::Transformed(_) => false,
        }
    }

    /// Where `ray` first crosses the shape inside `interval`. `shear` is [`Shear::new`] of the same ray, or [`Shear::NONE`] if the
    /// shape needs no view.
    #[inline]
    pub fn intersect(&self, ray: &Ray, shear: &Shear, interval: Interval) -> Intersection {
        match self {
            Self::Triangle(triangle) => triangle.intersect(shear, interval),
            Self::Sphere(sphere) => sphere.intersect(ray, interval),
            Self::Plane(plane) => plane.intersect(ray, interval),
            Self::Cuboid(cuboid) => cuboid.intersect(ray, interval),
            Self::Disc(disc) => disc.intersect(ray, interval),
            Self::Polygon(polygon) => polygon.intersect(ray, shear, interval),
            Self::Patch(patch) => patch.intersect(shear, interval),
            Self::Body(body) => body.intersect(ray, interval),
            Self::Mesh(mesh) => mesh.intersect(ray, interval),
            Self::Transformed(transformed) => transformed.intersect(ray, interval),
            Self::Naive(naive) => naive.intersect(ray, shear, interval),
        }
    }

    /// Where `ray` crosses the shape at `t`, as found by [`Shape::intersect`]: true if it goes in there, false if it comes
    /// out, `None` if it only touches a solid. Decided by what decided that it is crossed, not by the normal, which is
    /// rounded: so a ray comes out of a closed mesh as often as it goes in.
    pub fn enters(&self, ray: &Ray, shear: &Shear, t: f64) -> Option<bool> {
        match self {
            Self::Triangle(triangle) => Some(triangle.is_met_in_front(shear)),
            Self::Sphere(sphere) => enters_solid(sphere.span(ray)?, t),
            Self::Cuboid(cuboid) => enters_solid(cuboid.span(ray)?, t),
            Self::Plane(plane) => Some(plane.normal().dot(ray.direction) < 0.0),
            Self::Disc(disc) => Some(disc.frame.w.dot(ray.direction) < 0.0),
            Self::Polygon(polygon) => Some(polygon.is_met_in_front(shear)),
            Self::Patch(patch) => {
                let crossings = patch.crossings(shear);
                crossings.iter().find(|c| c.t == t).map(|c| c.enters)
            }
            Self::Body(body) => body.enters(ray, t),
            Self::Mesh(mesh) => mesh.enters(ray, t),
            Self::Transformed(transformed) => transformed.enters(ray, t),
            Self::Naive(naive) if naive.arithmetic == Arithmetic::default() => {
                naive.shape.enters(ray, shear, t)
            }
            Self::Naive(naive) => {
                let normal = naive.surface(ray, t, [1.0, 0.0, 0.0], 0).normal;
                Some(normal.dot(ray.direction) < 0.0)
            }
        }
    }

    /// The spans of the ray's line inside a solid; `None` if the shape is no solid.
    pub fn spans(&self, ray: &Ray) -> Option<Spans> {
        match self {
            Self::Sphere(sphere) => Some(between(sphere.span(ray))),
            Self::Cuboid(cuboid) => Some(between(cuboid.span(ray))),
            Self::Body(body) => body.is_solid().then(|| body.spans(ray)),
            Self::Triangle(_)
            | Self::Plane(_)
            | Self::Disc(_)
            | Self::Polygon(_)
            | Self::Patch(_)
            | Self::Mesh(_) => None,
            Self::Transformed(moved) => moved.shape.spans(&moved.transform.ray_to_object(ray)),
            Self::Naive(naive) => naive.shape.spans(ray),
        }
    }

    /// True if the shape bounds a part of space by itself.
    pub fn is_solid(&self) -> bool {
        match self {
            Self::Sphere(_) | Self::Cuboid(_) => true,
            Self::Body(body) => body.is_solid(),
            Self::Triangle(_)
            | Self::Plane(_)
            | Self::Disc(_)
            | Self::Polygon(_)
            | Self::Patch(_)
            | Self::Mesh(_) => false,
            Self::Transformed(transformed) => transformed.shape.is_solid(),
            Self::Naive(naive) => naive.shape.is_solid(),
        }
    }

    /// True if a line may cross the shape more than once.
    pub fn is_crossed_often(&self) -> bool {
        self.is_solid() || matches!(self.plain(), Self::Patch(_)) || self.mesh().is_some()
    }

    /// True for a solid that every line crosses twice at most.
    pub fn is_convex(&self) -> bool {
        match self {
            Self::Body(_) | Self::Mesh(_) => false,
            Self::Transformed(transformed) => transformed.shape.is_convex(),
            Self::Naive(naive) => naive.shape.is_convex(),
            other => other.is_solid(),
        }
    }

    /// The volume of a solid, in cubic metres, as rounded; 0 for what is no solid.
    pub fn volume(&self) -> f64 {
        match self {
            Self::Sphere(sphere) => sphere.volume(),
            Self::Cuboid(cuboid) => cuboid.bounds.size().element_product(),
            Self::Body(body) => body.volume(),
            Self::Triangle(_)
            | Self::Plane(_)
            | Self::Disc(_)
            | Self::Polygon(_)
            | Self::Patch(_)
            | Self::Mesh(_) => 0.0,
            Self::Transformed(moved) => moved.shape.volume() * moved.transform.volume_ratio(),
            Self::Naive(naive) => naive.shape.volume(),
        }
    }

    /// The point at which `ray` crosses the shape, as found by [`Shape::intersect`].
    pub fn surface(&self, ray: &Ray, t: f64, place: [f64; 3], part: u32) -> SurfacePoint {
        match self {
            Self::Triangle(triangle) => triangle.surface(place),
            Self::Sphere(sphere) => sphere.surface(ray, t),
            Self::Plane(plane) => plane.surface(ray, t),
            Self::Cuboid(cuboid) => cuboid.surface(ray, t),
            Self::Disc(disc) => disc.surface(ray, t),
            Self::Polygon(polygon) => polygon.surface(ray, t),
            Self::Patch(patch) => patch.surface([place[0], place[1]]),
            Self::Body(body) => body.surface(ray, t, part),
            Self::Mesh(mesh) => mesh.surface(place, part),
            Self::Transformed(transformed) => transformed.surface(ray, t, place, part),
            Self::Naive(naive) => naive.surface(ray, t, place, part),
        }
    }

    /// The point, its error and its normal as [`Shape::surface`] gives them, without u and v where those take time.
    pub fn bare_surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        match self {
            Self::Sphere(sphere) => sphere.bare_surface(ray, t),
            Self::Transformed(transformed) => transformed.bare_surface(ray, t, part),
            other => other.surface(ray, t, [0.0; 3], part),
        }
    }

    /// The gradient of the equation F = 0 of a curved surface at a point of a part, in world space: at right angles to the surface,
    /// outwards. None where there is no equation but a plane's or a table's, and for spheres, whose normal needs none.
    pub fn gradient(&self, point: DVec3, part: u32) -> Option<DVec3> {
        match self.plain() {
            Self::Body(body) => body.gradient(point, part),
            Self::Transformed(transformed) => transformed.gradient(point, part),
            _ => None,
        }
    }

    /// A box around the shape that contains it whatever was rounded; `None` if the shape has no end.
    pub fn bounds(&self) -> Option<Aabb> {
        match self {
            Self::Triangle(triangle) => Some(triangle.bounds()),
            Self::Sphere(sphere) => Some(sphere.bounds()),
            Self::Plane(_) => None,
            Self::Cuboid(cuboid) => Some(cuboid.bounds),
            Self::Disc(disc) => Some(disc.bounds()),
            Self::Polygon(polygon) => Some(polygon.bounds()),
            Self::Patch(patch) => Some(patch.bounds()),
            Self::Body(body) => Some(body.bounds()),
            Self::Mesh(mesh) => Some(mesh.bounds()),
            Self::Transformed(transformed) => transformed.bounds(),
            Self::Naive(naive) => naive.bounds(),
        }
    }

    /// True if the shape lies in a plane and is tested in world space: a ray that leaves it cannot meet it again.
    pub fn is_flat(&self) -> bool {
        match self {
            Self::Triangle(_) | Self::Plane(_) | Self::Disc(_) | Self::Polygon(_) => true,
            Self::Sphere(_)
            | Self::Cuboid(_)
            | Self::Body(_)
            | Self::Patch(_)
            | Self::Mesh(_)
            | Self::Transformed(_) => false,
            Self::Naive(naive) => naive.shape.is_flat(),
        }
    }

    /// What the shape is called in what a user reads.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Triangle(_) => "triangle",
            Self::Sphere(_) => "sphere",
            Self::Plane(_) => "plane",
            Self::Cuboid(_) => "box",
            Self::Disc(_) => "disc",
            Self::Polygon(_) => "polygon",
            Self::Patch(_) => "patch",
            Self::Body(body) => body.kind(),
            Self::Mesh(_) => "mesh",
            Self::Transformed(transformed) => transformed.shape.kind(),
            Self::Naive(naive) => naive.shape.kind(),
        }
    }
}
