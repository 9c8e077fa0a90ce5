//! How large a scene may be. Scene files come from anywhere, also from people who mean no good: every size is
//! bounded before memory or time is spent on it.

/// Bytes of one file.
pub const MAX_FILE_BYTES: u64 = 256 << 20;
/// Bytes of all files of a scene together; a file that is used twice counts twice.
pub const MAX_SCENE_BYTES: u64 = 512 << 20;
/// Triangles and other shapes of a scene.
pub const MAX_PRIMITIVES: usize = 2_000_000;
/// Lights of a scene: each costs a shadow ray at every hit.
pub const MAX_LIGHTS: usize = 1000;
/// Groups inside groups.
pub const MAX_GROUP_DEPTH: usize = 32;
/// Bytes of a name.
pub const MAX_NAME_BYTES: usize = 200;
/// Corners of one polygon of an OBJ file: cutting it into triangles takes time that grows with their square.
pub const MAX_CORNERS: usize = 1000;
/// Warnings that a scene keeps; further ones are counted.
pub const MAX_WARNINGS: usize = 20;
/// Pixels along one edge of the picture.
pub const MAX_EDGE: u32 = 16_384;
/// Pixels of the picture.
pub const MAX_PIXELS: u64 = 64 << 20;
/// Samples a pixel.
pub const MAX_SAMPLES: u32 = 4096;
/// How far from its pixel's middle a sample may lie, in pixels.
pub const MAX_FILTER_RADIUS: f64 = 16.0;
/// Shadow rays to an area light, a hit.
pub const MAX_LIGHT_SAMPLES: u32 = 1 << 16;
/// Metres from the origin, in world space; also the largest radius. Beyond, a millimetre is less than `f64` can tell.
pub const MAX_COORDINATE: f64 = 1e12;
/// Any channel of a light, an emission or a background.
pub const MAX_RADIANCE: f64 = 1e12;
/// The smallest index of refraction, far below every real one, and the largest, far above.
pub const IOR: [f64; 2] = [0.01, 100.0];
/// The largest exponent of a highlight or a spot light.
pub const MAX_EXPONENT: f64 = 1e9;

/// Why a picture of `width` x `height` pixels cannot be made; `None` if it can.
pub fn size_problem(width: u32, height: u32) -> Option<String> {
    let pixels = u64::from(width) * u64::from(height);
    if width == 0 || height == 0 {
        Some(format!("a picture of {width}x{height} has no pixels"))
    } else if width > MAX_EDGE || height > MAX_EDGE {
        Some(format!(
            "a picture of {width}x{height} is too large: an edge has at most {MAX_EDGE} pixels"
        ))
    } else if pixels > MAX_PIXELS {
        Some(format!(
            "a picture of {width}x{height} has {pixels} pixels: at most {MAX_PIXELS} are possible"
        ))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_a_smallest_and_a_largest() {
        assert_eq!(size_problem(1, 1), None);
        assert_eq!(size_problem(MAX_EDGE, 4096), None);
        for (w, h) in [(0, 240), (320, 0), (1_000_000, 1_000_000), (16_384, 16_384)] {
            assert!(size_problem(w, h).is_some(), "{w}x{h}");
        }
    }
}
