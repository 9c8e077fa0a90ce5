//! What an area light costs for how much noise: every way to sample it, on whole pictures.
//!
//! The book's table: `RAYTREE_BOOK=1 cargo bench -p raytree-benches --bench soft_shadows -- --size 256`.
//!
//! `cargo bench -p raytree-benches --bench soft_shadows`, `-- --size N` for pictures of N x N pixels (64); with `RAYTREE_BOOK=1` the table
//! goes into the book as well.

#[path = "common/table.rs"]
mod table;

use std::fmt::Write;
use std::time::Instant;

use raytree::accel::AccelKind;
use raytree::lab::Reference;
use raytree::lab::error::errors;
use raytree::sampling::{LightSampling, Sampler};
use raytree::scene::{self, Adaptive, Pilot, Settings};
use raytree::tracer::{Film, draw};
use raytree::world::World;

use table::{markdown, median, publish};

/// How often each contestant draws.
const ROUNDS: usize = 5;

/// Shadow rays to the lamp, a pixel, where all have equally many.
const RAYS: u32 = 16;

/// Where the pixels around decide: their threshold, and the most samples.
const AROUND: (f64, u32) = (0.003, 256);

/// Samples a pixel of the reference, with another seed.
const REFERENCE: u32 = 1024;

/// The bunny on a floor below a lamp of 1.5 x 1.5, all matt, without any other light.
const BUNNY: &str = r#"{
  "format": "raytree-scene/1", "name": "bunny-lamp", "background": [0, 0, 0], "ambient": [0, 0, 0],
  "camera": {"eye": [0.5, 1.9, 4.6], "look_at": [0, 0.92, 0], "vertical_fov": 33},
  "materials": {
    "clay": {"diffuse": [0.72, 0.5, 0.36]}, "floor": {"diffuse": [0.7, 0.7, 0.68]},
    "lamp": {"diffuse": [0, 0, 0], "emission": [9, 8.6, 8]}
  },
  "lights": [{"area": {"name": "lamp", "object": "lamp"}}],
  "objects": [
    {"quad": {"name": "lamp", "material": "lamp", "corner": [-0.75, 3.2, -0.75], "u": [1.5, 0, 0], "v": [0, 0, 1.5]}},
    {"obj": {"name": "bunny", "material": "clay", "file": "bunny.obj"}},
    {"quad": {"name": "floor", "material": "floor", "corner": [-5, 0, 5], "u": [10, 0, 0], "v": [0, 0, -10]}}
  ]
}"#;

/// The bunny's world.
fn bunny() -> World {
    let folder = tempfile::tempdir().expect("a folder");
    let put = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("room on the disk");
        path
    };
    put("bunny.obj", include_str!("../scenes/bunny.obj"));
    let path = put("scene.json", BUNNY);
    let scene = scene::load(path.to_str().expect("a plain path")).expect("a scene");
    World::new(scene, AccelKind::Wide)
}

/// A picture's cost and error.
struct Drawn {
    rays: u64,
    seconds: f64,
    rmse: f64,
}

/// A picture and the seconds that it took one thread.
fn timed(world: &World, settings: &Settings, threads: usize) -> (Film, f64) {
    let start = Instant::now();
    let film = draw(world, settings, threads);
    assert!(!film.truncated, "nothing is left out");
    (film, start.elapsed().as_secs_f64())
}

