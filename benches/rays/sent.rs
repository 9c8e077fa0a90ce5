//! The rays: those of a picture of 1024 x 1024 pixels in the order of its tiles, the shadow ray and one diffuse
//! bounce of each that hits, and the bounces in no order at all.

use raytree::accel::Accel;
use raytree::geometry::Shape;
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::Silent;

/// A ray and the part of it that counts.
pub type Sent = (Ray, Interval);

/// Pixels on each side.
const SIZE: usize = 1024;

/// Rays of one kind.
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// Whether any hit will do.
    pub any: bool,
    /// The rays.
    pub rays: Vec<Sent>,
}

/// Every kind of ray for some shapes.
pub fn kinds(accel: &Accel, shapes: &[Shape]) -> Vec<Kind> {
    let primary = primary();
    let ends = ends(accel, shapes, &primary);
    let bounce = bounce(&ends);
    let mut shuffled = bounce.clone();
    for i in (1..shuffled.len()).rev() {
        shuffled.swap(i, (random(i as u64) * (i + 1) as f64) as usize);
    }
    let kind = |name, any, rays| Kind { name, any, rays };
    vec![
        kind("primary", false, primary),
        kind("shadow", true, shadow(&ends)),
        kind("bounce", false, bounce),
        kind("shuffled", false, shuffled),
    ]
}

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
        let normal = shape.surface(ray, hit.t, hit.place, hit.part).normal;
        let towards = if normal.dot(ray.direction) < 0.0 {
            normal
        } else {
            -normal
        };
        Some((ray.at(hit.t * (1.0 - 1e-4)), towards))
    };
    rays.iter().filter_map(end).collect()
}

fn shadow(ends: &[(DVec3, DVec3)]) -> Vec<Sent> {
    let light = DVec3::new(3.0, 3.5, 1.0);
    let send = |(origin, _): &(DVec3, DVec3)| {
        let way = light - *origin;
        let ray = Ray::new(*origin, way.normalize());
        (ray, Interval::before(way.length()))
    };
    ends.iter().map(send).collect()
}

/// Into the hemisphere above each point, by the cosine: to a random point of the unit sphere around the normal's tip.
fn bounce(ends: &[(DVec3, DVec3)]) -> Vec<Sent> {
    let send = |(i, (origin, normal)): (usize, &(DVec3, DVec3))| {
        let z = 2.0 * random(2 * i as u64 + 1) - 1.0;
        let phi = std::f64::consts::TAU * random(2 * i as u64 + 2);
        let r = (1.0 - z * z).max(0.0).sqrt();
        let on = DVec3::new(r * libm::cos(phi), r * libm::sin(phi), z);
        let direction = (*normal + on).normalize_or(*normal);
        (Ray::new(*origin, direction), Interval::FORWARD)
    };
    ends.iter().enumerate().map(send).collect()
}

/// A number in [0, 1) for each seed.
fn random(seed: u64) -> f64 {
    let z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}
