//! Whole pictures: millions of rays a second of every accelerator on every kind of scene, eye, shadow, reflected and
//! transmitted rays and shading together, in turns in one run; and what a second thread is worth.
//!
//! `cargo bench -p raytree-benches --bench pictures`; with `RAYTREE_BOOK=1` the tables go into the book as well.

#[path = "common/table.rs"]
mod table;

use std::ops::ControlFlow;
use std::time::Instant;

use raytree::accel::AccelKind;
use raytree::scene::{self, Settings};
use raytree::trace::Counts;
use raytree::tracer::{draw, render};
use raytree::world::World;

use table::{markdown, median, publish};

/// How often each contestant draws.
const ROUNDS: usize = 5;

/// Accelerators that are this many times slower than the quickest draw only once.
const SLOW: f64 = 4.0;

/// The list is only asked where it ends within reason.
const LIST_LIMIT: usize = 1000;

/// The scenes: a few shapes, spheres of glass and mirrors, boxes, meshes; and thousands of spheres.
const SCENES: [&str; 11] = [
    "triangle",
    "whitted",
    "glass-block",
    "nested-glass",
    "mirrors",
    "shadows",
    "room",
    "teapot",
    "bunny",
    "spd:balls:4",
    "spd:gears:2",
];

/// Seconds for one picture.
fn seconds(world: &World, settings: &Settings, threads: usize) -> f64 {
    let start = Instant::now();
    let film = draw(world, settings, threads);
    assert!(!film.truncated, "nothing is left out");
    start.elapsed().as_secs_f64()
}

/// A row for each scene: how many times as fast as the list each accelerator is, and the best one's rays a second.
fn accelerators() -> String {
    let mut head = vec![
        "scene".to_string(),
        "shapes".to_string(),
        "rays".to_string(),
    ];
    head.extend(
        AccelKind::ALL
            .iter()
            .map(|kind| format!("`{}`", kind.name())),
    );
    let mut rows = Vec::new();
    for name in SCENES {
        let scene = scene::load(name).expect("built in");
        let settings = scene.settings.with(|s| {
            s.image.width = 256;
            s.image.height = 256;
            s.recursion.depth = 7;
        });
        let worlds = AccelKind::ALL.map(|kind| World::new(scene.clone(), kind));
        let (_, counts) = render::<Counts>(&worlds[worlds.len() - 1], &settings, 0, &|_, _| {
            ControlFlow::Continue(())
        });
        let rays = counts.iter().fold(Counts::default(), Counts::plus).rays();
        let mut times: Vec<_> = worlds
            .iter()
            .zip(AccelKind::ALL)
            .map(|(world, kind)| {
                if kind == AccelKind::List && scene.shapes.len() > LIST_LIMIT {
                    return vec![f64::INFINITY];
                }
                vec![seconds(world, &settings, 1)]
            })
            .collect();
        let best = times.iter().map(|t| t[0]).fold(f64::INFINITY, f64::min);
        for _ in 1..ROUNDS {
            for (world, times) in worlds.iter().zip(&mut times) {
                if times[0] < SLOW * best {
                    times.push(seconds(world, &settings, 1));
                }
            }
        }
        let mut row = vec![
            name.to_string(),
            scene.shapes.len().to_string(),
            rays.to_string(),
        ];
        row.extend(
            times
                .into_iter()
                .map(|t| match rays as f64 / median(t) / 1e6 {
                    0.0 => "-".to_string(),
                    rate => format!("{rate:.2}"),
                }),
        );
        rows.push(row);
    }
    let about = "Millions of rays a second, one thread, 256x256 pixels, depth 7, medians of 5 rounds in turns.";
    format!("{about}\n\n{}", markdown(&head, &rows))
}

/// Seconds for two pictures side by side, each on one thread of its own: all that a second core of this machine gives.
fn seconds_side_by_side(world: &World, settings: &Settings) -> f64 {
    let start = Instant::now();
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| seconds(world, settings, 1));
        }
    });
    start.elapsed().as_secs_f64()
}

/// A row for each scene: how many times as fast two threads are as one, and two pictures side by side as one after the
/// other.
fn threads() -> String {
    let head = [
        "scene",
        "one thread, Mrays/s",
        "two threads",
        "times as fast",
        "two pictures side by side",
    ]
    .map(String::from);
    let mut rows = Vec::new();
    for name in ["whitted", "bunny", "spd:balls:4"] {
        let scene = scene::load(name).expect("built in");
        let settings = scene.settings.with(|s| {
            s.image.width = 1024;
            s.image.height = 1024;
        });
        let world = World::new(scene, AccelKind::Wide);
        let (_, counts) = render::<Counts>(&world, &settings, 0, &|_, _| ControlFlow::Continue(()));
        let rays = counts.iter().fold(Counts::default(), Counts::plus).rays() as f64;
        let rounds: Vec<_> = (0..2 * ROUNDS)
            .map(|_| {
                let one = seconds(&world, &settings, 1);
                let two = seconds(&world, &settings, 2);
                (one, two, seconds_side_by_side(&world, &settings))
            })
            .collect();
        let rate =
            |times: &mut dyn Iterator<Item = f64>| format!("{:.2}", rays / median(times) / 1e6);
        rows.push(vec![
            name.to_string(),
            rate(&mut rounds.iter().map(|r| r.0)),
            rate(&mut rounds.iter().map(|r| r.1)),
            format!("{:.2}", median(rounds.iter().map(|r| r.0 / r.1))),
            format!("{:.2}", median(rounds.iter().map(|r| 2.0 * r.0 / r.2))),
        ]);
    }
    let about = "`wide`, 1024x1024 pixels, medians of 10 rounds in turns. Side by side, two threads share nothing: no \
        program is quicker on two cores of this machine.";
    format!("{about}\n\n{}", markdown(&head, &rows))
}

fn main() {
    // `cargo test` runs this program as well, without the flag.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    if !std::env::args().any(|a| a == "threads") {
        publish("pictures", &accelerators());
    }
    publish("threads", &threads());
}
