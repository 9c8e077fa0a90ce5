//! Ray trees that nobody should hand in: the files in `hostile/`, and large ones that are made here. Each is answered in words,
//! soon and in bounded memory.

use std::time::{Duration, Instant};

use raytree::scene::printable::is_printable;
use raytree::trace::facts::Fact;
use raytree::trace::read::read_trees;

use super::memory::counted;

/// The longest that a hostile file may take; more where the program is not optimised.
const SOON: Duration = Duration::from_secs(if cfg!(debug_assertions) { 10 } else { 2 });
/// Bytes of memory that it may take.
const MOST: usize = 512 << 20;

/// Reads a file; its messages and problems, none of which steers a terminal.
#[track_caller]
fn told(name: &str, file: &[u8]) -> Vec<String> {
    let start = Instant::now();
    let (answers, memory) = counted(|| read_trees(file, name));
    let took = start.elapsed();
    assert!(took < SOON, "{name}: {took:?}");
    assert!(memory.peak < MOST, "{name}: {memory:?}");
    let mut told = Vec::new();
    for answer in answers {
        match answer {
            Ok(pixel) => told.extend(pixel.problems),
            Err(error) => told.extend(error.to_string().lines().map(str::to_owned)),
        }
    }
    assert!(
        told.iter().all(|line| line.chars().all(is_printable)),
        "{told:?}"
    );
    told
}

/// The files, and what is said of each.
const FILES: [(&str, &str); 14] = [
    ("duplicate-key.json", "root.ior: stands here twice"),
    ("duplicate-key-escaped.json", "root.ior: stands here twice"),
    ("twin-children.json", "is a second R ray from the same hit"),
    ("twin-lights.json", "is a second L ray to `a`, sample 1"),
    (
        "no-number.json",
        "`root.hit.t` is -Infinity: a division by 0?",
    ),
    (
        "beyond-64-bits.json",
        "`root.ior` is 1e999, beyond what 64 bits hold",
    ),
    ("control-character.json", "a text has a control character"),
    (
        "unseen-letters.json",
        "\\u{202e}\\u{202e}\\u{1b}[2J\\u{200b}",
    ),
    ("not-utf8.json", "is not UTF-8 text"),
    ("circle.ndjson", "hangs on itself"),
    ("utf16.json", "is UTF-16 text"),
    ("cut.json", "ends inside of a document"),
    (
        "long-light-name.json",
        "has 201 bytes; no light has a name of more than 200",
    ),
    ("pixel-far-away.json", "a whole number from 0 to 4294967295"),
];

#[test]
fn hostile_files_are_answered() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fuzz/hostile");
    let count = std::fs::read_dir(folder).expect("the folder").count();
    assert_eq!(count, FILES.len(), "each file is read");
    for (name, said) in FILES {
        let file = std::fs::read(format!("{folder}/{name}")).expect("a file");
        let told = told(name, &file);
        assert!(
            told.iter().any(|line| line.contains(said)),
            "{name}: {told:?}"
        );
    }
    // What is no number is nothing, and all else of the ray is read.
    let file = std::fs::read(format!("{folder}/no-number.json")).expect("a file");
    let pixel = read_trees(&file, "a").remove(0).expect("it is read");
    assert!(
        pixel.rays[0]
            .facts
            .iter()
            .all(|(_, fact)| *fact == Fact::Nothing)
    );
    assert_eq!(pixel.rays[0].facts.len(), 3);
}

#[test]
fn large_hostile_files_are_answered() {
    let node = |inside: &str| format!("{{\"root\":{{\"kind\":\"I\",{inside}}}}}\n");
    let rays = |count: usize| {
        (0..count)
            .map(|n| format!("{{\"kind\":\"L\",\"sample\":{n}}},"))
            .collect::<Vec<_>>()
            .concat()
    };
    let flat = |count: usize| {
        (1..count)
            .map(|n| format!("{{\"kind\":\"T\",\"id\":{n},\"parent\":{}}}\n", n - 1))
            .collect::<Vec<_>>()
            .concat()
    };
    let cases: [(&str, String, &str); 14] = [
        (
            "brackets",
            node(&format!("\"a\":{}", "[".repeat(30 << 20))),
            "a line has 30 MiB",
        ),
        (
            "brackets on lines",
            node(&format!("\"a\":{}", "[\n".repeat(20 << 20))),
            "brackets more than 2100 deep",
        ),
        (
            "brackets that close",
            node(&format!(
                "\"a\":{}{}",
                "[\n".repeat(9 << 20),
                "]\n".repeat(9 << 20)
            )),
            "brackets more than 2100 deep",
        ),
        (
            "many deep lines",
            format!("{}\n", "[{\"a\":".repeat(2500)).repeat(2000),
            "brackets more than 2100 deep",
        ),
        (
            "many open lines",
            "{\"a\":[1,\n".repeat(1 << 20),
            "brackets more than 2100 deep",
        ),
        (
            "a long text",
            node(&format!("\"medium\":\"{}\"", "a".repeat(15 << 20))),
            "bytes; 65536 at most",
        ),
        (
            "a text without end",
            node(&format!("\"medium\":\"{}", "a".repeat(15 << 20))),
            "a text has",
        ),
        (
            "children",
            node(&format!("\"children\":[{}0]", rays(200_000))),
            "more than 70000 rays",
        ),
        (
            "a chain",
            "{\"kind\":\"I\",\"id\":0}\n".to_owned() + &flat(90_000),
            "lies too deep",
        ),
        (
            "flat rays",
            "{\"kind\":\"I\"}\n".repeat(200_000),
            "100000 rays that a pixel may have",
        ),
        (
            "values",
            node(&format!("\"a\":[\n{}0]", "0,\n".repeat(12 << 20))),
            "more than 8388608 values",
        ),
        (
            "unknown fields",
            node(&format!("{}\"ior\":1", "\"a\":1,".repeat(2 << 20))),
            "2097152 unknown fields, the first is `root.a`",
        ),
        ("errors", "0,".repeat(8 << 20), "more than 1000 errors"),
        (
            "terms",
            node(&format!(
                "\"terms\":[{}0]",
                "{\"term\":\"ambient\",\"value\":NaN},".repeat(400_000)
            )),
            "more fields hold no value",
        ),
    ];
    for (name, text, said) in cases {
        let told = told(name, text.as_bytes());
        assert!(
            told.iter().any(|line| line.contains(said)),
            "{name}: {:?}",
            &told[..told.len().min(3)]
        );
    }
}
