//! The tree document: written as JSON and read back it is what it was, and what is made of it does not depend on the way.

use proptest::prelude::*;
use raytree::scene::{self, Settings};
use raytree::trace::export::{Dot, Html, Svg, Text, json};
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;

use super::common;

/// The document of a pixel of a built-in scene of 24x18 pixels, at a chance position.
fn document(name: &str, chance: u32, settings: &Settings, traversal: bool) -> Document {
    let scene = scene::load(name).expect("a built-in scene");
    let settings = settings.with(|s| {
        s.image.width = 24;
        s.image.height = 18;
        s.light.samples = 4;
    });
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(
        &world,
        &settings,
        (chance % 24, chance / 24 % 18),
        traversal,
    );
    document::of(View {
        world: &world,
        settings: &settings,
        trace: &trace,
    })
}

fn check(document: &Document) {
    let mut text = Vec::new();
    json::write(&mut text, document).expect("a buffer takes everything");
    let read: Document = serde_json::from_slice(&text).expect("what was written can be read");
    assert_eq!(read, *document);
    assert_eq!(Text(&read).to_string(), Text(document).to_string());
    assert_eq!(Dot(&read).to_string(), Dot(document).to_string());
    assert_eq!(Svg(&read).to_string(), Svg(document).to_string());
    let page = |document| {
        Html {
            document,
            drawing: "",
        }
        .to_string()
    };
    assert_eq!(page(&read), page(document));
    // The layout changes no value.
    let compact = serde_json::to_value(document).expect("writable");
    let pretty: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
    assert_eq!(compact, pretty);
}

proptest! {
    #![proptest_config(common::config(48))]

    #[test]
    fn documents_are_read_as_they_were_written(
        scene in 0..scene::list().len(),
        chance in 0u32..24 * 18,
        samples in 1u32..4,
        seed: u64,
        exposure in 0.1..10.0f64,
        traversal: bool,
    ) {
        let name = scene::list()[scene].0;
        let base = scene::load(name).expect("a built-in scene").settings;
        let settings = base.with(|s| {
            s.pixel.samples = samples;
            s.image.exposure = exposure;
            s.seed = seed;
        });
        check(&document(name, chance, &settings, traversal));
    }
}

#[test]
fn a_document_names_lights_and_rays() {
    let settings = Settings::default();
    let document = document("whitted", 24 * 12 + 12, &settings, false);
    assert!(!document.scene.lights.is_empty());
    let rays: Vec<_> = document
        .samples
        .iter()
        .flat_map(document::SampleTree::rays)
        .collect();
    assert!(rays.len() > 1 && rays.len() as u64 <= document.rays);
    let lights = &document.scene.lights;
    for ray in &rays {
        assert!(ray.node.light.iter().all(|light| lights.contains(light)));
    }
}

/// Written while it is traced, it has the bytes of the whole one.
#[test]
fn a_streamed_document_is_the_whole_one() {
    for (number, (name, ..)) in (0..).zip(scene::list()) {
        let scene = scene::load(name).expect("a built-in scene");
        for (samples, traversal) in [(1, true), (3, false)] {
            let settings = scene.settings.with(|s| {
                (s.image.width, s.image.height) = (24, 18);
                s.pixel.samples = samples;
                s.light.samples = 4;
                if number % 3 == 1 && samples > 1 {
                    s.pixel.sampler = raytree::sampling::Sampler::Random;
                    s.pixel.adaptive = Some(scene::Adaptive {
                        threshold: 1e-4,
                        most: 16,
                        pilot: scene::Pilot::Kept,
                    });
                }
                if number % 5 == 2 {
                    s.bends = "l-reversed".parse().expect("a bend");
                }
            });
            let world = World::new(scene.clone(), settings.accel);
            for at in [(12, 9), (5, 13), (20, 2)] {
                let trace = trace_pixel(&world, &settings, at, traversal);
                let view = View {
                    world: &world,
                    settings: &settings,
                    trace: &trace,
                };
                let foreseen = document::foresee(&world, &settings, at, traversal);
                assert_eq!(foreseen.nodes, trace.tree.nodes.len() as u64, "{name}");
                let [mut whole, mut streamed] = [Vec::new(), Vec::new()];
                json::write(&mut whole, &document::of(view)).expect("a buffer");
                let stream = document::stream(&world, &settings, &foreseen);
                json::write(&mut streamed, &stream).expect("a buffer");
                assert!(whole == streamed, "{name} {at:?}");
                let mut compact = Vec::new();
                json::write_compact(&mut compact, &stream).expect("a buffer");
                let value =
                    |text: &[u8]| -> Document { serde_json::from_slice(text).expect("JSON") };
                assert_eq!(value(&compact), value(&whole), "{name} {at:?}");
                assert!(compact.len() < whole.len() && compact.ends_with(b"}\n"));
            }
        }
    }
}

