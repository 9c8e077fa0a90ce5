//! FLIP: how much two pictures differ to an eye that switches between them, from 0 (not at all) to 1.
//!
//! Colours are blurred as the eye blurs them at a distance, and compared; where edges or dots differ as well, the
//! difference counts more. All of it is about what a screen shows, so it is computed from sRGB with 8 bits.
//!
//! Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: a difference evaluator for
//! alternating images" (LDR-FLIP).

use std::f64::consts::PI;

use glam::DMat3;

use crate::math::DVec3;
use crate::tracer::Film;

/// Pixels in a degree of what the eye sees: a screen of 3840 pixels, 0.7 m wide, from 0.7 m away.
const PIXELS_PER_DEGREE: f64 = 0.7 * 3840.0 / 0.7 * (PI / 180.0);

/// The blur of each opponent channel, as the sum of two Gaussians of (weight, scale).
const BLURS: [[(f64, f64); 2]; 3] = [
    [(1.0, 0.0047), (0.0, 1e-5)],
    [(1.0, 0.0053), (0.0, 1e-5)],
    [(34.1, 0.04), (13.5, 0.025)],
];

/// The width of the edges and dots that an eye looks for, in degrees.
const FEATURE: f64 = 0.082;

/// The exponent of colour differences.
const COLOR_POWER: f64 = 0.7;
/// The exponent of differences between edges or dots.
const FEATURE_POWER: f64 = 0.5;
/// Colour differences up to this share of the largest ...
const SMALL_SHARE: f64 = 0.4;
/// ... fill this share of the scale.
const SMALL_RANGE: f64 = 0.95;

/// XYZ of the linear primaries of sRGB: rows X, Y, Z.
const RGB_TO_XYZ: [[f64; 3]; 3] = [
    [
        10_135_552.0 / 24_577_794.0,
        8_788_810.0 / 24_577_794.0,
        4_435_075.0 / 24_577_794.0,
    ],
    [
        2_613_072.0 / 12_288_897.0,
        8_788_810.0 / 12_288_897.0,
        887_015.0 / 12_288_897.0,
    ],
    [
        1_425_312.0 / 73_733_382.0,
        8_788_810.0 / 73_733_382.0,
        70_074_185.0 / 73_733_382.0,
    ],
];

/// What the eye makes of a picture. The reference's is used again and again.
#[derive(Clone, Debug)]
pub struct Seen {
    /// Blurred colours in L*a*b*, the chroma less where it is dark.
    colors: Vec<[f64; 3]>,
    /// Strengths of edges and of dots.
    features: Vec<[f64; 2]>,
}

/// One channel of a picture.
struct Plane {
    width: usize,
    values: Vec<f64>,
}

/// A filter along one axis: the weights of -radius..=radius.
type Kernel = Vec<f64>;

impl Seen {
    /// Of a film with this exposure.
    pub fn new(film: &Film, exposure: f64) -> Self {
        let opponent: Vec<[f64; 3]> = film
            .pixels
            .iter()
            .map(|p| {
                let shown = (*p * exposure).to_srgb8();
                opponent(to_xyz(shown.map(|c| linear(f64::from(c) / 255.0))))
            })
            .collect();
        let plane = |channel: usize| Plane {
            width: film.width.max(1) as usize,
            values: opponent.iter().map(|c| c[channel]).collect(),
        };
        let [y, cx, cz] = [0, 1, 2].map(|channel| blurred(&plane(channel), BLURS[channel]));
        let colors = y.iter().zip(cx).zip(cz);
        Self {
            colors: colors.map(|((y, cx), cz)| to_lab([*y, cx, cz])).collect(),
            features: features(&Plane {
                values: opponent.iter().map(|c| (c[0] + 16.0) / 116.0).collect(),
                ..plane(0)
            }),
        }
    }
}

/// The mean over all pixels of two pictures of one size.
pub fn flip(a: &Seen, b: &Seen) -> f64 {
    // The largest difference of colours that a screen can show: green and blue.
    let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|rgb| hunt(lab(to_xyz(rgb))));
    let largest = libm::pow(hyab(green, blue), COLOR_POWER);
    let colors = a.colors.iter().zip(&b.colors);
    let features = a.features.iter().zip(&b.features);
    let sum: f64 = colors
        .zip(features)
        .map(|((ca, cb), (fa, fb))| {
            let color = spread(libm::pow(hyab(*ca, *cb), COLOR_POWER), largest);
            let feature = (fa[0] - fb[0]).abs().max((fa[1] - fb[1]).abs());
            let feature = libm::pow(feature / 2.0f64.sqrt(), FEATURE_POWER).min(1.0);
            libm::pow(color, 1.0 - feature)
        })
        .sum();
    sum / a.colors.len().max(1) as f64
}

