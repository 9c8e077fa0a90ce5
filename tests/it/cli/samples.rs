//! What the command line says about the samples of a pixel, as a user types it.

use std::ops::ControlFlow;
use std::process::Command;

use raytree::accel::AccelKind;
use raytree::lab::converge::{StopReason, converge};
use raytree::math::Rgb;
use raytree::probe::Silent;
use raytree::sampling::Sampler;
use raytree::scene;
use raytree::trace::trace_pixel;
use raytree::tracer::{draw, render};
use raytree::world::World;
use serde_json::Value;

struct Ran {
    code: i32,
    out: Vec<u8>,
    err: String,
}

fn run(line: &str) -> Ran {
    let output = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(line.split_whitespace())
        .output()
        .expect("runs");
    Ran {
        code: output.status.code().expect("ended by itself"),
        out: output.stdout,
        err: String::from_utf8(output.stderr).expect("UTF-8"),
    }
}

/// The three channels of a pixel in a PFM file with 8 x 6 pixels.
fn in_pfm(file: &str, x: usize, y: usize) -> [f32; 3] {
    let bytes = std::fs::read(file).expect("written");
    let floats = bytes.strip_prefix(b"PF\n8 6\n-1.0\n").expect("a header");
    [0, 1, 2].map(|channel| {
        let at = ((5 - y) * 8 + x) * 12 + channel * 4;
        f32::from_le_bytes(floats[at..at + 4].try_into().expect("4 bytes"))
    })
}

fn traced(line: &str) -> Value {
    let ran = run(line);
    assert_eq!(ran.code, 0, "{}", ran.err);
    serde_json::from_slice(&ran.out).expect("JSON")
}

#[test]
fn what_goes_wrong_is_told_in_one_message() {
    let scene = "render soft-shadow --size 8x6 -o unwritten.png";
    for (flags, words) in [
        ("--samples 0", "must be a whole number from 1 to 4096"),
        ("--sets 0", "must be a whole number from 1"),
        ("--samples 4 --sets 5 --sampling sobol", "--sets 5"),
        (
            "--samples 4 --sets 2 --sampling regular",
            "--sampling random",
        ),
        ("--filter-radius 0", "above 0"),
        ("--filter-radius nan", "above 0"),
        ("--filter-radius 17", "at most 16"),
        ("--filter bell", "mitchell"),
        ("--adaptive 0", "above 0"),
        ("--adaptive=-1", "above 0"),
        ("--adaptive inf", "above 0"),
        ("--adaptive 0.1 --sampling regular", "--sampling random"),
        (
            "--adaptive 0.1 --samples 8 --max-samples 4",
            "--max-samples 4",
        ),
        (
            "--adaptive 0.1 --samples 8 --max-samples 15 --pilot apart",
            "16",
        ),
        ("--adaptive 0.1 --samples 1 --pilot around", "at least 2"),
        ("--max-samples 16", "--adaptive"),
        ("--sample-map x.png", "--adaptive"),
        ("--until-error 0", "above 0"),
        ("--until-error 0.1 --sampling regular", "--sampling random"),
        ("--until-error 0.1 --adaptive 0.1", "--adaptive"),
    ] {
        let ran = run(&format!("{scene} {flags}"));
        assert_eq!(ran.code, 2, "{flags}: {}", ran.err);
        assert!(ran.err.contains(words), "{flags}: {}", ran.err);
        assert!(
            ran.out.is_empty() && !ran.err.contains("panicked"),
            "{}",
            ran.err
        );
    }
    assert!(!std::path::Path::new("unwritten.png").exists());
}

#[test]
fn until_error_says_what_it_cost_and_how_to_have_it_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.pfm").display().to_string();
    let again = folder.path().join("b.pfm").display().to_string();
    let render = "render soft-shadow --size 8x6 --light-samples 1 --until-error 0.01";
    let ran = run(&format!("{render} -o {file}"));
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.err.contains("at most 0.01"), "{}", ran.err);
    let line = |start: &str| {
        let mut lines = ran.err.lines().filter_map(|line| line.strip_prefix(start));
        lines.next().expect("a line").to_owned()
    };
    let ran_again = run(&format!("{} -o {again}", line("again: raytree ")));
    assert_eq!(ran_again.code, 0, "{}", ran_again.err);
    assert_eq!(
        std::fs::read(&file).expect("there"),
        std::fs::read(&again).expect("there")
    );
    for (x, y) in [(1, 1), (4, 3), (7, 5)] {
        let trace = line("a pixel of it: raytree ").replace("X,Y", &format!("{x},{y}"));
        let pixel = traced(&trace);
        let linear =
            [0, 1, 2].map(|i| pixel["color"]["linear"][i].as_f64().expect("a number") as f32);
        assert_eq!(linear, in_pfm(&file, x, y));
    }
    let few = run(&format!("{render} --max-rays 2000 -o {file}"));
    assert_eq!(few.code, 3, "{}", few.err);
    assert!(few.err.contains("--max-rays"), "{}", few.err);
}

