//! How building grows with the scene: time and memory, from 10^3 triangles to 10^6, or to 10^7 with `RAYTREE_SCALE=7`; and a
//! model of 10^6 triangles from its file to its first picture.
//!
//! Each size is built in a process of its own, so that its peak of memory is its own: this program, run again.
//!
//! `cargo bench -p raytree-benches --bench scaling`; with `RAYTREE_BOOK=1` the tables go into the book as well.

#[path = "common/ball.rs"]
mod ball;
#[path = "common/obj.rs"]
mod obj;
#[path = "common/program.rs"]
mod program;
#[path = "common/table.rs"]
mod table;
#[path = "common/terminal.rs"]
mod terminal;

use std::fmt::Write;
use std::fs::read_to_string;
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::Shape;

use program::raytree;
use table::{markdown, median, publish};
use terminal::{Terminal, covered, cpu};

/// What is built, and the most bytes a triangle that a scene may take while it is.
const KINDS: [(AccelKind, f64); 3] = [
    (AccelKind::Wide, 200.0),
    (AccelKind::Kd, 250.0),
    (AccelKind::Bvh, f64::INFINITY),
];

/// Rings of a ball of about 10^3, 10^4 ... triangles: 4 a ring and ring.
const RINGS: [usize; 5] = [16, 50, 158, 500, 1581];

/// How often each is built, in turns; the largest only once.
const ROUNDS: usize = 3;

/// Tells this program to be the one that builds: a kind's name and a number of rings.
const CHILD: &str = "RAYTREE_SCALING_CHILD";

/// Of a process: a figure in kilobytes from its status, in bytes. 0 where the system does not tell.
fn status(process: &str, what: &str) -> f64 {
    let text = read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(what));
    let number = line.and_then(|l| l.split_whitespace().nth(1)?.parse::<f64>().ok());
    1024.0 * number.unwrap_or(0.0)
}

/// What a child found: seconds, of the clock and of all processors; bytes of the tree; bytes at the peak, with the shapes
/// themselves.
struct Built {
    seconds: f64,
    cpu: f64,
    tree: f64,
    peak: f64,
}

/// Builds once, and prints what it took.
fn child(task: &str) {
    let (name, rings) = task.split_once(' ').expect("a kind and a number");
    let kind = AccelKind::ALL.into_iter().find(|k| k.name() == name);
    let kind = kind.expect("the name of a kind");
    // Threads are started before, as they are in a program that has read a file.
    rayon::join(|| (), || ());
    let empty = status("self", "VmRSS");
    let mut shapes = Vec::with_capacity(4 * rings.parse::<usize>().expect("a number").pow(2));
    shapes.extend(ball::triangles(rings.parse().expect("a number")).map(Shape::Triangle));
    let (start, before) = (Instant::now(), cpu("self"));
    let accel = Accel::build(kind, &shapes);
    let seconds = start.elapsed().as_secs_f64();
    let cpu = cpu("self").saturating_sub(before).as_secs_f64();
    let peak = status("self", "VmHWM") - empty;
    println!("{seconds} {cpu} {} {peak}", accel.stats().bytes);
    black_box((accel, shapes));
}

/// Lets a child build.
fn built(kind: AccelKind, rings: usize) -> Built {
    let program = std::env::current_exe().expect("this program");
    let output = Command::new(program)
        .arg("--bench")
        .env(CHILD, format!("{} {rings}", kind.name()))
        .stderr(Stdio::inherit())
        .output();
    let text = String::from_utf8(output.expect("itself").stdout).expect("numbers");
    let numbers: Vec<f64> = text
        .split_whitespace()
        .map(|n| n.parse().expect("a number"))
        .collect();
    Built {
        seconds: numbers[0],
        cpu: numbers[1],
        tree: numbers[2],
        peak: numbers[3],
    }
}

