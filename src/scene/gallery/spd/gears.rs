//! A block of gear wheels that mesh, some of them of glass, over a mirroring ground.

use std::f64::consts::{PI, TAU};

use super::{Finish, Kind, Spd, Viewpoint};
use crate::math::DVec3;

pub const KIND: Kind = Kind {
    name: "spd:gears",
    note: "Haines' gear wheels: glass between many lights.",
    size: 4,
    // Top, bottom and, twice, the sides of each wheel; the ground.
    count: |size| {
        let wheels = u64::from(size).saturating_pow(3);
        wheels.saturating_mul(4 * EDGES as u64).saturating_add(2)
    },
    build,
    view: Viewpoint {
        from: [-1.1, -2.1, 2.6],
        at: [0.0; 3],
        up: [0.0, 0.0, 1.0],
        lights: &[
            [2.0, 4.0, 4.0],
            [-2.0, 4.0, 3.0],
            [2.0, -2.5, 2.5],
            [-1.0, -4.0, 2.0],
            // Just behind the eye.
            [-1.111, -2.121, 2.626],
        ],
    },
};

const TEETH: usize = 36;
/// Edges of a wheel's outline.
const EDGES: usize = 4 * TEETH;
/// The part of the radius that the teeth take.
const TOOTH: f64 = 0.1;
/// A wheel is a little smaller than its place, so that no two share a surface.
const SHRUNK: f64 = 0.995;

fn build(spd: &mut Spd, size: u32) {
    let ground = spd.material(
        "ground",
        &Finish {
            color: [1.0, 0.85, 0.7],
            diffuse: 0.3,
            mirror: 0.6,
            highlight: 0.3,
            angle: 37.0,
            ..Finish::MATT
        },
    );
    spd.begin("ground", ground);
    let corners = [[2.0, 2.0], [-2.0, 2.0], [-2.0, -2.0], [2.0, -2.0]];
    spd.quad(corners.map(|[x, y]| DVec3::new(x, y, 0.0)));

    let n = f64::from(size);
    let radius = 1.0 / (n - (n - 1.0) * TOOTH / 2.0);
    let first = DVec3::new(radius - 1.0, radius - 1.0, 1.0);
    let offset = DVec3::new(radius * (2.0 - TOOTH), radius * (2.0 - TOOTH), -1.0 / n);
    let thickness = f64::min(0.1, 1.0 / (2.0 * n));
    for iz in 0..size {
        for iy in 0..size {
            for ix in 0..size {
                let name = format!("gear {ix} {iy} {iz}");
                let material = spd.material(&name, &surface(ix, iy, iz));
                spd.begin(name, material);
                let steps = DVec3::new(f64::from(ix), f64::from(iy), f64::from(iz));
                let angle = PI * f64::from((ix + iy + iz) % 2) / TEETH as f64;
                wheel(spd, first + steps * offset, angle, radius, thickness);
            }
        }
    }
}

/// A colour that looks like chance; every fifth wheel is of glass.
fn surface(ix: u32, iy: u32, iz: u32) -> Finish {
    let shade = |a: u32, b: u32, c: u32, factor: f64| {
        let x = f64::from(a * 3 + b * 2 + c + 1) * factor / 7.0;
        0.01 + x.fract()
    };
    let color = [
        shade(ix, iy, iz, 5.0),
        shade(iy, iz, ix, 3.0),
        shade(iz, ix, iy, 2.0),
    ];
    let brightest = color.into_iter().fold(0.0, f64::max);
    let matt = Finish {
        color: color.map(|c| c / brightest),
        ..Finish::MATT
    };
    if (ix * 4 + iy * 2 + iz).is_multiple_of(5) {
        return Finish {
            diffuse: 0.2,
            transmission: 0.8,
            ior: 1.1,
            ..matt
        };
    }
    matt
}

/// A wheel whose top has its middle at `center`.
fn wheel(spd: &mut Spd, center: DVec3, start: f64, radius: f64, thickness: f64) {
    let (outer, inner) = (SHRUNK * radius, (1.0 - TOOTH) * radius);
    let outline: Vec<DVec3> = (0..TEETH)
        .flat_map(|tooth| {
            let corners = [(-0.19, outer), (0.19, outer), (0.3, inner), (0.7, inner)];
            corners.map(|(part, r)| {
                let angle = start + TAU * (tooth as f64 + part) / TEETH as f64;
                center + r * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
            })
        })
        .collect();
    let down = DVec3::new(0.0, 0.0, -thickness);
    let next = outline.iter().cycle().skip(1);
    for (&p, &q) in outline.iter().zip(next) {
        spd.triangle([center, p, q]);
        spd.triangle([center + down, q + down, p + down]);
        spd.quad([p, p + down, q + down, q]);
    }
}
