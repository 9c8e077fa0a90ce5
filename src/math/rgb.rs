//! Colours: linear RGB radiance, or a factor of it per channel.

use std::ops::{Add, AddAssign, Mul};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::srgb;

/// Red, green and blue, linear. As a radiance any finite value from 0 up; as a coefficient usually 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "[f64; 3]", into = "[f64; 3]")]
#[schemars(with = "[f64; 3]")]
pub struct Rgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::grey(0.0);
    /// One in each channel.
    pub const WHITE: Self = Self::grey(1.0);

    /// A colour from its three channels.
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self { r, g, b }
    }

    /// Grey: one value in each channel.
    pub const fn grey(value: f64) -> Self {
        Self::new(value, value, value)
    }

    /// The channels in order.
    pub const fn channels(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// The largest channel: what a ray can contribute at most, for the weight threshold.
    pub fn max_channel(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// True if every channel is exactly 0.
    pub fn is_black(self) -> bool {
        self.channels() == [0.0; 3]
    }

    /// The colour, or black if a channel is NaN or infinite, so that it does not spread into a sum.
    pub fn finite_or_black(self) -> Self {
        if self.is_finite() { self } else { Self::BLACK }
    }

    /// True if no channel is NaN or infinite.
    pub fn is_finite(self) -> bool {
        self.channels().iter().all(|c| c.is_finite())
    }

    /// A function applied to each channel.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::new(f(self.r), f(self.g), f(self.b))
    }

    /// Relative luminance Y of linear sRGB (ITU-R BT.709): the brightness that a text ramp shows.
    pub fn luminance(self) -> f64 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// Its part of the brightness of `whole`, by luminance; 0 of black.
    pub fn fraction_of(self, whole: Self) -> f64 {
        let whole = whole.luminance();
        if whole > 0.0 {
            self.luminance() / whole
        } else {
            0.0
        }
    }

    /// What a screen shows: [`Rgb::encoded`], 8 bits a channel.
    pub fn to_srgb8(self) -> [u8; 3] {
        self.channels().map(|c| srgb::byte(c.clamp(0.0, 1.0)))
    }

    /// Channels encoded for a screen, 0 to 1: clamped to [0, 1] (only here, at the very end), then the curve of sRGB.
    pub fn encoded(self) -> [f64; 3] {
        self.channels().map(|c| srgb::encoded(c.clamp(0.0, 1.0)))
    }
}

impl Rgb {
    /// [`Rgb::to_srgb8`] with channels cut off in the place of rounded.
    pub fn to_srgb8_floor(self) -> [u8; 3] {
        self.channels()
            .map(|c| (srgb::encoded(c.clamp(0.0, 1.0)) * 255.0).floor() as u8)
    }

    /// From channels that are encoded as sRGB, 0 to 1.
    pub fn from_srgb(encoded: [f64; 3]) -> Self {
        encoded.map(srgb::linear).into()
    }
}

impl From<[f64; 3]> for Rgb {
    fn from([r, g, b]: [f64; 3]) -> Self {
        Self { r, g, b }
    }
}

impl From<Rgb> for [f64; 3] {
    fn from(rgb: Rgb) -> Self {
        rgb.channels()
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Mul for Rgb {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.r * o.r, self.g * o.g, self.b * o.b)
    }
}

impl Mul<f64> for Rgb {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self::new(self.r * s, self.g * s, self.b * s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_has_its_published_values() {
        // 0.214041 is the linear value of sRGB 0.5 (127.5): IEC 61966-2-1.
        assert_eq!(Rgb::grey(0.0).to_srgb8(), [0; 3]);
        assert_eq!(Rgb::grey(0.214_04).to_srgb8(), [127; 3]);
        assert_eq!(Rgb::grey(0.214_05).to_srgb8(), [128; 3]);
        assert_eq!(Rgb::grey(7.0).to_srgb8(), [255; 3]);
        assert_eq!(Rgb::grey(-1.0).to_srgb8(), [0; 3]);
        for byte in 0..=255 {
            let back = Rgb::from_srgb([f64::from(byte) / 255.0; 3]);
            assert_eq!(back.to_srgb8(), [byte; 3]);
        }
    }
}
