//! The wide tree, one ray at a time and in bundles, against the other crate: a picture's rays in the order of its
//! tiles, their shadow rays and one bounce of each.

use std::hint::black_box;
use std::time::Instant;

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Hit, Shape, Triangle};
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::Silent;

use super::Other;

/// Pixels on each side.
const SIZE: usize = 1024;

/// Rays that the tracer would ask for at once: a tile's.
const BUNDLE: usize = 256;

/// How often each contestant runs.
const ROUNDS: usize = 5;

type Sent = (Ray, Interval);

/// One ray for each pixel: tiles of 16 x 16, in them blocks of 4 x 4.
fn primary() -> Vec<Sent> {
    let eye = DVec3::new(0.4, 0.7, 3.0);
    let w = eye.normalize();
    let u = DVec3::Y.cross(w).normalize();
    let v = w.cross(u);
    let tiles = SIZE / 16;
    (0..SIZE * SIZE)
        .map(|i| {
            let (tile, block, pixel) = (i / 256, i / 16 % 16, i % 16);
            let x = tile % tiles * 16 + block % 4 * 4 + pixel % 4;
            let y = tile / tiles * 16 + block / 4 * 4 + pixel / 4;
            let at = |p: usize| 0.8 * ((p as f64 + 0.5) / SIZE as f64 - 0.5);
            let direction = (at(x) * u - at(y) * v - w).normalize();
            (Ray::new(eye, direction), Interval::FORWARD)
        })
        .collect()
}

/// Where the rays end: a point a little above the surface, and the normal on its side.
fn ends(accel: &Accel, shapes: &[Shape], rays: &[Sent]) -> Vec<(DVec3, DVec3)> {
    let end = |(ray, interval): &Sent| {
        let hit = accel.closest(shapes, ray, *interval, &mut Silent)?;
        let shape = &shapes[hit.primitive as usize];
        let normal = shape.surface(ray, hit.t, hit.barycentric).normal;
        let normal = if normal.dot(ray.direction) < 0.0 {
            normal
        } else {
            -normal
        };
        Some((ray.at(hit.t * (1.0 - 1e-4)), normal))
    };
    rays.iter().filter_map(end).collect()
}

fn shadow(ends: &[(DVec3, DVec3)]) -> Vec<Sent> {
    let light = DVec3::new(4.0, 3.0, 1.0);
    let send = |(origin, _): &(DVec3, DVec3)| {
        let way = light - *origin;
        (
            Ray::new(*origin, way.normalize()),
            Interval::before(way.length()),
        )
    };
    ends.iter().map(send).collect()
}

/// Into the hemisphere above each point, by the cosine: to a random point of the unit sphere around the normal's tip.
fn bounce(ends: &[(DVec3, DVec3)]) -> Vec<Sent> {
    let random = |seed: u64| {
        let z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    };
    let send = |(i, (origin, normal)): (usize, &(DVec3, DVec3))| {
        let (z, phi) = (
            2.0 * random(2 * i as u64 + 1) - 1.0,
            std::f64::consts::TAU * random(2 * i as u64 + 2),
        );
        let r = (1.0 - z * z).max(0.0).sqrt();
        let on = DVec3::new(r * libm::cos(phi), r * libm::sin(phi), z);
        (
            Ray::new(*origin, (*normal + on).normalize_or(*normal)),
            Interval::FORWARD,
        )
    };
    ends.iter().enumerate().map(send).collect()
}

/// The middle of some numbers.
fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn seconds<T>(run: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = run();
    (start.elapsed().as_secs_f64(), black_box(result))
}

/// Prints rays a second, and the median of the ratios that were taken in turns.
pub fn table(meshes: &[(&str, Vec<Triangle>)]) {
    for (mesh, triangles) in meshes {
        let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
        let mut ratios = Vec::new();
        for _ in 0..ROUNDS {
            let (theirs, _) = seconds(|| Other::build(triangles));
            let (ours, _) = seconds(|| Accel::build(AccelKind::Wide, &shapes));
            ratios.push(ours / theirs);
        }
        let (accel, other) = (
            Accel::build(AccelKind::Wide, &shapes),
            Other::build(triangles),
        );
        let stats = accel.stats();
        println!(
            "{mesh}: {} triangles, {} bytes each, built in {:.2} of the time of obvhs medium",
            triangles.len(),
            stats.bytes / triangles.len(),
            median(ratios)
        );
        let primary = primary();
        let ends = ends(&accel, &shapes, &primary);
        for (kind, rays) in [
            ("primary", primary),
            ("shadow", shadow(&ends)),
            ("bounce", bounce(&ends)),
        ] {
            compare(kind, &accel, &other, &shapes, &rays);
        }
    }
}

fn compare(kind: &str, accel: &Accel, other: &Other, shapes: &[Shape], rays: &[Sent]) {
    let shadow = kind == "shadow";
    let theirs: Vec<_> = rays.iter().map(Other::ray).collect();
    let reference = || {
        let hits = |&&ray: &&obvhs::ray::Ray| {
            if shadow {
                other.any(ray)
            } else {
                other.closest(ray)
            }
        };
        theirs.iter().filter(hits).count()
    };
    let single = || {
        let find = if shadow { Accel::any } else { Accel::closest };
        let hits =
            |(ray, interval): &&Sent| find(accel, shapes, ray, *interval, &mut Silent).is_some();
        rays.iter().filter(hits).count()
    };
    let bundles = || {
        let (mut closest, mut any) = ([None::<Hit>; BUNDLE], [false; BUNDLE]);
        let mut hits = 0;
        for rays in rays.chunks(BUNDLE) {
            if shadow {
                accel.any_many(shapes, rays, &mut any);
                hits += any[..rays.len()].iter().filter(|&&hit| hit).count();
            } else {
                accel.closest_many(shapes, rays, &mut closest);
                hits += closest[..rays.len()].iter().flatten().count();
            }
        }
        hits
    };
    let (mut times, mut hits) = ([const { Vec::new() }; 3], [0; 3]);
    for _ in 0..ROUNDS {
        for (i, (time, count)) in [seconds(reference), seconds(single), seconds(bundles)]
            .into_iter()
            .enumerate()
        {
            times[i].push(time);
            hits[i] = count;
        }
    }
    for (i, name) in ["obvhs", "wide", "wide, bundles"].into_iter().enumerate() {
        let ratios = times[0]
            .iter()
            .zip(&times[i])
            .map(|(theirs, ours)| theirs / ours);
        println!(
            "  {kind:8} {name:14} {:7.2} Mrays/s {:6.2} of obvhs  {} of {} hit",
            rays.len() as f64 / median(times[i].clone()) / 1e6,
            median(ratios.collect()),
            hits[i],
            rays.len(),
        );
    }
}
