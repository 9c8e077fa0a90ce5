//! A range of the ray parameter t.

/// The open interval `min < t < max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Values up to and including this one lie before the interval.
    pub min: f64,
    /// Values from this one on lie behind it; infinite for an open end.
    pub max: f64,
}

impl Interval {
    /// All that lies in front of a ray's origin.
    pub const FORWARD: Self = Self {
        min: 0.0,
        max: f64::INFINITY,
    };

    /// All of a ray's line.
    pub const LINE: Self = Self {
        min: f64::NEG_INFINITY,
        max: f64::INFINITY,
    };

    /// The interval `min < t < max`.
    pub fn new(min: f64, max: f64) -> Self {
        Self { min, max }
    }

    /// In front of the origin and before `max`.
    pub fn before(max: f64) -> Self {
        Self { min: 0.0, max }
    }

    /// True if `min < t < max`; false for NaN.
    pub fn contains(&self, t: f64) -> bool {
        self.min < t && t < self.max
    }
}
