//! Reconstruction filters: how much radiance counts in a pixel's colour by its distance from the pixel's middle.
//!
//! pixel = integral of f(x) f(y) radiance(x, y), where f is even, 0 beyond the radius, and integrates to 1. Samples
//! have the density |f| / integral |f| (filter importance sampling: Ernst, Stamminger and Greiner 2006, "Filter
//! importance sampling"), so that all weights are of one size, and no pixel needs a neighbour's samples.

use serde::{Deserialize, Serialize};

/// The shape of a filter.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Filter {
    /// Everything within the radius counts the same.
    #[default]
    Box,
    /// Falls straight to 0 at the radius.
    Tent,
    /// A bell curve with a standard deviation of a third of the radius, cut off there.
    Gaussian,
    /// Cubic pieces that dip below 0, which keeps edges sharp (Mitchell and Netravali 1988, "Reconstruction filters in
    /// computer graphics", B = C = 1/3).
    Mitchell,
}

/// Standard deviations at the radius of the Gaussian.
const DEVIATIONS: f64 = 3.0;

/// Where Mitchell's filter changes its sign, with a radius of 2.
const MITCHELL_ROOT: f64 = 8.0 / 7.0;

impl Filter {
    /// Every filter.
    pub const ALL: [Self; 4] = [Self::Box, Self::Tent, Self::Gaussian, Self::Mitchell];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Tent => "tent",
            Self::Gaussian => "gaussian",
            Self::Mitchell => "mitchell",
        }
    }

    /// The radius in pixels if none is asked for.
    pub fn usual_radius(self) -> f64 {
        match self {
            Self::Box => 0.5,
            Self::Tent => 1.0,
            Self::Gaussian => 1.5,
            Self::Mitchell => 2.0,
        }
    }

    /// True if some of it is below 0.
    pub fn has_negative_lobes(self) -> bool {
        self == Self::Mitchell
    }

    /// f(x) for a radius of 1.
    pub fn value(self, x: f64) -> f64 {
        let x = x.abs();
        if x >= 1.0 {
            return 0.0;
        }
        match self {
            Self::Box => 0.5,
            Self::Tent => 1.0 - x,
            Self::Gaussian => {
                let z = DEVIATIONS * x;
                let bell = libm::exp(-z * z / 2.0) / (2.0 * std::f64::consts::PI).sqrt();
                DEVIATIONS * bell / gaussian_fraction()
            }
            Self::Mitchell => 2.0 * mitchell(2.0 * x),
        }
    }

    /// Inverse CDF of |f|: the x in [-1, 1] with the fraction `u` of the integral of |f| to its left, for a radius of 1.
    #[inline]
    pub fn sample(self, u: f64) -> f64 {
        // Half of it lies on each side of the middle; v is the fraction between the middle and x.
        let (v, side) = ((2.0 * u - 1.0).abs(), if u < 0.5 { -1.0 } else { 1.0 });
        let x = match self {
            Self::Box => v,
            // v = 1 - (1 - x)^2, with 1 - v = 2 min(u, 1 - u), which does not cancel.
            Self::Tent => 1.0 - (2.0 * u.min(1.0 - u)).max(0.0).sqrt(),
            Self::Gaussian => normal_quantile(0.5 * v * gaussian_fraction()) / DEVIATIONS,
            Self::Mitchell => mitchell_quantile(v) / 2.0,
        };
        side * x.clamp(0.0, 1.0)
    }
}

/// The fraction of a bell curve that lies within the radius: erf(3 / sqrt 2).
fn gaussian_fraction() -> f64 {
    0.997_300_203_936_739_8
}

/// Mitchell's filter of radius 2 at `t` from 0 to 2. The outer piece is (t - 2)^2 (8 - 7 t) / 18.
fn mitchell(t: f64) -> f64 {
    if t < 1.0 {
        (7.0 * t * t * t - 12.0 * t * t + 16.0 / 3.0) / 6.0
    } else {
        (2.0 - t) * (2.0 - t) * (8.0 - 7.0 * t) / 18.0
    }
}

/// The integral of |mitchell| from 0 to `t`.
fn mitchell_integral(t: f64) -> f64 {
    // Of the outer piece from t to 2, with s = 2 - t: (7 s^4 / 4 - 2 s^3) / 18.
    let tail = |t: f64| {
        let s = 2.0 - t;
        s * s * s * (7.0 / 4.0 * s - 2.0) / 18.0
    };
    if t < 1.0 {
        t * (7.0 / 4.0 * t * t * t - 4.0 * t * t + 16.0 / 3.0) / 6.0
    } else if t < MITCHELL_ROOT {
        0.5 - tail(t)
    } else {
        0.5 - 2.0 * tail(MITCHELL_ROOT) + tail(t)
    }
}

/// The t with the fraction `v` of the integral of |mitchell| over 0..2 before it: Newton's method, kept between bounds
/// that are halved where a step would leave them.
fn mitchell_quantile(v: f64) -> f64 {
    let wanted = v * mitchell_integral(2.0);
    let (mut low, mut high) = (0.0, 2.0);
    let mut t: f64 = v;
    for _ in 0..64 {
        let excess = mitchell_integral(t) - wanted;
        if excess > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let step = t - excess / mitchell(t).abs();
        let next = if step > low && step < high {
            step
        } else {
            0.5 * (low + high)
        };
        if (next - t).abs() <= 1e-15 {
            return next;
        }
        t = next;
    }
    t
}

