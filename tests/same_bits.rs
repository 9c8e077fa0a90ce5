//! One picture: the same bits for any number of threads, any accelerator, with and without listening.

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::probe::Silent;
use raytree::scene::{self, Sampling, Settings, World};
use raytree::trace::{Counts, ledger, trace_pixel};
use raytree::tracer::{Film, Flow, render};

fn film(world: &World, settings: &Settings, threads: usize) -> Film {
    render::<Silent>(world, settings, threads, &|_, _| Flow::Continue).0
}

fn bits(pixels: &[Rgb]) -> Vec<[u64; 3]> {
    pixels
        .iter()
        .map(|c| c.channels().map(f64::to_bits))
        .collect()
}

fn settings_of(name: &str, width: u32, height: u32) -> Settings {
    let base = scene::load(name).expect("a built-in scene").settings;
    Settings {
        width,
        height,
        ..base
    }
}

#[test]
fn all_accelerators_and_thread_counts_draw_the_same_bits() {
    for (name, _) in scene::list() {
        let settings = settings_of(name, 32, 24);
        let scene = scene::load(name).expect("a built-in scene");
        let list = World::new(scene.clone(), AccelKind::List);
        let expected = film(&list, &settings, 1);
        assert!(!expected.cut, "{name}");
        for kind in AccelKind::ALL {
            let world = World::new(scene.clone(), kind);
            for threads in [1, 8] {
                let got = film(&world, &settings, threads);
                assert_eq!(
                    bits(&expected.pixels),
                    bits(&got.pixels),
                    "{name}, {}, {threads} threads",
                    kind.name()
                );
                assert_eq!(expected.rays, got.rays);
            }
        }
    }
}

#[test]
fn listening_changes_nothing() {
    for (name, _) in scene::list() {
        let settings = settings_of(name, 20, 15);
        let world = World::new(scene::load(name).expect("built in"), settings.accel);
        let silent = film(&world, &settings, 2);
        let (counted, counts) = render::<Counts>(&world, &settings, 2, &|_, _| Flow::Continue);
        assert_eq!(bits(&silent.pixels), bits(&counted.pixels), "{name}");
        let sum = counts.iter().fold(Counts::default(), Counts::plus);
        assert_eq!(sum.rays(), silent.rays, "{name}: each ray is told once");
        for (x, y) in [(10, 7), (3, 12), (17, 2), (9, 11)] {
            for traversal in [false, true] {
                let trace = trace_pixel(&world, &settings, (x, y), traversal);
                assert_eq!(
                    bits(&[trace.pixel.color]),
                    bits(&[silent.at(x, y)]),
                    "{name} ({x}, {y})"
                );
                assert_eq!(ledger::first_open(&trace.tree), None);
                assert_eq!(
                    bits(&[ledger::pixel_sum(&trace)]),
                    bits(&[trace.pixel.color])
                );
            }
        }
    }
}

#[test]
fn jittered_samples_are_the_same_on_every_thread_and_change_with_the_seed() {
    let settings = Settings {
        samples: 4,
        sampling: Sampling::Jittered,
        ..settings_of("whitted", 40, 30)
    };
    let world = World::new(scene::load("whitted").expect("built in"), settings.accel);
    let one = film(&world, &settings, 1);
    assert_eq!(one, film(&world, &settings, 8));
    let other = Settings {
        seed: 1,
        ..settings
    };
    assert_ne!(one, film(&world, &other, 8));
}

#[test]
fn a_render_can_be_stopped() {
    let settings = settings_of("whitted", 256, 256);
    let world = World::new(scene::load("whitted").expect("built in"), settings.accel);
    let (film, _) = render::<Silent>(&world, &settings, 1, &|_, _| Flow::Stop);
    assert!(film.cut);
    assert!(film.at(255, 255).is_black() && !film.at(0, 0).is_black());
}
