//! `raytree find` and its queries: what it finds is what the ray trees say.

use crate::cli;
use assert_cmd::Command;
use raytree::accel::AccelKind;
use raytree::lab::find::find;
use raytree::probe::{Event, RayKind};
use raytree::scene::{self, Settings};
use raytree::shading::Side;
use raytree::trace::{Outcome, PixelTrace, TreeQuery, View, trace_pixel};
use raytree::world::World;

use crate::from_text;

/// A world, settings for a small picture of it, and the trees of all of its pixels.
fn picture(name: &str) -> (World, Settings, Vec<PixelTrace>) {
    let world = World::new(scene::load(name).expect("built in"), AccelKind::Bsp);
    let settings = world.scene.settings.with(|s| {
        s.image.width = 20;
        s.image.height = 15;
    });
    let pixels = (0..15).flat_map(|y| (0..20).map(move |x| (x, y)));
    let trees = pixels
        .map(|at| trace_pixel(&world, &settings, at, false))
        .collect();
    (world, settings, trees)
}

/// Compares a query with what `expected` says of each tree. Some pixels satisfy it, and some do not.
fn check(
    (world, settings, trees): &(World, Settings, Vec<PixelTrace>),
    text: &str,
    expected: impl Fn(&PixelTrace) -> bool,
) {
    let query: TreeQuery = text.parse().expect(text);
    let mut count = 0;
    for trace in trees {
        let view = View {
            world,
            settings,
            trace,
        };
        let holds = query.holds(view);
        assert_eq!(holds, expected(trace), "{text} at {},{}", trace.x, trace.y);
        count += usize::from(holds);
    }
    assert!(count > 0 && count < trees.len(), "{text}: {count}");
}

#[test]
fn queries_say_what_the_trees_say() {
    let picture = picture("glass-block");
    let scene = &picture.0.scene;
    let name_of_hit = |trace: &PixelTrace, node: u32| match trace.tree.node(node).outcome {
        Some(Outcome::Hit(hit)) => Some(scene.object_of(hit.primitive).name.as_str()),
        _ => None,
    };
    let object = "block";
    let hits = |t: &PixelTrace| name_of_hit(t, 0) == Some(object);
    check(&picture, &format!("hits:\"{object}\""), hits);
    check(&picture, "miss", |t| name_of_hit(t, 0).is_none());
    check(&picture, "not miss", |t| name_of_hit(t, 0).is_some());

    let kinds =
        |t: &PixelTrace, kind| (0..t.tree.node(0).size).any(|n| t.tree.node(n).ray.kind == kind);
    check(&picture, "some(R)", |t| kinds(t, RayKind::Reflected));
    check(&picture, "some(R) and some(T)", |t| {
        kinds(t, RayKind::Reflected) && kinds(t, RayKind::Transmitted)
    });
    let deepest = |t: &PixelTrace| {
        let rays = (0..t.tree.node(0).size).map(|n| t.tree.node(n).ray);
        let paths = rays.filter(|ray| ray.kind != RayKind::Light);
        paths.map(|ray| ray.depth).max().unwrap_or(0)
    };
    check(&picture, "depth >= 3", |t| deepest(t) >= 3);
    check(&picture, "depth>0 and depth<=4", |t| {
        (1..=4).contains(&deepest(t))
    });
    check(&picture, "rays > 4", |t| t.tree.node(0).size > 4);
    check(&picture, "luminance < 0.3", |t| {
        t.pixel.color.luminance() < 0.3
    });

    let absent = |t: &PixelTrace, name: &str| {
        let mut events = t.tree.events.iter();
        events.any(|e| matches!(e, Event::Absent { reason, .. } if reason.name() == name))
    };
    check(&picture, "tir", |t| absent(t, "total-internal-reflection"));
    check(&picture, "some(absent:facing-away)", |t| {
        absent(t, "facing-away")
    });
    let blocked = |t: &PixelTrace| {
        let mut children = t.tree.children(0);
        children.any(|c| matches!(t.tree.node(c).outcome, Some(Outcome::Blocked(_))))
    };
    check(&picture, "blocked:*", blocked);
    let path = |t: &PixelTrace| {
        let via = |n: u32| {
            t.tree
                .children(n)
                .find(|c| t.tree.node(*c).ray.kind == RayKind::Transmitted)
        };
        via(0)
            .and_then(via)
            .is_some_and(|n| name_of_hit(t, n).is_some())
    };
    check(&picture, "path:TT>*", path);
}

