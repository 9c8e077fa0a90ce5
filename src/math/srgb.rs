//! sRGB: what a screen shows. Source: IEC 61966-2-1.

use std::sync::LazyLock;

/// The transfer curve: linear [0, 1] to encoded [0, 1].
pub fn encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    }
}

/// Its inverse.
pub fn linear(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        libm::pow((encoded + 0.055) / 1.055, 2.4)
    }
}

/// The 8 bits of a linear value in [0, 1]: the curve, rounded, but looked up. (A picture asks three times a pixel, and
/// powers are slow.) A cell of the table of values holds one step of the curve at most, so that one comparison tells the byte.
pub fn byte(linear: f64) -> u8 {
    let tables = &*TABLES;
    let first = tables.first[((linear * CELLS as f64) as usize).min(CELLS)];
    let next = tables.steps[usize::from(first)];
    first + u8::from(next <= linear)
}

/// The curve, rounded to 8 bits.
fn byte_by_formula(linear: f64) -> u8 {
    (encoded(linear) * 255.0).round() as u8
}

/// Cells of the table of values: so many that the curve, which is steepest at 0 (255 x 12.92 steps), has one step in each at most.
const CELLS: usize = 4096;

/// What bytes are looked up in.
struct Tables {
    /// The smallest linear value of each byte from 1 on; behind them NaN, which no value reaches.
    steps: [f64; 256],
    /// The byte at the beginning of each cell.
    first: [u8; CELLS + 1],
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let steps = std::array::from_fn(|i| if i < 255 { step_to(i) } else { f64::NAN });
    let first = std::array::from_fn(|cell| {
        let value = cell as f64 / CELLS as f64;
        steps.partition_point(|step| *step <= value) as u8
    });
    Tables { steps, first }
});

/// The smallest linear value whose byte is above `byte`: found by bisection of the formula itself, so that both agree to the last
/// bit.
fn step_to(byte: usize) -> f64 {
    // Positive numbers are in the order of their bits. Rounding moves the step by a few units in the last place.
    let about = linear((byte as f64 + 0.5) / 255.0).to_bits();
    let (mut below, mut above) = (about - WITHIN, about + WITHIN);
    while above - below > 1 {
        let middle = u64::midpoint(below, above);
        if usize::from(byte_by_formula(f64::from_bits(middle))) > byte {
            above = middle;
        } else {
            below = middle;
        }
    }
    f64::from_bits(above)
}

/// Units in the last place within which a step is looked for.
const WITHIN: u64 = 1 << 12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_is_that_of_the_formula() {
        for x in [0.0, f64::MIN_POSITIVE, 0.003_130_8, 0.5, 1.0] {
            assert_eq!(byte(x), byte_by_formula(x), "{x}");
        }
        // Around each step, where one bit decides, and everywhere between.
        for step in &TABLES.steps[..255] {
            for ulps in -2000..=2000 {
                let x = f64::from_bits(step.to_bits().wrapping_add_signed(ulps));
                assert_eq!(byte(x), byte_by_formula(x), "{x}");
            }
        }
        for i in 0..100_000 {
            let x = f64::from(i) / 99_999.0;
            assert_eq!(byte(x), byte_by_formula(x), "{x}");
        }
    }

    #[test]
    fn every_byte_has_its_step() {
        let steps = &TABLES.steps[..255];
        assert!(steps.is_sorted());
        for (step, i) in steps.iter().zip(1..=255) {
            assert_eq!(byte(*step), i);
            assert_eq!(byte(step.next_down()), i - 1);
        }
    }

    #[test]
    fn a_cell_has_one_step_at_most() {
        for cells in TABLES.first.windows(2) {
            assert!(cells[1] - cells[0] <= 1, "{cells:?}");
        }
    }
}
