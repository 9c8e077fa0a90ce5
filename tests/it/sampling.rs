//! The samples of a pixel against answers known on paper: an edge through a pixel at any angle (hard case 83), slopes
//! of the error, what standard errors and adaptive sampling promise, and samples that are no numbers.

use raytree::accel::AccelKind;
use raytree::math::{DVec3, Rgb};
use raytree::probe::Silent;
use raytree::sampling::stream::{splitmix64, to_unit_f64};
use raytree::sampling::{Filter, SampleSet, Sampler};
use raytree::scene::Camera;
use raytree::scene::{Adaptive, Pilot, Settings};
use raytree::tracer::{Pixel, pixel};
use raytree::world::World;

use crate::from_text;

/// A half-plane x < 0 that shines with radiance 1 before black: an edge.
const EDGE: &str = r#"{
  "format": "raytree-scene/1", "name": "edge", "background": [0, 0, 0], "ambient": [0, 0, 0],
  "camera": {"eye": [0, 0, 1], "look_at": [0, 0, 0]},
  "materials": {"shining": {"diffuse": [0, 0, 0], "emission": [1, 1, 1]}},
  "objects": [{"quad": {"name": "half", "material": "shining", "corner": [-1000, -1000, 0], "u": [1000, 0, 0], "v": [0, 2000, 0]}}]
}"#;

/// The edge, and one pixel before it that is a metre wide: turned by an angle, its middle `d` right of the edge.
struct Edge {
    world: World,
}

impl Edge {
    fn new() -> Self {
        Self {
            world: World::new(from_text::scene(EDGE), AccelKind::List),
        }
    }

    /// The pixel, and how much of it is lit.
    fn pixel(&mut self, settings: &Settings, angle: f64, d: f64) -> (Pixel, f64) {
        let (eye, look_at) = (DVec3::new(d, 0.0, 1.0), DVec3::new(d, 0.0, 0.0));
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let fov = 2.0 * libm::atan(0.5);
        let camera = Camera::new(eye, look_at, DVec3::new(sin, cos, 0.0), fov);
        self.world.scene.camera = camera.expect("up is not along z");
        let found = pixel(&self.world, settings, (0, 0), &mut Silent);
        (found, lit_area(cos, sin, d))
    }

    /// Pixels at `count` angles and distances, each with a seed of its own: what was found, and what is true.
    fn pixels(&mut self, settings: &Settings, count: u64) -> Vec<(Pixel, f64)> {
        (0..count)
            .map(|seed| {
                let angle = std::f64::consts::TAU * to_unit_f64(splitmix64(2 * seed));
                let d = to_unit_f64(splitmix64(2 * seed + 1)) - 0.5;
                self.pixel(&settings.with(|s| s.seed = seed), angle, d)
            })
            .collect()
    }
}

