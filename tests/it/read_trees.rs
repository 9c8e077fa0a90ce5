//! Ray trees that are read back: whatever form they are written in, they tell the same facts.

use std::collections::BTreeMap;

use proptest::prelude::*;
use raytree::scene;
use raytree::trace::document::SampleTree;
use raytree::trace::export::json;
use raytree::trace::facts::{PixelFacts, RayFacts, TreePath, pixel_facts};
use raytree::trace::read::{ReadError, read_trees};
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;
use serde_json::{Value, json};

use super::common;

/// The document of a pixel of a built-in scene of 24x18 pixels.
fn traced(name: &str, (x, y): (u32, u32), samples: u32, traversal: bool) -> Document {
    let scene = scene::load(name).expect("a built-in scene");
    let settings = scene.settings.with(|s| {
        s.image.width = 24;
        s.image.height = 18;
        s.light.samples = 4;
        s.pixel.samples = samples;
    });
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(&world, &settings, (x, y), traversal);
    document::of(View {
        world: &world,
        settings: &settings,
        trace: &trace,
    })
}

fn read(text: &[u8]) -> Vec<PixelFacts> {
    let answers = read_trees(text, "a.json").into_iter();
    answers.map(|answer| answer.expect("a tree")).collect()
}

/// A line for each ray, in this order of chance.
fn flat(document: &Document, seed: u64) -> String {
    let pixel = json!([document.pixel.x, document.pixel.y]);
    let mut lines = vec![
        json!({ "pixel": pixel, "scene": document.scene, "color": document.color }).to_string(),
    ];
    let mut first = 0;
    for sample in &document.samples {
        let rays: Vec<_> = SampleTree::rays(sample).collect();
        for (number, ray) in rays.iter().enumerate() {
            let mut line = serde_json::to_value(ray.node).expect("writable");
            let fields = line.as_object_mut().expect("an object");
            fields.remove("children");
            fields.insert("id".to_owned(), json!(first + number));
            fields.insert("pixel".to_owned(), pixel.clone());
            fields.insert("scene".to_owned(), json!(document.scene.name));
            match ray.parent {
                Some(parent) => drop(fields.insert("parent".to_owned(), json!(first + parent))),
                None => drop(fields.insert("sample".to_owned(), json!(sample.index))),
            }
            lines.push(line.to_string());
        }
        first += rays.len();
    }
    // A chance order that the seed repeats.
    lines.sort_by_key(|line| blake3::hash(format!("{seed}{line}").as_bytes()).to_string());
    lines.join("\n")
}

/// The rays by their names, which do not depend on an order.
fn by_path(facts: &PixelFacts) -> BTreeMap<&TreePath, (&RayFacts, Option<&TreePath>)> {
    let parent = |ray: &RayFacts| ray.parent.map(|parent| &facts.rays[parent].path);
    let rays = facts.rays.iter().map(|ray| (&ray.path, (ray, parent(ray))));
    rays.collect()
}

fn check(document: &Document, seed: u64) {
    let facts = pixel_facts(document);
    let mut pretty = Vec::new();
    json::write(&mut pretty, document).expect("a buffer takes everything");
    let compact = serde_json::to_string(document).expect("writable");
    assert_eq!(read(&pretty), std::slice::from_ref(&facts));
    assert_eq!(
        read(format!("{compact}\n{compact}\n").as_bytes()),
        [facts.clone(), facts.clone()]
    );
    assert_eq!(
        read(format!("[{compact},\n{compact}]").as_bytes()),
        [facts.clone(), facts.clone()]
    );
    let [flat] = &read(flat(document, seed).as_bytes())[..] else {
        panic!("one pixel is told");
    };
    assert_eq!(
        (&flat.scene, flat.pixel, &flat.color, &flat.srgb8),
        (&facts.scene, facts.pixel, &facts.color, &facts.srgb8)
    );
    let (flat, whole) = (by_path(flat), by_path(&facts));
    assert_eq!(flat.len(), whole.len());
    for (path, (ray, parent)) in whole {
        let (other, same_parent) = flat[path];
        assert_eq!(
            (&ray.facts, &ray.absent, parent),
            (&other.facts, &other.absent, same_parent),
            "{path}"
        );
    }
}

proptest! {
    #![proptest_config(common::config(32))]

    #[test]
    fn what_is_written_is_read(
        chance in 0u32..24 * 18,
        samples in 1u32..4,
        seed: u64,
        traversal: bool,
    ) {
        let scenes = scene::list();
        let name = scenes[seed as usize % scenes.len()].0;
        check(&traced(name, (chance % 24, chance / 24), samples, traversal), seed);
    }
}

#[test]
fn every_built_in_scene_is_read_as_it_is_written() {
    for (name, _) in scene::list() {
        check(&traced(name, (12, 9), 2, true), 7);
    }
}

#[test]
fn a_changed_number_is_a_changed_fact() {
    let document = traced("whitted", (12, 12), 1, false);
    let mut value = serde_json::to_value(&document).expect("writable");
    let t = value.pointer_mut("/samples/0/root/hit/t").expect("it hits");
    *t = Value::from(t.as_f64().expect("a number") + 1.0);
    let read = read(value.to_string().as_bytes());
    assert_ne!(read, [pixel_facts(&document)]);
}

