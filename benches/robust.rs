//! What robust arithmetic costs: our tests of triangles and spheres beside the usual ones in double precision, on the same
//! rays and shapes, in turns in one run.
//!
//! Then whole pictures: the knobs of arithmetic, turned as `raytree cost` turns them.
//!
//! `cargo bench -p raytree-benches --bench robust`; with `RAYTREE_BOOK=1` the tables go into the book as well.

#[path = "common/table.rs"]
mod table;

use std::hint::black_box;
use std::time::{Duration, Instant};

use raytree::accel::fastest;
use raytree::geometry::arithmetic::{sphere, triangle};
use raytree::geometry::{Intersection, Shear, Sphere, Triangle};
use raytree::lab::{Effort, Lab, Parameter, parameters};
use raytree::math::{DVec3, Interval, Ray};
use raytree::sampling::Sampler;
use raytree::sampling::stream::{splitmix64, to_unit_f64};
use raytree::scene::load;
use raytree::world::World;

use table::{markdown, median, publish};

/// The scenes whose pictures are drawn with each choice.
const SCENES: [&str; 5] = ["whitted", "room", "nested-glass", "teapot", "spd:balls:3"];

/// How often each contestant runs.
const ROUNDS: usize = 21;

/// Rays, each of which is tested against all shapes.
const RAYS: usize = 256;
const SHAPES: usize = 1024;

/// A point in the cube [-1, 1)^3.
fn point(number: usize) -> DVec3 {
    let [x, y, z] = [0, 1, 2].map(|axis| to_unit_f64(splitmix64((3 * number + axis) as u64)));
    DVec3::new(x, y, z) * 2.0 - 1.0
}

/// Ours and the usual test, each of which counts the shapes that all rays hit: nanoseconds a test of each, the median of the
/// first one's time over the second one's, and the hits.
fn race(contestants: [&dyn Fn() -> usize; 2]) -> ([f64; 2], f64, [usize; 2]) {
    let mut rounds = Vec::new();
    let mut hits = [0; 2];
    for _ in 0..ROUNDS {
        let times = [0, 1].map(|i| {
            let start = Instant::now();
            hits[i] = black_box(contestants[i]());
            start.elapsed().as_secs_f64() * 1e9 / (RAYS * SHAPES) as f64
        });
        rounds.push(times);
    }
    let time = |i: usize| median(rounds.iter().map(|r| r[i]));
    let ratio = median(rounds.iter().map(|r| r[0] / r[1]));
    ([time(0), time(1)], ratio, hits)
}

/// A row of the table.
fn row(what: &str, names: [&str; 2], race: ([f64; 2], f64, [usize; 2])) -> Vec<String> {
    let (times, ratio, hits) = race;
    let share = 100.0 * hits[0] as f64 / (RAYS * SHAPES) as f64;
    vec![
        what.to_string(),
        format!("{share:.0} %"),
        format!("{} {:.2} ns", names[0], times[0]),
        format!("{} {:.2} ns", names[1], times[1]),
        format!("{ratio:.2}"),
    ]
}

fn is_hit(found: Intersection) -> usize {
    usize::from(matches!(found, Intersection::Hit { .. }))
}

/// Triangles of this size around places in the cube, and rays from outside through it.
fn triangles(what: &str, size: f64) -> Vec<String> {
    let corner = |i: usize, k: usize| point(i) * 0.5 + point(7 * i + k) * size;
    let shapes: Vec<_> = (0..SHAPES)
        .map(|i| Triangle {
            corners: [1, 2, 3].map(|k| corner(i, k)),
        })
        .collect();
    let rays = rays();
    let ours = || {
        let of_ray = |ray: &Ray| {
            let shear = Shear::new(ray);
            let hits = shapes
                .iter()
                .map(|t| is_hit(t.intersect(&shear, Interval::FORWARD)));
            hits.sum::<usize>()
        };
        rays.iter().map(of_ray).sum()
    };
    let usual = || {
        let of_ray = |ray: &Ray| {
            let test = |t| is_hit(triangle::moller_trumbore::<f64>(t, ray, Interval::FORWARD));
            shapes.iter().map(test).sum::<usize>()
        };
        rays.iter().map(of_ray).sum()
    };
    let names = ["watertight", "Moller-Trumbore"];
    row(what, names, race([&ours, &usual]))
}

