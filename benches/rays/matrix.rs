//! All accelerators and all peers, on the same rays, in turns.

use std::hint::black_box;
use std::time::Instant;

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Hit, Shape, Triangle};
use raytree::probe::Silent;

use super::peers::{NAMES, Peer};
use super::sent::{Kind, Sent, kinds};
use super::table::{markdown, median};

/// How often each contestant runs.
const ROUNDS: usize = 5;

/// Rays that the tracer would ask for at once: a tile's.
const BUNDLE: usize = 256;

/// Contestants that are this many times slower than the first one run fewer rays, the others all.
const SLOW: f64 = 8.0;

/// The list is only asked where it ends within reason.
const LIST_LIMIT: usize = 100;

/// A structure that finds hits.
enum Contestant {
    Ours(AccelKind, Accel),
    Bundles(AccelKind, Accel),
    Peer(&'static str, Peer),
}

impl Contestant {
    fn name(&self) -> String {
        match self {
            Self::Ours(kind, _) => format!("`{}`", kind.name()),
            Self::Bundles(kind, _) => format!("`{}`, bundles", kind.name()),
            Self::Peer(name, _) => (*name).to_string(),
        }
    }

    /// Something that can be timed: how many of the rays hit.
    fn run<'a>(
        &'a self,
        shapes: &'a [Shape],
        rays: &'a [Sent],
        any: bool,
    ) -> Box<dyn Fn() -> usize + 'a> {
        match self {
            Self::Ours(_, accel) => Box::new(move || one_by_one(accel, shapes, rays, any)),
            Self::Bundles(_, accel) => Box::new(move || in_bundles(accel, shapes, rays, any)),
            Self::Peer(_, peer) => peer.run(rays, any),
        }
    }
}

fn one_by_one(accel: &Accel, shapes: &[Shape], rays: &[Sent], any: bool) -> usize {
    let find = if any { Accel::any_hit } else { Accel::closest };
    let hits = |(ray, interval): &&Sent| find(accel, shapes, ray, *interval, &mut Silent).is_some();
    rays.iter().filter(hits).count()
}

fn in_bundles(accel: &Accel, shapes: &[Shape], rays: &[Sent], any: bool) -> usize {
    let (mut closest, mut blocked) = ([None::<Hit>; BUNDLE], [false; BUNDLE]);
    let ask = |rays: &[Sent]| {
        if any {
            accel.occluded_many(shapes, rays, &mut blocked);
            blocked[..rays.len()].iter().filter(|&&hit| hit).count()
        } else {
            accel.closest_many(shapes, rays, &mut closest);
            closest[..rays.len()].iter().flatten().count()
        }
    };
    rays.chunks(BUNDLE).map(ask).sum()
}

fn seconds<T>(run: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = run();
    (start.elapsed().as_secs_f64(), black_box(result))
}

/// What is said of a mesh: a table of build times, memory and rays a second.
pub fn measure(mesh: &str, triangles: &[Triangle]) -> String {
    let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
    let (all, mut rows) = contestants(triangles, &shapes);
    let mut head = vec![
        format!("{mesh}: {} triangles", triangles.len()),
        "build".to_string(),
        "bytes a triangle".to_string(),
    ];
    let wide = Accel::build(AccelKind::Wide, &shapes);
    for kind in kinds(&wide, &shapes) {
        head.push(format!("{}, Mrays/s (x)", kind.name));
        for (row, (rate, ratio)) in rows.iter_mut().zip(compare(&all, &shapes, &kind)) {
            row.push(format!("{rate:.2} ({ratio:.2})"));
        }
    }
    markdown(&head, &rows)
}

/// Everything that can be asked, with the first columns of its row: the time of building, as a ratio to the first
/// peer's, and memory.
fn contestants(triangles: &[Triangle], shapes: &[Shape]) -> (Vec<Contestant>, Vec<Vec<String>>) {
    let (mut all, mut rows) = (Vec::new(), Vec::new());
    let reference = || seconds(|| Peer::build(NAMES[0], triangles)).0;
    let mut add = |contestant: Contestant, ratios: Vec<f64>, bytes: Option<usize>| {
        let bytes = bytes.map_or_else(String::new, |b| (b / triangles.len()).to_string());
        rows.push(vec![
            contestant.name(),
            format!("{:.2}", median(ratios)),
            bytes,
        ]);
        all.push(contestant);
    };
    // `RAYTREE_WHO=wide,kd` asks only those whose names contain one of these, next to the first peer.
    let who = std::env::var("RAYTREE_WHO").unwrap_or_default();
    let is_asked = |name: &str| name == NAMES[0] || who.split(',').any(|w| name.contains(w));
    for name in NAMES.into_iter().filter(|name| is_asked(name)) {
        let build = || seconds(|| Peer::build(name, triangles)).0;
        let ratios = (0..ROUNDS).map(|_| build() / reference()).collect();
        add(
            Contestant::Peer(name, Peer::build(name, triangles)),
            ratios,
            None,
        );
    }
    for kind in AccelKind::ALL {
        if !is_asked(kind.name()) {
            continue;
        }
        if kind == AccelKind::List && shapes.len() > LIST_LIMIT {
            continue;
        }
        let build = || seconds(|| Accel::build(kind, shapes)).0;
        let ratios: Vec<f64> = (0..ROUNDS).map(|_| build() / reference()).collect();
        let accel = Accel::build(kind, shapes);
        let bytes = accel.stats().bytes;
        if accel.gains_from_packets() {
            add(
                Contestant::Bundles(kind, accel.clone()),
                ratios.clone(),
                Some(bytes),
            );
        }
        add(Contestant::Ours(kind, accel), ratios, Some(bytes));
    }
    (all, rows)
}

/// Millions of rays a second of each, and how many times as fast as the first it is: medians of rounds in turns.
fn compare(all: &[Contestant], shapes: &[Shape], kind: &Kind) -> Vec<(f64, f64)> {
    let count = kind.rays.len();
    // Who is slow by a first look gets a part of the rays, spread over the picture.
    let look: Vec<Sent> = kind.rays.iter().copied().step_by(64).collect();
    let least = |c: &Contestant| {
        let run = c.run(shapes, &look, kind.any);
        (0..2)
            .map(|_| seconds(&run).0)
            .fold(f64::INFINITY, f64::min)
    };
    let first = least(&all[0]);
    let part: Vec<Sent> = kind
        .rays
        .chunks(BUNDLE)
        .step_by(8)
        .flatten()
        .copied()
        .collect();
    let runs: Vec<_> = all
        .iter()
        .map(|c| {
            if least(c) > SLOW * first {
                (c.run(shapes, &part, kind.any), part.len())
            } else {
                (c.run(shapes, &kind.rays, kind.any), count)
            }
        })
        .collect();
    let hits = runs[0].0();
    let mut times = vec![Vec::new(); runs.len()];
    for _ in 0..ROUNDS {
        for ((run, rays), times) in runs.iter().zip(&mut times) {
            let (time, found) = seconds(run);
            // Single precision loses or invents a few.
            assert!(
                *rays < count || found.abs_diff(hits) <= count / 1000,
                "{found} {hits}"
            );
            times.push(time / *rays as f64);
        }
    }
    times
        .iter()
        .map(|own| {
            let ratios = times[0].iter().zip(own).map(|(first, own)| first / own);
            (1e-6 / median(own.iter().copied()), median(ratios))
        })
        .collect()
}
