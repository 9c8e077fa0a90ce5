//! Stepping through a recorded pixel: back undoes forward, over and out nest, and a million rays are no burden.

use std::time::{Duration, Instant};

use proptest::prelude::*;
use raytree::debug::Cursor;
use raytree::math::{DVec3, Rgb};
use raytree::probe::{Event, NONE, Probe, RayKind, RayRecord};
use raytree::scene::{self, Settings};
use raytree::trace::{PixelTrace, RayTree, Recorder, View, document, explain, ledger, trace_pixel};
use raytree::world::World;

use crate::common;

fn traced(name: &str, at: (u32, u32), depth: u32) -> (World, Settings, PixelTrace) {
    let scene = scene::load(name).expect("a built-in scene");
    let settings = scene.settings.with(|s| {
        s.image.width = 64;
        s.image.height = 48;
        s.recursion.depth = depth;
        s.pixel.samples = 2;
    });
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(&world, &settings, at, true);
    (world, settings, trace)
}

#[test]
fn every_event_belongs_to_the_ray_around_it() {
    let (_, _, trace) = traced("whitted", (30, 22), 4);
    let tree = &trace.tree;
    assert!(
        tree.nodes.len() > 12,
        "a tree worth the name: {}",
        tree.nodes.len()
    );
    // The slow twin of `node_of_event`: replay the log with a stack.
    let (mut open, mut next) = (Vec::new(), 0);
    for (index, event) in tree.events.iter().enumerate() {
        if let Event::Ray(_) = event {
            open.push(next);
            next += 1;
        }
        assert_eq!(
            tree.node_of_event(index),
            open.last().copied(),
            "event {index}"
        );
        if let Event::Return { .. } = event {
            open.pop();
        }
    }
    // Every event of a ray is told once, by its own node.
    let own: usize = (0..next).map(|id| tree.own_events(id).count()).sum();
    let samples = tree.samples.len();
    assert_eq!(own + samples, tree.events.len());
    assert_eq!(tree.samples.iter().filter_map(|s| s.root).count(), samples);
}

proptest! {
    #![proptest_config(common::config(256))]

    #[test]
    fn back_undoes_step(start in 0usize..10_000) {
        let (_, _, trace) = traced("whitted", (30, 22), 3);
        let tree = &trace.tree;
        let here = Cursor::at(tree, start);
        let ahead = here.step(tree);
        if ahead != here {
            prop_assert_eq!(ahead.back(), here);
        }
        let behind = here.back();
        if behind != here {
            prop_assert_eq!(behind.step(tree), here);
        }
        // Over and out never go back, and land on an end or behind the traversal.
        for far in [here.over(tree), here.out(tree)] {
            prop_assert!(far.position() >= here.position());
        }
        for kind in RayKind::ALL {
            if let Some(ray) = here.next_ray(tree, |k| k == kind) {
                prop_assert!(ray.position() > here.position());
                let is_kind = matches!(tree.events[ray.position()], Event::Ray(sent) if sent.kind == kind);
                prop_assert!(is_kind);
                prop_assert!(ray.step(tree).previous_ray(tree, |k| k == kind) == Some(ray));
            }
        }
    }
}

#[test]
fn over_a_ray_shows_its_answer_and_out_shows_its_senders() {
    let (_, _, trace) = traced("whitted", (30, 22), 4);
    let tree = &trace.tree;
    for (id, node) in tree.nodes.iter().enumerate() {
        let start = Cursor::at_node(tree, id as u32);
        assert_eq!(start.over(tree).position(), node.last_event as usize);
        assert_eq!(
            start.step(tree).out(tree).position(),
            node.last_event as usize
        );
        if let Some(parent) = node.parent {
            let from_end = Cursor::at(tree, node.last_event as usize).out(tree);
            assert_eq!(from_end.position(), tree.node(parent).last_event as usize);
        }
    }
    assert_eq!(Cursor::end(tree).position() + 1, tree.events.len());
}