/// Small differences get most of the scale from 0 to 1.
fn spread(difference: f64, largest: f64) -> f64 {
    let small = SMALL_SHARE * largest;
    if difference < small {
        SMALL_RANGE / small * difference
    } else {
        SMALL_RANGE + (difference - small) / (largest - small) * (1.0 - SMALL_RANGE)
    }
}

/// The sum of two Gaussians: each is one along x times one along y.
fn blurred(plane: &Plane, gaussians: [(f64, f64); 2]) -> Vec<f64> {
    // All channels have the radius that the widest needs.
    let widest = BLURS.iter().flatten().map(|g| g.1).fold(0.0, f64::max);
    let radius = (3.0 * (widest / (2.0 * PI * PI)).sqrt() * PIXELS_PER_DEGREE).ceil() as i32;
    let mut sum = vec![0.0; plane.values.len()];
    let mut total = 0.0;
    for (weight, scale) in gaussians.into_iter().filter(|g| g.0 > 0.0) {
        let kernel: Kernel = (-radius..=radius)
            .map(|i| {
                let x = f64::from(i) / PIXELS_PER_DEGREE;
                libm::exp(-PI * PI * x * x / scale)
            })
            .collect();
        let weight = weight * (PI / scale).sqrt();
        let mass: f64 = kernel.iter().sum();
        total += weight * mass * mass;
        for (sum, value) in sum.iter_mut().zip(plane.filtered(&kernel, &kernel)) {
            *sum += weight * value;
        }
    }
    sum.iter().map(|s| s / total).collect()
}

/// Edges and dots: the first and the second derivative of a Gaussian along each axis.
fn features(plane: &Plane) -> Vec<[f64; 2]> {
    let sigma = 0.5 * FEATURE * PIXELS_PER_DEGREE;
    let radius = (3.0 * sigma).ceil() as i32;
    let kernel = |f: &dyn Fn(f64) -> f64| -> Kernel {
        (-radius..=radius)
            .map(|i| {
                let x = f64::from(i);
                f(x) * libm::exp(-x * x / (2.0 * sigma * sigma))
            })
            .collect()
    };
    let gauss = normalized(kernel(&|_| 1.0));
    let edge = normalized(kernel(&|x| -x));
    let dot = normalized(kernel(&|x| x * x / (sigma * sigma) - 1.0));
    let strength = |along: &Kernel| -> Vec<f64> {
        let (x, y) = (plane.filtered(along, &gauss), plane.filtered(&gauss, along));
        x.iter().zip(y).map(|(x, y)| libm::hypot(*x, y)).collect()
    };
    let (edges, dots) = (strength(&edge), strength(&dot));
    edges.into_iter().zip(dots).map(|(e, d)| [e, d]).collect()
}

/// Positive weights made to add up to 1, and negative ones to -1.
fn normalized(mut kernel: Kernel) -> Kernel {
    let sum = |negative: bool| -> f64 {
        let part = kernel.iter().filter(|w| (**w < 0.0) == negative);
        part.sum::<f64>().abs()
    };
    let (positive, negative) = (sum(false), sum(true));
    for w in &mut kernel {
        *w /= if *w < 0.0 { negative } else { positive };
    }
    kernel
}

impl Plane {
    /// Filtered along both axes; beyond its borders it goes on as at them.
    fn filtered(&self, along_x: &Kernel, along_y: &Kernel) -> Vec<f64> {
        let (width, height) = (self.width, self.values.len() / self.width);
        // A place `i - radius` away, kept inside.
        let inside = |at: usize, i: usize, radius: usize, end: usize| {
            (at + i).saturating_sub(radius).min(end - 1)
        };
        let mut half = vec![0.0; self.values.len()];
        for (at, out) in half.iter_mut().enumerate() {
            let (x, row) = (at % width, at / width * width);
            let weights = along_x.iter().enumerate();
            *out = weights
                .map(|(i, w)| w * self.values[row + inside(x, i, along_x.len() / 2, width)])
                .sum();
        }
        let mut full = vec![0.0; half.len()];
        for (at, out) in full.iter_mut().enumerate() {
            let (x, y) = (at % width, at / width);
            let weights = along_y.iter().enumerate();
            *out = weights
                .map(|(i, w)| w * half[inside(y, i, along_y.len() / 2, height) * width + x])
                .sum();
        }
        full
    }
}

