//! `raytree diff`: a tree agrees with itself, and with a bent law the difference names that bend.

use std::collections::BTreeMap;

use assert_cmd::Command;
use raytree::accel::AccelKind;
use raytree::grade::diff::TreeDiff;
use raytree::grade::follow::PixelReference;
use raytree::grade::pixel_tree;
use raytree::grade::quantity::QuantityKind;
use raytree::grade::tolerance::Tolerances;
use raytree::scene::limits::MAX_DEPTH;
use raytree::scene::{self, Bend, Settings};
use raytree::trace::facts::{PixelFacts, pixel_facts};
use raytree::trace::{View, document, trace_pixel};
use raytree::world::World;

/// Scenes in which nearly all bends show. None has a light with an area: at one pixel their samples, which are drawn by chance, tell no
/// mistake from another.
const SCENES: [&str; 6] = [
    "lessons/tasks/hits.json",
    "lessons/tasks/light.json",
    "lessons/tasks/glass.json",
    "teapot",
    "quadrics",
    "csg",
];

fn world(name: &str) -> (World, Settings) {
    let path = if name.contains('/') {
        format!("{}/{name}", env!("CARGO_MANIFEST_DIR"))
    } else {
        name.to_owned()
    };
    let world = World::new(scene::load(&path).expect(name), AccelKind::Bsp);
    let settings = world.scene.settings.with(|s| {
        (s.image.width, s.image.height) = (80, 60);
        s.pixel.samples = 1;
        s.light.samples = 1;
    });
    (world, settings)
}

fn facts(world: &World, settings: &Settings, at: (u32, u32)) -> PixelFacts {
    let trace = trace_pixel(world, settings, at, false);
    pixel_facts(&document::of(View {
        world,
        settings,
        trace: &trace,
    }))
}

fn pixels() -> impl Iterator<Item = (u32, u32)> {
    let columns = [9, 22, 31, 39, 47, 55, 68];
    [19, 33, 41, 50]
        .into_iter()
        .flat_map(move |y| columns.map(|x| (x, y)))
}

fn compare(
    of: (&World, &Settings),
    at: (u32, u32),
    ours: &PixelFacts,
    theirs: &PixelFacts,
) -> TreeDiff {
    let of = PixelReference {
        scene: Some(of),
        pixel: at,
        facts: ours,
    };
    TreeDiff::new(of, theirs, &Tolerances::default(), &|_| true)
}

/// With `RAYTREE_PIXELS=all` all pixels of 80x60.
#[test]
fn every_tree_agrees_with_itself() {
    let all = std::env::var("RAYTREE_PIXELS").is_ok_and(|pixels| pixels == "all");
    let asked: Vec<(u32, u32)> = if all {
        (0..60).flat_map(|y| (0..80).map(move |x| (x, y))).collect()
    } else {
        pixels().collect()
    };
    for name in scene::builtin::names().chain(SCENES) {
        let (world, settings) = world(name);
        for &at in &asked {
            let ours = facts(&world, &settings, at);
            let diff = compare((&world, &settings), at, &ours, &ours);
            assert!(diff.is_empty() && diff.asked > 5, "{name} {at:?}: {diff:?}");
        }
    }
}

/// What diff says first of each bend, at all pixels where it changes the tree: it or its law, or something else.
#[test]
fn a_bent_law_is_named_first() {
    // Seen, named first by itself or among others, or by its law.
    let mut counts: BTreeMap<&str, [u32; 2]> = BTreeMap::new();
    let mut wrong = Vec::new();
    for name in SCENES {
        let (world, settings) = world(name);
        for at in pixels() {
            let ours = facts(&world, &settings, at);
            for bend in Bend::all() {
                let bent = settings.with(|s| s.bends = bend.into());
                let theirs = facts(&world, &bent, at);
                let diff = compare((&world, &settings), at, &ours, &theirs);
                let Some(first) = diff.causes.first() else {
                    continue;
                };
                let count = counts.entry(bend.name()).or_default();
                count[0] += 1;
                if first.as_if.contains(&bend) || first.first.law == bend.law() {
                    count[1] += 1;
                } else {
                    wrong.push(format!(
                        "{bend} in {name} at {at:?}: {} by {:?}",
                        first.first.address(at),
                        first.as_if
                    ));
                }
            }
        }
    }
    let seen: u32 = counts.values().map(|[seen, _]| seen).sum();
    let named: u32 = counts.values().map(|[_, named]| named).sum();
    let all = wrong.join("\n");
    assert!(
        counts.len() >= 54,
        "{} bends show: {counts:?}",
        counts.len()
    );
    assert!(
        f64::from(named) >= 0.99 * f64::from(seen),
        "{named} of {seen}:\n{all}"
    );
}