fn spheres(what: &str, radius: f64) -> Vec<String> {
    let shapes: Vec<_> = (0..SHAPES)
        .map(|i| Sphere {
            center: point(i) * 0.5,
            radius,
        })
        .collect();
    let rays = rays();
    let ours = || {
        let of_ray = |ray: &Ray| {
            let test = |s: &Sphere| is_hit(s.intersect(ray, Interval::FORWARD));
            shapes.iter().map(test).sum::<usize>()
        };
        rays.iter().map(of_ray).sum()
    };
    let usual = || {
        let of_ray = |ray: &Ray| {
            let test = |s| is_hit(sphere::school::<f64>(s, ray, Interval::FORWARD));
            shapes.iter().map(test).sum::<usize>()
        };
        rays.iter().map(of_ray).sum()
    };
    let names = ["stable", "school"];
    row(what, names, race([&ours, &usual]))
}

fn rays() -> Vec<Ray> {
    let from = |i: usize| point(i + 100_000).normalize_or(DVec3::X) * 3.0;
    let ray = |i: usize| Ray::new(from(i), (point(i + 200_000) * 0.5 - from(i)).normalize());
    (0..RAYS).map(ray).collect()
}

/// What each choice costs in a picture of a scene, over the robust one in the same round, and how far it is off: knob,
/// position, time, RMSE.
fn picture(name: &str) -> Vec<([String; 2], [f64; 2])> {
    let scene = load(name).expect("a scene");
    let settings = scene.settings.with(|s| {
        s.image.width = 120;
        s.image.height = 90;
        s.pixel.samples = 1;
        s.light.samples = 1;
        s.pixel.sampler = Sampler::Grid;
        s.accel = fastest(&scene.shapes);
    });
    let world = World::new(scene, settings.accel);
    let choices = parameters(&world, &settings, Effort::LEAST);
    let mut lab = Lab {
        world,
        accel: settings.accel,
        arithmetic: settings.arithmetic,
        runs: 1,
        threads: 1,
        given: None,
        reference: None,
    };
    let mut rows = Vec::new();
    for knob in choices.into_iter().filter(Parameter::is_arithmetic) {
        let mut round = || {
            let end = Instant::now() + Duration::from_secs(600);
            lab.measure(vec![knob.clone()], end, &|_| {})
                .remove(0)
                .steps
        };
        let rounds: Vec<_> = (0..ROUNDS).map(|_| round()).collect();
        for (i, step) in rounds[0].iter().enumerate() {
            let over_robust = rounds.iter().map(|steps| {
                let robust = steps.last().expect("a position");
                steps[i].seconds / robust.seconds
            });
            let rmse = step.errors.expect("a reference").rmse;
            let what = [knob.group.to_string(), step.step.clone()];
            rows.push((what, [median(over_robust), rmse]));
        }
    }
    rows
}

/// A row for each position of a knob, a column for each scene.
fn pictures() -> String {
    let columns = SCENES.map(picture);
    let mut names: Vec<[String; 2]> = Vec::new();
    for (name, _) in columns.iter().flatten() {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    // By knobs, in the order of the first scene that has each.
    names.sort_by_key(|[knob, _]| {
        ["triangle", "offset", "quadratic"]
            .iter()
            .position(|k| k == knob)
            .unwrap_or(9)
    });
    let head: Vec<String> = ["", ""]
        .iter()
        .chain(&SCENES)
        .map(|s| (*s).to_string())
        .collect();
    let cell = |found: &[f64; 2]| match found {
        [time, 0.0] => format!("{time:.2}, 0"),
        [time, rmse] => format!("{time:.2}, {rmse:.0e}"),
    };
    let row = |name: &[String; 2]| {
        let cells = columns.iter().map(|column| {
            let found = column.iter().find(|(other, _)| other == name);
            found.map_or("-".to_string(), |(_, found)| cell(found))
        });
        name.iter().map(|n| format!("`{n}`")).chain(cells).collect()
    };
    let rows: Vec<Vec<String>> = names.iter().map(row).collect();
    markdown(&head, &rows)
}

fn main() {
    // `cargo test` runs this program as well, without the flag.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    let head = ["shapes", "hit", "ours", "usual", "ours / usual"].map(String::from);
    let rows = [
        triangles("small triangles", 0.05),
        triangles("large triangles", 1.0),
        spheres("small spheres", 0.05),
        spheres("large spheres", 0.5),
    ];
    let about = format!(
        "{RAYS} rays against each of {SHAPES} shapes in double precision, medians of {ROUNDS} rounds in turns, on one thread."
    );
    publish("robust", &format!("{about}\n\n{}", markdown(&head, &rows)));
    let about = format!(
        "120x90 pixels, one ray a pixel, one thread, medians of {ROUNDS} rounds in turns. Of each: the time over that of the \
robust choice, then the RMSE against it."
    );
    publish("robust-pictures", &format!("{about}\n\n{}", pictures()));
}