#[test]
fn a_search_stops_early_and_is_the_same_for_any_number_of_threads() {
    let (world, settings, _) = picture("glass-block");
    let query: TreeQuery = "some(R)".parse().expect("a query");
    let go_on = |_: &[(u32, u32)], _| std::ops::ControlFlow::Continue(());
    let all = find(&world, &settings, &query, usize::MAX, 1, &go_on);
    assert!(all.complete && all.searched == 300 && all.pixels.len() > 3);
    assert_eq!(find(&world, &settings, &query, usize::MAX, 4, &go_on), all);
    let first = find(&world, &settings, &query, 2, 4, &go_on);
    assert_eq!(first.pixels, all.pixels[..2]);
    assert!(!first.complete);
}

fn raytree(arguments: &str) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(arguments.split('|'));
    command.output().expect("it runs")
}

#[test]
fn find_lists_pixels_and_says_no_by_its_status() {
    let found = raytree("find|glass-block|tir|--size|40x30|--first|2");
    let (lines, told) = (
        String::from_utf8_lossy(&found.stdout),
        String::from_utf8_lossy(&found.stderr),
    );
    assert_eq!(found.status.code(), Some(0), "{told}");
    assert_eq!(lines.lines().count(), 2, "{lines}");
    assert!(
        told.contains("raytree trace glass-block --size 40x30") && told.contains("--pixel"),
        "{told}"
    );

    let json = raytree("find|whitted|hit|--size|8x6|--json");
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).expect("JSON");
    let count = json["count"].as_u64().expect("a number");
    assert!(
        count > 0
            && json["pixels"]
                .as_array()
                .is_some_and(|p| p.len() as u64 == count)
    );

    let none = raytree("find|whitted|depth > 900|--size|8x6");
    assert_eq!(none.status.code(), Some(4));
    let wrong = raytree("find|whitted|hitz:ball");
    let told = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert_eq!(wrong.status.code(), Some(2), "{told}");
    assert!(told.contains("did you mean `hits`?"), "{told}");
}

#[test]
fn the_mask_is_white_where_pixels_were_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mask.png");
    let path = path.to_str().expect("a plain path");
    let ran = raytree(&format!(
        "find|triangle|hit|--size|20x15|--mask|{path}|--json"
    ));
    let json: serde_json::Value = serde_json::from_slice(&ran.stdout).expect("JSON");
    let mask = image::open(path).expect("a picture").into_luma8();
    let white = mask.pixels().filter(|p| p.0[0] == 255).count();
    assert_eq!(json["count"].as_u64(), Some(white as u64));
    assert!(white > 0 && white < 300);
}

/// A misspelt name is never found, and that is told once.
#[test]
fn a_name_that_nothing_has_is_told() {
    let ran = |query: &str, more: &str| {
        let output = raytree(&format!("find|soft-shadow|{query}|--size|8x6{more}"));
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), told)
    };
    for (query, said) in [
        (
            "hits:flor",
            "no object is named `flor`; did you mean `floor`?",
        ),
        (
            "some(lit:lmap) or hits:flor",
            "no light is named `lmap`; did you mean `lamp`?",
        ),
        ("material:gras", "no material is named `gras`"),
        ("part:wal", "no part is named `wal`; did you mean `wall`?"),
    ] {
        let (status, told) = ran(query, "");
        assert_eq!(told.matches("warning: ").count(), 1, "{told}");
        assert!(told.contains(said), "{told}");
        assert!(status != Some(1) && status != Some(2), "{told}");
        assert_eq!(ran(query, "|--deny-warnings").0, Some(1));
        assert_eq!(ran(query, "|-q").1, "");
    }
    for query in ["hits:floor", "hits:flor*", "not lit:lamp"] {
        assert!(!ran(query, "").1.contains("warning"), "{query}");
    }
}