/// A row for each number of triangles.
fn building() -> String {
    let largest = std::env::var("RAYTREE_SCALE").is_ok_and(|exponent| exponent == "7");
    let sizes = &RINGS[..if largest { 5 } else { 4 }];
    let mut text = String::new();
    for (kind, limit) in KINDS {
        let mut times: Vec<Vec<Built>> = sizes.iter().map(|_| Vec::new()).collect();
        for round in 0..ROUNDS {
            for (rings, times) in sizes.iter().zip(&mut times) {
                if round == 0 || *rings < RINGS[4] {
                    times.push(built(kind, *rings));
                }
            }
        }
        let of = |times: &[Built], what: fn(&Built) -> f64| median(times.iter().map(what));
        let law = |rings: usize| {
            let n = (4 * rings * rings) as f64;
            n * n.log2()
        };
        // The smallest is over before threads have begun: the second one is the measure.
        let unit = of(&times[1], |b| b.seconds) / law(sizes[1]);
        let rows = sizes.iter().zip(&times).map(|(rings, times)| {
            let (n, seconds) = ((4 * rings * rings) as f64, of(times, |b| b.seconds));
            vec![
                n.to_string(),
                format!("{:.1}", 1000.0 * seconds),
                format!("{:.0}", 1000.0 * of(times, |b| b.cpu)),
                format!("{:.2}", seconds / law(*rings) / unit),
                format!("{:.0}", of(times, |b| b.tree) / n),
                format!("{:.0}", of(times, |b| b.peak) / n),
            ]
        });
        let rows: Vec<_> = rows.collect();
        let head = [
            &format!("`{}`: triangles", kind.name()),
            "ms to build",
            "CPU",
            "times n log n",
            "bytes a triangle: tree",
            "at the peak",
        ]
        .map(String::from);
        text += &markdown(&head, &rows);
        if limit.is_finite() {
            let largest = (4 * sizes[sizes.len() - 1].pow(2)) as f64;
            let peak = of(&times[sizes.len() - 1], |b| b.peak) / largest;
            let verdict = if peak <= limit { "kept" } else { "missed" };
            let _ = writeln!(
                text,
                "\nThe limit at the peak is {limit} bytes a triangle: {verdict}."
            );
        }
        text.push('\n');
    }
    format!(
        "Two threads, medians of {ROUNDS} rounds (of 10^7 triangles, one), and processor time: a busy machine can be told from slow code. *Times n log n* is 1 where time grows as n log n from 10^4 \
         triangles on. The peak is the resident memory while it is built, the 80 bytes of each triangle in the scene included.\n\n{text}"
    )
}

/// Runs the program to its end: seconds, of the clock and of all processors, and bytes at the peak.
fn rendered(args: &[&str]) -> [f64; 3] {
    let (program, start) = (raytree(), Instant::now());
    let child = Command::new(program)
        .arg("render")
        .args(args)
        .stderr(Stdio::null())
        .spawn();
    let mut child = child.expect("the program");
    let process = child.id().to_string();
    let (mut peak, mut used) = (0.0f64, Duration::ZERO);
    while child.try_wait().expect("a child").is_none() {
        peak = peak.max(status(&process, "VmHWM"));
        used = used.max(cpu(&process));
        std::thread::sleep(Duration::from_millis(1));
    }
    [start.elapsed().as_secs_f64(), used.as_secs_f64(), peak]
}

/// A row for each way to look at a model of a million triangles.
fn whole() -> String {
    let triangles = ball::bumpy_ball(500);
    let file = obj::written(&triangles);
    let path = file.path().to_str().expect("a plain path");
    let picture = tempfile::Builder::new().suffix(".png").tempfile();
    let picture = picture.expect("a place for files");
    let picture = picture.path().to_str().expect("a plain path");
    let mut rows = Vec::new();
    let mut row = |name: String, runs: Vec<[f64; 3]>| {
        let of = |which: usize| median(runs.iter().map(|run| run[which]));
        let bytes = of(2) / triangles.len() as f64;
        rows.push(vec![
            name,
            format!("{:.2}", of(0)),
            format!("{:.2}", of(1)),
            format!("{bytes:.0}"),
        ]);
    };
    for kind in ["wide", "kd"] {
        let args = [path, "--accel", kind, "--size", "320x240", "-o", picture];
        let runs = (0..ROUNDS).map(|_| rendered(&args)).collect();
        row(format!("`render --accel {kind}`, 320x240 pixels"), runs);
    }
    let view = |_| {
        let mut terminal = Terminal::view(&[path], (160, 50));
        let first = terminal.until(covered) - terminal.started;
        let peak = status(&terminal.process(), "VmHWM");
        [first.as_secs_f64(), terminal.cpu().as_secs_f64(), peak]
    };
    row(
        "`view`, to its first picture".to_string(),
        (0..ROUNDS).map(view).collect(),
    );
    let head = ["program", "seconds", "CPU", "bytes a triangle at the peak"].map(String::from);
    format!(
        "From the start of the program with an OBJ file of 10^6 triangles ({} MB) to its picture, medians of {ROUNDS} runs; resident memory at \
         the peak.\n\n{}",
        std::fs::metadata(path).map_or(0, |m| m.len() / 1_000_000),
        markdown(&head, &rows)
    )
}

fn main() {
    // `cargo test` runs this program as well, without the flag.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    match std::env::var(CHILD) {
        Ok(task) => child(&task),
        Err(_) => publish("scaling", &format!("{}{}", building(), whole())),
    }
}
