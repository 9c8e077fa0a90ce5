//! A ray: the half-line that starts at `origin` and runs along `direction`.

use super::DVec3;

/// The points `origin + t * direction`, t >= 0.
///
/// World-space rays have unit direction, so `t` is a distance in metres. A ray that was moved into an object's own
/// space (see [`super::Transform`]) keeps the same `t` and gives up the unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where the ray starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
}

impl Ray {
    /// A ray from its start and its direction, taken as they are.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction }
    }

    /// The point at parameter `t`. Good for display; surfaces compute their hit points more exactly themselves.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}
