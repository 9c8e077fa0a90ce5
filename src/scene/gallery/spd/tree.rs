//! A tree of cones on a field under seven lights.
//!
//! Source: Aono and Kunii 1984, "Botanical tree image generation", IEEE CG&A 4(5).

use glam::{DAffine3, DMat3};

use super::{Finish, Kind, SIDES, Spd, Viewpoint, geometric_sum, turn};
use crate::math::DVec3;

pub const KIND: Kind = Kind {
    name: "spd:tree",
    note: "Haines' tree: thin branches under seven lights.",
    size: 11,
    count: |size| {
        let each = 1 + 2 * u64::from(SIDES);
        geometric_sum(2, size)
            .saturating_mul(each)
            .saturating_add(2)
    },
    build,
    view: Viewpoint {
        from: [4.5, 0.4, 2.0],
        at: [0.0, 0.0, 1.5],
        up: [0.0, 0.0, 1.0],
        lights: &[
            [-5.0, 5.0, 50.0],
            [30.0, -30.0, 30.0],
            [-40.0, -30.0, 20.0],
            [10.0, 30.0, 40.0],
            [-30.0, 40.0, 10.0],
            [50.0, 25.0, 20.0],
            [-10.0, -60.0, 30.0],
        ],
    },
};

/// For each of the two branches at a fork: the angle between them and the stem, the turn about it (degrees), and
/// their length as a part of its.
const FORK: [[f64; 3]; 2] = [[40.0, 90.0, 0.65], [25.0, 230.0, 0.70]];
/// A branch's end, and its child's base, in parts of its own base.
const TAPER: f64 = 0.67;
/// The radius of the trunk at its base.
const THICKNESS: f64 = 0.15;

fn build(spd: &mut Spd, size: u32) {
    let grass = Finish {
        color: [0.2, 0.7, 0.2],
        ..Finish::MATT
    };
    let grass = spd.material("grass", &grass);
    let bark = Finish {
        color: [0.55, 0.4, 0.2],
        ..Finish::MATT
    };
    let bark = spd.material("bark", &bark);
    spd.begin("field", grass);
    let corners = [[50.0, 50.0], [-50.0, 50.0], [-50.0, -50.0], [50.0, -50.0]];
    spd.quad(corners.map(|[x, y]| DVec3::new(x, y, 0.0)));

    let forks = FORK.map(|[angle, around, length]| {
        let bent = turn(DVec3::Z, around.to_radians()) * turn(DVec3::X, angle.to_radians());
        DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::splat(length)) * bent,
            translation: DVec3::Z,
        }
    });
    let mut branches = Vec::new();
    grow(&mut branches, &forks, DAffine3::IDENTITY, THICKNESS, size);
    spd.begin("branches", bark);
    for &(base, apex, radius) in &branches {
        spd.tube((base, radius), (apex, radius * TAPER));
    }
    spd.begin("joints", bark);
    for (_, apex, radius) in branches {
        spd.sphere(apex, radius * TAPER);
    }
}

/// A branch and all that grow on it, as base, apex and radius of the base.
fn grow(
    branches: &mut Vec<(DVec3, DVec3, f64)>,
    forks: &[DAffine3; 2],
    place: DAffine3,
    radius: f64,
    depth: u32,
) {
    let apex = place.transform_point3(DVec3::Z);
    branches.push((place.translation, apex, radius));
    if let Some(depth) = depth.checked_sub(1) {
        for fork in forks {
            grow(branches, forks, place * *fork, radius * TAPER, depth);
        }
    }
}
