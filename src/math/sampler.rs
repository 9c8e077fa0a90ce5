//! Random numbers without a state.
//!
//! Every number is a pure function of (seed, pixel, sample, dimension). So a pixel can be traced again alone, on any
//! thread and in any order, and meets the same numbers: the replay is the picture.

/// What a random number is used for. Each use has its own stream, so that switching one off leaves the others alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// The sample's place in its pixel, x.
    FilmX,
    /// The sample's place in its pixel, y.
    FilmY,
    /// The points on an area light, at each place that is lit by it.
    Light,
}

/// A number in [0, 1), a multiple of 2^-53.
pub fn uniform(seed: u64, pixel: (u32, u32), sample: u32, dimension: Dimension) -> f64 {
    let mut hash = mix(seed);
    hash = mix(hash ^ (u64::from(pixel.0) << 32 | u64::from(pixel.1)));
    hash = mix(hash ^ (u64::from(sample) << 32 | dimension as u64));
    unit(hash)
}

/// The name of the run of points that light number `light` takes in a pixel where the path `path` ends: the same for
/// all samples of the pixel, so that their points complete each other.
pub fn light_run(seed: u64, pixel: (u32, u32), path: u64, light: u32) -> u64 {
    let hash = mix(mix(seed) ^ (u64::from(pixel.0) << 32 | u64::from(pixel.1)));
    mix(mix(hash ^ path) ^ (u64::from(light) << 32 | Dimension::Light as u64))
}

/// The upper 53 bits as a number in [0, 1).
pub fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// One step of `SplitMix64`: an odd constant, then a mixer that spreads each bit over all 64.
/// Source: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"; constants by Stafford.
pub fn mix(x: u64) -> u64 {
    let mut z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitmix_gives_its_published_first_output() {
        // The first output of the reference SplitMix64 for seed 0.
        assert_eq!(mix(0), 0xe220_a839_7b1d_cdaf);
    }

    #[test]
    fn the_numbers_fill_the_unit_interval_evenly() {
        // 10,000 numbers in 10 bins: the variance of a bin is 900, so 6 sigma is 180.
        let mut bins = [0i32; 10];
        for i in 0..10_000 {
            let x = uniform(1, (i % 100, i / 100), 0, Dimension::FilmX);
            bins[(x * 10.0) as usize] += 1;
        }
        assert!(bins.iter().all(|n| (n - 1000).abs() < 180), "{bins:?}");
    }
}
