//! Random numbers, directions and rays for the tests of solids: always the same ones.
//!
//! `RAYTREE_MANY=300 cargo test --release --lib geometry` asks 300 times as many, about a million a law.

use crate::math::{DVec3, Ray};

/// So many cases, times `RAYTREE_MANY` if that is set.
pub fn many<T: std::ops::Mul<Output = T> + From<u16>>(few: T) -> T {
    let times = std::env::var("RAYTREE_MANY").ok();
    let times = times.and_then(|times| times.parse::<u16>().ok());
    few * T::from(times.unwrap_or(1))
}

/// Numbers that look random. Source: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
pub struct TestRays(pub u64);

impl TestRays {
    /// A number from 0 to 1, without 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number from -1 to 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A number at the end of what there is, or none.
    pub fn strange(&mut self) -> f64 {
        const STRANGE: [f64; 9] = [
            0.0,
            -0.0,
            1.0,
            1e-320,
            1e-200,
            1e200,
            f64::MAX,
            f64::INFINITY,
            f64::NAN,
        ];
        STRANGE[(9.0 * self.unit()) as usize]
    }

    /// A point of the cube from -1 to 1.
    pub fn in_cube(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }

    /// A unit vector.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.in_cube();
            if v.length_squared() > 1e-2 && v.length_squared() < 1.0 {
                return v.normalize();
            }
        }
    }

    /// A ray that passes within `size` of the centre on each axis, from so far away.
    pub fn ray(&mut self, size: f64, distance: f64) -> Ray {
        let (target, d) = (size * self.in_cube(), self.direction());
        Ray::new(target - distance * d, d)
    }
}
