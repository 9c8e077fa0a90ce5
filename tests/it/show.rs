//! `raytree render --show`: the numbers of the picture are those of the ray trees.

use assert_cmd::Command;
use raytree::accel::AccelKind;
use raytree::probe::RayKind;
use raytree::scene;
use raytree::trace::trace_pixel;
use raytree::world::World;

fn raytree(args: &[&str]) -> (String, String, Option<i32>) {
    let ran = Command::cargo_bin("raytree")
        .expect("built")
        .args(args)
        .output()
        .expect("runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (text(&ran.stdout), text(&ran.stderr), ran.status.code())
}

/// The numbers of a PFM file, row after row from the top.
fn numbers(bytes: &[u8], (width, height): (usize, usize)) -> Vec<f32> {
    let data = &bytes[bytes.len() - 12 * width * height..];
    let red =
        |i: usize| f32::from_le_bytes(data[12 * i..12 * i + 4].try_into().expect("four bytes"));
    // The file begins with the last row.
    let rows = (0..height).rev();
    rows.flat_map(|y| (0..width).map(move |x| red(y * width + x)))
        .collect()
}

#[test]
fn rays_and_depths_are_those_of_the_trees() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("shown.pfm");
    let name = file.to_str().expect("UTF-8");
    let world = World::new(
        scene::load("glass-block").expect("built in"),
        AccelKind::default(),
    );
    let settings = world
        .scene
        .settings
        .with(|s| (s.image.width, s.image.height) = (24, 18));
    for mode in ["rays", "depth"] {
        let args = [
            "render",
            "glass-block",
            "--size",
            "24x18",
            "--show",
            mode,
            "-o",
            name,
        ];
        let (_, told, status) = raytree(&args);
        assert_eq!(status, Some(0), "{told}");
        assert!(
            told.contains("percent of the pixels in each tenth"),
            "{told}"
        );
        let shown = numbers(&std::fs::read(&file).expect("written"), (24, 18));
        for (i, shown) in shown.iter().enumerate() {
            let at = ((i % 24) as u32, (i / 24) as u32);
            let tree = trace_pixel(&world, &settings, at, false).tree;
            let rays = tree.nodes.iter().filter(|n| n.ray.kind != RayKind::Light);
            let deepest = rays.map(|node| node.ray.depth);
            let expected = match mode {
                "rays" => tree.nodes.len() as u32,
                _ => deepest.max().unwrap_or(0),
            };
            assert_eq!(*shown, expected as f32, "{mode} at {at:?}");
        }
    }
}

#[test]
fn pictures_of_modes_are_text_or_png_and_odd_flags_are_refused() {
    for mode in [
        "rays",
        "nodes",
        "tests",
        "depth",
        "t",
        "error",
        "normal",
        "object",
        "hit",
        "direction",
    ] {
        let args = [
            "render", "room", "--size", "32x20", "--show", mode, "--color", "never", "--quiet",
        ];
        let (text, told, status) = raytree(&args);
        assert_eq!((status, told.as_str()), (Some(0), ""), "{mode}");
        assert_eq!(text.lines().count(), 10, "{mode}: {text}");
    }
    let (_, told, status) = raytree(&["render", "room", "--show", "rays", "--stats"]);
    assert!(status == Some(2) && told.contains("--stats"), "{told}");
    let (_, told, status) = raytree(&["render", "room", "--show", "beauty"]);
    assert!(status == Some(2) && told.contains("rays"), "{told}");
}

#[test]
fn hit_and_direction_are_those_of_the_eye_ray() {
    use raytree::lab::show::{ShowMode, ShownValue};
    use raytree::math::Rgb;
    use raytree::scene::Bend;
    use raytree::trace::View;
    let bend = Bend::all().find(|b| b.name() == "fov-full");
    for name in ["whitted", "teapot", "nested-glass"] {
        let scene = scene::load(name).expect("built in");
        let settings = scene
            .settings
            .with(|s| (s.image.width, s.image.height) = (24, 18));
        let bent = settings.with(|s| s.bends = bend.expect("a bend").into());
        let world = World::new(scene, AccelKind::default());
        let (mut grey, mut coloured, mut sky) = (0, 0, 0);
        for (settings, at) in [settings, bent]
            .iter()
            .flat_map(|s| (0..24 * 18).map(move |i| (s, (i % 24, i / 24))))
        {
            let trace = trace_pixel(&world, settings, at, false);
            let direction = trace.tree.node(0).ray.direction;
            let expected = Rgb::from_srgb((direction * 0.5 + 0.5).to_array());
            let shown = ShowMode::Direction.of(&world, settings, at);
            assert_eq!(shown, ShownValue::Color(expected), "{name} {at:?}");
            let view = View {
                world: &world,
                settings,
                trace: &trace,
            };
            let expected = match view.surface_hit(0) {
                None => {
                    sky += 1;
                    vec![world.scene.background]
                }
                Some(surface) if surface.material.diffuse.is_black() => {
                    grey += 1;
                    vec![Rgb::grey(0.5)]
                }
                Some(surface) => {
                    coloured += 1;
                    let squares = surface.material.checker.map(|c| c.diffuse);
                    [surface.material.diffuse]
                        .into_iter()
                        .chain(squares)
                        .collect()
                }
            };
            let ShownValue::Color(shown) = ShowMode::Hit.of(&world, settings, at) else {
                panic!("{name} {at:?} shows no colour");
            };
            assert!(expected.contains(&shown), "{name} {at:?}: {shown:?}");
        }
        assert!(
            coloured > 0 && sky + grey > 0,
            "{name}: {coloured} {sky} {grey}"
        );
    }
}
