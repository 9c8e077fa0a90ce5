//! The shapes of a scene: the closed set of what a ray can hit.

mod naive;
mod transformed;

pub use naive::Naive;
pub use transformed::Transformed;

use super::{
    Aabb, Arithmetic, Cuboid, Disc, Intersection, Plane, Shear, Sphere, SurfacePoint, Triangle,
};
use crate::math::{Interval, Ray};

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
    /// A sphere, box or disc that was turned or stretched: tested in its own space.
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

impl Shape {
    /// Where `ray` first crosses the shape inside `interval`. `shear` is [`Shear::new`] of the same ray.
    #[inline]
    pub fn intersect(&self, ray: &Ray, shear: &Shear, interval: Interval) -> Intersection {
        match self {
            Self::Triangle(triangle) => triangle.intersect(shear, interval),
            Self::Sphere(sphere) => sphere.intersect(ray, interval),
            Self::Plane(plane) => plane.intersect(ray, interval),
            Self::Cuboid(cuboid) => cuboid.intersect(ray, interval),
            Self::Disc(disc) => disc.intersect(ray, interval),
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
            Self::Transformed(transformed) => transformed.enters(ray, t),
            Self::Naive(naive) if naive.arithmetic == Arithmetic::default() => {
                naive.shape.enters(ray, shear, t)
            }
            Self::Naive(naive) => {
                let normal = naive.surface(ray, t, [1.0, 0.0, 0.0]).normal;
                Some(normal.dot(ray.direction) < 0.0)
            }
        }
    }

    /// True if the shape bounds a part of space by itself.
    pub fn is_solid(&self) -> bool {
        match self {
            Self::Sphere(_) | Self::Cuboid(_) => true,
            Self::Triangle(_) | Self::Plane(_) | Self::Disc(_) => false,
            Self::Transformed(transformed) => transformed.shape.is_solid(),
            Self::Naive(naive) => naive.shape.is_solid(),
        }
    }

    /// The volume of a solid, in cubic metres, as rounded; 0 for what is no solid.
    pub fn volume(&self) -> f64 {
        match self {
            Self::Sphere(sphere) => sphere.volume(),
            Self::Cuboid(cuboid) => cuboid.bounds.size().element_product(),
            Self::Triangle(_) | Self::Plane(_) | Self::Disc(_) => 0.0,
            Self::Transformed(moved) => moved.shape.volume() * moved.transform.volume_ratio(),
            Self::Naive(naive) => naive.shape.volume(),
        }
    }

    /// The point at which `ray` crosses the shape, as found by [`Shape::intersect`].
    pub fn surface(&self, ray: &Ray, t: f64, barycentric: [f64; 3]) -> SurfacePoint {
        match self {
            Self::Triangle(triangle) => triangle.surface(barycentric),
            Self::Sphere(sphere) => sphere.surface(ray, t),
            Self::Plane(plane) => plane.surface(ray, t),
            Self::Cuboid(cuboid) => cuboid.surface(ray, t),
            Self::Disc(disc) => disc.surface(ray, t),
            Self::Transformed(transformed) => transformed.surface(ray, t, barycentric),
            Self::Naive(naive) => naive.surface(ray, t, barycentric),
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
            Self::Transformed(transformed) => transformed.bounds(),
            Self::Naive(naive) => naive.bounds(),
        }
    }

    /// True if the shape lies in a plane and is tested in world space: a ray that leaves it cannot meet it again.
    pub fn is_flat(&self) -> bool {
        match self {
            Self::Triangle(_) | Self::Plane(_) | Self::Disc(_) => true,
            Self::Sphere(_) | Self::Cuboid(_) | Self::Transformed(_) => false,
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
            Self::Transformed(transformed) => transformed.shape.kind(),
            Self::Naive(naive) => naive.shape.kind(),
        }
    }
}
