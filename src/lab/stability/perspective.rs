//! Weights of a triangle's corners along a row of pixels, blended in space and on the screen.

use super::picture::{Panel, Picture, Place, Seen, panel};
use super::{Case, Chance, Outcome, percent};
use crate::geometry::{Intersection, Shear, Triangle};
use crate::lab::raster::{Projection, RowSpan, ScreenBlend, scanline};
use crate::math::{DVec2, DVec3, Interval};
use crate::scene::Camera;

pub const ROW_WEIGHTS: Case = Case {
    name: "row-weights",
    hard: "triangles whose corners are 1 to 100 m deep, filled row by row",
    source: "Heckbert and Moreton 1991, Interpolation for polygon texture mapping",
    measure: row_weights,
    picture: Picture {
        shows: "a floor of tiles, two triangles",
        wrong: "the other colour by the eye ray",
        draw: floor,
    },
};

const SIZE: (u32, u32) = (64, 64);

fn blends() -> [(&'static str, ScreenBlend); 2] {
    [
        ("--affine", ScreenBlend::Affine),
        ("ours", ScreenBlend::Perspective),
    ]
}

/// A camera in the origin that looks along -z, 90 degrees wide.
fn camera() -> Option<Camera> {
    let right_angle = std::f64::consts::FRAC_PI_2;
    Camera::new(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, right_angle)
}

/// The weights of the corners at the point that an eye ray meets, by the tracer's test.
fn by_ray(screen: &Projection, triangle: &Triangle, x: f64, row: u32) -> Option<[f64; 3]> {
    let ray = screen.ray(x, row);
    match triangle.intersect(&Shear::new(&ray), Interval::FORWARD) {
        Intersection::Hit { place, .. } => Some(place),
        _ => None,
    }
}

fn row_weights() -> Vec<Outcome> {
    const TRIANGLES: usize = 200;
    let camera = camera();
    let outcome = |(name, blend): (&str, ScreenBlend)| {
        let mut chance = Chance(42);
        let (mut wrong, mut all) = (0, 0);
        for screen in camera.iter().map(|camera| Projection::new(camera, SIZE)) {
            for _ in 0..TRIANGLES {
                let corners = [(); 3].map(|()| {
                    let depth = libm::exp10(2.0 * chance.next());
                    depth * chance.point().with_z(-1.0)
                });
                let triangle = Triangle { corners };
                let polygon = screen.polygon(&triangle);
                for row in scanline::rows(&polygon, SIZE.1).into_iter().flatten() {
                    let Some(span) = RowSpan::of(&polygon, row, blend) else {
                        continue;
                    };
                    for x in span.pixels(SIZE.0).map(|x| f64::from(x) + 0.5) {
                        let Some(right) = by_ray(&screen, &triangle, x, row) else {
                            continue;
                        };
                        let off = |i: usize| (span.at(x).weights[i] - right[i]).abs();
                        all += 1;
                        wrong += usize::from((0..3).any(|i| off(i) > 1e-9));
                    }
                }
            }
        }
        Outcome {
            arithmetic: name.to_owned(),
            ours: name == "ours",
            found: percent(wrong, all),
            allowed: 0.0,
            unit: "% of pixels with weights 1e-9 off",
        }
    };
    blends().map(outcome).to_vec()
}

/// A square of the floor, 8 x 8 tiles, which starts 1.1 m in front of the eye, 1 m below it. (No middle of a pixel sees the edge of a tile, where rounding
/// decides.)
const FLOOR: [DVec3; 4] = [
    DVec3::new(-4.037, -1.0, -1.1),
    DVec3::new(3.963, -1.0, -1.1),
    DVec3::new(3.963, -1.0, -9.1),
    DVec3::new(-4.037, -1.0, -9.1),
];

/// Each pixel of the window is filled as a pixel of the screen, by the span of its row.
fn floor(size: (u32, u32)) -> Vec<Panel> {
    let camera = camera();
    let [a, b, c, d] = FLOOR;
    let triangles = [
        ([a, b, c], [[0, 0], [8, 0], [8, 8]]),
        ([a, c, d], [[0, 0], [8, 8], [0, 8]]),
    ];
    let tile = |weights: [f64; 3], corners: [[i32; 2]; 3]| {
        let pairs = weights.iter().zip(corners);
        let at: DVec2 = pairs
            .map(|(w, [x, y])| *w * DVec2::new(f64::from(x), f64::from(y)))
            .sum();
        (at.x.floor() + at.y.floor()).rem_euclid(2.0)
    };
    let of = |(name, blend): (&str, ScreenBlend)| {
        panel((name, name == "ours"), size, |place: Place| {
            let background = Seen {
                brightness: 0.02,
                wrong: false,
            };
            let Some(screen) = camera.as_ref().map(|camera| Projection::new(camera, size)) else {
                return background;
            };
            // The window's middle looks ahead; its pixels are the screen's.
            let pixel = |at: f64, half: f64| (at / half / 2.0 - 0.5).round();
            let x = pixel(1.0 + place.x, place.half[0]) + 0.5;
            let row = pixel(1.0 - place.y, place.half[1]) as u32;
            for (corners, tiles) in triangles {
                let triangle = Triangle { corners };
                let Some(weights) = by_ray(&screen, &triangle, x, row) else {
                    continue;
                };
                if let Some(span) = RowSpan::of(&screen.polygon(&triangle), row, blend) {
                    let (right, drawn) = (tile(weights, tiles), tile(span.at(x).weights, tiles));
                    return Seen {
                        brightness: 0.3 + 0.5 * drawn,
                        wrong: drawn != right,
                    };
                }
            }
            background
        })
    };
    blends().map(of).to_vec()
}
