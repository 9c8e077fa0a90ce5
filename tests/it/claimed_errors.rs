//! The error that a picture claims beside the error that it has, for whole scenes.

use raytree::accel::AccelKind;
use raytree::sampling::Sampler;
use raytree::scene::{self, Settings};
use raytree::tracer::{Film, draw};
use raytree::world::World;

/// Soft shadows, mirrors and glass, a curved mesh.
const SCENES: [&str; 3] = ["soft-shadow", "whitted", "teapot"];

/// Pictures of each scene by each sampler: their errors are compared in the mean.
const PICTURES: u64 = 8;

/// The root mean squares of the claimed and of the true errors of the pixels of many pictures, and the share of the pixels whose
/// true error is at most twice the claimed one.
fn errors(world: &World, settings: &Settings, truth: &Film) -> ([f64; 2], f64) {
    let (mut squares, mut covered, mut pixels) = ([0.0; 2], 0.0, 0.0);
    for seed in 0..PICTURES {
        let film = draw(world, &settings.with(|s| s.seed = seed), 0);
        for ((color, truth), claimed) in film.pixels.iter().zip(&truth.pixels).zip(&film.errors) {
            let error = color.luminance() - truth.luminance();
            squares[0] += claimed * claimed;
            squares[1] += error * error;
            // What rounding leaves in a pixel of one colour is no error of sampling.
            covered += f64::from(error.abs() <= 2.0 * claimed + 1e-6);
            pixels += 1.0;
        }
    }
    (squares.map(|sum| (sum / pixels).sqrt()), covered / pixels)
}

/// With eight sets a pixel's error over its estimate has Student's distribution with 7 degrees of freedom: 91.4 % within 2.
#[test]
fn the_claimed_error_is_the_true_one_in_the_mean() {
    println!("| scene | sampler | claimed / true | within 2 standard errors |\n|---|---|---|---|");
    for name in SCENES {
        let world = World::new(scene::load(name).expect("built in"), AccelKind::Wide);
        let base = world.scene.settings.with(|s| {
            s.image.width = 16;
            s.image.height = 12;
            s.light.samples = 1;
            s.pixel.samples = 64;
            s.pixel.sets = 8;
            s.pixel.errors = true;
        });
        let truth = base.with(|s| {
            s.pixel.sampler = Sampler::Sobol;
            s.pixel.samples = 1024;
            s.pixel.sets = 1;
            s.seed = 77;
        });
        let truth = draw(&world, &truth, 0);
        for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
            let settings = base.with(|s| s.pixel.sampler = sampler);
            let ([claimed, is], covered) = errors(&world, &settings, &truth);
            let ratio = claimed / is;
            println!(
                "| `{name}` | `{}` | {ratio:.2} | {:.0} % |",
                sampler.name(),
                100.0 * covered
            );
            assert!((0.9..1.2).contains(&ratio), "{name}, {sampler:?}: {ratio}");
            assert!(covered > 0.85, "{name}, {sampler:?}: {covered}");
        }
    }
}
