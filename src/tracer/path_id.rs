//! Path id: which ray of a pixel asks for random numbers.

/// Identity of a path from the eye, the key of its points on area lights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathId {
    /// Pixel.
    pub pixel: (u32, u32),
    /// Number of the pixel's sample.
    pub sample: u32,
    /// The reflections and transmissions since the eye as a number to the base 3, without zeros.
    pub path: u64,
}

impl PathId {
    /// The eye ray of a sample.
    pub fn eye(pixel: (u32, u32), sample: u32) -> Self {
        Self {
            pixel,
            sample,
            path: 0,
        }
    }

    /// The path with one more ray, reflected or transmitted.
    #[must_use]
    pub fn then(self, transmitted: bool) -> Self {
        let path = self.path.wrapping_mul(3).wrapping_add(1);
        Self {
            path: path.wrapping_add(u64::from(transmitted)),
            ..self
        }
    }
}
