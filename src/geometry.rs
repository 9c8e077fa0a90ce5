//! Shapes, and where a ray meets them.
//!
//! Finding and describing are two steps: [`Shape::intersect`] says only *where* on the ray, as often as there are
//! candidates; [`Shape::surface`] describes the one point that was chosen.

pub mod aabb;
pub mod arithmetic;
pub mod cuboid;
pub mod disc;
pub mod naive;
pub mod plane;
pub mod sphere;
pub mod triangle;

pub use aabb::Aabb;
pub use arithmetic::{Arithmetic, Offset, Precision, Quadratic, TriangleTest};
pub use cuboid::Cuboid;
pub use disc::Disc;
pub use naive::Naive;
pub use plane::Plane;
pub use sphere::Sphere;
pub use triangle::{Shear, Triangle};

use crate::math::{DVec2, DVec3, Interval, Ray, Transform};

/// What testing one shape against one ray found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intersection {
    /// The first crossing inside the interval.
    Hit {
        /// The ray parameter.
        t: f64,
        /// For triangles the weights of the three corners, which sum to 1; zeros for other shapes.
        barycentric: [f64; 3],
    },
    /// The ray's line crosses the shape, but at or before the start of the interval.
    Behind(f64),
    /// The ray crosses the shape, but at or after the end of the interval.
    TooFar(f64),
    /// The ray's line does not cross the shape.
    Miss,
}

impl Intersection {
    /// A crossing at `t`, put in its place before, inside or behind the interval. NaN is a miss.
    pub fn classify(t: f64, barycentric: [f64; 3], interval: Interval) -> Self {
        if interval.contains(t) {
            Self::Hit { t, barycentric }
        } else if t <= interval.min {
            Self::Behind(t)
        } else if t >= interval.max {
            Self::TooFar(t)
        } else {
            Self::Miss
        }
    }

    /// The first of two crossings t0 <= t1 of a solid that lies inside the interval.
    pub fn first_of(t0: f64, t1: f64, interval: Interval) -> Self {
        match Self::classify(t0, [0.0; 3], interval) {
            Self::Behind(_) => Self::classify(t1, [0.0; 3], interval),
            found => found,
        }
    }
}

/// The closest thing a ray met: which primitive, and where on the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ray parameter, in metres along a world-space ray.
    pub t: f64,
    /// Index into the scene's primitives.
    pub primitive: u32,
    /// Weights of a triangle's corners; zeros for other shapes.
    pub barycentric: [f64; 3],
}

/// A point on a surface, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The point.
    pub point: DVec3,
    /// How far the true surface may be from `point`, per axis (a bound, not an estimate).
    pub error: DVec3,
    /// The unit normal of the shape itself, pointing outwards (triangles: the side that sees the corners run
    /// counter-clockwise).
    pub normal: DVec3,
    /// Surface coordinates: see each shape.
    pub uv: DVec2,
}

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
    Placed(Box<Placed>),
    /// Any of these, tested with other arithmetic: only where a user asked to see it.
    Naive(Box<Naive>),
}

// There may be millions.
const _: () = assert!(size_of::<Shape>() == 80);

/// A shape in its own space, and the way from there into the world.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The shape in object space.
    pub shape: Shape,
    /// Object space to world space.
    pub transform: Transform,
}

/// Whether a ray goes into a solid at `t`, which is one of the two places where it crosses it.
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
            Self::Placed(placed) => {
                let ray = placed.transform.ray_to_object(ray);
                placed.shape.intersect(&ray, &Shear::new(&ray), interval)
            }
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
            Self::Placed(placed) => {
                let ray = placed.transform.ray_to_object(ray);
                placed.shape.enters(&ray, &Shear::new(&ray), t)
            }
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
            Self::Placed(placed) => placed.shape.is_solid(),
            Self::Naive(naive) => naive.shape.is_solid(),
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
            Self::Placed(placed) => {
                let ray = placed.transform.ray_to_object(ray);
                let local = placed.shape.surface(&ray, t, barycentric);
                let error = placed.transform.point_error(local.point, local.error);
                // The next test takes the way back as well. The inverse is only known as well as the transform is
                // conditioned, and a turn brings the error of each axis to all others.
                let there_and_back = 1.0 + 2.0 * placed.transform.condition();
                SurfacePoint {
                    point: placed.transform.point(local.point),
                    error: DVec3::splat(there_and_back * error.max_element()),
                    normal: placed.transform.normal(local.normal),
                    uv: local.uv,
                }
            }
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
            Self::Placed(placed) => placed
                .shape
                .bounds()
                .map(|b| b.transformed(&placed.transform)),
            Self::Naive(naive) => naive.bounds(),
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
            Self::Placed(placed) => placed.shape.kind(),
            Self::Naive(naive) => naive.shape.kind(),
        }
    }
}
