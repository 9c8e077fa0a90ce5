//! Numbers, vectors, colours and angles as text to read.

use crate::math::{DVec3, Rgb};

/// A number with at most five decimals and no trailing zeros, as a power of ten below 1e-4 and from 1e7 on; NaN is `none`.
pub fn num(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return if x.is_nan() {
            "none".to_owned()
        } else {
            "infinite".to_owned()
        };
    }
    if (1e-4..1e7).contains(&x.abs()) {
        let fixed = format!("{x:.5}");
        return fixed.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{x:.3e}")
}

/// A number of things: `1 ray`, `8 rays`.
pub fn counted(n: u64, what: &str) -> String {
    let plural = if n == 1 { "" } else { "s" };
    format!("{n} {what}{plural}")
}

/// A part of a whole as a percentage; what is smaller than half of the last digit is 0 without a sign.
pub fn percent(fraction: f64) -> String {
    let shown = format!("{:.1}", fraction * 100.0);
    let shown = if shown == "-0.0" { "0.0" } else { &shown };
    format!("{shown} %")
}

/// Three numbers: `(x, y, z)`.
pub fn triple([x, y, z]: [f64; 3]) -> String {
    format!("({}, {}, {})", num(x), num(y), num(z))
}

/// A vector: `(x, y, z)`.
pub fn vec3(v: DVec3) -> String {
    triple(v.to_array())
}

/// A linear colour: `(r, g, b)`.
pub fn rgb(c: Rgb) -> String {
    triple(c.channels())
}

/// The angle of a cosine, in degrees with two decimals.
pub fn degrees(cos: f64) -> String {
    format!(
        "{:.2} degrees",
        libm::acos(cos.clamp(-1.0, 1.0)).to_degrees()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_has_no_sign() {
        for zero in [0.0, -0.0, -1e-9, -4e-4] {
            assert_eq!(percent(zero), "0.0 %");
        }
        assert_eq!([0.125, -0.01].map(percent), ["12.5 %", "-1.0 %"]);
        assert_eq!([num(-0.0), num(5.988e-74)], ["0", "5.988e-74"]);
        assert_eq!(triple([-0.0, 0.0, -1.0]), "(0, 0, -1)");
    }

    #[test]
    fn numbers_are_short_and_honest() {
        let text = [
            0.0,
            1.0,
            -0.5,
            1.0 / 3.0,
            1e-9,
            12_345_678.0,
            f64::INFINITY,
            f64::NAN,
        ]
        .map(num);
        let expected = [
            "0", "1", "-0.5", "0.33333", "1.000e-9", "1.235e7", "infinite", "none",
        ];
        assert_eq!(text, expected);
    }
}
