//! An edge of a polygon as seen from the middle: a great circle, whose shadow on the unit disc is an ellipse.

use crate::math::DVec3;

/// The plane z = slope . (x, y) of a great circle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Edge {
    slope: [f64; 2],
}

impl Edge {
    /// The edge between two corners, as seen from the middle.
    pub fn new(a: DVec3, b: DVec3) -> Self {
        let n = a.cross(b);
        Self {
            slope: [-n.x / n.z, -n.y / n.z],
        }
    }

    /// The great circle's height over the `azimuth` (cosine and sine), for a radius of 1.
    #[inline]
    fn height(&self, azimuth: [f64; 2]) -> f64 {
        self.slope[0] * azimuth[0] + self.slope[1] * azimuth[1]
    }

    /// The ellipse's squared radius: a point of the circle lies at height / radius on the unit sphere.
    #[inline]
    pub fn squared_radius(&self, azimuth: [f64; 2]) -> f64 {
        let z = self.height(azimuth);
        1.0 / (1.0 + z * z)
    }

    /// One over the height of the circle's unit normal.
    #[inline]
    pub fn steepness(&self) -> f64 {
        let [x, y] = self.slope;
        (1.0 + x * x + y * y).sqrt()
    }

    /// The area between the middle and the ellipse, from `start` on: half the angle along the circle, times the height
    /// of its normal. In a turn t from d to e, |d x e| = sin t x steepness, and d.e = cos t + the heights' product.
    #[inline]
    pub fn area_under(&self, start: [f64; 2], sin: f64, cos: f64) -> f64 {
        let steepness = self.steepness();
        let heights = self.height(start) * self.height(rotated(start, sin, cos));
        libm::atan2(sin * steepness, cos + heights) / (2.0 * steepness)
    }

    /// Sine and cosine of the turn that an angle along the circle makes, as seen from above.
    pub fn turn_of(&self, start: [f64; 2], angle: f64) -> (f64, f64) {
        // The start d, and at a right angle to it along the circle n x d, in the frame of the start's azimuth.
        let z = self.height(start);
        let across = self.slope[1] * start[0] - self.slope[0] * start[1];
        let steepness = self.steepness();
        let length = (1.0 + z * z).sqrt();
        let (sin, cos) = libm::sincos(angle);
        let side = DVec3::new(-z * across, 1.0 + z * z, across) / (steepness * length);
        let x = cos / length + sin * side.x;
        let y = sin * side.y;
        let flat = (x * x + y * y).sqrt();
        if flat > 0.0 {
            (y / flat, x / flat)
        } else {
            (0.0, 1.0)
        }
    }
}

/// An azimuth turned counterclockwise.
#[inline]
pub fn rotated([x, y]: [f64; 2], sin: f64, cos: f64) -> [f64; 2] {
    [x * cos - y * sin, x * sin + y * cos]
}

/// Cosine and sine of a corner's azimuth.
pub fn azimuth(corner: DVec3) -> [f64; 2] {
    let length = (corner.x * corner.x + corner.y * corner.y).sqrt();
    if length > 0.0 {
        [corner.x / length, corner.y / length]
    } else {
        [1.0, 0.0]
    }
}

/// The angle from one azimuth to another, counterclockwise, from -pi to pi.
pub fn turn([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    libm::atan2(ax * by - ay * bx, ax * bx + ay * by)
}