/// The area of the part of the square |a|, |b| <= 1/2 with a c + b s + d < 0: the square is cut, exactly.
fn lit_area(c: f64, s: f64, d: f64) -> f64 {
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
    let side = |p: [f64; 2]| p[0] * c + p[1] * s + d;
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for (i, &p) in corners.iter().enumerate() {
        let q = corners[(i + 1) % 4];
        if side(p) < 0.0 {
            kept.push(p);
        }
        if (side(p) < 0.0) != (side(q) < 0.0) {
            let t = side(p) / (side(p) - side(q));
            kept.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    let next = kept.iter().cycle().skip(1);
    let doubled: f64 = kept
        .iter()
        .zip(next)
        .map(|(p, q)| p[0] * q[1] - p[1] * q[0])
        .sum();
    doubled / 2.0
}

fn settings(sampling: Sampler, samples: u32) -> Settings {
    Settings::default().with(|s| {
        s.image.width = 1;
        s.image.height = 1;
        s.pixel.samples = samples;
        s.pixel.sampler = sampling;
    })
}

fn rms(values: impl IntoIterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for x in values {
        sum += x * x;
        count += 1.0;
    }
    f64::sqrt(sum / count)
}

/// Root mean square of the errors, and the largest.
fn errors(pixels: &[(Pixel, f64)]) -> (f64, f64) {
    let off = pixels
        .iter()
        .map(|(pixel, truth)| (pixel.color.g - truth).abs());
    (rms(off.clone()), off.fold(0.0, f64::max))
}

/// Hard case 83. An edge meets at most 15 of 8 x 8 cells, and a sample is wrong about its cell by a standard deviation
/// of at most 1/2: sigma <= sqrt(15) / 2 / 64 = 0.03 for jittered samples, 0.06 for independent ones.
#[test]
fn an_edge_through_a_pixel_covers_what_it_does_at_a_thousand_angles() {
    let mut edge = Edge::new();
    assert!((lit_area(0.6, 0.8, 0.0) - 0.5).abs() < 1e-15);
    assert!((lit_area(1.0, 0.0, 0.25) - 0.25).abs() < 1e-15);
    let mut found = |sampling| errors(&edge.pixels(&settings(sampling, 64), 1000));
    let (random, jittered) = (found(Sampler::Random), found(Sampler::Stratified));
    let (regular, sobol) = (found(Sampler::Grid), found(Sampler::Sobol));
    println!("random {random:?} jittered {jittered:?} regular {regular:?} sobol {sobol:?}");
    assert!(random.0 < 0.06 && random.1 < 5.0 * 0.0625);
    assert!(jittered.0 < 0.03 && jittered.1 < 4.5 * 0.03);
    assert!(sobol.0 < 0.03 && sobol.1 < 4.5 * 0.03);
    assert!(
        regular.1 < 8.0 / 64.0,
        "no more than a row of cells is wrong"
    );
}

/// The slopes of log RMSE over log samples (Mitchell 1996; Owen 1997): on a smooth function, on a disc, and on edges
/// along an axis, anywhere. There the answer is known on paper: n evenly spread points are wrong about one of them,
/// sqrt(1/6) n^-1; the n^1/2 cells of a grid that the edge crosses give sqrt(1/6) n^-3/4; a grid by itself stalls.
#[test]
fn errors_fall_with_the_samples_as_theory_tells() {
    const COUNTS: [u32; 5] = [16, 64, 256, 1024, 4096];
    const RUNS: u64 = 100;
    let e = std::f64::consts::E;
    let edge = |key| to_unit_f64(splitmix64(key ^ 0xed6e));
    let value = |kind: usize, key, [x, y]: [f64; 2]| match kind {
        0 => libm::exp(x + y) - (e - 1.0) * (e - 1.0),
        1 => f64::from(u8::from(x * x + y * y < 1.0)) - std::f64::consts::FRAC_PI_4,
        _ => f64::from(u8::from(x < edge(key))) - edge(key),
    };
    let error = |sampler: Sampler, kind, count| {
        rms((0..RUNS).map(|key| {
            let key = splitmix64(key);
            let run = SampleSet { key, count };
            let sum: f64 = (0..count)
                .map(|i| value(kind, key, sampler.point(run, i)))
                .sum();
            sum / f64::from(count)
        }))
    };
    for (sampler, slopes, tolerance) in [
        (Sampler::Random, [-0.5, -0.5, -0.5], 0.05),
        (Sampler::Stratified, [-1.0, -0.726, -0.75], 0.1),
        (Sampler::Sobol, [-1.44, -0.747, -1.0], 0.1),
    ] {
        for (kind, expected) in slopes.into_iter().enumerate() {
            let logs = COUNTS.map(|n| {
                let error = error(sampler, kind, n);
                (libm::log(f64::from(n)), libm::log(error))
            });
            let slope = slope(&logs);
            println!("{sampler:?} {kind}: {slope:.3}");
            assert!(
                (slope - expected).abs() < tolerance,
                "{sampler:?}, integrand {kind}: {slope}, not {expected}"
            );
        }
    }
    let sixth = (1.0f64 / 6.0).sqrt();
    for (sampler, power) in [
        (Sampler::Random, 0.5),
        (Sampler::Stratified, 0.75),
        (Sampler::Sobol, 1.0),
    ] {
        let known = sixth * libm::pow(1024.0, -power);
        let found = error(sampler, 2, 1024);
        assert!(
            (found / known - 1.0).abs() < 0.3,
            "{sampler:?}: {found}, not {known}"
        );
    }
    let stalled = [1024, 16384].map(|count| {
        let run = SampleSet { key: 0, count };
        let left = (0..count).filter(|i| Sampler::Grid.point(run, *i)[0] < 0.3711);
        left.count() as f64 / f64::from(count) - 0.3711
    });
    assert!(
        stalled.iter().all(|off| (off - 3.9e-3).abs() < 1e-4),
        "{stalled:?}"
    );
}

/// The least-squares slope.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let above: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let below: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    above / below
}

/// An edge along the pixel's side: with a filter of radius 1 it shows the integral of the filter up to the edge.
#[test]
fn an_edge_shows_the_integral_of_each_filter() {
    let mut edge = Edge::new();
    for filter in Filter::ALL {
        for sampling in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
            let radius = filter.usual_radius();
            for d in [-0.7, -0.2, 0.0, 0.4, 1.3] {
                let steps = 4000;
                let width = 2.0 * radius / f64::from(steps);
                let truth: f64 = (0..steps)
                    .map(|i| -radius + (f64::from(i) + 0.5) * width)
                    .filter(|x| x + d < 0.0)
                    .map(|x| filter.value(x / radius) / radius * width)
                    .sum();
                let runs = 60;
                let settings = settings(sampling, 64).with(|s| {
                    s.pixel.filter = filter;
                    s.pixel.filter_radius = radius;
                });
                let values: Vec<f64> = (0..runs)
                    .map(|seed| {
                        edge.pixel(&settings.with(|s| s.seed = seed), 0.0, d)
                            .0
                            .color
                            .g
                    })
                    .collect();
                let n = runs as f64;
                let mean = values.iter().sum::<f64>() / n;
                let spread = rms(values.iter().map(|x| x - mean)) / n.sqrt();
                // 60 comparisons: 4.5 sigma. A filter that dips below 0 is a ratio, with a bias of 1/N.
                let bias = if filter.has_negative_lobes() {
                    0.01
                } else {
                    1e-3
                };
                assert!(
                    (mean - truth).abs() < 4.5 * spread + bias,
                    "{filter:?} {sampling:?} d = {d}: {mean} +- {spread}, not {truth}"
                );
            }
        }
    }
}