/// The inverse of sRGB's transfer curve (IEC 61966-2-1).
fn linear(encoded: f64) -> f64 {
    if encoded > 0.04045 {
        libm::pow((encoded + 0.055) / 1.055, 2.4)
    } else {
        encoded / 12.92
    }
}

fn to_xyz(rgb: [f64; 3]) -> [f64; 3] {
    RGB_TO_XYZ.map(|row| row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2])
}

/// XYZ of white.
fn white() -> [f64; 3] {
    to_xyz([1.0; 3])
}

/// YCxCz, in which the eye's channels can be blurred: as L*a*b*, but linear.
fn opponent(xyz: [f64; 3]) -> [f64; 3] {
    let white = white();
    let [x, y, z] = [0, 1, 2].map(|i| xyz[i] / white[i]);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// From YCxCz to what [`hyab`] compares. Colours that no screen can show, which a blur may make, are clamped.
fn to_lab([y, cx, cz]: [f64; 3]) -> [f64; 3] {
    let white = white();
    let y = (y + 16.0) / 116.0;
    let relative = [y + cx / 500.0, y, y - cz / 200.0];
    let xyz = DVec3::from_array([0, 1, 2].map(|i| relative[i] * white[i]));
    let matrix = DMat3::from_cols_array_2d(&RGB_TO_XYZ).transpose();
    let rgb = (matrix.inverse() * xyz).clamp(DVec3::ZERO, DVec3::ONE);
    hunt(lab(to_xyz(rgb.to_array())))
}

/// CIE L*a*b*.
fn lab(xyz: [f64; 3]) -> [f64; 3] {
    const DELTA: f64 = 6.0 / 29.0;
    let white = white();
    let [x, y, z] = [0, 1, 2].map(|i| {
        let t = xyz[i] / white[i];
        if t > DELTA * DELTA * DELTA {
            libm::cbrt(t)
        } else {
            t / (3.0 * DELTA * DELTA) + 4.0 / 29.0
        }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// What is dark looks less colourful. (Hunt 1952.)
fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// A distance of colours that holds for large differences too. (Abasi, Amani Tehran and Fairchild 2020.)
fn hyab(p: [f64; 3], q: [f64; 3]) -> f64 {
    (p[0] - q[0]).abs() + libm::hypot(p[1] - q[1], p[2] - q[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    /// A picture of 48x32 whose bytes are whole-number arithmetic, so that others can make the same.
    fn picture(pixel: impl Fn(u32, u32) -> [u32; 3]) -> Seen {
        let (width, height) = (48, 32);
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let film = Film {
            width,
            height,
            pixels: pixels
                .map(|(x, y)| {
                    let [r, g, b] = pixel(x, y).map(|c| linear(f64::from(c % 256) / 255.0));
                    Rgb::new(r, g, b)
                })
                .collect(),
            ..Film::default()
        };
        Seen::new(&film, 1.0)
    }

    fn slopes(x: u32, y: u32) -> [u32; 3] {
        [5 * x, 7 * y, 3 * x + 2 * y]
    }

    #[test]
    fn it_is_what_the_evaluator_of_its_authors_says() {
        // PyPI flip-evaluator 1.7: evaluate(reference, test, "LDR"), mean of the map, for the same bytes.
        let reference = picture(slopes);
        let noise = |x: u32, y: u32| slopes(x, y).map(|c| c + x * x * 31 % 17 + y * x * 13 % 23);
        let blocks = |x: u32, y: u32| {
            let on = (x / 8 + y / 8) % 2 * 60;
            slopes(x, y).map(|c| (c % 256).saturating_sub(on))
        };
        let green = picture(|_, _| [0, 255, 0]);
        let blue = picture(|_, _| [0, 0, 255]);
        for (name, a, b, expected) in [
            ("noise", &reference, &picture(noise), 0.321_173_51),
            ("blocks", &reference, &picture(blocks), 0.408_509_42),
            ("green and blue", &green, &blue, 1.0),
        ] {
            let found = flip(a, b);
            assert!((found - expected).abs() < 1e-7, "{name}: {found}");
        }
    }

    #[test]
    fn a_picture_does_not_differ_from_itself() {
        let seen = picture(slopes);
        assert_eq!(flip(&seen, &seen), 0.0);
    }
}