#[test]
fn adaptive_pictures_can_be_had_again_pixel_by_pixel() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = |name: &str| folder.path().join(name).display().to_string();
    let (file, errors, map) = (name("a.pfm"), name("errors.pfm"), name("map.png"));
    for (pilot, first) in [("apart", 4), ("around", 0)] {
        let flags = format!(
            "soft-shadow --size 8x6 --light-samples 2 --adaptive 0.01 --pilot {pilot} --filter mitchell"
        );
        let ran = run(&format!(
            "render {flags} -o {file} --sample-map {map} --error-map {errors}"
        ));
        assert_eq!(ran.code, 0, "{}", ran.err);
        let map = image::open(&map).expect("a picture").to_luma8();
        assert_eq!(map.dimensions(), (8, 6));
        assert!(map.pixels().any(|p| p.0[0] == 0) && map.pixels().any(|p| p.0[0] == 255));
        for (x, y) in [(0, 0), (3, 4), (5, 3)] {
            let pixel = traced(&format!("trace {flags} --pixel {x},{y}"));
            let samples = pixel["samples"].as_array().expect("a list");
            let weights = samples
                .iter()
                .map(|s| s["weight"].as_f64().expect("a number"));
            let unweighted = weights.clone().filter(|w| *w == 0.0).count();
            assert_eq!(unweighted, first, "those that only decide");
            assert!((weights.sum::<f64>() - 1.0).abs() < 1e-12);
            assert_eq!(pixel["settings"]["adaptive"]["pilot"], *pilot);
            let error = pixel["standard_error"].as_f64().expect("a number") as f32;
            assert_eq!(in_pfm(&errors, x, y), [error; 3]);
            let linear =
                [0, 1, 2].map(|i| pixel["color"]["linear"][i].as_f64().expect("a number") as f32);
            assert_eq!(linear, in_pfm(&file, x, y));
        }
    }
}

/// No file can make a sample that is no number (tests/fuzz looks for one), so a material is spoiled by hand.
#[test]
fn a_sample_that_is_no_number_counts_as_black_and_is_told_of() {
    let mut scene = scene::load("soft-shadow").expect("built in");
    scene.materials[0].ambient = Rgb::grey(f64::NAN);
    scene.ambient = Rgb::WHITE;
    let settings = scene.settings.with(|s| {
        s.image.width = 6;
        s.image.height = 5;
        s.pixel.samples = 2;
    });
    let world = World::new(scene, AccelKind::Wide);
    let film = draw(&world, &settings, 2);
    assert!(film.pixels.iter().all(|color| color.is_finite()));
    let ((x, y), sample) = film.non_finite.first.expect("a spoiled sample");
    let trace = trace_pixel(&world, &settings, (x, y), false);
    assert_eq!(trace.pixel.first_non_finite, Some(sample));
    let mut count = 0;
    for y in 0..settings.image.height {
        for x in 0..settings.image.width {
            let pixel = trace_pixel(&world, &settings, (x, y), false).pixel;
            assert_eq!(pixel.color, film.at(x, y));
            count += u64::from(pixel.non_finite);
        }
    }
    assert_eq!(film.non_finite.count, count);
}

/// What `--until-error` promises, against a picture with very many samples and another seed.
#[test]
fn the_error_that_was_asked_for_is_the_error_that_is_there() {
    let scene = scene::load("soft-shadow").expect("built in");
    let world = World::new(scene, AccelKind::Wide);
    let base = world.scene.settings.with(|s| {
        s.image.width = 20;
        s.image.height = 15;
        s.pixel.samples = 16;
        s.light.samples = 1;
    });
    let go_on = |_, _| ControlFlow::Continue(());
    let truth = base.with(|s| {
        s.pixel.samples = 4096;
        s.pixel.sampler = Sampler::Sobol;
        s.seed = 77;
    });
    let truth = render::<Silent>(&world, &truth, 0, &go_on).0;
    for sampling in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        let wanted = 0.01;
        let settings = base.with(|s| s.pixel.sampler = sampling);
        let found = converge(&world, &settings, wanted, 0, &go_on);
        assert_eq!(found.stop, StopReason::Reached);
        let estimate = found.passes.last().expect("a try").error;
        let squares = found.film.pixels.iter().zip(&truth.pixels);
        let squares = squares.map(|(a, b)| (a.luminance() - b.luminance()).powi(2));
        let error = (squares.sum::<f64>() / 300.0).sqrt();
        println!(
            "{sampling:?}: estimated {estimate:.5}, true {error:.5}, {} tries",
            found.passes.len()
        );
        assert!(
            estimate <= wanted && error < 1.1 * wanted,
            "{sampling:?}: {error}"
        );
        let again = render::<Silent>(&world, &found.settings, 1, &go_on).0;
        assert_eq!(again, found.film);
    }
}
