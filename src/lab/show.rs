//! What can be shown of each pixel in the place of its colour: how much work it took, and what its eye ray meets.

use rayon::prelude::*;

use crate::math::{DVec3, Rgb};
use crate::probe::{RayKind, Silent};
use crate::scene::Settings;
use crate::shading::ShadingPoint;
use crate::trace::{Counts, trace_pixel_here};
use crate::tracer::laws::{Bent, Laws as _};
use crate::tracer::{pixel, thread_pool};
use crate::world::World;

/// What [`ShowMode::Hit`] shows where Kd is black, in all channels.
const GREY: f64 = 0.5;

/// What is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum, strum::VariantArray)]
pub enum ShowMode {
    /// Rays of all kinds
    Rays,
    /// Nodes of the acceleration structure that were visited
    Nodes,
    /// Shapes that were tested
    Tests,
    /// Depth of the deepest R or T ray
    Depth,
    /// Distance that the eye ray goes, in metres
    T,
    /// Standard error of the pixel's luminance, where its samples tell one
    Error,
    /// Normal where the eye ray ends, towards the viewer: x, y and z from -1 to 1 as red, green and blue
    Normal,
    /// Object where the eye ray ends, each in a colour of its own
    Object,
    /// Kd where the eye ray ends, grey where it is black; no lights
    Hit,
    /// Direction of the eye ray: x, y and z from -1 to 1 as red, green and blue
    Direction,
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShownValue {
    /// A number, for a scale of colours.
    Number(f64),
    /// A colour as a screen has it, linear.
    Color(Rgb),
    /// Nothing is there to be shown.
    Nothing,
}

impl ShowMode {
    /// What the numbers are, for a legend.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Rays => "rays a pixel",
            Self::Nodes => "nodes a pixel",
            Self::Tests => "tests a pixel",
            Self::Depth => "depth",
            Self::T => "t, in metres",
            Self::Error => "standard error",
            Self::Normal => "normal",
            Self::Object => "object",
            Self::Hit => "Kd",
            Self::Direction => "direction",
        }
    }

    /// Shows a pixel.
    pub fn of(self, world: &World, settings: &Settings, at: (u32, u32)) -> ShownValue {
        match self {
            Self::Rays | Self::Nodes | Self::Tests => {
                let mut counts = Counts::default();
                pixel(world, settings, at, &mut counts);
                let count = match self {
                    Self::Rays => counts.rays(),
                    Self::Nodes => counts.nodes,
                    _ => counts.tests,
                };
                ShownValue::Number(count as f64)
            }
            Self::Depth => {
                let trace = trace_pixel_here(world, settings, at, false);
                let rays = trace.tree.nodes.iter();
                let rays = rays.filter(|node| node.ray.kind != RayKind::Light);
                ShownValue::Number(f64::from(rays.map(|n| n.ray.depth).max().unwrap_or(0)))
            }
            Self::Error => {
                let settings = settings.with(|s| s.pixel.errors = true);
                let error = pixel(world, &settings, at, &mut Silent).error;
                if error.is_finite() {
                    ShownValue::Number(error)
                } else {
                    ShownValue::Nothing
                }
            }
            Self::T | Self::Normal | Self::Object | Self::Hit | Self::Direction => {
                self.of_eye_ray(world, settings, at)
            }
        }
    }

    /// Shows what the eye ray through the middle of a pixel meets.
    fn of_eye_ray(self, world: &World, settings: &Settings, (x, y): (u32, u32)) -> ShownValue {
        let middle = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        let (scene, effects, laws) = (&world.scene, settings.effects, Bent(settings.bends));
        let ray = laws.eye_ray(&scene.camera, middle, settings.size());
        if self == Self::Direction {
            return as_color(ray.direction);
        }
        let Some(hit) = laws.closest(world, &ray, &mut Silent) else {
            return match self {
                Self::Hit => ShownValue::Color(scene.background),
                _ => ShownValue::Nothing,
            };
        };
        let at = laws.interaction(scene, &ray, &hit);
        match self {
            Self::T => ShownValue::Number(hit.t),
            Self::Normal => as_color(scene.shaded_with((&hit, &at), settings).normal),
            Self::Hit => {
                let material = scene.material_at(&hit);
                let kd = ShadingPoint::new(&at, material, effects).diffuse_color();
                ShownValue::Color(if kd.is_black() { Rgb::grey(GREY) } else { kd })
            }
            _ => ShownValue::Color(object_color(world.scene.owners[hit.primitive as usize])),
        }
    }
}

/// A vector as a colour: x, y and z from -1 to 1 as red, green and blue.
fn as_color(vector: DVec3) -> ShownValue {
    ShownValue::Color(Rgb::from_srgb((vector * 0.5 + 0.5).to_array()))
}

/// A colour for the object of a number: hues by the golden angle, so that neighbours differ.
fn object_color(object: u32) -> Rgb {
    let turn = (f64::from(object) * 0.618_033_988_75).fract();
    let channel = |shift: f64| {
        let wave = libm::cos(std::f64::consts::TAU * (turn + shift));
        0.55 + 0.4 * wave
    };
    Rgb::from_srgb([channel(0.0), channel(1.0 / 3.0), channel(2.0 / 3.0)])
}

