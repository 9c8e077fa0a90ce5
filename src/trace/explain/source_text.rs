//! The lines of the functions that events name, as they stand in this program.

use super::source::SourcePlace;

/// Files with their text.
macro_rules! files {
    ($($path:literal),* $(,)?) => {
        &[$(($path, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $path)))),*]
    };
}

/// All files that events name; a test compares.
const FILES: &[(&str, &str)] = files![
    "src/accel/bsp/traverse.rs",
    "src/accel/bvh/traverse.rs",
    "src/accel/fast/bvh8/single.rs",
    "src/accel/fast/compact/traverse.rs",
    "src/accel/grid.rs",
    "src/accel/list.rs",
    "src/geometry/cuboid.rs",
    "src/geometry/disc.rs",
    "src/geometry/plane.rs",
    "src/geometry/shape.rs",
    "src/geometry/shared_mesh.rs",
    "src/geometry/sphere.rs",
    "src/geometry/triangle.rs",
    "src/scene/camera.rs",
    "src/shading/interaction.rs",
    "src/shading/optics.rs",
    "src/shading/point.rs",
    "src/tracer/corners.rs",
    "src/tracer/direct.rs",
    "src/tracer/light_sampler.rs",
    "src/tracer/pixel/camera_sample.rs",
    "src/tracer/whitted.rs",
];

/// The function with its comment, each line with its number; `None` if it is not there.
pub fn source_text(place: SourcePlace) -> Option<String> {
    let (_, text) = FILES.iter().find(|(path, _)| *path == place.file)?;
    let lines: Vec<&str> = text.lines().collect();
    let heads = [
        format!("fn {}(", place.function),
        format!("fn {}<", place.function),
    ];
    let head = lines
        .iter()
        .position(|line| heads.iter().any(|head| line.contains(head)))?;
    // Comments and attributes stand right above; a closing brace at the same indent ends the function.
    let is_above = |line: &&&str| line.trim_start().starts_with(['/', '#']);
    let above = lines[..head].iter().rev().take_while(is_above).count();
    let indent = lines[head].len() - lines[head].trim_start().len();
    let end = format!("{}}}", " ".repeat(indent));
    let length = lines[head..].iter().position(|line| *line == end)?;
    let numbered =
        (head - above..=head + length).map(|at| format!("{:4}  {}\n", at + 1, lines[at]));
    Some(numbered.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_function_is_shown_from_its_comment_to_its_end() {
        let text = source_text(SourcePlace {
            file: "src/shading/point.rs",
            function: "eval",
        });
        let text = text.expect("it is there");
        let lines: Vec<&str> = text.lines().map(|line| line[6..].trim()).collect();
        assert!(
            lines[0].starts_with("///") && lines.last() == Some(&"}"),
            "{text}"
        );
        let braces = |c: char| text.matches(c).count();
        assert_eq!(braces('{'), braces('}'));
        assert_eq!(text.matches(" fn ").count(), 1, "{text}");
        let nothing = SourcePlace {
            file: "src/shading/point.rs",
            function: "no_such",
        };
        assert_eq!(source_text(nothing), None);
    }
}
