//! How large a scene, a picture and a recording may be. Scene files come from anywhere, also from people who mean no
//! good: every size is bounded before memory or time is spent on it. The book shows these limits as a table.

/// Bytes of one file.
pub const MAX_FILE_BYTES: u64 = 256 << 20;
/// Bytes of all files of a scene together; a file that is used twice counts twice.
pub const MAX_SCENE_BYTES: u64 = 512 << 20;
/// Bytes of a scene file that can be changed without writing it: all of it becomes JSON values, twice.
pub const MAX_CHANGED_BYTES: usize = 64 << 20;
/// Shapes of a scene that is no scene file and can be changed all the same: all of it is written as one.
pub const MAX_CHANGED_SHAPES: usize = 200_000;
/// Bytes of all changes together.
pub const MAX_PATCH_BYTES: usize = 64 << 10;
/// Triangles and other shapes of a scene.
pub const MAX_PRIMITIVES: usize = 2_000_000;
/// Triangles of a mesh in a part up to which each use has triangles of its own; a larger one is kept once.
pub const FEW_TRIANGLES: usize = 64;
/// How much a transform may magnify rounding (|M| |M^-1|) where a mesh in a part is kept once.
pub const MAX_CONDITION: f64 = 4096.0;
/// Lights of a scene: each costs a shadow ray at every hit.
pub const MAX_LIGHTS: usize = 1000;
/// Groups inside groups.
pub const MAX_GROUP_DEPTH: usize = 32;
/// Objects and groups in parts, counted at each use.
pub const MAX_PLACED: usize = 200_000;
/// Brackets inside brackets of a JSON file: the limit of its parser, which recurses.
pub const MAX_NESTING: usize = 127;
/// Bytes of a name.
pub const MAX_NAME_BYTES: usize = 200;
/// Corners of a face of an OBJ file that is not convex: cutting it into triangles takes time that grows with their square.
pub const MAX_CORNERS: usize = 1000;
/// Warnings that a scene keeps; further ones are counted.
pub const MAX_WARNINGS: usize = 20;
/// Pixels along one edge of the picture.
pub const MAX_EDGE: u32 = 16_384;
/// Pixels of the picture.
pub const MAX_PIXELS: u64 = 64 << 20;
/// Pixels of a picture that others are measured against, each of which is of its size.
pub const MAX_REFERENCE_PIXELS: u64 = 4 << 20;
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

/// Rays nest at most this deep, whatever depth was asked for: recursion has to end before the stack does.
pub const MAX_DEPTH: u32 = 1000;
/// Rays that a picture may cost if nobody asks for another number.
pub const DEFAULT_MAX_RAYS: u64 = 1_000_000_000;
/// Surfaces that the search for the medium around the eye crosses.
pub const MAX_CROSSINGS: usize = 256;
/// Events that a recording keeps.
pub const MAX_EVENTS: usize = 10_000_000;
/// Bytes that a recording takes.
pub const MAX_EVENT_BYTES: usize = 512 << 20;
/// Nodes that a diagram shows.
pub const MAX_DIAGRAM_NODES: usize = 2000;
/// Steps of a ray through the accelerator that a page shows.
pub const MAX_PAGE_STEPS: usize = 500;
/// Threads.
pub const MAX_THREADS: usize = 1024;
/// Seconds that measuring may be given.
pub const MAX_SECONDS: f64 = 1e6;

