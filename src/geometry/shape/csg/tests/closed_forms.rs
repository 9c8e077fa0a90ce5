//! Volumes and areas by mean span length, against closed forms.

use std::f64::consts::PI;

use super::*;

/// The volume by a pencil of n x n parallel rays, one at random in each cell of a square around the origin with sides of 2 half,
/// seen along `direction`.
fn volume(solid: &Csg, direction: DVec3, half: f64, n: u32) -> f64 {
    let mut random = TestRays(41);
    let frame = crate::math::Frame::around(direction);
    let cell = 2.0 * half / f64::from(n);
    let mut length = 0.0;
    for i in 0..n {
        for j in 0..n {
            let place = |k: u32, r: f64| (f64::from(k) + r) * cell - half;
            let (x, y) = (place(i, random.unit()), place(j, random.unit()));
            let origin = x * frame.u + y * frame.v - 5.0 * direction;
            length += solid.spans(&Ray::new(origin, direction)).length();
        }
    }
    length * cell * cell
}

/// Solids with volumes known on paper, and half the side of a square that they are within, seen from anywhere.
fn known() -> Vec<(&'static str, Csg, f64, f64)> {
    let ball_at = |x: f64| ball([x, 0.0, 0.0], 1.0);
    let (a, b) = (|| ball_at(-0.5), || ball_at(0.5));
    // Two unit balls 1 apart have 5 pi / 12 in common; each has 4 pi / 3.
    let lens = 5.0 * PI / 12.0;
    let whole = 4.0 * PI / 3.0;
    // A unit cube's corner cut off by the plane through its neighbours: 1 - 1 / 6.
    let corner = behind([0.5, 0.5, -0.5], DVec3::ONE.normalize());
    let unit = || cube([-0.5; 3], [0.5; 3]);
    // A die: a cube of side 2 within a ball of radius s, whose six caps of height h = s - 1 stand out of the cube. (They do not
    // overlap for s <= sqrt 2.)
    let s = 1.375;
    let h = s - 1.0;
    let die = 4.0 / 3.0 * PI * s * s * s - 6.0 * PI * h * h * (3.0 * s - h) / 3.0;
    let cube_2 = || cube([-1.0; 3], [1.0; 3]);
    vec![
        ("lens", csg(op(Common, [a(), b()])), lens, 1.0),
        ("moon", csg(op(Difference, [a(), b()])), whole - lens, 1.5),
        ("twins", csg(op(Union, [a(), b()])), 2.0 * whole - lens, 1.5),
        ("corner", csg(op(Common, [unit(), corner])), 5.0 / 6.0, 0.9),
        (
            "die",
            csg(op(Common, [cube_2(), ball([0.0; 3], s)])),
            die,
            1.4,
        ),
        (
            "holed",
            csg(op(Difference, [cube_2(), ball([0.0; 3], s)])),
            8.0 - die,
            1.8,
        ),
    ]
}

#[test]
fn volumes_are_those_of_closed_forms() {
    for (name, solid, expected, half) in known() {
        for direction in [DVec3::X, DVec3::new(0.48, 0.6, -0.64)] {
            let found = volume(&solid, direction, half, 100);
            let off = (found / expected - 1.0).abs();
            assert!(
                off < 4e-3,
                "{name}: {found} instead of {expected}, off by {off:e}"
            );
        }
    }
}

#[test]
fn volumes_come_nearer_with_more_rays() {
    for (name, solid, expected, half) in known() {
        let direction = DVec3::new(0.48, 0.6, -0.64);
        let off = [125, 500].map(|n| volume(&solid, direction, half, n) / expected - 1.0);
        // With four times as many rays along each side.
        assert!(
            off[0].abs() < 3e-3 && off[1].abs() < 3e-4,
            "{name}: {off:?}"
        );
    }
}
