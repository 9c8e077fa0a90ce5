//! Files from anywhere: whatever is in them, the answer is a scene or one clear message, within bounds. See README.md.

#![expect(
    clippy::format_collect,
    clippy::format_push_string,
    reason = "texts are made line by line, as they read"
)]

mod arguments;
mod bytes;
mod dice;
mod documents;
mod handed_in;
mod hostile_trees;
mod large;
mod laws;
mod memory;
mod models;
mod pictures;
mod queries;
mod search;
mod tasks;
mod trees;
mod words;
mod written_out;
mod zips;

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use laws::{Case, catch_panics, check_picture};
use search::{Met, Search, found};

#[global_allocator]
static MEMORY: memory::Counting = memory::Counting;

/// Works on one thread of a pool, so that all memory is counted where it is asked for.
fn on_one_thread<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .stack_size(64 << 20)
        .build();
    pool.expect("a thread").install(work)
}

/// Well-formed files, to be changed and to be compared with.
fn well_formed() -> Vec<Case> {
    let scene = |text: &str, model: &str| {
        let files = [
            ("scene.json", text.to_string()),
            ("m.obj", model.to_string()),
        ];
        Case::new(
            files
                .map(|(name, text)| (name.to_string(), text.into_bytes()))
                .into(),
        )
    };
    let text = |name: &str| {
        let path = format!("{}/scenes/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).expect("a built-in scene")
    };
    let model =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 2 4 3\n";
    let names = [
        "whitted",
        "triangle",
        "glass-block",
        "nested-glass",
        "shadows",
        "room",
        "lamps",
        "soft-shadow",
    ];
    let mut cases: Vec<_> = names
        .iter()
        .map(|name| scene(&text(&format!("{name}.json")), model))
        .collect();
    let teapot = text("teapot.obj");
    // Its first points, and the faces between them.
    let inside = |line: &str| {
        line.split([' ', '/'])
            .filter_map(|w| w.parse().ok())
            .all(|i: usize| i <= 100)
    };
    let lines = |key: &str| {
        let lines = teapot
            .lines()
            .filter(|line| line.starts_with(key) && (key != "f " || inside(line)));
        lines
            .take(100)
            .map(|line| format!("{line}\n"))
            .collect::<String>()
    };
    let teapot = lines("v ") + &lines("vn ") + &lines("f ");
    cases.push(Case::new(BTreeMap::from([(
        "m.obj".to_string(),
        teapot.into_bytes(),
    )])));
    let with_materials = format!("mtllib x.mtl\nusemtl a\n{model}");
    let mtl = "newmtl a\nKd 1 0.5 0\nKs 1 1 1\nNs 20\nillum 4\nd 0.5\nNi 1.5\nnewmtl b\nKe 1 1 1\n";
    let files = [("m.obj", with_materials.as_str()), ("x.mtl", mtl)];
    cases.push(Case::new(
        files
            .map(|(name, text)| (name.to_string(), text.as_bytes().to_vec()))
            .into(),
    ));
    cases
}

/// The search with this seed, over all that is known.
fn search(seed: u64) -> Search {
    let mut corpus = well_formed();
    let work = corpus.iter().map(|case| {
        let (_, outcome) = case.read(None).expect("a well-formed file breaks no law");
        assert!(
            outcome.accepted,
            "a well-formed file is accepted: {}",
            case.main
        );
        outcome.memory.total as f64 / case.size() as f64
    });
    let work = work.fold(0.0, f64::max);
    corpus.extend(found().into_iter().map(|(_, case)| case));
    Search {
        seed,
        corpus,
        work,
        rendered: 1,
    }
}

fn environment(name: &str) -> Option<u64> {
    std::env::var(name).ok()?.parse().ok()
}

#[test]
fn every_failure_ever_found_is_answered() {
    catch_panics();
    let work = search(0).work;
    for (name, case) in found() {
        let read = on_one_thread(|| case.read(Some(work)));
        let (scene, _) =
            read.unwrap_or_else(|broken| panic!("{name}: {}: {}", broken.law, broken.how));
        for chance in 0..16 {
            let checked = scene
                .as_ref()
                .map_or(Ok(()), |scene| check_picture(scene, chance));
            checked.unwrap_or_else(|broken| panic!("{name}: {}: {}", broken.law, broken.how));
        }
    }
}

/// A few thousand inputs; with `RAYTREE_FUZZ=SECONDS` as many as there is time for, on all cores, from
/// `RAYTREE_FUZZ_SEED` (0) and number `RAYTREE_FUZZ_FIRST` (0) on.
#[test]
fn whatever_is_in_a_file_the_laws_hold() {
    catch_panics();
    let seconds = environment("RAYTREE_FUZZ");
    let first = environment("RAYTREE_FUZZ_FIRST").unwrap_or(0);
    let mut search = search(environment("RAYTREE_FUZZ_SEED").unwrap_or(0));
    let threads = if seconds.is_some() {
        std::thread::available_parallelism().map_or(1, |n| n.get() as u64)
    } else {
        1
    };
    search.rendered = if seconds.is_some() { 32 } else { 4 };
    let count = environment("RAYTREE_FUZZ_COUNT").unwrap_or(if seconds.is_some() {
        u64::MAX / threads
    } else {
        4000
    });
    let start = Instant::now();
    let end = seconds.map(|seconds| start + Duration::from_secs(seconds));
    let search = &search;
    let results: Vec<_> = std::thread::scope(|scope| {
        let run = |k| move || on_one_thread(|| search.run([first + k, threads, count], end));
        let running: Vec<_> = (0..threads).map(|k| scope.spawn(run(k))).collect();
        running
            .into_iter()
            .map(|thread| thread.join().expect("no panic outside of a case"))
            .collect()
    });
    let (mut all, mut failures) = (Met::default(), Vec::new());
    for (met, broken) in results {
        failures.extend(broken);
        all = Met {
            inputs: all.inputs + met.inputs,
            bytes: all.bytes + met.bytes,
            accepted: all.accepted + met.accepted,
            rendered: all.rendered + met.rendered,
            memory: all.memory.max(met.memory),
            slowest: all.slowest.max(met.slowest),
        };
    }
    println!(
        "{all:?} in {:.0?}, work of well-formed files {:.0}",
        start.elapsed(),
        search.work
    );
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    // Both answers are met often, or the search would be about nothing.
    let share = all.accepted as f64 / all.inputs as f64;
    assert!(
        all.inputs < 1000 || (0.1..0.9).contains(&share),
        "{share} of the inputs are scenes"
    );
}
