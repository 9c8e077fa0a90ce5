//! A fractal mountain and four glass balls above it.
//!
//! Source of the mountain: Fournier, Fussell and Carpenter 1982, "Computer rendering of stochastic models".

use std::f64::consts::TAU;

use super::{Finish, Kind, Spd, Viewpoint, turn};
use crate::math::DVec3;

pub const KIND: Kind = Kind {
    name: "spd:mount",
    note: "Haines' fractal mountain, and glass balls above it.",
    size: 6,
    count: |size| {
        4u64.saturating_pow(size)
            .saturating_mul(2)
            .saturating_add(4)
    },
    build,
    view: Viewpoint {
        from: [-1.6, 1.6, 1.7],
        at: [0.0; 3],
        up: [0.0, 0.0, 1.0],
        lights: &[[-100.0, -100.0, 100.0]],
    },
};

/// Between 2, smooth, and 3, wild.
const FRACTAL_DIMENSION: f64 = 2.2;
/// Which mountain of all.
const SEED: u64 = 21;
/// The mountain stands on x and y from -1 to 1.
const WIDTH: f64 = 2.0;

fn build(spd: &mut Spd, size: u32) {
    let glass = spd.material(
        "glass",
        &Finish {
            diffuse: 0.1,
            mirror: 0.1,
            highlight: 0.4,
            angle: 6.7,
            transmission: 0.9,
            ior: 1.5,
            ..Finish::MATT
        },
    );
    balls(spd, glass);
    let rock = spd.material(
        "rock",
        &Finish {
            color: [0.5, 0.45, 0.35],
            ..Finish::MATT
        },
    );
    spd.begin("mountain", rock);
    let ratio = 2.0 / libm::exp(libm::log(2.0) / (FRACTAL_DIMENSION - 1.0));
    let mountain = Mountain {
        size,
        spacing: WIDTH / f64::from(1u32 << size),
        roughness: (ratio * ratio - 1.0).sqrt(),
    };
    mountain.grow(spd, [0, 0], 1 << size, [0.0; 4]);
}

/// Four balls that touch: the corners of a tetrahedron.
fn balls(spd: &mut Spd, glass: u32) {
    let (center, radius) = (DVec3::new(-0.8, 0.8, 1.0), 0.17);
    let top = DVec3::Z * radius * 1.5_f64.sqrt();
    let d = 1.0 / 2.0_f64.sqrt();
    let lower = turn(DVec3::new(d, d, 0.0), libm::acos(-1.0 / 3.0)) * top;
    let thirds = [0.0, 1.0, 2.0].map(|third| turn(DVec3::Z, third * TAU / 3.0) * lower);
    for (i, offset) in [top].into_iter().chain(thirds).enumerate() {
        spd.begin(format!("ball {}", i + 1), glass);
        spd.sphere(center + offset, radius);
    }
}

/// How the mountain grows.
struct Mountain {
    size: u32,
    /// Between two points of the finest grid.
    spacing: f64,
    roughness: f64,
}

impl Mountain {
    /// A square, its lower left corner at grid point (x, y), its four heights counter-clockwise from there: cut into
    /// four, the new points shifted up or down by chance, or put in as two triangles.
    fn grow(&self, spd: &mut Spd, [x, y]: [u32; 2], width: u32, [a, b, c, d]: [f64; 4]) {
        if width == 1 {
            let point = |x, y, z| {
                let coordinate = |i: u32| f64::from(i) * self.spacing - 1.0;
                DVec3::new(coordinate(x), coordinate(y), z)
            };
            let (p, q) = (point(x, y, a), point(x + 1, y, b));
            let (r, s) = (point(x + 1, y + 1, c), point(x, y + 1, d));
            spd.triangle([p, q, r]);
            spd.triangle([r, s, p]);
            return;
        }
        let half = width / 2;
        let rise = f64::from(half) * self.spacing * self.roughness;
        // The shift of a point on an edge depends on its grid point alone, so that the neighbour gets the same height.
        let shift = |dx, dy| rise * gauss(SEED + self.hash(x + dx, y + dy));
        let low = f64::midpoint(a, b) + shift(half, 0);
        let right = f64::midpoint(b, c) + shift(width, half);
        let up = f64::midpoint(c, d) + shift(half, width);
        let left = f64::midpoint(d, a) + shift(0, half);
        let middle = (a + b + c + d) / 4.0 + std::f64::consts::SQRT_2 * shift(half, half);
        self.grow(spd, [x, y], half, [a, low, middle, left]);
        self.grow(spd, [x + half, y], half, [low, b, right, middle]);
        self.grow(spd, [x + half, y + half], half, [middle, right, c, up]);
        self.grow(spd, [x, y + half], half, [left, middle, up, d]);
    }

    /// The original's hash of a grid point. Larger mountains than it was made for keep its smallest shifts.
    fn hash(&self, x: u32, y: u32) -> u64 {
        let shifted = |n: u32, by: u32| u64::from(n) << by.saturating_sub(self.size);
        (shifted(x, 23) + shifted(y, 15) + shifted(x, 7)) & 0xffff
    }
}

/// A normally distributed number, by the original's own generator.
/// Source: Marsaglia and Bray 1964, "A convenient method for generating normal variables".
fn gauss(seed: u64) -> f64 {
    const MODULUS: u64 = 134_456;
    let next = |x: u64| (28_411 + x * 8121) % MODULUS;
    let unit = |x: u64| x as f64 * 2.0 / MODULUS as f64 - 1.0;
    let mut state = seed;
    loop {
        let (first, second) = (next(state), next(next(state)));
        state = second;
        let (v1, v2) = (unit(first), unit(second));
        let r = v1 * v1 + v2 * v2;
        if r < 1.0 && r > 0.0 {
            return v1 * (-2.0 * libm::log(r) / r).sqrt();
        }
    }
}
