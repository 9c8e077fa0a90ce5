//! Rays that the limits of recursion left out, and how much they would have counted.

use crate::math::Rgb;

/// Rays that were left out, because paths ended at the depth or because they would have counted too little.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayCuts {
    /// Those beyond `--depth`.
    pub by_depth: u64,
    /// Those under `--min-weight`.
    pub by_weight: u64,
    /// The sum of their weights: for each the luminance of its throughput, its factor in the sample. Where all light comes
    /// back, an eye ray that loses 1 sees nothing of it, and one that loses 0 sees all.
    pub weight: f64,
}

impl RayCuts {
    /// None.
    pub const NONE: Self = Self {
        by_depth: 0,
        by_weight: 0,
        weight: 0.0,
    };

    /// True if no ray was left out.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.count() == 0
    }

    /// All of them.
    #[inline]
    pub fn count(&self) -> u64 {
        self.by_depth + self.by_weight
    }

    /// Counts a ray beyond the depth. (Never inlined, so that rays that are sent pay nothing.)
    #[cold]
    #[inline(never)]
    pub fn depth(&mut self, throughput: Rgb) {
        self.by_depth += 1;
        self.weight += throughput.luminance();
    }

    /// Counts a ray of too little weight.
    #[cold]
    #[inline(never)]
    pub fn weight(&mut self, throughput: Rgb) {
        self.by_weight += 1;
        self.weight += throughput.luminance();
    }

    /// The sums of both.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            by_depth: self.by_depth + other.by_depth,
            by_weight: self.by_weight + other.by_weight,
            weight: self.weight + other.weight,
        }
    }
}
