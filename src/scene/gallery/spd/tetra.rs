//! A tetrahedron of tetrahedra of tetrahedra: much emptiness between few rays that meet anything.

use super::{Finish, Kind, Spd, Viewpoint};
use crate::math::DVec3;

pub const KIND: Kind = Kind {
    name: "spd:tetra",
    note: "Haines' pyramid of pyramids: mostly empty space.",
    size: 6,
    count: |size| 4u64.saturating_pow(size),
    build,
    view: Viewpoint {
        from: [1.022_846, -3.177_154, -2.174_512],
        at: [-0.004_103, -0.004_103, 0.216_539],
        up: [-0.816_497, -0.816_497, 0.816_497],
        lights: &[[2.0, -18.0, -5.0]],
    },
};

/// Every other corner of a cube: those of a tetrahedron.
const CORNERS: [[f64; 3]; 4] = [
    [-1.0, -1.0, 1.0],
    [-1.0, 1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, 1.0],
];

fn build(spd: &mut Spd, size: u32) {
    let red = spd.material(
        "red",
        &Finish {
            color: [1.0, 0.2, 0.2],
            ..Finish::MATT
        },
    );
    spd.begin("tetrahedra", red);
    grow(spd, DVec3::ZERO, 1.0, size);
}

/// A tetrahedron in the cube around `center` with half the edge `half`: four in its corners, or its four faces.
fn grow(spd: &mut Spd, center: DVec3, half: f64, depth: u32) {
    if depth > 1 {
        for corner in CORNERS {
            let center = center + DVec3::from(corner) * half / 2.0;
            grow(spd, center, half / 2.0, depth - 1);
        }
        return;
    }
    let [a, b, c, d] = CORNERS.map(|corner| center + DVec3::from(corner) * half);
    for face in [[a, b, c], [d, c, b], [c, d, a], [b, a, d]] {
        spd.triangle(face);
    }
}