#[test]
fn every_event_can_be_explained() {
    for name in [
        "whitted",
        "nested-glass",
        "glass-block",
        "shadows",
        "room",
        "mirrors",
        "bunny",
    ] {
        let (world, settings, trace) = traced(name, (30, 26), 4);
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        for index in 0..trace.tree.events.len() {
            let said = explain(view, index);
            assert!(
                !said.title.is_empty() && said.sentence.ends_with(['.', '?']),
                "{said:?}"
            );
            assert!(
                !said.rows.iter().any(|r| r.text.contains("NaN")),
                "{said:?}"
            );
        }
    }
}

/// Writes the log of a full binary tree of R and T rays: 2^levels - 1 of them.
fn binary<P: Probe>(probe: &mut P, depth: u32, levels: u32) -> Rgb {
    let kind = if depth == 0 {
        RayKind::Incident
    } else {
        RayKind::Reflected
    };
    let weight = if depth == 0 {
        Rgb::WHITE
    } else {
        Rgb::grey(0.5)
    };
    probe.event(Event::Ray(RayRecord {
        kind,
        sample: 0,
        depth,
        light: NONE,
        medium: NONE,
        origin: DVec3::ZERO,
        direction: DVec3::Z,
        t_max: f64::INFINITY,
        weight,
    }));
    let mut radiance = Rgb::BLACK;
    if depth + 1 == levels {
        probe.event(Event::Miss);
        radiance = Rgb::WHITE;
    } else {
        radiance += Rgb::grey(0.5) * binary(probe, depth + 1, levels);
        radiance += Rgb::grey(0.5) * binary(probe, depth + 1, levels);
    }
    probe.event(Event::Return { radiance });
    radiance
}

#[test]
fn a_million_rays_step_without_lag() {
    let mut recorder = Recorder::<false>::default();
    recorder.event(Event::Sample {
        index: 0,
        film: [0.5, 0.5],
        weight: 1.0,
    });
    binary(&mut recorder, 0, 20);
    let tree = RayTree::new(recorder);
    assert_eq!((tree.nodes.len(), tree.dropped), ((1 << 20) - 1, 0));
    let start = Instant::now();
    for i in 0..2000 {
        let cursor = Cursor::at(&tree, i * 1013)
            .step(&tree)
            .out(&tree)
            .over(&tree)
            .back();
        let node = tree.node_of_event(cursor.position());
        assert!(tree.own_events(node.unwrap_or(0)).count() < 10);
    }
    // A key has 16 ms; here 2,000 rounds of five moves have 1,000 times less each.
    assert!(
        start.elapsed() < Duration::from_secs(4),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn a_log_is_bounded_and_says_so() {
    let scene = scene::load("whitted").expect("built in");
    let settings = scene.settings.with(|s| {
        s.image.width = 64;
        s.image.height = 48;
    });
    let world = World::new(scene, settings.accel);
    for limit in [0, 1, 2, 7, 40] {
        let mut recorder = Recorder::<true>::with_limit(limit);
        let pixel = raytree::tracer::pixel(&world, &settings, (30, 22), &mut recorder);
        assert_eq!(recorder.events.len(), limit);
        assert!(recorder.dropped > 0);
        let tree = RayTree::new(recorder);
        let trace = PixelTrace {
            x: 30,
            y: 22,
            pixel,
            tree,
        };
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        let text = serde_json::to_string(&document::of(view)).expect("writable");
        assert!(text.contains("\"truncated\":"), "{text}");
        // What is there can still be walked and explained.
        for index in 0..trace.tree.events.len() {
            explain(view, index);
        }
    }
}

#[test]
fn the_ledger_notices_a_wrong_sum() {
    let (_, _, mut trace) = traced("whitted", (30, 22), 3);
    assert_eq!(ledger::first_open(&trace.tree), None);
    trace.tree.nodes[0].radiance.r += f64::EPSILON;
    assert_eq!(ledger::first_open(&trace.tree), Some(0));
}