/// What is compared: every way to choose places, and what else saves rays or time.
fn ways(size: u32) -> Vec<(String, Settings)> {
    let base = Settings::default().with(|s| {
        s.image.width = size;
        s.image.height = size;
        s.pixel.samples = RAYS;
        s.light.samples = 1;
        s.pixel.sampler = Sampler::Sobol;
    });
    let mut ways: Vec<_> = Sampler::ALL
        .into_iter()
        .flat_map(|sampler| LightSampling::ALL.map(|by| (sampler, by)))
        .filter(|way| *way != (Sampler::Grid, LightSampling::Projected))
        .map(|(sampler, light_sampling)| {
            let name = format!("`{}`, by `{}`", sampler.name(), light_sampling.name());
            (
                name,
                base.with(|s| {
                    s.light.sampler = sampler;
                    s.light.density = light_sampling;
                }),
            )
        })
        .collect();
    // Fewer rays from the eye, each with more to the lamp.
    let four = base.with(|s| {
        s.pixel.samples = 4;
        s.light.samples = RAYS / 4;
    });
    ways.push(("`sobol`, 4 eye rays with 4 rays each".to_owned(), four));
    let (threshold, most) = AROUND;
    for light_samples in [1, 4] {
        let around = four.with(|s| {
            s.light.samples = light_samples;
            s.pixel.adaptive = Some(Adaptive {
                threshold,
                most,
                pilot: Pilot::Around,
            });
        });
        let name = format!("`sobol`, `--pilot around`, eye rays with {light_samples} each");
        ways.push((name, around));
    }
    ways
}

/// A row for each way: rays, seconds, error, and error x root of seconds, which more independent samples leave alone.
fn rows(world: &World, size: u32) -> String {
    let ways = ways(size);
    let reference = ways[0].1.with(|s| {
        s.pixel.samples = REFERENCE;
        s.seed = 99;
        s.light.sampler = Sampler::Sobol;
    });
    let reference = Reference::new(timed(world, &reference, 0).0, 1.0);
    let mut draws: Vec<Vec<Drawn>> = ways.iter().map(|_| Vec::new()).collect();
    for seed in 0..ROUNDS as u64 {
        for ((_, settings), draws) in ways.iter().zip(&mut draws) {
            let settings = settings.with(|s| s.seed = seed);
            let (film, seconds) = timed(world, &settings, 1);
            let rmse = errors(&film, &reference, 1.0).expect("the same size").rmse;
            draws.push(Drawn {
                rays: film.rays,
                seconds,
                rmse,
            });
        }
    }
    let head = [
        "places on the lamp",
        "Mrays",
        "seconds",
        "RMSE",
        "RMSE x s^1/2",
    ]
    .map(String::from);
    let mut rows = Vec::new();
    for ((name, _), draws) in ways.iter().zip(&draws) {
        let seconds = median(draws.iter().map(|d| d.seconds));
        let squares: f64 = draws.iter().map(|d| d.rmse * d.rmse).sum();
        let rmse = (squares / draws.len() as f64).sqrt();
        rows.push(vec![
            name.clone(),
            format!("{:.2}", draws[0].rays as f64 / 1e6),
            format!("{seconds:.3}"),
            format!("{rmse:.5}"),
            format!("{:.5}", rmse * seconds.sqrt()),
        ]);
    }
    markdown(&head, &rows)
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    // `cargo test` runs this program as well, without the flag.
    if !arguments.iter().any(|a| a == "--bench") {
        return;
    }
    let size = arguments.iter().skip_while(|a| *a != "--size").nth(1);
    let size = size.map_or(64, |n| n.parse().expect("a number of pixels"));
    let mut text = format!(
        "{size}x{size} pixels, one thread. Seconds are medians of {ROUNDS} rounds in turns, errors the root of the mean of \
         their squares. Each\npixel sends {RAYS} rays to the lamp, one from each of its eye rays if nothing is said; in the \
         last two rows as many as the pixels\naround ask for (T = {}).\n",
        AROUND.0
    );
    let soft_shadow = scene::load("soft-shadow").expect("built in");
    let soft_shadow = World::new(soft_shadow, AccelKind::List);
    for (name, world) in [
        ("The bunny on a floor below a lamp", bunny()),
        ("`soft-shadow`", soft_shadow),
    ] {
        let _ = write!(text, "\n{name}:\n\n{}", rows(&world, size));
    }
    publish("soft-shadows", &text);
}
