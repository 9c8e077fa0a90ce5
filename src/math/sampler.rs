//! Random numbers without a state.
//!
//! Every number is a pure function of (seed, pixel, sample, dimension). So a pixel can be traced again alone, on any
//! thread and in any order, and meets the same numbers: the replay is the picture.

/// What random numbers are used for. Each use has its own stream, so that switching one off leaves the others alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// The samples' places in their pixel.
    Film,
    /// The places of samples that only decide how many others there are.
    Pilot,
    /// The points on an area light, at each place that is lit by it.
    Light,
}

/// The name of the run of points that set number `set` of a pixel's samples takes on the film.
pub fn film_run(seed: u64, pixel: (u32, u32), dimension: Dimension, set: u32) -> u64 {
    mix(pixel_hash(seed, pixel) ^ (u64::from(set) << 32 | dimension as u64))
}

/// What the runs of a pixel have in common.
fn pixel_hash(seed: u64, pixel: (u32, u32)) -> u64 {
    mix(mix(seed) ^ (u64::from(pixel.0) << 32 | u64::from(pixel.1)))
}

/// The name of the run of points that light number `light` takes in a pixel where the path `path` ends: the same for
/// all samples of the pixel, so that their points complete each other.
pub fn light_run(seed: u64, pixel: (u32, u32), path: u64, light: u32) -> u64 {
    mix(mix(pixel_hash(seed, pixel) ^ path) ^ (u64::from(light) << 32 | Dimension::Light as u64))
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
}