/// A reader that goes away ends the writing, and nothing hangs.
#[test]
fn a_stream_that_nobody_reads_ends() {
    struct Full(usize);
    impl std::io::Write for Full {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0 = self
                .0
                .checked_sub(bytes.len())
                .ok_or(std::io::ErrorKind::StorageFull)?;
            Ok(bytes.len())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let scene = scene::load("lamps").expect("a built-in scene");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (24, 18);
        s.pixel.samples = 50;
    });
    let world = World::new(scene, settings.accel);
    let foreseen = document::foresee(&world, &settings, (12, 13), false);
    let stream = document::stream(&world, &settings, &foreseen);
    let told = json::write(Full(20_000), &stream).map_err(|e| e.kind());
    assert_eq!(told, Err(std::io::ErrorKind::StorageFull));
}

/// 40 times as many rays take no more memory.
#[test]
#[cfg(target_os = "linux")]
fn memory_does_not_grow_with_the_samples() {
    use std::io::Read;
    let peak = |samples: &str| {
        let scene = ["trace", "lamps", "--size", "24x18", "--pixel", "12,13"];
        let more = ["--light-samples", "64", "--samples", samples, "-q"];
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
            .args(scene.iter().chain(&more))
            .stdout(std::process::Stdio::piped())
            .spawn()
            .expect("it runs");
        let mut out = child.stdout.take().expect("a pipe");
        let (mut peak, mut bytes, mut buffer) = (0, 0, vec![0; 1 << 16]);
        loop {
            let status = std::fs::read_to_string(format!("/proc/{}/status", child.id()));
            let status = status.unwrap_or_default();
            let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
            let kib = line.and_then(|l| l.split_whitespace().next()?.parse::<u64>().ok());
            peak = peak.max(kib.unwrap_or(0));
            match out.read(&mut buffer).expect("a pipe") {
                0 => break,
                n => bytes += n,
            }
        }
        assert!(child.wait().expect("it ends").success());
        (peak, bytes)
    };
    let [(few, short), (many, long)] = ["25", "1000"].map(peak);
    assert!(long > 30 * short && short > 1_000_000, "{short} {long}");
    assert!(few > 0 && many < few + 16_000, "{few} KiB, then {many} KiB");
}

#[test]
fn vectors_stand_on_one_line() {
    let mut text = Vec::new();
    let document = document("whitted", 200, &Settings::default(), true);
    json::write(&mut text, &document).expect("a buffer takes everything");
    let text = String::from_utf8(text).expect("UTF-8");
    let starts = [
        "\"origin\"",
        "\"linear\"",
        "\"radiance\"",
        "\"interval\"",
        "\"film\"",
    ];
    for start in starts {
        let mut lines = text.lines().filter(|l| l.trim_start().starts_with(start));
        assert!(
            lines
                .next()
                .is_some_and(|line| line.contains('[') && line.contains(']')),
            "{start}"
        );
    }
}
