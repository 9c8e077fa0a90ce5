//! One picture: the same bits for any number of threads, any accelerator, with and without listening.

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::probe::Silent;
use raytree::sampling::{Filter, LightSampling, Sampler};
use raytree::scene::{self, Adaptive, Pilot, Settings};
use raytree::trace::{Counts, ledger, trace_pixel};
use raytree::tracer::{Film, draw, render};
use raytree::world::World;
use std::ops::ControlFlow;

fn film(world: &World, settings: &Settings, threads: usize) -> Film {
    draw(world, settings, threads)
}

fn bits(pixels: &[Rgb]) -> Vec<[u64; 3]> {
    pixels
        .iter()
        .map(|c| c.channels().map(f64::to_bits))
        .collect()
}

fn settings_of(name: &str, width: u32, height: u32) -> Settings {
    let base = scene::load(name).expect("a built-in scene").settings;
    base.with(|s| {
        s.image.width = width;
        s.image.height = height;
    })
}

#[test]
fn all_accelerators_and_thread_counts_draw_the_same_bits() {
    for (name, _) in scene::list() {
        let settings = settings_of(name, 32, 24);
        let scene = scene::load(name).expect("a built-in scene");
        let list = World::new(scene.clone(), AccelKind::List);
        let expected = film(&list, &settings, 1);
        assert!(!expected.truncated, "{name}");
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
        let (counted, counts) =
            render::<Counts>(&world, &settings, 2, &|_, _| ControlFlow::Continue(()));
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

/// All that can be asked of the samples of a pixel.
fn ways_to_sample(base: Settings) -> Vec<Settings> {
    let mut ways = Vec::new();
    let adaptive = |pilot| {
        Some(Adaptive {
            threshold: 0.02,
            most: 40,
            pilot,
        })
    };
    let plans = [
        (1, None),
        (3, None),
        (1, adaptive(Pilot::Kept)),
        (1, adaptive(Pilot::Apart)),
        (1, adaptive(Pilot::Around)),
    ];
    for sampling in Sampler::ALL {
        for filter in Filter::ALL {
            for (sets, adaptive) in plans {
                let sampler = if sampling == Sampler::Stratified {
                    Sampler::Stratified
                } else {
                    base.light.sampler
                };
                ways.push(base.with(|s| {
                    s.pixel.samples = 5;
                    s.pixel.sets = sets;
                    s.pixel.sampler = sampling;
                    s.pixel.filter = filter;
                    s.pixel.filter_radius = filter.usual_radius();
                    s.pixel.adaptive = adaptive;
                    s.light.samples = 2;
                    s.light.sampler = sampler;
                    s.pixel.errors = true;
                }));
            }
        }
    }
    ways
}

#[test]
fn however_samples_are_chosen_the_replay_is_the_picture() {
    let base = settings_of("soft-shadow", 18, 17);
    let scene = scene::load("soft-shadow").expect("built in");
    let [wide, list] = [AccelKind::Wide, AccelKind::List].map(|k| World::new(scene.clone(), k));
    let mut adapted = 0;
    for settings in ways_to_sample(base) {
        let picture = film(&wide, &settings, 1);
        assert_eq!(picture, film(&list, &settings, 8), "{settings:?}");
        let (told, counts) =
            render::<Counts>(&list, &settings, 2, &|_, _| ControlFlow::Continue(()));
        assert_eq!(bits(&picture.pixels), bits(&told.pixels), "{settings:?}");
        let sum = counts.iter().fold(Counts::default(), Counts::plus);
        assert_eq!(
            sum.rays(),
            picture.rays,
            "{settings:?}: each ray is told once"
        );
        adapted += usize::from(picture.samples.iter().any(|n| *n > 10));
        for (x, y) in [(9, 9), (4, 13), (17, 16)] {
            let trace = trace_pixel(&list, &settings, (x, y), false);
            assert_eq!(
                bits(&[trace.pixel.color]),
                bits(&[picture.at(x, y)]),
                "{settings:?}"
            );
            assert_eq!(
                bits(&[ledger::pixel_sum(&trace)]),
                bits(&[picture.at(x, y)])
            );
            let index = (y * 18 + x) as usize;
            assert_eq!(trace.pixel.error.to_bits(), picture.errors[index].to_bits());
            assert_eq!(trace.tree.samples.len(), trace.pixel.samples as usize);
        }
    }
    assert!(
        adapted > 30,
        "most adaptive pictures have pixels with more samples: {adapted}"
    );
}

#[test]
fn samples_by_chance_change_with_the_seed() {
    for sampling in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        let settings = settings_of("whitted", 40, 30).with(|s| {
            s.pixel.samples = 4;
            s.pixel.sampler = sampling;
        });
        let world = World::new(scene::load("whitted").expect("built in"), settings.accel);
        let other = settings.with(|s| s.seed = 1);
        assert_ne!(film(&world, &settings, 2), film(&world, &other, 2));
    }
}

/// From 65 rays on each hit asks for itself; and a pixel whose budget ends between two rays ends there in both.
#[test]
fn rays_to_area_lights_are_the_same_when_they_are_foreseen() {
    for (name, light_samples, max_rays) in [
        ("soft-shadow", 1, u64::MAX),
        ("soft-shadow", 64, u64::MAX),
        ("soft-shadow", 65, u64::MAX),
        ("lamps", 3, u64::MAX),
        ("lamps", 20, u64::MAX),
        ("lamps", 7, 40 * 30 * 15),
    ] {
        for light_sampling in LightSampling::ALL {
            let settings = settings_of(name, 40, 30).with(|s| {
                s.pixel.samples = 2;
                s.light.samples = light_samples;
                s.light.density = light_sampling;
                s.recursion.max_rays = max_rays;
            });
            let scene = scene::load(name).expect("built in");
            let [wide, list] =
                [AccelKind::Wide, AccelKind::List].map(|kind| World::new(scene.clone(), kind));
            let foreseen = film(&wide, &settings, 2);
            let asked = film(&list, &settings, 2);
            assert_eq!(bits(&foreseen.pixels), bits(&asked.pixels), "{settings:?}");
            assert_eq!(foreseen.rays, asked.rays, "{settings:?}");
            assert_eq!(foreseen.truncated, max_rays < u64::MAX, "{settings:?}");
        }
    }
}

#[test]
fn a_render_can_be_stopped() {
    let settings = settings_of("whitted", 256, 256);
    let world = World::new(scene::load("whitted").expect("built in"), settings.accel);
    let (film, _) = render::<Silent>(&world, &settings, 1, &|_, _| ControlFlow::Break(()));
    assert!(film.truncated);
    assert!(film.at(255, 255).is_black() && !film.at(0, 0).is_black());
}