fn raytree(args: &[&str]) -> (String, Option<i32>) {
    let output = Command::cargo_bin("raytree")
        .expect("built")
        .args(args)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned()
        + &String::from_utf8_lossy(&output.stderr);
    (text, output.status.code())
}

#[test]
fn the_command_tells_the_law_and_where_to_look() {
    let glass = "lessons/tasks/glass.json@150,130";
    let (text, status) = raytree(&["diff", glass, glass, "--size", "320x240"]);
    assert_eq!(status, Some(0), "{text}");
    let args = [
        "diff",
        glass,
        glass,
        "--size",
        "320x240",
        "--bend-b",
        "medium-not-tracked",
    ];
    let (text, status) = raytree(&args);
    assert_eq!(status, Some(4), "{text}");
    assert!(text.contains("as if     medium-not-tracked:"), "{text}");
    assert!(
        text.contains("raytree view lessons/tasks/glass.json --size 320x240 --at 150,130/T"),
        "{text}"
    );
    let (text, _) = raytree(&[&args[..], &["--format", "json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["format"], "raytree-diff/1");
    assert_eq!(json["causes"][0]["as_if"][0], "medium-not-tracked");
    assert!(json["agree"].as_u64() < json["asked"].as_u64());
    let (page, status) = raytree(&[&args[..], &["--format", "html"]].concat());
    assert_eq!(status, Some(4));
    // Both trees, the cause, and nothing that loads or runs.
    for part in [
        "<!DOCTYPE html>",
        "default-src 'none'",
        "medium-not-tracked",
        "<th>handed in</th>",
        "wrong: law media",
        "42 consequences: ",
        ">agrees</td>",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    assert!(
        !page.contains("<script") && !page.contains("http:") && !page.contains("https:"),
        "{page}"
    );
}

/// An exam sheet shows a wrong tree and does not say what is wrong with it.
#[test]
fn an_anonymous_tree_does_not_name_its_bend() {
    let args = ["trace", "whitted@160,120", "--bend", "eta-inverted"];
    let (named, status) = raytree(&args);
    assert_eq!(status, Some(0));
    let (anonymous, status) = raytree(&[&args[..], &["--anonymous"]].concat());
    assert_eq!(status, Some(0));
    assert!(named.contains("eta-inverted") && !anonymous.contains("eta-inverted"));
    let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).expect("JSON");
    assert_eq!(read(&named)["samples"], read(&anonymous)["samples"]);
    for format in ["text", "html", "dot", "svg"] {
        let (text, _) = raytree(&[&args[..], &["--anonymous", "--format", format]].concat());
        assert!(!text.contains("eta-inverted"), "{format}");
    }
}

#[test]
fn wrong_command_lines_are_told() {
    for (args, status, part) in [
        (vec!["diff", "whitted@1", "whitted@1,1"], 2, "is no pixel"),
        (
            vec!["diff", "whitted@1,1/R", "whitted@1,1"],
            2,
            "a part of a tree",
        ),
        (vec!["diff", "whitted@9999,1", "whitted@1,1"], 2, "outside"),
        (
            vec!["diff", "whitted@1,1", "no-such-file.json"],
            1,
            "there is no such file",
        ),
        (
            vec!["diff", "whitted", "whitted"],
            2,
            "name a pixel of it, as in whitted@160,120",
        ),
        (
            vec!["diff", "whitted@1,1", "spd:balls:2"],
            2,
            "as in spd:balls:2@160,120",
        ),
        (
            vec!["diff", "whitted@1,1", "whitted@1,1", "--ask", "colour"],
            2,
            "is no quantity",
        ),
        (
            vec!["diff", "whitted@1,1", "whitted@1,1", "--tol", "t=x"],
            2,
            "is no tolerance",
        ),
        (
            vec![
                "diff",
                "whitted@1,1",
                "whitted@1,1",
                "--bend-b",
                "eta-invertd",
            ],
            2,
            "did you mean `eta-inverted`",
        ),
        (vec!["diff", "whitted@1,1", "Cargo.toml"], 1, ""),
    ] {
        let (text, code) = raytree(&args);
        assert_eq!(code, Some(status), "{args:?}: {text}");
        assert!(text.contains(part), "{args:?}: {text}");
    }
}

#[test]
fn quantities_have_names() {
    use std::str::FromStr as _;
    for name in ["outcome", "t", "geometric_normal", "srgb8", "lit"] {
        assert_eq!(QuantityKind::from_str(name).expect(name).name(), name);
    }
}

/// An eye between two mirrors that lose nothing.
const BETWEEN_MIRRORS: &str = r#"{"format": "raytree-scene/1", "name": "between mirrors",
 "camera": {"eye": [0, 0, 0], "look_at": [0, 0, -1]},
 "materials": {"mirror": {"mirror": [1, 1, 1]}},
 "objects": [
  {"plane": {"name": "before", "material": "mirror", "point": [0, 0, -1], "normal": [0, 0, 1]}},
  {"plane": {"name": "behind", "material": "mirror", "point": [0, 0, 1], "normal": [0, 0, -1]}}]}"#;

#[test]
fn the_deepest_tree_needs_no_deep_stack_of_the_caller() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mirrors.json");
    std::fs::write(&path, BETWEEN_MIRRORS).expect("written");
    let scene = scene::load(path.to_str().expect("UTF-8")).expect("a scene");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (9, 9);
        s.recursion.depth = MAX_DEPTH;
    });
    let world = World::new(scene, settings.accel);
    let small = std::thread::Builder::new().stack_size(256 << 10);
    let traced = move || pixel_tree::traced(&world, &settings, (4, 4));
    let thread = small.spawn(traced).expect("a thread");
    let tree = thread.join().expect("a tree");
    assert_eq!(tree.rays.len(), MAX_DEPTH as usize + 1);
}