#[test]
fn what_the_book_shows_is_read_whole() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/handing-in.md");
    let book = std::fs::read_to_string(path).expect("the chapter");
    let mut rays = Vec::new();
    for block in book.split("```json\n").skip(1) {
        let text = block.split("```").next().expect("an example");
        for pixel in read(text.as_bytes()) {
            assert_eq!(pixel.problems, [""; 0], "{text}");
            assert_eq!(pixel.pixel, Some((160, 100)));
            rays.push(pixel.rays.len());
        }
    }
    assert_eq!(rays, [2, 2]);
}

/// A document whose root has this field.
fn with(field: &str) -> String {
    format!("{{\"pixel\":[1,1],\"root\":{{\"kind\":\"I\",{field}}}}}")
}

#[test]
fn limits_break_the_pixel_that_exceeds_them_and_no_other() {
    let good = with("\"ior\":1");
    let deep = |levels: usize| {
        let open = "{\"kind\":\"R\",\"children\":[".repeat(levels);
        with(&format!("\"children\":[{open}{}]", "]}".repeat(levels)))
    };
    let lights = |count: usize| {
        let light = |n| format!("{{\"kind\":\"L\",\"light\":\"a\",\"sample\":{n}}}");
        with(&format!(
            "\"children\":[{}]",
            (0..count).map(light).collect::<Vec<_>>().join(",")
        ))
    };
    let wide = |count: usize| {
        let branch = format!("{{\"kind\":\"R\",\"children\":[{}]}}", lights_of(count));
        with(&format!("\"children\":[{branch},{}]", lights_of(count)))
    };
    let text = |length: usize| with(&format!("\"medium\":\"{}\"", "a".repeat(length)));
    let line = |length: usize| with(&format!("\"mine\":[{}0]", "0,".repeat(length / 2)));
    let cases: [(String, String, &str); 6] = [
        (deep(1048), deep(1060), "brackets more than 2100 deep"),
        (lights(70_000), lights(70_001), "more than 70000 rays"),
        (
            wide(49_999),
            wide(50_000),
            "100000 rays that a pixel may have",
        ),
        (text(65_536), text(65_537), "65537 bytes; 65536 at most"),
        (
            line(15 << 20),
            line(17 << 20),
            "a line has 17 MiB; 16 at most",
        ),
        (
            line(8 << 20),
            with(&format!("\"mine\":[\n{}0]", "0,\n".repeat((8 << 20) + 1))),
            "more than 8388608 values",
        ),
    ];
    for (below, beyond, said) in cases {
        let text = format!("{good}\n{beyond}\n{below}\n{good}\n");
        let start = std::time::Instant::now();
        let answers = read_trees(text.as_bytes(), "a.json");
        let [Ok(_), Err(error), Ok(_), Ok(_)] = &answers[..] else {
            let short: Vec<String> = answers
                .iter()
                .map(|a| {
                    a.as_ref()
                        .map_or_else(ToString::to_string, |_| "read".to_owned())
                })
                .collect();
            panic!("{said}: {short:?}");
        };
        assert!(error.to_string().contains(said), "{error}, not {said}");
        assert!(
            start.elapsed().as_secs() < 10,
            "{said}: {:?}",
            start.elapsed()
        );
    }
}

fn lights_of(count: usize) -> String {
    let light = |n| format!("{{\"kind\":\"L\",\"sample\":{n}}}");
    (0..count).map(light).collect::<Vec<_>>().join(",")
}

#[test]
fn a_file_has_limits_as_a_whole() {
    let last = |text: String| -> ReadError {
        let mut answers = read_trees(text.as_bytes(), "a.json");
        answers.pop().expect("an answer").expect_err("too much")
    };
    let pixels = |count: usize| {
        (0..count)
            .map(|n| format!("{{\"pixel\":[{n},0],\"kind\":\"I\"}}\n"))
            .collect::<Vec<_>>()
            .concat()
    };
    assert!(
        last(pixels(100_001))
            .to_string()
            .contains("more than 100000 pixels")
    );
    assert!(
        read_trees(pixels(100_000).as_bytes(), "a")
            .iter()
            .all(Result::is_ok)
    );
    let rays = format!(
        "{{\"root\":{{\"kind\":\"I\",\"children\":[{}]}}}}\n",
        lights_of(60_000)
    );
    assert!(
        last(rays.repeat(18))
            .to_string()
            .contains("more than 1000000 rays")
    );
    assert!(
        last("oh no\n".repeat(2000))
            .to_string()
            .contains("more than 1000 errors")
    );
    assert!(
        last(" ".repeat((64 << 20) + 1))
            .to_string()
            .contains("has 64 MiB")
    );
    // Paths of deep trees take memory that grows with the square of their depth.
    let chain = |n: usize| {
        (1..n)
            .map(|id| format!("{{\"kind\":\"R\",\"id\":{id},\"parent\":{}}}\n", id - 1))
            .collect::<Vec<_>>()
            .concat()
    };
    let eye = "{\"kind\":\"I\",\"id\":0}\n";
    assert_eq!(
        read((eye.to_owned() + &chain(1050)).as_bytes())[0]
            .rays
            .len(),
        1050
    );
    assert!(
        last(eye.to_owned() + &chain(1060))
            .to_string()
            .contains("lies too deep")
    );
    let leaves = |n: usize| {
        (0..n)
            .map(|s| format!("{{\"kind\":\"L\",\"parent\":999,\"sample\":{s}}}\n"))
            .collect::<Vec<_>>()
            .concat()
    };
    assert!(
        last(eye.to_owned() + &chain(1000) + &leaves(5000))
            .to_string()
            .contains("lies too deep")
    );
}
