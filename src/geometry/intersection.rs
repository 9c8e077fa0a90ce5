//! Results of ray tests: an intersection, the closest hit, and the surface point there.

use crate::math::{DVec2, DVec3, Interval};

/// What testing one shape against one ray found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intersection {
    /// The first crossing inside the interval.
    Hit {
        /// The ray parameter.
        t: f64,
        /// What the shape needs to find the point again: see [`Hit::place`].
        place: [f64; 3],
        /// The part of the shape that is met: see [`Hit::part`].
        part: u32,
    },
    /// The ray's line crosses the shape, but at or before the start of the interval.
    Behind(f64),
    /// The ray crosses the shape, but at or after the end of the interval.
    TooFar(f64),
    /// The ray's line does not cross the shape.
    Miss,
}

impl Intersection {
    /// A crossing at `t`, which lies before, inside or behind the interval. NaN is a miss.
    pub fn classify(t: f64, place: [f64; 3], interval: Interval) -> Self {
        if interval.contains(t) {
            let part = 0;
            Self::Hit { t, place, part }
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
    /// The part of the shape that is met, counted from 0: the wall or a cap of a cylinder, the leaf of a solid that is cut from
    /// others. 0 for shapes of one part.
    pub part: u32,
    /// What the shape needs to find the point again: the weights of a triangle's corners, which sum to 1; u and v of a patch;
    /// zeros for other shapes.
    pub place: [f64; 3],
}

// There is one in every event of a hit.
const _: () = assert!(size_of::<Hit>() == 40);

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
