//! The scene `slanted`, in which nothing runs along an axis: crates on a slope, leaning fences and reeds.
//!
//! Planes along the axes fit turned boxes and long diagonal triangles badly, planes at any angle well: what a BSP tree
//! can do and a kd-tree cannot.

use super::builder::{SceneBuilder, matt};
use crate::math::{DVec3, Rgb};
use crate::sampling::stream::{splitmix64, to_unit_f64};
use crate::scene::{Camera, Scene, Settings};
use crate::shading::Material;

/// Its name.
pub const NAME: &str = "slanted";
/// What it shows.
pub const NOTE: &str =
    "Turned boxes and long diagonal triangles: where planes along the axes fit badly.";

/// Numbers of crates, fences, slats of a fence, tufts, and reeds of a tuft.
const CRATES: u64 = 50;
const FENCES: u64 = 7;
const SLATS: u64 = 13;
const TUFTS: u64 = 12;
const REEDS: u64 = 50;

/// The scene; `None` only if its camera had no view direction.
pub fn scene() -> Option<Scene> {
    let eye = DVec3::new(1.2, 1.5, 4.4);
    let look_at = DVec3::new(0.0, 0.15, 0.0);
    let camera = Camera::new(eye, look_at, DVec3::Y, 40_f64.to_radians())?;
    let mut builder = SceneBuilder::new(NAME, camera, Settings::default());
    builder.sky(Rgb::new(0.6, 0.7, 0.8), Rgb::grey(0.3));
    builder.light(DVec3::new(4.0, 6.0, 4.0), Rgb::new(0.75, 0.7, 0.6));
    let [earth, red, wood, green] = [
        ("earth", Rgb::new(0.55, 0.5, 0.4)),
        ("red", Rgb::new(0.75, 0.3, 0.2)),
        ("wood", Rgb::new(0.75, 0.6, 0.4)),
        ("green", Rgb::new(0.35, 0.55, 0.25)),
    ]
    .map(|(name, color)| builder.material(plain(name, color)));

    builder.begin("slope", earth);
    let corners = [[-3.0, 3.0], [3.0, 3.0], [3.0, -3.0], [-3.0, -3.0]];
    builder.quad(corners.map(|[x, z]| slope(x, z)));

    builder.begin("crates", red);
    for i in 0..CRATES {
        let at = 1.7 * random(i, 0);
        let center = slope(at.x, at.z) + DVec3::Y * (0.35 + 0.25 * at.y / 1.7);
        let size = DVec3::splat(0.09) + 0.04 * random(i, 1);
        let [u, v, w] = turned(random(i, 2), random(i, 3));
        block(&mut builder, center, [size.x * u, size.y * v, size.z * w]);
    }

    builder.begin("fences", wood);
    for i in CRATES..CRATES + FENCES {
        let at = 1.5 * random(i, 0);
        let lean = DVec3::Y + 0.5 * random(i, 2);
        let [up, along, through] = turned(lean, random(i, 1));
        for slat in 0..SLATS {
            let step = 0.09 * (slat as f64 - 0.5 * (SLATS - 1) as f64);
            let center = slope(at.x, at.z) + 0.45 * up + step * along;
            let half = [0.5 * up, 0.03 * along, 0.01 * through];
            block(&mut builder, center, half);
        }
    }

    builder.begin("reeds", green);
    let wind = DVec3::new(0.8, 1.0, 0.45);
    for i in CRATES + FENCES..CRATES + FENCES + TUFTS {
        let at = 1.8 * random(i, 0);
        for reed in 0..REEDS {
            let spread = 0.25 * random(i * REEDS + reed, 1);
            let root = slope(at.x + spread.x, at.z + spread.z);
            let tip = root + 1.3 * (wind + 0.12 * random(i * REEDS + reed, 2));
            let side = 0.02
                * wind
                    .cross(random(i * REEDS + reed, 3))
                    .normalize_or(DVec3::X);
            builder.triangle([root - side, root + side, tip]);
        }
    }
    Some(builder.finish())
}

/// Point of the slope at x and z.
fn slope(x: f64, z: f64) -> DVec3 {
    DVec3::new(x, -0.35 - 0.3 * x + 0.2 * z, z)
}

/// A box with these three half edges.
fn block(builder: &mut SceneBuilder, center: DVec3, half: [DVec3; 3]) {
    for k in 0..3 {
        for side in [1.0, -1.0] {
            let (n, a, b) = (side * half[k], half[(k + 1) % 3], side * half[(k + 2) % 3]);
            let corners = [n - a - b, n + a - b, n + a + b, n - a + b];
            builder.quad(corners.map(|corner| center + corner));
        }
    }
}

/// Three unit vectors at right angles, the first along `u`.
fn turned(u: DVec3, v: DVec3) -> [DVec3; 3] {
    let u = u.normalize_or(DVec3::X);
    let w = u.cross(v).normalize_or(u.any_orthonormal_vector());
    [u, w.cross(u), w]
}

/// Pseudo-random point in the cube from -1 to 1, a hash of the two numbers.
fn random(of: u64, which: u64) -> DVec3 {
    let coordinate = |k: u64| 2.0 * to_unit_f64(splitmix64(splitmix64(4 * of + which) + k)) - 1.0;
    DVec3::new(coordinate(0), coordinate(1), coordinate(2))
}

/// Material with a faint highlight.
fn plain(name: &str, color: Rgb) -> Material {
    Material {
        specular: Rgb::grey(0.1),
        shininess: 20.0,
        ..matt(name, color)
    }
}
