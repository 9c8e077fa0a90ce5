//! The profile of a quadric of revolution: its radius R at each height y.
//!
//! Straight: R = m + s y, the cylinder (s = 0) and the cone. Curved: R^2 = a y^2 + b y + c, the others; see the constructors.
//! One equation for five shapes: F = x^2 + z^2 - R^2. A cone's F has a second nappe beyond the apex, where R < 0. It lies
//! outside of the two planes that end the shape, as no radius is below 0 between them.

use std::f64::consts::PI;

use super::moved::Moved;
use super::on_line::OnLine;
use crate::math::{DVec2, DVec3};

/// The radius as a function of the height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Profile {
    /// R = m + s y.
    Straight {
        /// The radius at y = 0.
        m: f64,
        /// How much it grows with y.
        s: f64,
    },
    /// R^2 = a y^2 + b y + c.
    Curved {
        /// Above 0 for hyperboloids, 0 for paraboloids.
        a: f64,
        /// Not 0 for paraboloids only.
        b: f64,
        /// R^2 at y = 0; below 0 for hyperboloids of two sheets.
        c: f64,
    },
}

impl Profile {
    /// From `bottom` at y = -h to `top` at y = +h.
    pub fn straight(bottom: f64, top: f64, h: f64) -> Self {
        let (m, s) = (0.5 * (bottom + top), (top - bottom) / (2.0 * h));
        Self::Straight { m, s }
    }

    /// R^2 = r^2 (y + h) / 2h.
    pub fn paraboloid(radius: f64, h: f64) -> Self {
        let (a, b) = (0.0, radius * radius / (2.0 * h));
        Self::Curved { a, b, c: b * h }
    }

    /// R^2 = w^2 + (r^2 - w^2) (y/h)^2.
    pub fn one_sheet(waist: f64, radius: f64, h: f64) -> Self {
        Self::Curved {
            a: (radius - waist) * (radius + waist) / (h * h),
            b: 0.0,
            c: waist * waist,
        }
    }

    /// R^2 = r^2 (y^2 - w^2) / (h^2 - w^2).
    pub fn two_sheets(waist: f64, radius: f64, h: f64) -> Self {
        let a = radius * radius / ((h - waist) * (h + waist));
        let c = -a * waist * waist;
        Self::Curved { a, b: 0.0, c }
    }

    /// a, b and c of R^2 = a y^2 + b y + c.
    pub fn square(self) -> [f64; 3] {
        match self {
            Self::Straight { m, s } => [s * s, 2.0 * m * s, m * m],
            Self::Curved { a, b, c } => [a, b, c],
        }
    }

    /// R^2, below 0 where there is no surface.
    pub fn radius_squared(self, y: f64) -> f64 {
        match self {
            Self::Straight { m, s } => (m + s * y) * (m + s * y),
            Self::Curved { a, b, c } => (a * y + b) * y + c,
        }
    }

    /// R, or 0 where there is no surface.
    pub fn radius(self, y: f64) -> f64 {
        match self {
            Self::Straight { m, s } => (m + s * y).max(0.0),
            Self::Curved { .. } => self.radius_squared(y).max(0.0).sqrt(),
        }
    }

    /// The narrower end of a cone: 1 at the top, -1 at the bottom; 0 for other shapes.
    pub fn narrow_end(self) -> f64 {
        match self {
            Self::Straight { s, .. } if s != 0.0 => -s.signum(),
            _ => 0.0,
        }
    }

    /// R dR/dy, half the slope of R^2.
    pub fn half_slope(self, y: f64) -> f64 {
        match self {
            Self::Straight { m, s } => (m + s * y) * s,
            Self::Curved { a, b, .. } => a * y + 0.5 * b,
        }
    }

    /// F = x^2 + z^2 - R(y)^2 along a line: A = e.e - a d_y^2, B = p.e - R R' d_y, C = p.p - R^2, with p = (o_x, o_z) and
    /// e = (d_x, d_z).
    pub fn on_line(self, line: &Moved) -> OnLine {
        let (o, d) = (line.origin, line.direction);
        let (p, e) = (DVec2::new(o.x, o.z), DVec2::new(d.x, d.z));
        let [square, ..] = self.square();
        let a = e.length_squared() - square * (d.y * d.y);
        let b = p.dot(e) - self.half_slope(o.y) * d.y;
        let c = p.length_squared() - self.radius_squared(o.y);
        OnLine::new(a, b, c)
    }

    /// True if R changes faster than y at (radius, y). To take R from y would make a given error larger there.
    pub fn is_flat(self, radius: f64, y: f64) -> bool {
        match self {
            Self::Straight { s, .. } => s.abs() > 1.0,
            Self::Curved { .. } => self.half_slope(y).abs() > radius,
        }
    }

    /// The height near `y` at which R is `radius`. For walls that are flat there.
    pub fn height(self, radius: f64, y: f64) -> f64 {
        match self {
            Self::Straight { m, s } => (radius - m) / s,
            Self::Curved { a: 0.0, b, c } => (radius * radius - c) / b,
            Self::Curved { a, c, .. } => {
                let square = (radius * radius - c) / a;
                square.max(0.0).sqrt().copysign(y)
            }
        }
    }

    /// The gradient of F, halved: (x, -R dR/dy, z). The cone's is divided by R: it keeps its direction up to the apex, where
    /// the gradient vanishes and the axis is left.
    pub fn outwards(self, point: DVec3) -> DVec3 {
        let y = match self {
            Self::Straight { s, .. } => -s * libm::hypot(point.x, point.z),
            Self::Curved { .. } => -self.half_slope(point.y),
        };
        let apex = match self {
            Self::Straight { s, .. } => DVec3::new(0.0, -s, 0.0),
            Self::Curved { .. } => DVec3::Y,
        };
        DVec3::new(point.x, y, point.z).normalize_or(apex.normalize_or(DVec3::Y))
    }

    /// pi times the integral of R^2 from -h to h. Two sheets: only beyond the gap.
    pub fn volume(self, h: f64) -> f64 {
        match self {
            Self::Straight { m, s } => 2.0 * PI * h * (m * m + s * s * h * h / 3.0),
            Self::Curved { a, c, .. } if c < 0.0 => {
                let w = (-c / a).sqrt();
                2.0 * PI * a * (h - w) * (h - w) * (h + 2.0 * w) / 3.0
            }
            Self::Curved { a, c, .. } => 2.0 * PI * h * (c + a * h * h / 3.0),
        }
    }
}
