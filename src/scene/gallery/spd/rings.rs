//! A pyramid of balls, each woven of six rings of five tubes, before a wall.

use std::f64::consts::PI;

use super::{Finish, Kind, SIDES, Spd, Viewpoint, turn};
use crate::math::DVec3;

pub const KIND: Kind = Kind {
    name: "spd:rings",
    note: "Haines' pyramid of woven rings: dull mirrors deep behind each other.",
    size: 7,
    // 30 tubes and 30 joints for each of 1 + 4 + 9 + ... balls; the wall.
    count: |size| {
        let n = u64::from(size);
        let woven = n.saturating_mul(n + 1).saturating_mul(2 * n + 1) / 6;
        let each = 30 * (1 + 2 * u64::from(SIDES));
        woven.saturating_mul(each).saturating_add(2)
    },
    build,
    view: Viewpoint {
        from: [-1.0, -SPREAD, 0.5],
        at: [-1.0, 1.0 - SPREAD, 0.5],
        up: [0.0, 0.0, 1.0],
        lights: &[
            [3.0, -SPREAD, 3.0],
            [-4.0, -SPREAD, 1.0],
            [2.0, -SPREAD, -4.0],
        ],
    },
};

/// From one layer of balls to the next: 1 / sin(pi / 8).
const SPREAD: f64 = 2.613_125_929_752_753;
/// Of tubes and joints.
const RADIUS: f64 = 0.07412;

/// The six colours of the rings.
const COLORS: [(&str, [f64; 3]); 6] = [
    ("red", [1.0, 0.0, 0.0]),
    ("green", [0.0, 1.0, 0.0]),
    ("blue", [0.0, 0.0, 1.0]),
    ("cyan", [0.0, 1.0, 1.0]),
    ("magenta", [1.0, 0.0, 1.0]),
    ("yellow", [1.0, 1.0, 0.0]),
];

fn build(spd: &mut Spd, size: u32) {
    let white = spd.material("wall", &Finish::MATT);
    spd.begin("wall", white);
    // It just fills the picture.
    let far = SPREAD * f64::from(size + 1);
    let half = 1.01 * (far + SPREAD) * libm::tan(PI / 8.0);
    let corners = [[half, half], [-half, half], [-half, -half], [half, -half]];
    spd.quad(corners.map(|[x, z]| DVec3::new(x - 1.0, far, z + 0.5)));

    let centers = centers(size);
    for (number, (color, rgb)) in COLORS.into_iter().enumerate() {
        let material = spd.material(
            color,
            &Finish {
                color: rgb,
                diffuse: 0.5,
                mirror: 0.2,
                highlight: 0.3,
                angle: 37.0,
                ..Finish::MATT
            },
        );
        let ring = ring(number);
        spd.begin(format!("tubes {color}"), material);
        for &center in &centers {
            for (&base, &apex) in ring.iter().zip(ring.iter().cycle().skip(4)) {
                spd.tube((center + base, RADIUS), (center + apex, RADIUS));
            }
        }
        spd.begin(format!("joints {color}"), material);
        for &center in &centers {
            for corner in ring {
                spd.sphere(center + corner, RADIUS);
            }
        }
    }
}

/// Centres of the balls: one in front, then four, then nine and so on.
fn centers(size: u32) -> Vec<DVec3> {
    let at = |depth: u32, i: u32| f64::from(2 * i) - f64::from(depth);
    (0..size)
        .flat_map(|depth| (0..=depth).map(move |z| (depth, z)))
        .flat_map(|(depth, z)| (0..=depth).map(move |x| (depth, x, z)))
        .map(|(d, x, z)| DVec3::new(at(d, x), SPREAD * f64::from(d + 1), at(d, z)))
        .collect()
}

/// The corners of one of six pentagons around the origin, in planes like the faces of a dodecahedron.
fn ring(number: usize) -> [DVec3; 5] {
    let scale = 1.0 / (1.0 + RADIUS);
    let corners = [0.0, 1.0, 2.0, 3.0, 4.0].map(|i| {
        let angle = i * 2.0 * PI / 5.0;
        scale * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
    });
    let Some(number) = number.checked_sub(1) else {
        return corners;
    };
    let between_faces = 2.0 * libm::acos(libm::cos(PI / 3.0) / libm::sin(PI / 5.0));
    let tilt = turn(DVec3::X, between_faces);
    let around = turn(DVec3::Z, PI * (2.0 * number as f64 + 1.0) / 5.0);
    corners.map(|p| around * (tilt * p))
}
