//! Random numbers without a state (counter-based): each a hash of (seed, pixel, dimension, sample).
//!
//! So a pixel can be traced again alone, on any thread and in any order, and meets the same numbers: the replay is the
//! picture.

/// The use of a random number. Each has a stream of its own, so that switching one off leaves the others alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// The samples' positions in their pixel.
    Film,
    /// The positions of pilot samples, which only decide how many others there are.
    Pilot,
    /// The points on an area light, at each hit that it lights.
    Light,
}

/// The key of the sample set number `set` of a pixel on the film.
pub fn film_key(seed: u64, pixel: (u32, u32), dimension: Dimension, set: u32) -> u64 {
    splitmix64(pixel_hash(seed, pixel) ^ (u64::from(set) << 32 | dimension as u64))
}

/// The key of the points on light number `light` in a pixel, at the hit where the path `path` ends: one for all samples of
/// a `set`, so that their points complete each other.
pub fn light_key(seed: u64, pixel: (u32, u32), path: u64, [light, set]: [u32; 2]) -> u64 {
    let path_hash = splitmix64(pixel_hash(seed, pixel) ^ path);
    splitmix64(path_hash ^ (u64::from(light) << 32 | u64::from(set) << 8 | Dimension::Light as u64))
}

/// What the keys of a pixel have in common.
fn pixel_hash(seed: u64, pixel: (u32, u32)) -> u64 {
    splitmix64(splitmix64(seed) ^ (u64::from(pixel.0) << 32 | u64::from(pixel.1)))
}

/// Two uniform random numbers in [0, 1) for sample number `index` of the set `key`.
pub fn uniform2(key: u64, index: u32) -> [f64; 2] {
    let x = splitmix64(key ^ splitmix64(u64::from(index)));
    [to_unit_f64(x), to_unit_f64(splitmix64(x))]
}

/// The upper 53 bits as a number in [0, 1).
pub fn to_unit_f64(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// One step of `SplitMix64`: an odd constant, then a mixer that spreads each bit over all 64.
/// Source: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"; constants by Stafford.
pub fn splitmix64(x: u64) -> u64 {
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
        assert_eq!(splitmix64(0), 0xe220_a839_7b1d_cdaf);
    }
}
