//! The lecture's frame: what the slide reckons, what the list would take, and what each accelerator takes.
//!
//! All accelerators draw the same pixels in turns, in one run, on one thread: every sixteenth pixel of each row and
//! column, with all its samples. Times for the whole frame are these times 256.

use std::ops::ControlFlow;
use std::time::Instant;

use raytree::accel::AccelKind;
use raytree::scene::{self, Settings};
use raytree::trace::Counts;
use raytree::tracer::{draw, render};
use raytree::world::World;

/// Pixels of the frame for each pixel that is drawn, along an edge.
const STRIDE: u32 = 16;
/// Rounds; the median counts.
const ROUNDS: usize = 5;
/// The slide's machine: tests a second.
const SLIDE_RATE: f64 = 100_000.0;

/// Seconds to draw the pixels once.
fn seconds(world: &World, settings: &Settings) -> f64 {
    let start = Instant::now();
    let film = draw(world, settings, 1);
    assert!(!film.truncated, "nothing is left out");
    start.elapsed().as_secs_f64()
}

fn counts(world: &World, settings: &Settings) -> Counts {
    let (_, parts) = render::<Counts>(world, settings, 1, &|_, _| ControlFlow::Continue(()));
    parts.iter().fold(Counts::default(), Counts::plus)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let scene = scene::load("lecture-1000").expect("computed");
    let frame = scene.settings;
    let (pixels, objects) = (frame.image.width * frame.image.height, scene.shapes.len());
    let slide = f64::from(pixels)
        * f64::from(frame.pixel.samples)
        * f64::from(frame.recursion.depth)
        * objects as f64;
    println!(
        "slide: {}x{} pixels x {} rays x {} levels x {objects} objects = {slide} tests, \
         {:.0} hours at {SLIDE_RATE} tests/s",
        frame.image.width,
        frame.image.height,
        frame.pixel.samples,
        frame.recursion.depth,
        slide / SLIDE_RATE / 3600.0
    );
    // `cargo test` runs this program as well, without the flag.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }

    let part = frame.with(|s| {
        s.image.width = frame.image.width / STRIDE;
        s.image.height = frame.image.height / STRIDE;
    });
    let share = f64::from(STRIDE * STRIDE);
    let worlds = AccelKind::ALL.map(|kind| (kind, World::new(scene.clone(), kind)));
    let mut times = worlds.each_ref().map(|_| Vec::new());
    for _ in 0..ROUNDS {
        for ((_, world), times) in worlds.iter().zip(&mut times) {
            times.push(seconds(world, &part));
        }
    }
    let medians = times.map(median);
    let list = worlds
        .iter()
        .zip(medians)
        .find(|((kind, _), _)| *kind == AccelKind::List);
    let list = list.map_or(f64::NAN, |(_, time)| time);

    println!(
        "measured on 1/{share} of the pixels, one thread, medians of {ROUNDS} rounds in turns:"
    );
    for ((kind, world), time) in worlds.iter().zip(medians) {
        let found = counts(world, &part);
        println!(
            "{:12} {:8.1} s a frame, {:7.2} x list, {:7.2} tests a ray, {:6.2} Mtests/s, {:6.3} Mrays/s",
            kind.name(),
            time * share,
            list / time,
            found.tests as f64 / found.rays() as f64,
            found.tests as f64 / time / 1e6,
            found.rays() as f64 / time / 1e6,
        );
        if *kind == AccelKind::List {
            println!(
                "{:12} the frame has {:.3e} tests, not {slide:.3e}; those would take {:.1} s",
                "",
                found.tests as f64 * share,
                slide * time / found.tests as f64
            );
        }
    }
}