#[test]
fn a_wall_of_one_brightness_has_no_noise_with_any_filter() {
    let mut edge = Edge::new();
    for filter in Filter::ALL {
        for sampling in Sampler::ALL {
            for samples in [1, 3, 16] {
                let settings = settings(sampling, samples).with(|s| {
                    s.pixel.filter = filter;
                    s.pixel.filter_radius = filter.usual_radius();
                    s.pixel.errors = true;
                });
                let (wall, _) = edge.pixel(&settings, 0.3, -20.0);
                assert!((wall.color.g - 1.0).abs() < 1e-12, "{filter:?}, {samples}");
                assert!(samples == 1 || wall.error == 0.0);
            }
        }
    }
}

/// What the estimated standard error is worth: its root mean square beside that of the true errors. Of independent
/// samples and of independent sets it is right; of others too large, never too small.
#[test]
fn standard_errors_are_right_or_too_large() {
    let mut edge = Edge::new();
    let mut ratio = |sampling, samples, sets| {
        let settings = settings(sampling, samples).with(|s| {
            s.pixel.sets = sets;
            s.pixel.errors = true;
        });
        let pixels = edge.pixels(&settings, 1500);
        let ratio = rms(pixels.iter().map(|(pixel, _)| pixel.error)) / errors(&pixels).0;
        println!("{sampling:?}, {samples} samples in {sets} sets: {ratio:.2}");
        ratio
    };
    // The ratio itself is uncertain by about 1 / sqrt(2 x 1500) = 2 %.
    for samples in [5, 16, 64] {
        assert!((ratio(Sampler::Random, samples, 1) - 1.0).abs() < 0.1);
    }
    for sampling in [Sampler::Stratified, Sampler::Sobol] {
        assert!((ratio(sampling, 64, 8) - 1.0).abs() < 0.1);
        for samples in [16, 64, 256] {
            let ratio = ratio(sampling, samples, 1);
            assert!(ratio > 0.97 && ratio < 8.0, "{ratio}");
        }
    }
}