/// The picture in the window has another size: the command says that of the compared one.
#[test]
fn the_command_to_look_has_the_size_that_was_compared() {
    let args = [
        "diff",
        "whitted@160,120",
        "whitted@160,120",
        "--bend-b",
        "normal-inward",
    ];
    let (text, status) = raytree(&args);
    assert_eq!(status, Some(4), "{text}");
    assert!(
        text.contains("raytree view whitted --size 320x240 --at 160,120"),
        "{text}"
    );
}

#[test]
fn a_file_without_the_pixel_says_which_it_has() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("trees.json");
    let path = path.to_str().expect("a plain path");
    let tree = |at: &str| raytree(&["trace", "triangle", "--size", "8x6", "--pixel", at]).0;
    let trees = |count: u32| {
        (0..count)
            .map(|x| tree(&format!("{x},1")))
            .collect::<String>()
    };
    for (count, said) in [(1, "it has that of 0,1"), (3, "those of 0,1  1,1  2,1")] {
        std::fs::write(path, trees(count)).expect("written");
        let (text, status) = raytree(&["diff", "triangle@5,5", path, "--size", "8x6"]);
        assert_eq!(status, Some(1), "{text}");
        assert!(
            text.contains("no tree of pixel 5,5") && text.contains(said),
            "{text}"
        );
    }
}