/// The limits as the book tells them: what is limited, to how much, and what happens beyond.
pub fn table() -> Vec<[String; 3]> {
    const REFUSED: &str = "refused";
    const COUNTED: &str = "the others are counted";
    let mebibytes = |bytes: u64| format!("{} MiB", bytes >> 20);
    let up_to = |x: f64, unit: &str| format!("{x:e}{unit}");
    let rows: [(&str, String, &str); 21] = [
        (
            "triangles and other shapes",
            MAX_PRIMITIVES.to_string(),
            REFUSED,
        ),
        (
            "corners of a face in an OBJ file that is not convex",
            MAX_CORNERS.to_string(),
            "its triangles are a guess, with a warning",
        ),
        ("lights", MAX_LIGHTS.to_string(), REFUSED),
        (
            "coordinates, and radii",
            up_to(MAX_COORDINATE, " m"),
            REFUSED,
        ),
        ("a channel of a colour", up_to(MAX_RADIANCE, ""), REFUSED),
        (
            "an index of refraction",
            format!("{} to {}", IOR[0], IOR[1]),
            REFUSED,
        ),
        (
            "an exponent of a highlight or a cone",
            up_to(MAX_EXPONENT, ""),
            REFUSED,
        ),
        ("pixels along an edge", MAX_EDGE.to_string(), REFUSED),
        ("pixels of a picture", MAX_PIXELS.to_string(), REFUSED),
        (
            "pixels of a `--reference`",
            MAX_REFERENCE_PIXELS.to_string(),
            REFUSED,
        ),
        ("samples a pixel", MAX_SAMPLES.to_string(), REFUSED),
        (
            "shadow rays to an area light, a hit",
            MAX_LIGHT_SAMPLES.to_string(),
            REFUSED,
        ),
        ("`--threads`", MAX_THREADS.to_string(), REFUSED),
        (
            "`--budget` of `raytree cost`",
            up_to(MAX_SECONDS, " s"),
            REFUSED,
        ),
        (
            "rays of a picture",
            format!("{DEFAULT_MAX_RAYS}, or `--max-rays`"),
            "each pixel has its even share; what is beyond is left out, and the exit status is 3",
        ),
        (
            "bounces, whatever `--depth` says",
            MAX_DEPTH.to_string(),
            "the ray is left out, and the exit status is 3",
        ),
        (
            "surfaces between the eye and the open air",
            MAX_CROSSINGS.to_string(),
            "the media beyond are not looked for",
        ),
        (
            "events of a recorded pixel; of each of its samples where it is written as JSON",
            format!("{MAX_EVENTS}, or {}", mebibytes(MAX_EVENT_BYTES as u64)),
            "the tree is told as cut, and the exit status is 3",
        ),
        ("nodes of a diagram", MAX_DIAGRAM_NODES.to_string(), COUNTED),
        (
            "steps of a ray on a page",
            MAX_PAGE_STEPS.to_string(),
            COUNTED,
        ),
        ("warnings of a scene", MAX_WARNINGS.to_string(), COUNTED),
    ];
    let rows = of_files().into_iter().chain(rows).chain(of_changes());
    rows.map(|(what, most, beyond)| [what.to_string(), most, beyond.to_string()])
        .collect()
}

/// The limits of files, and of what is nested in them.
fn of_files() -> [(&'static str, String, &'static str); 6] {
    const REFUSED: &str = "refused";
    let mebibytes = |bytes: u64| format!("{} MiB", bytes >> 20);
    [
        ("one file", mebibytes(MAX_FILE_BYTES), REFUSED),
        (
            "all files of a scene, each as often as it is named",
            mebibytes(MAX_SCENE_BYTES),
            REFUSED,
        ),
        (
            "brackets inside brackets of a scene file",
            MAX_NESTING.to_string(),
            REFUSED,
        ),
        (
            "groups and parts inside each other",
            MAX_GROUP_DEPTH.to_string(),
            REFUSED,
        ),
        (
            "objects and groups in parts, at each use",
            MAX_PLACED.to_string(),
            REFUSED,
        ),
        (
            "a name, with those of its groups",
            format!("{MAX_NAME_BYTES} bytes"),
            REFUSED,
        ),
    ]
}

/// The limits of `--patch`, `--change` and the debugger's changes of a scene.
fn of_changes() -> [(&'static str, String, &'static str); 3] {
    let refused = "refused";
    [
        (
            "a scene file that is changed without writing it",
            format!("{} MiB", MAX_CHANGED_BYTES >> 20),
            refused,
        ),
        (
            "shapes of a model or a computed scene that is changed so",
            MAX_CHANGED_SHAPES.to_string(),
            refused,
        ),
        (
            "all changes of a scene together",
            format!("{} KiB", MAX_PATCH_BYTES >> 10),
            refused,
        ),
    ]
}

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
