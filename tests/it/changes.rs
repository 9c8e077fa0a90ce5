//! Changes of scenes: `--change` and `--patch` at every command, and scenes that are no scene files.

use std::fs;

use raytree::probe::Silent;
use raytree::scene::{Edit, Scene, generated, load, source, trace_command, view_command};
use raytree::trace::trace_pixel;
use raytree::tracer::pixel;
use raytree::world::World;
use serde_json::Value;

use crate::cli::{Ran, refused, run};

const SIZE: &str = "24x18";
const GLASS: &str = "material.glass.ior=1.1";

fn done(args: &[&str]) -> Ran {
    let ran = run(args);
    assert_eq!(ran.code, 0, "{args:?}: {}", ran.err);
    ran
}

/// The words of a command line in which none has a quotation mark in it.
fn words(command: &str) -> Vec<String> {
    let parts = command.split('\'').enumerate();
    let mut words = Vec::new();
    for (i, part) in parts {
        if i % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}

fn with<'a>(command: &'a str, args: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    [&[command], args, more].concat()
}

fn traced(args: &[&str]) -> Value {
    serde_json::from_slice(&done(args).out).expect("JSON")
}

#[test]
fn every_command_takes_changes_and_agrees_on_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let (patch, png) = (path("patch.json"), path("a.png"));
    fs::write(&patch, r#"{"materials": {"glass": {"ior": 1.1}}}"#).expect("written");
    let plain = ["whitted", "--size", SIZE];
    let by_flag = [&plain[..], &["--change", GLASS]].concat();
    let by_file = [&plain[..], &["--patch", &patch]].concat();
    let both = [
        &plain[..],
        &[
            "--change",
            GLASS,
            "--patch",
            &patch,
            "--change",
            "camera.eye[0]+=0",
        ],
    ]
    .concat();

    let pixel = ["--pixel", "12,9"];
    let whole = traced(&with("trace", &plain, &pixel));
    let tree = traced(&with("trace", &by_flag, &pixel));
    assert_ne!(tree["color"], whole["color"]);
    assert_ne!(tree["scene"]["hash"], whole["scene"]["hash"]);
    for args in [&by_file, &both] {
        assert_eq!(traced(&with("trace", args, &pixel)), tree, "{args:?}");
    }
    done(&with("render", &by_flag, &["-o", &png]));
    let picture = image::open(&png).expect("a PNG").to_rgb8();
    let srgb = [0, 1, 2].map(|i| tree["color"]["srgb8"][i].as_u64().expect("a number") as u8);
    assert_eq!(picture.get_pixel(12, 9).0, srgb);
    // The picture is not written over the patch.
    refused(
        &with("trace", &by_file, &["--pixel", "12,9", "-o", &patch]),
        2,
        &["patch.json: this file is read, and would be replaced"],
    );

    let found = |args: &[&str]| done(&with("find", args, &["hits:floor"])).out;
    assert_eq!(found(&by_file), found(&by_flag));
    let matt = ["--change", "material.glass.transmission=[0,0,0]"];
    let effects =
        String::from_utf8(done(&[&["effects", "whitted"], &matt[..]].concat()).out).expect("UTF-8");
    let refraction = effects
        .lines()
        .find(|line| line.starts_with("refraction"))
        .expect("a line");
    assert!(refraction.contains(" off "), "{refraction}");
    let at = "whitted@12,9";
    done(&[&["diff", at, at, "--size", SIZE], &matt[..]].concat());
    let reduced = path("part.json");
    done(&with("reduce", &by_flag, &["--at", "12,9", "-o", &reduced]));
    let part = traced(&["trace", &reduced, "--size", SIZE, "--pixel", "12,9"]);
    assert_eq!(part["color"], tree["color"]);
}

