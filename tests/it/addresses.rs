//! Addresses: every ray of a pixel has one, and it leads to that ray.

use raytree::debug::Session;
use raytree::scene;
use raytree::trace::address::{node_at, subtree};
use raytree::trace::document::SampleTree;
use raytree::trace::facts::pixel_facts;
use raytree::trace::{Address, View, document, trace_pixel};
use raytree::world::World;
use std::sync::Arc;

use super::cli::{refused, run};

#[test]
fn every_ray_is_found_by_its_path() {
    for name in ["whitted", "glass-block", "soft-shadow", "mirrors"] {
        let scene = scene::load(name).expect("a built-in scene");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (32, 24);
            s.light.samples = 4;
            s.pixel.samples = 2;
        });
        let world = Arc::new(World::new(scene, settings.accel));
        let trace = trace_pixel(&world, &settings, (17, 14), false);
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        let document = document::of(view);
        let facts = pixel_facts(&document);
        assert_eq!(facts.rays.len(), trace.tree.nodes.len());
        for (number, ray) in facts.rays.iter().enumerate() {
            assert_eq!(
                node_at(view, &ray.path),
                Ok(number as u32),
                "{name}{}",
                ray.path
            );
            let alone = subtree(document.clone(), &ray.path).expect("it is there");
            let size = trace.tree.node(number as u32).size as usize;
            assert_eq!(
                alone.samples.iter().flat_map(SampleTree::rays).count(),
                size
            );
            assert_eq!(
                alone.samples[0].root.as_ref().map(|root| root.id),
                Some(number as u32)
            );
        }
        let mut session = Session::of(Arc::clone(&world), settings, trace.clone());
        for (number, ray) in facts.rays.iter().enumerate() {
            let text = format!("17,14{}", ray.path);
            let address: Address = text.parse().expect("an address");
            assert_eq!(session.go_to_address(&address), Ok(()));
            assert_eq!(session.node(), Some(number as u32), "{text}");
        }
        let event: Address = "17,14#5".parse().expect("an address");
        assert_eq!(session.go_to_address(&event), Ok(()));
        assert_eq!(session.cursor().position(), 5);
    }
}

#[test]
fn trace_writes_the_tree_of_an_address() {
    let json = |args: &[&str]| -> serde_json::Value {
        let ran = run(args);
        assert_eq!(ran.code, 0, "{args:?}: {}", ran.err);
        serde_json::from_slice(&ran.out).expect("JSON")
    };
    let whole = json(&["trace", "whitted", "--pixel", "160,120"]);
    assert_eq!(json(&["trace", "whitted@160,120"]), whole);
    assert_eq!(json(&["trace", "whitted", "--at", "160,120"]), whole);
    let children = whole
        .pointer("/samples/0/root/children")
        .and_then(|c| c.as_array())
        .expect("rays");
    let reflected = children
        .iter()
        .find(|child| child["kind"] == "R")
        .expect("it mirrors");
    for args in [
        &["trace", "whitted@160,120/R"][..],
        &["trace", "whitted", "--at", "160,120/R"],
        &["trace", "whitted", "--at", "whitted@160,120/R"],
    ] {
        assert_eq!(
            json(args).pointer("/samples/0/root"),
            Some(reflected),
            "{args:?}"
        );
    }
    for (args, words) in [
        (&["trace", "whitted"][..], &["--pixel X,Y", "SCENE@X,Y"][..]),
        (&["trace", "whitted@160"], &["`160` is no pixel"]),
        (&["trace", "whitted@160,120/X"], &["`X` is no step"]),
        (&["trace", "whitted@999,0"], &["outside the picture"]),
        (
            &["trace", "whitted@160,120/R/T/R"],
            &["there is no step T from /R, which sends L:"],
        ),
        (&["trace", "whitted@160,120:7"], &["there is no sample 7"]),
        (&["trace", "whitted@1,2", "--pixel", "1,2"], &["told twice"]),
        (&["trace", "whitted@1,2", "--at", "1,2"], &["told twice"]),
        (
            &["trace", "whitted", "--at", "room@1,2"],
            &["another scene"],
        ),
        (
            &["trace", "whitted", "--at", "1,2", "--pixel", "1,2"],
            &["cannot be used with"],
        ),
        (&["view", "whitted@1"], &["`1` is no pixel"]),
        (
            &["view", "whitted@99,99", "--size", "20x20"],
            &["outside the picture of 20x20"],
        ),
    ] {
        refused(args, 2, words);
    }
}
