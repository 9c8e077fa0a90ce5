//! A sector of a polygon's shadow on the unit disc: between two azimuths, an outer and an inner ellipse.

use crate::math::DVec3;

/// The azimuth is found when the area is right to this part of its sector; a step of Newton's squares the error.
const CLOSE: f64 = 1e-7;

/// The part of the shadow between two azimuths.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sector {
    /// Cosine and sine of the azimuth where it starts.
    start: [f64; 2],
    /// How far it turns, less than half a turn.
    sweep: f64,
    outer: Edge,
    /// `None` if it reaches to the middle.
    inner: Option<Edge>,
    /// The area of the sectors before it and its own.
    pub until: f64,
}

/// The plane z = slope . (x, y) of a great circle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Edge {
    slope: [f64; 2],
}

impl Sector {
    /// The sector that starts at an azimuth and turns by `sweep`, after others with the area `before`.
    pub fn new(start: [f64; 2], sweep: f64, outer: Edge, inner: Option<Edge>, before: f64) -> Self {
        let mut sector = Self {
            start,
            sweep,
            outer,
            inner,
            until: before,
        };
        let (sin, cos) = libm::sincos(sweep);
        sector.until += sector.area(sin, cos);
        sector
    }

    /// The place in the disc: `u` of the sector's `area` lies before its azimuth, and `v` of the ring between the
    /// ellipses inside it.
    pub fn at(&self, u: f64, v: f64, area: f64) -> [f64; 2] {
        let (sin, cos) = match self.inner {
            // Equal areas are equal angles along the edge.
            None => self
                .outer
                .turn_of(self.start, 2.0 * u * area * self.outer.steepness()),
            Some(_) => self.turn_of(u, area),
        };
        let way = rotated(self.start, sin, cos);
        let [near, far] = self.ring(way);
        let radius = (near + v * (far - near)).sqrt();
        [way[0] * radius, way[1] * radius]
    }

    /// The squares of the radii of the ellipses towards an azimuth.
    fn ring(&self, way: [f64; 2]) -> [f64; 2] {
        let inner = self.inner.map_or(0.0, |edge| edge.squared(way));
        [inner, self.outer.squared(way).max(inner)]
    }

    /// The area between its start and a turn.
    fn area(&self, sin: f64, cos: f64) -> f64 {
        let inner = self.inner.map_or(0.0, |e| e.under(self.start, sin, cos));
        self.outer.under(self.start, sin, cos) - inner
    }

    /// Sine and cosine of the turn with the part `u` of the area before it. The area's derivative is half the
    /// difference of the squared radii, so Newton's method finds it, kept between bounds that close in.
    fn turn_of(&self, u: f64, area: f64) -> (f64, f64) {
        let density = |way| {
            let [near, far] = self.ring(way);
            (far - near) / 2.0
        };
        let (mut low, mut high) = (0.0, self.sweep);
        // As if the density changed evenly from one end to the other.
        let (sin, cos) = libm::sincos(self.sweep);
        let (a, b) = (density(self.start), density(rotated(self.start, sin, cos)));
        let root = (a * a + u * (b * b - a * a)).max(0.0).sqrt();
        let mut turn = if a + root > 0.0 {
            self.sweep * (u * (a + b) / (a + root)).min(1.0)
        } else {
            self.sweep * u
        };
        for _ in 0..20 {
            let (sin, cos) = libm::sincos(turn);
            let off = self.area(sin, cos) - u * area;
            if off > 0.0 {
                high = turn;
            } else {
                low = turn;
            }
            let next = turn - off / density(rotated(self.start, sin, cos));
            turn = if next > low && next < high {
                next
            } else {
                f64::midpoint(low, high)
            };
            if off.abs() <= CLOSE * area {
                break;
            }
        }
        libm::sincos(turn)
    }
}

impl Edge {
    /// The edge between two corners, as seen from the middle.
    pub fn new(a: DVec3, b: DVec3) -> Self {
        let n = a.cross(b);
        Self {
            slope: [-n.x / n.z, -n.y / n.z],
        }
    }

    /// The great circle's height over the azimuth of `way`, for a radius of 1.
    fn height(&self, way: [f64; 2]) -> f64 {
        self.slope[0] * way[0] + self.slope[1] * way[1]
    }

    /// The ellipse's squared radius: a point of the circle lies at height / radius on the unit sphere.
    fn squared(&self, way: [f64; 2]) -> f64 {
        let z = self.height(way);
        1.0 / (1.0 + z * z)
    }

    /// One over the height of the circle's unit normal.
    fn steepness(&self) -> f64 {
        let [x, y] = self.slope;
        (1.0 + x * x + y * y).sqrt()
    }

    /// The area between the middle and the ellipse, from `start` on: half the angle along the circle, times the height
    /// of its normal. In a turn t from d to e, |d x e| = sin t x steepness, and d.e = cos t + the heights' product.
    fn under(&self, start: [f64; 2], sin: f64, cos: f64) -> f64 {
        let steepness = self.steepness();
        let heights = self.height(start) * self.height(rotated(start, sin, cos));
        libm::atan2(sin * steepness, cos + heights) / (2.0 * steepness)
    }

    /// Sine and cosine of the turn that an angle along the circle makes, as seen from above.
    fn turn_of(&self, start: [f64; 2], angle: f64) -> (f64, f64) {
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
