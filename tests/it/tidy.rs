//! The rules of the house, enforced: layers, one concept a file, who may print and who may exit.

use std::fs;
use std::path::{Path, PathBuf};

/// From the ground up: a file may use its own layer and those before it.
const LAYERS: [&str; 12] = [
    "math", "geometry", "probe", "accel", "shading", "scene", "world", "tracer", "trace", "lab",
    "cli", "tui",
];

/// The faces: only they may talk to a user. Each may use all the rest.
const FACES: [&str; 2] = ["cli", "tui"];

/// The one file that may be `unsafe`: it calls what was compiled for the instructions that it found.
const UNSAFE: &str = "accel/simd/x86.rs";

/// A file of more lines holds more than one concept.
const LONGEST: usize = 450;

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the source folder is there") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Every source file: its layer (`None` for lib.rs and main.rs), name and text.
fn house() -> Vec<(Option<usize>, String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = sources(&root);
    assert!(files.len() > 30, "the house is here");
    let describe = |path: PathBuf| {
        let name = path
            .strip_prefix(&root)
            .expect("below src")
            .display()
            .to_string();
        let first = name.split(['/', '\\', '.']).next().unwrap_or_default();
        let layer = LAYERS.iter().position(|l| *l == first);
        let text = fs::read_to_string(&path).expect("UTF-8");
        (layer, name, text)
    };
    files.into_iter().map(describe).collect()
}

/// The code without comments and without its tests, which stand at the end of a file.
fn code(text: &str) -> String {
    let body = text
        .split("#[cfg(test)]\nmod tests")
        .next()
        .unwrap_or_default();
    body.lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join("\n")
}

/// The layers that a text names by `crate::layer`.
fn used(code: &str) -> Vec<usize> {
    let after = code.split("crate::").skip(1);
    after
        .filter_map(|rest| {
            let name: String = rest
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect();
            LAYERS.iter().position(|l| *l == name)
        })
        .collect()
}

#[test]
fn a_layer_uses_only_those_below_it() {
    for (layer, name, text) in house() {
        let Some(layer) = layer else { continue };
        assert!(
            !code(&text).contains("use crate::{"),
            "{name}: name each layer in a line of its own"
        );
        for other in used(&code(&text)) {
            assert!(
                other <= layer || FACES.contains(&LAYERS[layer]),
                "{name} (layer {}) uses `{}`, which stands above it",
                LAYERS[layer],
                LAYERS[other]
            );
        }
    }
}

#[test]
fn the_rule_of_layers_can_fail() {
    assert_eq!(
        used(&code(
            "use crate::trace::tree;\nfn f() { crate::math::g() }"
        )),
        [8, 0]
    );
    assert!(used(&code("// use crate::trace")).is_empty());
}

#[test]
fn every_file_says_what_it_is_and_stays_short() {
    for (_, name, text) in house() {
        assert!(text.starts_with("//! "), "{name} begins with what it is");
        let lines = text.lines().count();
        assert!(lines <= LONGEST, "{name} has {lines} lines");
    }
}

#[test]
fn only_faces_print_and_only_main_exits() {
    for (layer, name, text) in house() {
        let code = code(&text);
        let face = layer.is_some_and(|l| FACES.contains(&LAYERS[l]));
        for word in ["println!", "print!(", "dbg!("] {
            assert!(face || !code.contains(word), "{name} uses {word}");
        }
        assert!(!code.contains("process::exit"), "{name} exits");
        for word in ["todo!(", "unimplemented!(", "unsafe {"] {
            let allowed = word == "unsafe {" && name.replace('\\', "/") == UNSAFE;
            assert!(allowed || !code.contains(word), "{name} uses {word}");
        }
    }
}