/// The z with the fraction `q` of a bell curve between 0 and z, for q below 0.4987.
/// Source: Wichura 1988, "Algorithm AS 241: the percentage points of the normal distribution" (PPND16).
fn normal_quantile(q: f64) -> f64 {
    const A: [f64; 8] = [
        3.387_132_872_796_366_5,
        1.331_416_678_917_843_8e2,
        1.971_590_950_306_551_3e3,
        1.373_169_376_550_946e4,
        4.592_195_393_154_987e4,
        6.726_577_092_700_87e4,
        3.343_057_558_358_813e4,
        2.509_080_928_730_122_7e3,
    ];
    const B: [f64; 8] = [
        1.0,
        4.231_333_070_160_091e1,
        6.871_870_074_920_579e2,
        5.394_196_021_424_751e3,
        2.121_379_430_158_659_7e4,
        3.930_789_580_009_271e4,
        2.872_908_573_572_194_3e4,
        5.226_495_278_852_854e3,
    ];
    const C: [f64; 8] = [
        1.423_437_110_749_683_5,
        4.630_337_846_156_546,
        5.769_497_221_460_691,
        3.647_848_324_763_204_5,
        1.270_458_252_452_368_4,
        2.417_807_251_774_506e-1,
        2.272_384_498_926_918_4e-2,
        7.745_450_142_783_414e-4,
    ];
    const D: [f64; 8] = [
        1.0,
        2.053_191_626_637_759,
        1.676_384_830_183_803_8,
        6.897_673_349_851e-1,
        1.481_039_764_274_800_8e-1,
        1.519_866_656_361_645_7e-2,
        5.475_938_084_995_345e-4,
        1.050_750_071_644_416_9e-9,
    ];
    let polynomial = |c: [f64; 8], x: f64| c.into_iter().rev().fold(0.0, |sum, c| sum * x + c);
    if q <= 0.425 {
        let r = 0.180_625 - q * q;
        return q * polynomial(A, r) / polynomial(B, r);
    }
    let r = (-libm::log(0.5 - q)).sqrt() - 1.6;
    polynomial(C, r) / polynomial(D, r)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral of `f` over [-1, x] by the midpoint rule.
    fn integral(f: impl Fn(f64) -> f64, x: f64) -> f64 {
        let steps = 20_000;
        let width = (x + 1.0) / f64::from(steps);
        (0..steps)
            .map(|i| f(-1.0 + (f64::from(i) + 0.5) * width) * width)
            .sum()
    }

    #[test]
    fn filters_integrate_to_one_and_are_even() {
        for filter in Filter::ALL {
            let one = integral(|x| filter.value(x), 1.0);
            assert!((one - 1.0).abs() < 1e-7, "{filter:?}: {one}");
            for x in [0.1, 0.5, 0.7, 0.99] {
                assert_eq!(filter.value(x), filter.value(-x));
            }
            assert_eq!(filter.value(1.0), 0.0);
        }
    }

    #[test]
    fn samples_have_the_density_of_the_filter() {
        for filter in Filter::ALL {
            let whole = integral(|x| filter.value(x).abs(), 1.0);
            for u in [0.0, 1e-9, 0.02, 0.1, 0.3, 0.5, 0.77, 0.9, 0.98, 1.0 - 1e-9] {
                let x = filter.sample(u);
                let fraction = integral(|x| filter.value(x).abs(), x) / whole;
                assert!(
                    (fraction - u).abs() < 2e-7,
                    "{filter:?}: {fraction} is not {u}"
                );
            }
            let samples: Vec<f64> = (0..1000)
                .map(|i| filter.sample(f64::from(i) / 1000.0))
                .collect();
            assert!(samples.is_sorted(), "{filter:?}");
            assert!(samples[0] >= -1.0 && samples[999] <= 1.0);
        }
    }

    #[test]
    fn quantiles_are_those_of_the_error_function() {
        for i in 0..4987 {
            let q = f64::from(i) / 1e4;
            let fraction = 0.5 * libm::erf(normal_quantile(q) / std::f64::consts::SQRT_2);
            assert!((fraction - q).abs() < 1e-15, "{q}");
        }
        let fraction = libm::erf(DEVIATIONS / std::f64::consts::SQRT_2);
        assert!((gaussian_fraction() - fraction).abs() < 1e-15);
    }

    #[test]
    fn mitchells_lobes_are_as_on_paper() {
        // k(0) = 8/9, k(1) = 1/18, and 6/343 of the integral below 0 on each side.
        assert!((mitchell(0.0) - 8.0 / 9.0).abs() < 1e-15);
        assert!((mitchell(1.0) - 1.0 / 18.0).abs() < 1e-15);
        assert!((2.0 * mitchell_integral(2.0) - 1.0 - 4.0 * 6.0 / 343.0).abs() < 1e-15);
        for i in 0..1000 {
            let v = f64::from(i) / 1000.0;
            let mass = mitchell_integral(mitchell_quantile(v)) / mitchell_integral(2.0);
            assert!((mass - v).abs() < 1e-14, "{v}");
        }
    }
}
