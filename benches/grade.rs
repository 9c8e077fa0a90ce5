//! How long a whole course takes: zip archives with a ray tree for each of 100 pixels, marked with the search for mistakes.
//!
//! `cargo bench -p raytree-benches --bench grade`; a first word gives the number of archives.

#[path = "common/table.rs"]
mod table;

use std::io::{Cursor, Write as _};
use std::path::PathBuf;
use std::time::Instant;

use raytree::grade::report::Report;
use raytree::grade::submission::Submission;
use raytree::grade::task::{Task, TaskScene};
use raytree::scene::{Bend, Bends};
use raytree::trace::export::json;
use raytree::trace::{View, document, trace_pixel_here};
use raytree::tracer::thread_pool;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use table::{markdown, median, publish};

/// Pixels of a submission.
const PIXELS: usize = 100;

/// Rounds; the median is told.
const ROUNDS: usize = 5;

const TASK: &str = r#"
format = "raytree-task/1"
name = "Course"
size = "320x240"
settings = { depth = 5 }
[[check]]
id = "trees"
points = 10
scene = "whitted"
pixels = { count = 100, seed = 1, where = "hit" }
ask = ["core"]
"#;

fn main() {
    let count = std::env::args().nth(1).and_then(|word| word.parse().ok());
    let count: usize = count.unwrap_or(500);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("course.toml");
    std::fs::write(&path, TASK).expect("written");
    let path = path.to_str().expect("UTF-8");
    let tasks = [thread_pool::install(2, || Task::load(path)).expect("a task")];
    let scene = &tasks[0].scenes[0];
    // A third is right, the others make each another mistake.
    let bends: Vec<Bend> = Bend::all().collect();
    let (right, wrong): (Vec<u8>, Vec<Vec<u8>>) = thread_pool::install(2, || {
        let archive = |bends| archive(&tasks[0], scene, bends);
        let wrong = bends.iter().map(|bend| archive((*bend).into()));
        (archive(Bends::default()), wrong.collect())
    });
    let archives = (0..count).map(|i| match i % 3 {
        0 => &right,
        _ => &wrong[i % wrong.len()],
    });
    let folder = folder.path();
    let files: Vec<_> = archives
        .enumerate()
        .map(|(i, bytes)| {
            let file = folder.join(format!("student{i}.zip"));
            std::fs::write(&file, bytes).expect("written");
            file
        })
        .collect();
    let bytes: u64 = files
        .iter()
        .map(|f| f.metadata().map_or(0, |m| m.len()))
        .sum();
    let rows = [1, 2].map(|threads| {
        let mut named = 0;
        let seconds = (0..ROUNDS).map(|_| {
            let start = Instant::now();
            let report = thread_pool::install(threads, || {
                Report::new(&tasks, &files, |file: &PathBuf| Submission::read(file))
            });
            named = report
                .submissions
                .iter()
                .filter(|m| m.diagnosis.is_some())
                .count();
            start.elapsed().as_secs_f64()
        });
        let seconds = median(seconds);
        vec![
            threads.to_string(),
            count.to_string(),
            PIXELS.to_string(),
            format!("{:.1}", bytes as f64 / 1e6),
            named.to_string(),
            format!("{seconds:.2}"),
        ]
    });
    let head = [
        "threads",
        "archives",
        "pixels each",
        "MB",
        "mistakes named",
        "s",
    ];
    publish("grade", &markdown(&head.map(str::to_owned), &rows));
}

/// What a tracer with these bends hands in.
fn archive(task: &Task, scene: &TaskScene, bends: Bends) -> Vec<u8> {
    let settings = scene.settings.with(|s| s.bends = bends);
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default();
    zip.start_file("whitted.ndjson", options).expect("started");
    for line in task.asked_pixels() {
        let mut words = line.split_whitespace().rev();
        let mut number = || {
            words
                .next()
                .and_then(|word| word.parse().ok())
                .expect("a number")
        };
        let (y, x) = (number(), number());
        let trace = trace_pixel_here(&scene.world, &settings, (x, y), false);
        let document = document::of(View {
            world: &scene.world,
            settings: &settings,
            trace: &trace,
        });
        let mut text = Vec::new();
        json::write(&mut text, &document).expect("a buffer takes everything");
        let value: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
        writeln!(zip, "{value}").expect("written");
    }
    zip.finish().expect("whole").into_inner()
}
