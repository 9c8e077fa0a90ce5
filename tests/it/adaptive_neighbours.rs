//! `--pilot around`: a pixel's number of samples comes from the first samples of the pixels around it.

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::probe::Silent;
use raytree::sampling::stream::splitmix64;
use raytree::sampling::{LightSampling, Sampler};
use raytree::scene::{Adaptive, Pilot, Settings};
use raytree::tracer::{Film, draw, pixel};
use raytree::world::World;

use crate::from_text;

/// A floor that sees a tenth of a lamp covered, everywhere in the picture: the screen ends at x = 0.4 before a lamp twice
/// as far away that ends at x = 1.
const FAINT: &str = r#"{
  "format": "raytree-scene/1", "name": "faint", "background": [0, 0, 0], "ambient": [0, 0, 0],
  "camera": {"eye": [0, 0.5, 0.5], "look_at": [0, 0, 0], "vertical_fov": 1},
  "materials": {
    "floor": {"diffuse": [0.5, 0.5, 0.5]}, "screen": {"diffuse": [0, 0, 0]},
    "lamp": {"diffuse": [0, 0, 0], "emission": [9, 9, 9]}
  },
  "lights": [{"area": {"name": "lamp", "object": "lamp"}}],
  "objects": [
    {"quad": {"name": "lamp", "material": "lamp", "corner": [-1, 2, -1], "u": [2, 0, 0], "v": [0, 0, 2]}},
    {"quad": {"name": "screen", "material": "screen", "corner": [0.4, 1, -9], "u": [9, 0, 0], "v": [0, 0, 18]}},
    {"quad": {"name": "floor", "material": "floor", "corner": [-5, 0, 5], "u": [10, 0, 0], "v": [0, 0, -10]}}
  ]
}"#;

/// The floor in so many pixels.
fn faint(edge: u32) -> (World, Settings) {
    let scene = from_text::scene(FAINT);
    let settings = scene.settings.with(|s| {
        s.image.width = edge;
        s.image.height = edge;
        s.pixel.samples = 4;
        s.pixel.sampler = Sampler::Sobol;
        s.light.samples = 1;
        // What is not covered is no noise.
        s.light.density = LightSampling::Projected;
    });
    (World::new(scene, AccelKind::Wide), settings)
}

fn decided(settings: &Settings, threshold: f64, pilot: Pilot) -> Settings {
    let most = 256;
    let adaptive = Some(Adaptive {
        threshold,
        most,
        pilot,
    });
    settings.with(|s| s.pixel.adaptive = adaptive)
}

fn film(world: &World, settings: &Settings) -> Film {
    draw(world, settings, 2)
}

#[test]
fn a_faint_penumbra_that_a_pixel_misses_is_seen_by_those_around_it() {
    let (world, settings) = faint(48);
    let kept = film(&world, &decided(&settings, 0.02, Pilot::Kept));
    let around = film(&world, &decided(&settings, 0.02, Pilot::Around));
    let left_alone = |film: &Film| {
        let alone = film.samples.iter().filter(|n| **n == 4).count();
        alone as f64 / film.samples.len() as f64
    };
    println!("{} and {}", left_alone(&kept), left_alone(&around));
    // Of four evenly spread points only the one in the last quarter may meet the screen.
    assert!(left_alone(&kept) > 0.6);
    assert!(
        left_alone(&around) < 0.01,
        "24 of them inside a tile, 8 in its corners"
    );
}

/// To stop when the samples look alike is a bias; if others decide there is none.
#[test]
fn what_others_decide_is_unbiased() {
    let (world, settings) = faint(5);
    let truth = {
        let fine = settings.with(|s| {
            s.pixel.samples = 4096;
            s.seed = 99;
        });
        pixel(&world, &fine, (2, 2), &mut Silent).color.g
    };
    let runs = 3000;
    for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        let [kept, around] = [Pilot::Kept, Pilot::Around].map(|pilot| {
            let settings = decided(&settings, 0.05, pilot);
            let mut sums = [0.0; 2];
            for run in 0..runs {
                let seed = splitmix64(run);
                let settings = settings.with(|s| {
                    s.seed = seed;
                    s.light.sampler = sampler;
                });
                let off = pixel(&world, &settings, (2, 2), &mut Silent).color.g / truth - 1.0;
                sums = [sums[0] + off, sums[1] + off * off];
            }
            let [mean, square] = sums.map(|sum| sum / runs as f64);
            (mean, (square / runs as f64).sqrt())
        });
        println!("{sampler:?}: kept {kept:.5?}, around {around:.5?}");
        assert!(around.0.abs() < 4.0 * around.1, "{sampler:?}: {around:?}");
        assert!(kept.0 > 4.0 * kept.1, "this test can see a bias: {kept:?}");
    }
}

/// A pixel asks those of its tile; one that has none there knows nothing, and takes all it may.
#[test]
fn a_pixel_that_has_no_neighbour_takes_all_it_may() {
    let (world, settings) = faint(17);
    let settings = decided(&settings, 1e3, Pilot::Around);
    let found = film(&world, &settings);
    let (last, others) = found.samples.split_last().expect("pixels");
    assert_eq!(*last, 256);
    assert!(others.iter().all(|n| *n == 4));
}

#[test]
fn limits_hold() {
    let (world, settings) = faint(20);
    let settings = decided(&settings, 1e-6, Pilot::Around);
    let whole = film(&world, &settings);
    assert!(!whole.truncated && whole.samples.iter().all(|n| *n <= 256));
    // Room for 2 rays a pixel: fewer than the first samples would take.
    for max_rays in [400, 800, 4000] {
        let short = film(&world, &settings.with(|s| s.recursion.max_rays = max_rays));
        assert!(short.truncated && short.rays <= max_rays, "{}", short.rays);
        let alone = pixel(
            &world,
            &settings.with(|s| s.recursion.max_rays = max_rays),
            (7, 9),
            &mut Silent,
        );
        assert_eq!(alone.color, short.at(7, 9));
    }
    assert_ne!(whole.at(7, 9), Rgb::BLACK);
}