/// The colour of a share of the range, 0 to 1: dark blue, green, yellow. Points of the scale viridis (Smith and van der Walt
/// 2015), which is even to the eye and to those who see few colours, and grows brighter all the way.
pub fn scale(share: f64) -> Rgb {
    const POINTS: [[f64; 3]; 5] = [
        [0.267, 0.005, 0.329],
        [0.230, 0.322, 0.546],
        [0.128, 0.567, 0.551],
        [0.369, 0.789, 0.383],
        [0.993, 0.906, 0.144],
    ];
    let at = share.clamp(0.0, 1.0) * 4.0;
    let first = (at as usize).min(3);
    let part = at - first as f64;
    let mixed = [0, 1, 2].map(|c| POINTS[first][c] * (1.0 - part) + POINTS[first + 1][c] * part);
    Rgb::from_srgb(mixed)
}

/// A range of numbers, from its least to its largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShownRange(pub f64, pub f64);

impl ShownRange {
    /// That of all numbers; none if there are none.
    pub fn of(values: impl Iterator<Item = ShownValue>) -> Option<Self> {
        let numbers = values.filter_map(|value| match value {
            ShownValue::Number(x) if x.is_finite() => Some(x),
            _ => None,
        });
        numbers.fold(None, |range, x| match range {
            None => Some(Self(x, x)),
            Some(Self(least, most)) => Some(Self(least.min(x), most.max(x))),
        })
    }

    /// The colour of a value in this range; black where nothing is there.
    pub fn color(self, value: ShownValue) -> Rgb {
        let Self(least, most) = self;
        match value {
            ShownValue::Number(x) if most > least => scale((x - least) / (most - least)),
            ShownValue::Number(_) => scale(0.0),
            ShownValue::Color(color) => color,
            ShownValue::Nothing => Rgb::BLACK,
        }
    }
}

/// Shows all pixels of the picture, row after row, on `threads` threads (0: one a core).
pub fn show(world: &World, settings: &Settings, mode: ShowMode, threads: usize) -> Vec<ShownValue> {
    let (width, height) = settings.size();
    thread_pool::install(threads, || {
        let pixels = (0..u64::from(width) * u64::from(height)).into_par_iter();
        let at = |i: u64| ((i % u64::from(width)) as u32, (i / u64::from(width)) as u32);
        pixels.map(|i| mode.of(world, settings, at(i))).collect()
    })
}

/// How many numbers fall into each tenth of a range.
pub fn tenths(
    numbers: impl Iterator<Item = f64>,
    ShownRange(least, most): ShownRange,
) -> [usize; 10] {
    let mut bins = [0; 10];
    for x in numbers.filter(|x| x.is_finite()) {
        let share = if most > least {
            (x - least) / (most - least)
        } else {
            0.0
        };
        bins[((share * 10.0) as usize).min(9)] += 1;
    }
    bins
}

/// Numbers in words: the least, the middle one, the mean and the largest, and how many fall into each tenth of the range.
pub fn summary(values: &[ShownValue], mode: ShowMode) -> Option<String> {
    let mut numbers: Vec<f64> = values
        .iter()
        .filter_map(|value| match value {
            ShownValue::Number(x) if x.is_finite() => Some(*x),
            _ => None,
        })
        .collect();
    numbers.sort_by(f64::total_cmp);
    let (least, most) = (*numbers.first()?, *numbers.last()?);
    let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
    let median = numbers[numbers.len() / 2];
    let bins = tenths(numbers.iter().copied(), ShownRange(least, most));
    let shares = bins.map(|n| format!("{:.1}", 100.0 * n as f64 / numbers.len() as f64));
    let num = crate::trace::format::num;
    Some(format!(
        "{}: {} to {}, mean {}, median {}\npercent of the pixels in each tenth of this range: {}\n",
        mode.unit(),
        num(least),
        num(most),
        num(mean),
        num(median),
        shares.join(" ")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_grows_brighter_all_the_way() {
        let brightness: Vec<f64> = (0..=100)
            .map(|i| scale(f64::from(i) / 100.0).luminance())
            .collect();
        assert!(
            brightness.windows(2).all(|pair| pair[0] < pair[1]),
            "{brightness:?}"
        );
    }

    #[test]
    fn numbers_are_spread_over_their_range() {
        let values = [1.0, 3.0, 5.0, f64::NAN].map(ShownValue::Number);
        let range = ShownRange::of(values.into_iter()).expect("numbers");
        assert_eq!(range, ShownRange(1.0, 5.0));
        assert_eq!(range.color(ShownValue::Number(5.0)), scale(1.0));
        assert_eq!(range.color(ShownValue::Nothing), Rgb::BLACK);
        let text = summary(&values, ShowMode::Rays).expect("numbers");
        assert!(
            text.starts_with("rays a pixel: 1 to 5, mean 3, median 3\n"),
            "{text}"
        );
        assert!(
            text.ends_with("33.3 0.0 0.0 0.0 0.0 33.3 0.0 0.0 0.0 33.3\n"),
            "{text}"
        );
        assert_eq!(summary(&[ShownValue::Nothing], ShowMode::T), None);
    }
}
