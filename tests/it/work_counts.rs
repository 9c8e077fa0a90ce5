//! The gate on work: how many nodes are visited and how many shapes are tested may fall, but not rise.
//!
//! Counts are the same on every machine, whatever else it does and whatever instructions it has (steps that are told of are
//! the same with all of them: a test of `accel::simd`), so they are gated exactly; seconds never are.

use std::fmt::Write;
use std::ops::ControlFlow;

use raytree::accel::AccelKind;
use raytree::scene::{self, Settings};
use raytree::trace::Counts;
use raytree::tracer::render;
use raytree::world::World;

/// Lines of scene, accelerator, rays, nodes and tests, at 80x60 pixels and else as the scene wants it.
const FIGURES: &str = include_str!("../counts.txt");

/// All that is counted while a picture is drawn.
fn counts(world: &World, settings: &Settings) -> Counts {
    let (film, parts) = render::<Counts>(world, settings, 0, &|_, _| ControlFlow::Continue(()));
    assert!(!film.truncated, "nothing is left out");
    parts.iter().fold(Counts::default(), Counts::plus)
}

#[test]
fn no_more_work_than_before() {
    let (mut anew, mut complaints) = (String::new(), String::new());
    for line in FIGURES.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let [name, kind] = [words[0], words[1]];
        let [rays, nodes, tests] = [2, 3, 4].map(|i| words[i].parse::<u64>().expect("a number"));
        let scene = scene::load(name).expect("a built-in scene");
        let settings = scene.settings.with(|s| {
            s.image.width = 80;
            s.image.height = 60;
        });
        let accel = AccelKind::ALL.into_iter().find(|k| k.name() == kind);
        let world = World::new(scene, accel.expect("the name of an accelerator"));
        let found = counts(&world, &settings);
        let now = [found.rays(), found.nodes, found.tests];
        if now[0] != rays || now[1] > nodes || now[2] > tests {
            let before = [rays, nodes, tests];
            let _ = writeln!(
                complaints,
                "{name}, {kind}: rays, nodes, tests {now:?}, not {before:?}"
            );
        }
        let _ = writeln!(anew, "{name} {kind} {} {} {}", now[0], now[1], now[2]);
    }
    assert!(
        complaints.is_empty(),
        "other rays or more work than before:\n{complaints}\
         If that is meant, say in the commit why, and let tests/counts.txt be:\n{anew}"
    );
}
