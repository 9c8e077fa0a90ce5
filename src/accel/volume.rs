//! Bounding volumes: a box or a sphere, and the part of a ray inside it.

use crate::geometry::Aabb;
use crate::math::{DVec3, Interval, Ray};

/// What bounds a node.
#[derive(Clone, Copy, Debug)]
pub enum Volume {
    /// A box along the axes.
    Box(Aabb),
    /// A sphere with its inside.
    Sphere {
        /// Its middle.
        center: DVec3,
        /// Its radius.
        radius: f64,
    },
}

impl Volume {
    /// The box around it.
    pub fn bounds(&self) -> Aabb {
        match self {
            Self::Box(bounds) => *bounds,
            Self::Sphere { center, radius } => {
                Aabb::around([*center]).padded(DVec3::splat(*radius))
            }
        }
    }

    /// The part of a ray inside the volume grown by `tolerance`; `None` if it misses that.
    #[inline]
    pub fn clip(&self, ray: &Ray, interval: Interval, tolerance: f64) -> Option<Interval> {
        match self {
            Self::Box(bounds) => bounds.padded(DVec3::splat(tolerance)).clip(ray, interval),
            Self::Sphere { center, radius } => {
                clip_sphere(ray, *center, radius + 2.0 * tolerance, tolerance, interval)
            }
        }
    }
}

/// The part of a ray inside a sphere: where the ray is closest to the center, and half the chord to both sides.
///
/// The closest distance is wrong by less than the tolerance e. The radius was grown by 2 e, so for a ray that really passes at
/// p <= r the chord stays long enough: (r + 2 e)^2 - (p + e)^2 >= r^2 - p^2. NaN keeps the sphere in.
fn clip_sphere(
    ray: &Ray,
    center: DVec3,
    radius: f64,
    tolerance: f64,
    interval: Interval,
) -> Option<Interval> {
    let to_center = center - ray.origin;
    let speed = ray.direction.length();
    let t = to_center.dot(ray.direction) / (speed * speed);
    let distance = (to_center - t * ray.direction).length();
    if distance > radius {
        return None;
    }
    let half = ((radius - distance) * (radius + distance)).sqrt() + tolerance;
    // `max` and `min` ignore NaN.
    let inside = Interval::new(
        interval.min.max(t - half / speed),
        interval.max.min(t + half / speed),
    );
    (inside.min <= inside.max).then_some(inside)
}