#[test]
fn places_and_angles_are_those_of_the_hit_point() {
    // A floor seen at 45 degrees, in the middle pixel from sqrt(2) metres.
    let scene = from_text::scene(
        r#"{"format": "raytree-scene/1", "name": "floor",
        "camera": {"eye": [3, 1, 1], "look_at": [3, 0, 0], "vertical_fov": 40},
        "materials": {"grey": {"diffuse": [0.5, 0.5, 0.5]}},
        "objects": [{"plane": {"name": "floor", "material": "grey", "point": [0, 0, 0], "normal": [0, 1, 0]}}]}"#,
    );
    let settings = scene
        .settings
        .with(|s| (s.image.width, s.image.height) = (3, 3));
    let world = World::new(scene, AccelKind::List);
    let trace = &trace_pixel(&world, &settings, (1, 1), false);
    let view = View {
        world: &world,
        settings: &settings,
        trace,
    };
    let half = 0.5f64.sqrt();
    for (quantity, value) in [
        ("direction.x", 0.0),
        ("direction.y", -half),
        ("direction.z", -half),
        ("point.x", 3.0),
        ("point.y", 0.0),
        ("point.z", 0.0),
        ("normal.x", 0.0),
        ("normal.y", 1.0),
        ("normal.z", 0.0),
        ("angle", 45.0),
        ("n_dot_v", half),
        ("normal_angle", 0.0),
    ] {
        let (least, most) = (value - 1e-9, value + 1e-9);
        let query = format!("front and {quantity} >= {least} and {quantity} <= {most}");
        let query: TreeQuery = query.parse().expect("a query");
        assert!(query.holds(view), "{quantity}");
    }
    let query: TreeQuery = "back or angle > 45.01 or point.y > 0.01"
        .parse()
        .expect("a query");
    assert!(!query.holds(view));
}

#[test]
fn queries_for_places_and_angles_say_what_the_trees_say() {
    for scene in ["teapot", "glass-block"] {
        let picture = picture(scene);
        let (world, settings, _) = &picture;
        let at = |trace: &PixelTrace| {
            let view = View {
                world,
                settings,
                trace,
            };
            view.surface_hit(0).map(|surface| surface.at)
        };
        check(&picture, "direction.x > 0.05", |t| {
            t.tree.node(0).ray.direction.x > 0.05
        });
        check(&picture, "point.x < 0.1", |t| {
            at(t).is_some_and(|at| at.point.x < 0.1)
        });
        check(&picture, "normal.z > 0.5", |t| {
            at(t).is_some_and(|at| at.normal.z > 0.5)
        });
        check(&picture, "n_dot_v < 0.6", |t| {
            at(t).is_some_and(|at| at.normal.dot(at.to_viewer) < 0.6)
        });
        check(&picture, "angle > 50", |t| {
            at(t).is_some_and(|at| at.normal.dot(at.to_viewer) < libm::cos(50f64.to_radians()))
        });
        check(&picture, "front", |t| {
            at(t).is_some_and(|at| at.side == Side::Front)
        });
    }
    let leans = |t: &PixelTrace, (world, settings): (&World, &Settings)| {
        let view = View {
            world,
            settings,
            trace: t,
        };
        let at = view.surface_hit(0).map(|surface| surface.at);
        at.is_some_and(|at| at.normal.dot(at.geometric_normal) < libm::cos(4f64.to_radians()))
    };
    let picture = picture("teapot");
    let (world, settings, _) = &picture;
    check(&picture, "normal_angle > 4", |t| {
        leans(t, (world, settings))
    });
}

#[test]
fn a_part_is_found_by_its_name() {
    for (scene, query, part) in [
        ("csg", "part:die/one", "die/one"),
        ("quadrics", "part:top", "top"),
    ] {
        let found = cli::run(&["find", scene, query, "--size", "96x72", "--first", "1"]);
        assert_eq!(found.code, 0, "{}", found.err);
        let told = String::from_utf8_lossy(&found.out).into_owned();
        let pixel = told.split_whitespace().next().expect("a pixel").to_owned();
        let tree = cli::run(&["trace", scene, "--size", "96x72", "--pixel", &pixel]);
        let tree: serde_json::Value = serde_json::from_slice(&tree.out).expect("JSON");
        assert_eq!(tree["samples"][0]["root"]["hit"]["part"], part, "{told}");
    }
}
