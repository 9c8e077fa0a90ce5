//! Rays that limits leave out: how many, and how much light.

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::scene::effects::effects;
use raytree::scene::{Settings, Warning};
use raytree::trace::{View, document, trace_pixel};
use raytree::tracer::{Film, draw};
use raytree::world::World;

use super::{ball, file, with};
use crate::from_text::scene;

/// A picture of a scene, and the warning about what it lost.
fn drawn(text: &str, change: impl Fn(&mut Settings)) -> (World, Settings, Film, Option<Warning>) {
    let scene = scene(text);
    let settings = scene.settings.with(|s| {
        s.effects = effects(&scene);
        (s.image.width, s.image.height) = (24, 18);
        change(s);
    });
    let world = World::new(scene, AccelKind::Bvh);
    let film = draw(&world, &settings, 2);
    let warning = film.cuts.warning("test.json", &world.scene, &settings);
    (world, settings, film, warning)
}

/// Panes of glass before a blue sky, one behind the other: nothing absorbs.
fn panes(count: i32) -> String {
    let pane = |i: i32| {
        let (far, near) = (-f64::from(i) - 0.1, -f64::from(i));
        format!(
            r#"{{"box": {{"name": "pane {i}", "material": "glass", "min": [-5, -5, {far}], "max": [5, 5, {near}]}}}}"#
        )
    };
    let list: Vec<String> = (0..count).map(pane).collect();
    let glass = r#""materials": {"glass": {"transmission": [1, 1, 1], "ior": 1.5}}"#;
    with("", &format!(r#"{glass}, "objects": [{}]"#, list.join(", ")))
}

const SKY: Rgb = Rgb::new(0.2, 0.4, 0.6);

#[test]
fn what_is_seen_and_what_was_lost_is_all_the_light() {
    for (count, depth) in [(1, 1), (2, 3), (4, 5), (4, 8), (6, 5)] {
        let change = |s: &mut Settings| {
            s.recursion.depth = depth;
            s.recursion.min_weight = 0.001;
        };
        let (world, settings, film, _) = drawn(&panes(count), change);
        let mut sum = 0.0;
        for (x, y) in [(0, 0), (12, 9), (20, 3)] {
            let pixel = trace_pixel(&world, &settings, (x, y), false).pixel;
            assert_eq!(pixel.color, film.at(x, y));
            let all = pixel.color + SKY * pixel.cut_share();
            assert!((all.g - SKY.g).abs() < 1e-12, "{count} {depth}: {all:?}");
            sum += pixel.cut_share();
        }
        assert!(
            (film.cuts.share() - sum / 3.0).abs() < 0.02,
            "{count} {depth}"
        );
    }
}

#[test]
fn four_panes_are_dark_by_the_depth() {
    let (world, settings, film, warning) = drawn(&panes(4), |_| ());
    assert!(
        (film.at(12, 9).r - 0.0222).abs() < 1e-4,
        "{:?}",
        film.at(12, 9)
    );
    let text = warning.expect("a warning").to_string();
    for words in [
        "by depth, ",
        "88.9",
        "[rays-cut]",
        "raise --depth (5 now) until the picture stays as it is; `raytree trace test.json --size 24x18 --pixel ",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let command = text.rsplit('`').nth(1).expect("a command");
    let (_, flags) = command.split_once(" --pixel ").expect("a pixel");
    assert!(!flags.contains(' '), "no accelerator: {command}");
    assert_eq!(film.cuts.dark, 24 * 18);
    // The tree of a pixel has its rays that were left out, one by one.
    let trace = trace_pixel(&world, &settings, (12, 9), false);
    let view = View {
        world: &world,
        settings: &settings,
        trace: &trace,
    };
    let cut = document::of(view).cut.expect("cut rays");
    let absent = |reason: &str| {
        let events = trace.tree.events.iter();
        events.filter(|e| format!("{e:?}").contains(reason)).count() as u64
    };
    let found = [cut.depth, cut.weight];
    assert_eq!(found, [absent("DepthLimit"), absent("MinWeight")]);
    assert!(cut.depth > 0);
    assert!((cut.share - 0.889).abs() < 1e-3, "{}", cut.share);
    assert!(trace.pixel.cut_warning(&settings, "test.json").is_some());
    // Deep enough, many weak rays are left out; with these, all of the light is there.
    let (.., warning) = drawn(&panes(4), |s| s.recursion.depth = 20);
    let text = warning.expect("a warning").to_string();
    assert!(text.contains("lower --min-weight"), "{text}");
    let (.., film, warning) = drawn(&panes(4), |s| {
        s.recursion.depth = 20;
        s.recursion.min_weight = 1e-4;
    });
    assert_eq!(warning, None, "{}", film.cuts);
    assert!((film.at(12, 9).r - 0.2).abs() < 2e-3);
}

#[test]
fn mirrors_that_face_each_other_lose_by_depth_or_by_weight() {
    let room = |mirror: f64| {
        let wall = |name: &str, z: i32| {
            format!(
                r#"{{"plane": {{"name": "{name}", "material": "m", "point": [0, 0, {z}], "normal": [0, 0, {}]}}}}"#,
                -z
            )
        };
        let walls = [wall("front", -9), wall("back", 9)].join(", ");
        with(
            "",
            &format!(
                r#""materials": {{"m": {{"mirror": [{mirror}, {mirror}, {mirror}]}}}}, "objects": [{walls}]"#
            ),
        )
    };
    let (.., film, warning) = drawn(&room(0.9), |s| s.recursion.depth = 5);
    assert!((film.cuts.share() - 0.9_f64.powi(6)).abs() < 1e-12);
    assert!(
        warning
            .expect("a warning")
            .to_string()
            .contains("raise --depth")
    );
    let (.., film, warning) = drawn(&room(0.4), |s| s.recursion.min_weight = 0.5);
    assert!((film.cuts.share() - 0.4).abs() < 1e-12);
    assert!(
        warning
            .expect("a warning")
            .to_string()
            .contains("lower --min-weight (0.5 now)")
    );
    let (.., film, warning) = drawn(&room(0.4), |s| s.recursion.depth = 20);
    assert!(film.cuts.rays.by_weight > 0 && film.cuts.share() < 0.01);
    assert_eq!(warning, None);
}

#[test]
fn a_small_dark_spot_is_told_and_one_pixel_is_not() {
    // A ball of mirror in a dark corner of the picture, of which every ray is left out.
    let small = |radius: f64| {
        let text = file(&ball(r#""mirror": [1, 1, 1], "specular": [1, 1, 1]"#));
        text.replace("\"radius\": 1", &format!("\"radius\": {radius}"))
    };
    let change = |s: &mut Settings| {
        (s.image.width, s.image.height) = (160, 120);
        s.recursion.depth = 0;
    };
    let (.., film, warning) = drawn(&small(0.04), change);
    assert!(
        film.cuts.share() < 0.01 && film.cuts.dark > 20,
        "{}",
        film.cuts
    );
    assert!(warning.is_some());
    let (.., film, warning) = drawn(&small(0.02), change);
    assert!((1..20).contains(&film.cuts.dark), "{}", film.cuts.dark);
    assert_eq!(warning, None);
}
