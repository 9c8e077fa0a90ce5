//! The page of a pixel: every ray stands in it once, in its place, its sums close, and it loads nothing.

mod markup;
mod names;
mod numbers;
mod tree;

use raytree::debug::drawing;
use raytree::scene::{self, Scene, Settings};
use raytree::trace::export::Html;
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;

use super::cli::run;
use super::from_text;

/// The document of a pixel of a scene of 32x24 pixels, and its page.
fn page_of(
    scene: Scene,
    change: impl FnOnce(&mut Settings),
    at: (u32, u32),
    traversal: bool,
) -> (Document, String) {
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (32, 24);
        change(s);
    });
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(&world, &settings, at, traversal);
    let document = document::of(View {
        world: &world,
        settings: &settings,
        trace: &trace,
    });
    let drawing = drawing(&world.scene, &document);
    let page = written(&document, &drawing);
    (document, page)
}

fn written(document: &Document, drawing: &str) -> String {
    Html { document, drawing }.to_string()
}

/// Pages with all that pages have: samples, area lights, media, absences of many kinds.
fn pages() -> Vec<(String, Document, String)> {
    let scenes = [
        ("whitted", (16, 12)),
        ("whitted", (14, 13)),
        ("glass-block", (20, 7)),
        ("nested-glass", (16, 12)),
        ("soft-shadow", (17, 15)),
        ("lamps", (15, 14)),
        ("room", (15, 10)),
        ("mirrors", (16, 12)),
        ("triangle", (0, 0)),
    ];
    let mut pages = Vec::new();
    for (name, at) in scenes {
        for samples in [1, 3] {
            let scene = scene::load(name).expect("a built-in scene");
            let change = |s: &mut Settings| {
                s.light.samples = 4;
                s.pixel.samples = samples;
                if name == "nested-glass" {
                    s.recursion.depth = 3;
                }
            };
            let (document, page) = page_of(scene, change, at, name == "room");
            pages.push((format!("{name}, {samples}"), document, page));
        }
    }
    pages
}

/// Ten thousand rays, three of four of which are hits on glass, which have the most to tell.
#[test]
fn a_page_of_ten_thousand_rays_has_five_megabytes_at_most() {
    for (name, samples, depth) in [("nested-glass", 5, 14), ("whitted", 400, 12)] {
        let scene = scene::load(name).expect("a built-in scene");
        let deep = |s: &mut Settings| {
            s.recursion.depth = depth;
            s.recursion.min_weight = 0.0;
            s.pixel.samples = samples;
        };
        let (document, page) = page_of(scene, deep, (16, 12), false);
        let rays: usize = document.samples.iter().map(|s| s.rays().count()).sum();
        assert!(rays >= 10_000, "{name}: {rays}");
        let a_ray = page.len() / rays;
        assert!(a_ray <= 500, "{name}: {a_ray} bytes a ray");
    }
}

#[test]
fn the_steps_of_a_ray_are_heard_where_there_is_room() {
    let trace = |format: &str, more: &[&str]| {
        let base = [
            "trace", "room", "--size", "32x24", "--pixel", "15,10", "--format", format,
        ];
        let ran = run(&[&base[..], more].concat());
        let text = String::from_utf8(ran.out).expect("UTF-8");
        (ran.code, text, ran.err)
    };
    let (_, words, _) = trace("text", &["--traversal"]);
    assert!(words.contains("; split by ") && words.contains("; on to node "));
    assert!(words.contains(", the closest hit so far"), "{words}");
    let (_, json, _) = trace("json", &["--traversal"]);
    let tests = json.matches("\"test\": {").count();
    let visits = json.matches("\"node\": ").count();
    assert!(tests > 0 && visits > 0);
    for (format, start) in [("text", "  "), ("html", "<li>")] {
        let (code, text, err) = trace(format, &["--traversal"]);
        assert_eq!((code, err.as_str()), (0, ""), "{format}");
        let lines = |what: &str| {
            let is_step = |line: &&str| match line.find(what) {
                Some(at) if format == "html" => line[..at].ends_with(start),
                Some(at) => line[..at].chars().all(|c| " │".contains(c)),
                None => false,
            };
            text.lines().filter(is_step).count()
        };
        assert_eq!(
            (lines("test "), lines("node ")),
            (tests, visits),
            "{format}"
        );
        let (_, without, _) = trace(format, &[]);
        assert!(without.len() < text.len() && !without.contains("the closest hit so far"));
    }
    // The diagram folds what is long: the steps of each ray are counted, and its first and last ones told.
    let (code, diagram, err) = trace("dot", &["--traversal"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let (_, without, _) = trace("dot", &[]);
    assert!(!without.contains("shape=note"));
    let mut steps = 0;
    for note in diagram.lines().filter(|line| line.contains("shape=note")) {
        let lines: Vec<&str> = note.split("\\l").collect();
        assert!(lines.len() <= 15, "{note}");
        let count = lines[0]
            .split('"')
            .nth(1)
            .and_then(|text| text.split(' ').next());
        steps += count.map_or(0, |count| count.parse::<usize>().expect(note));
        let told = lines
            .iter()
            .filter(|l| l.starts_with("node ") || l.starts_with("test "));
        let folded = lines
            .iter()
            .find_map(|l| l.strip_prefix("... ")?.strip_suffix(" more ..."));
        let folded = folded.map_or(0, |count| count.parse::<usize>().expect(note));
        assert!(folded > 0 || told.clone().count() <= 12);
        assert_eq!(
            Some((told.count() + folded).to_string().as_str()),
            count,
            "{note}"
        );
    }
    assert_eq!(steps, tests + visits);
    for format in ["svg", "obj"] {
        let (code, text, err) = trace(format, &["--traversal"]);
        assert_eq!((code, err.lines().count()), (0, 1), "{err}");
        assert!(err.contains("warning: ") && err.contains(format), "{err}");
        let (_, without, quiet) = trace(format, &[]);
        assert_eq!((text, quiet.as_str()), (without, ""));
        let denied = trace(format, &["--traversal", "--deny-warnings"]);
        assert_eq!(denied.0, 1, "{}", denied.2);
        assert_eq!(trace(format, &["--traversal", "--quiet"]).2, "");
    }
}

#[test]
fn a_page_is_written_to_a_file_that_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.html").display().to_string();
    let base = ["trace", "whitted@160,120/T", "-o", &file];
    assert_eq!(run(&base).code, 2, "JSON is no page");
    let ran = run(&[&base[..], &["--format", "html"]].concat());
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let page = std::fs::read_to_string(&file).expect("written");
    assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
    // The tree of a ray begins with it, whatever its number is.
    let (rays, _) = markup::rays(&page);
    assert!(rays.iter().filter(|(_, parent)| parent.is_none()).count() == 1);
}
