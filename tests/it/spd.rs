//! Haines' procedural scenes send as many rays as others have published.
//!
//! Counts by Haines (1987 and later) and by Havran (1999), both in the documents of the original; Haines expects
//! agreement within about 10 %.
//!
//! The published sizes are the defaults. What is found may lie between the two counts, or beyond them by the tolerance
//! that is stated with each.

use raytree::probe::{Event, Probe, RayKind};
use raytree::scene::{self, Settings};
use raytree::tracer::render;
use raytree::world::World;
use std::ops::ControlFlow;

/// How many rays of each sort there were.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    last: Option<RayKind>,
    eye_hits: u64,
    bounced: u64,
    shadow: u64,
}

impl Probe for Tally {
    const TRAVERSAL: bool = false;

    fn event(&mut self, event: Event) {
        match event {
            Event::Ray(sent) => {
                self.last = Some(sent.kind);
                match sent.kind {
                    RayKind::Incident => {}
                    RayKind::Light => self.shadow += 1,
                    RayKind::Reflected | RayKind::Transmitted => self.bounced += 1,
                }
            }
            Event::Hit(_) => self.eye_hits += u64::from(self.last == Some(RayKind::Incident)),
            _ => {}
        }
    }
}

fn tally(world: &World, settings: &Settings) -> Tally {
    let (film, parts) = render::<Tally>(world, settings, 2, &|_, _| ControlFlow::Continue(()));
    assert!(!film.truncated);
    parts.iter().fold(Tally::default(), |sum, part| Tally {
        last: None,
        eye_hits: sum.eye_hits + part.eye_hits,
        bounced: sum.bounced + part.bounced,
        shadow: sum.shadow + part.shadow,
    })
}

/// Every so manieth ray of each row and column is followed to its end: all of them if this test is optimised.
const STRIDE: u32 = if cfg!(debug_assertions) { 4 } else { 1 };

/// Counts at the published size; for bounced (reflected and refracted) and shadow rays also how far off they may be.
struct Published {
    eye_hits: [u64; 2],
    bounced: [u64; 2],
    shadow: [u64; 2],
    shadow_tolerance: f64,
}

/// Within `tolerance` of one of the two, or between them.
fn near(what: &str, found: f64, published: [u64; 2], tolerance: f64) {
    let [a, b] = published.map(|n| n as f64);
    let (low, high) = (a.min(b) * (1.0 - tolerance), a.max(b) * (1.0 + tolerance));
    assert!(
        (low..=high).contains(&found),
        "{what}: {found} instead of {published:?}"
    );
}

fn check(name: &str, published: &Published) {
    let scene = scene::load(name).expect("computed");
    let settings = scene.settings;
    assert_eq!((settings.size(), settings.recursion.depth), ((513, 513), 4));
    let mut world = World::new(scene, settings.accel);

    // Some of the corners of the 512 x 512 pixels, by the same reckoning as all of them.
    let edge = 512 / STRIDE + 1;
    let (one, all) = (f64::from(edge), 513.0);
    let camera = &mut world.scene.camera;
    let whole = camera.half_height;
    camera.half_height = whole * (512.0 / all) * (one / (one - 1.0));
    let some = settings.with(|s| {
        s.image.width = edge;
        s.image.height = edge;
    });
    let rays = tally(&world, &some);
    let scale = (all / one) * (all / one);
    near(
        "reflected and refracted",
        rays.bounced as f64 * scale,
        published.bounced,
        0.1,
    );
    let tolerance = published.shadow_tolerance;
    near(
        "shadow",
        rays.shadow as f64 * scale,
        published.shadow,
        tolerance,
    );

    // What the eye sees, in full.
    world.scene.camera.half_height = whole;
    world.scene.lights.clear();
    let direct = settings.with(|s| s.recursion.depth = 0);
    let hits = tally(&world, &direct).eye_hits;
    near("eye hits", hits as f64, published.eye_hits, 0.005);
    println!("{name}: {hits} {rays:?}");
}

#[test]
fn balls() {
    let published = Published {
        eye_hits: [263_169; 2],
        bounced: [175_095, 179_884],
        shadow: [954_368, 959_244],
        shadow_tolerance: 0.1,
    };
    check("spd:balls", &published);
}

#[test]
fn gears() {
    let published = Published {
        eye_hits: [245_086, 245_332],
        bounced: [512_207, 494_338],
        shadow: [2_246_955, 2_088_012],
        shadow_tolerance: 0.1,
    };
    check("spd:gears", &published);
}

#[test]
fn mount() {
    let published = Published {
        eye_hits: [173_125, 173_685],
        bounced: [709_538, 710_436],
        shadow: [412_922, 361_037],
        shadow_tolerance: 0.15,
    };
    check("spd:mount", &published);
}

#[test]
fn rings() {
    let published = Published {
        eye_hits: [263_169; 2],
        bounced: [315_236, 312_879],
        shadow: [1_085_002, 1_077_336],
        shadow_tolerance: 0.1,
    };
    check("spd:rings", &published);
}

#[test]
fn tetra() {
    let published = Published {
        eye_hits: [49_788, 49_950],
        bounced: [0; 2],
        shadow: [46_112, 46_262],
        shadow_tolerance: 0.1,
    };
    check("spd:tetra", &published);
}

#[test]
fn tree() {
    let published = Published {
        eye_hits: [169_836, 169_907],
        bounced: [0; 2],
        shadow: [1_097_419, 1_110_323],
        shadow_tolerance: 0.1,
    };
    check("spd:tree", &published);
}