#[test]
fn what_is_printed_traces_the_same_bits() {
    let source = source("whitted").expect("a source");
    let edits = [
        GLASS,
        "light.sun.intensity*=0.1",
        "camera.eye[1]+=0.123456789012345",
        "object.red ball.radius=0.7",
    ];
    let names: Vec<String> = load("whitted")
        .expect("a scene")
        .lights
        .iter()
        .map(|l| l.name.clone())
        .collect();
    let objects = load("whitted").expect("a scene").objects;
    let edits = edits.map(|text| {
        let text = text.replace("light.sun", &format!("light.{}", names[0]));
        Edit::Typed(text.replace("red ball", &objects[1].name))
    });
    let (scene, patch) = source.changed(&edits).expect("changed");
    assert_eq!((patch.count(), scene.changes.len()), (4, 4));
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (24, 18);
        s.effects = raytree::scene::effects::effects(&scene);
    });
    let command = trace_command("whitted", &scene, &settings, (11, 8));
    let view = view_command("whitted", &scene, &settings, "11,8");
    let changes = |command: &str| words(command).iter().filter(|w| *w == "--change").count();
    assert_eq!((changes(&command), changes(&view)), (4, 4), "{command}");
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(&world, &settings, (11, 8), false);
    let words = words(&command);
    let args: Vec<&str> = words[1..].iter().map(String::as_str).collect();
    let tree = traced(&args);
    let bits = |x: f64| x.to_bits();
    let color = trace.pixel.color.channels().map(bits);
    let told = [0, 1, 2].map(|i| bits(tree["color"]["linear"][i].as_f64().expect("a number")));
    assert_eq!(told, color, "{command}");
    // Without the changes it is another pixel.
    let plain = traced(&["trace", "whitted", "--size", SIZE, "--pixel", "11,8"]);
    assert_ne!(plain["color"], tree["color"]);
}

#[test]
fn a_wrong_change_is_told_and_nothing_is_made() {
    for (args, words) in [
        (
            &["--change", "material.glas.ior=1.3"][..],
            &["there is no material `glas`", "did you mean `glass`?"][..],
        ),
        (
            &["--change", "material.glass.ior=abc"],
            &["`abc` is no value in JSON"],
        ),
        (&["--change", "depth=3"], &["a scene has no `depth`"]),
        (
            &["--patch", "no-such.json"],
            &["no-such.json: there is no such file"],
        ),
        (&["--patch", "/dev/zero"], &["not a regular file"]),
    ] {
        for command in [
            &["render"][..],
            &["trace", "--pixel", "1,1"],
            &["view"],
            &["effects"],
        ] {
            refused(&[command, &["whitted"], args].concat(), 1, words);
        }
    }
}

/// The scene with its camera moved, by a change and by hand.
fn moved(name: &str) -> (Scene, Scene) {
    let source = source(name).unwrap_or_else(|e| panic!("{name}: {e}"));
    let whole = source.scene().expect("a scene");
    let x = whole.camera.eye.x + 0.01;
    let edit = Edit::Typed(format!("camera.eye[0]={x}"));
    let (changed, _) = source
        .changed(&[edit])
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let by_hand = Scene {
        camera: changed.camera,
        ..whole.clone()
    };
    assert_ne!(changed.camera, whole.camera, "{name}");
    assert_ne!(changed.hash, whole.hash, "{name}");
    (changed, by_hand)
}

#[track_caller]
fn same_picture(name: &str) {
    let picture = |scene: Scene| {
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (16, 12);
            s.effects = raytree::scene::effects::effects(&scene);
        });
        let world = World::new(scene, settings.accel);
        let all = (0..12).flat_map(|y| (0..16).map(move |x| (x, y)));
        let color = |at| pixel(&world, &settings, at, &mut Silent).color;
        let bits: Vec<_> = all
            .map(|at| color(at).channels().map(f64::to_bits))
            .collect();
        bits
    };
    let (changed, by_hand) = moved(name);
    assert!(picture(changed) == picture(by_hand), "{name}");
}

#[test]
fn a_computed_scene_is_changed_where_it_is_changed_alone() {
    for (name, _) in generated() {
        let small = name.replace(":3", ":2").replace(":4", ":2");
        same_picture(&small);
    }
}

#[test]
fn a_model_without_a_scene_is_changed_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("model.obj");
    let text = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\nf 1 3 4\nusemtl odd.name\nf 2 3 4\nf 1 4 2\n";
    fs::write(&path, text).expect("written");
    fs::write(
        folder.path().join("m.mtl"),
        "newmtl red\nKd 1 0.1 0.1\nnewmtl odd.name\nKd 0 1 0\nNi 1.5\n",
    )
    .expect("written");
    let path = path.to_str().expect("UTF-8");
    same_picture(path);
    let tree = |args: &[&str]| {
        traced(&[&["trace", path, "--size", SIZE, "--pixel", "12,9"], args].concat())
    };
    let whole = tree(&[]);
    assert_ne!(
        tree(&[
            "--change",
            "material.red.diffuse=[0,0,1]",
            "--change",
            "material.odd.name.diffuse=[0,0,1]"
        ])["color"],
        whole["color"]
    );
    assert_eq!(tree(&["--change", "light.key.intensity*=1"]), whole);
}

#[test]
fn a_scene_that_is_too_large_to_be_changed_says_so() {
    refused(
        &["render", "spd:balls:6", "--change", "camera.eye[0]=1"],
        1,
        &["more than 200000 shapes", "keep its meshes in OBJ files"],
    );
}
