//! A sector of a polygon's shadow on the unit disc: between two azimuths, an outer and an inner ellipse.

use super::edge::{Edge, rotated};

/// The relative error of the area at which Newton's method stops; another step would square it.
const TOLERANCE: f64 = 1e-7;

/// The part of the shadow between two azimuths.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sector {
    /// Cosine and sine of the azimuth where it starts.
    start: [f64; 2],
    /// The angle from there to its end, less than half a turn.
    sweep: f64,
    outer: Edge,
    /// `None` if it reaches to the middle.
    inner: Option<Edge>,
    /// The area of the sectors before it and its own.
    pub cumulative_area: f64,
}

impl Sector {
    /// The sector that starts at an azimuth and turns by `sweep`, after others with the area `before`.
    pub fn new(start: [f64; 2], sweep: f64, outer: Edge, inner: Option<Edge>, before: f64) -> Self {
        let mut sector = Self {
            start,
            sweep,
            outer,
            inner,
            cumulative_area: before,
        };
        let (sin, cos) = libm::sincos(sweep);
        sector.cumulative_area += sector.area(sin, cos);
        sector
    }

    /// The point in the disc with the fraction `u` of the sector's `area` before its azimuth, and the fraction `v` of the
    /// ring between the ellipses inside it.
    pub fn at(&self, u: f64, v: f64, area: f64) -> [f64; 2] {
        let (sin, cos) = match self.inner {
            // Equal areas are equal angles along the edge.
            None => self
                .outer
                .turn_of(self.start, 2.0 * u * area * self.outer.steepness()),
            Some(_) => self.turn_of(u, area),
        };
        let azimuth = rotated(self.start, sin, cos);
        let [near, far] = self.ring(azimuth);
        let radius = (near + v * (far - near)).sqrt();
        [azimuth[0] * radius, azimuth[1] * radius]
    }

    /// The squares of the radii of the ellipses towards an azimuth.
    fn ring(&self, azimuth: [f64; 2]) -> [f64; 2] {
        let inner = self.inner.map_or(0.0, |edge| edge.squared_radius(azimuth));
        [inner, self.outer.squared_radius(azimuth).max(inner)]
    }

    /// The area between its start and a turn.
    fn area(&self, sin: f64, cos: f64) -> f64 {
        let inner = self
            .inner
            .map_or(0.0, |e| e.area_under(self.start, sin, cos));
        self.outer.area_under(self.start, sin, cos) - inner
    }

    /// Sine and cosine of the turn with the fraction `u` of the area before it. The area's derivative is half the
    /// difference of the squared radii, so Newton's method finds it, kept between bounds that close in.
    fn turn_of(&self, u: f64, area: f64) -> (f64, f64) {
        let density = |azimuth| {
            let [near, far] = self.ring(azimuth);
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
            if off.abs() <= TOLERANCE * area {
                break;
            }
        }
        libm::sincos(turn)
    }
}