fn adaptive(sampling: Sampler, threshold: f64, pilot: Pilot) -> Settings {
    settings(sampling, 8).with(|s| {
        s.pixel.adaptive = Some(Adaptive {
            threshold,
            most: 4096,
            pilot,
        });
    })
}

#[test]
fn adaptive_samples_go_where_they_differ_and_bring_the_error_down() {
    let mut edge = Edge::new();
    for sampling in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        for threshold in [0.1, 0.03] {
            let settings = adaptive(sampling, threshold, Pilot::Kept);
            let flat = edge.pixel(&settings, 0.1, -3.0).0;
            assert_eq!(flat.samples, 8, "nothing differs");
            let pixels = edge.pixels(&settings, 1000);
            let (error, _) = errors(&pixels);
            let samples = pixels.iter().map(|(pixel, _)| f64::from(pixel.samples));
            let mean = samples.sum::<f64>() / 1000.0;
            println!("{sampling:?} {threshold}: error {error:.4}, {mean:.0} samples");
            // Some edges pass all of the first eight samples by. If a share p is lit, independent samples miss it with
            // probability (1 - p)^8: a mean square error of 2 integral p^2 (1 - p)^8 dp = 4/990 below which nothing
            // goes. Evenly spread samples miss less.
            let known = (threshold * threshold + 4.0 / 990.0).sqrt();
            assert!(error < 1.15 * known, "{sampling:?}: {error}");
            assert!(mean > 8.0 && mean < 0.3 / (threshold * threshold));
        }
    }
}

/// Kirk and Arvo 1991: to stop when the samples look alike is a bias; a pilot that does not count has none.
#[test]
fn a_pilot_apart_is_unbiased_and_one_that_is_kept_is_not() {
    let mut edge = Edge::new();
    let runs = 6000;
    for sampling in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        let [kept, apart] = [Pilot::Kept, Pilot::Apart].map(|pilot| {
            let settings = adaptive(sampling, 0.05, pilot);
            // A tenth of the pixel is lit: most of the time few of the first samples see it.
            let off: Vec<f64> = (0..runs)
                .map(|run| {
                    let seed = splitmix64(run);
                    let (pixel, truth) = edge.pixel(&settings.with(|s| s.seed = seed), 0.4, 0.45);
                    pixel.color.g - truth
                })
                .collect();
            let mean = off.iter().sum::<f64>() / runs as f64;
            (mean, rms(off) / (runs as f64).sqrt())
        });
        println!(
            "{sampling:?}: kept {:.5} +- {:.5}, apart {:.5} +- {:.5}",
            kept.0, kept.1, apart.0, apart.1
        );
        assert!(apart.0.abs() < 4.0 * apart.1, "{sampling:?}: {apart:?}");
        if sampling == Sampler::Random {
            assert!(kept.0 < -4.0 * kept.1, "this test can see a bias: {kept:?}");
        }
    }
}

#[test]
fn a_sample_that_is_no_number_counts_as_black_and_is_told_of() {
    for bad in [f64::NAN, f64::INFINITY] {
        let mut scene = from_text::scene(EDGE);
        for material in &mut scene.materials {
            material.emission = Rgb::new(1.0, bad, 1.0);
        }
        let mut edge = Edge {
            world: World::new(scene, AccelKind::List),
        };
        for samples in [
            settings(Sampler::Stratified, 64),
            adaptive(Sampler::Sobol, 0.1, Pilot::Kept),
        ] {
            let (found, lit) = edge.pixel(&samples, 0.4, 0.1);
            assert_eq!(found.color, Rgb::BLACK);
            let share = f64::from(found.non_finite) / f64::from(found.samples);
            assert!((share - lit).abs() < 0.2 && found.first_non_finite.is_some());
        }
    }
}
