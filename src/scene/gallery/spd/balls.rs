//! A ball with nine balls on it, each with nine balls on it: the sphere flake. Mirrors before a floor.

use std::f64::consts::{PI, TAU};

use glam::DMat3;

use super::{Finish, Kind, Spd, Viewpoint, geometric_sum, turn};
use crate::math::DVec3;

pub const KIND: Kind = Kind {
    name: "spd:balls",
    note: "Haines' sphere flake: mirrors that see each other.",
    size: 4,
    count: |size| geometric_sum(9, size).saturating_add(2),
    build,
    view: Viewpoint {
        from: [2.1, 1.3, 1.7],
        at: [0.0; 3],
        up: [0.0, 0.0, 1.0],
        lights: &[[4.0, 3.0, 2.0], [1.0, -4.0, 4.0], [-3.0, 1.0, 5.0]],
    },
};

/// A ball's children have a third of its radius.
const RATIO: f64 = 1.0 / 3.0;

fn build(spd: &mut Spd, size: u32) {
    let floor = spd.material(
        "floor",
        &Finish {
            color: [1.0, 0.75, 0.33],
            diffuse: 0.8,
            ..Finish::MATT
        },
    );
    let mirror = spd.material(
        "mirror",
        &Finish {
            color: [1.0, 0.9, 0.7],
            diffuse: 0.5,
            mirror: 0.5,
            highlight: 0.5,
            angle: 37.0,
            ..Finish::MATT
        },
    );
    spd.begin("floor", floor);
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    spd.quad(corners.map(|[x, y]| DVec3::new(12.0 * x, 12.0 * y, -0.5)));
    spd.begin("balls", mirror);
    ball(spd, &children(), (DVec3::ZERO, 0.5), DVec3::Z, size);
}

/// The directions of the nine children of a ball that points to +z: six around its waist, three above.
fn children() -> Vec<DVec3> {
    let d = 1.0 / 2.0_f64.sqrt();
    let trio = [
        DVec3::new(d, d, 0.0),
        DVec3::new(d, 0.0, -d),
        DVec3::new(0.0, d, -d),
    ];
    let tilt = turn(DVec3::new(d, -d, 0.0), libm::asin(2.0 / 6.0_f64.sqrt()));
    (0..3)
        .map(|third| turn(DVec3::Z, f64::from(third) * TAU / 3.0))
        .flat_map(|around| trio.map(|p| around * (tilt * p)))
        .collect()
}

/// Puts in a ball that points away from its parent, then its children, `depth` generations of them.
fn ball(spd: &mut Spd, set: &[DVec3], (center, radius): (DVec3, f64), towards: DVec3, depth: u32) {
    spd.sphere(center, radius);
    let Some(depth) = depth.checked_sub(1) else {
        return;
    };
    let turned = if towards.z >= 0.9999 {
        DMat3::IDENTITY
    } else if towards.z <= -0.9999 {
        turn(DVec3::Y, PI)
    } else {
        turn(DVec3::Z.cross(towards).normalize(), libm::acos(towards.z))
    };
    for &direction in set {
        let direction = turned * direction;
        let place = center + direction * radius * (1.0 + RATIO);
        ball(spd, set, (place, radius * RATIO), direction, depth);
    }
}
