//! Other arithmetic than ours: it is only there where it was asked for, never without a word, and cannot stop the tracer.

use std::process::Command;

use raytree::accel::AccelKind;
use raytree::geometry::{Arithmetic, Offset, Precision, Quadratic, TriangleTest};
use raytree::probe::Event;
use raytree::scene::{self, Settings};
use raytree::trace::{View, trace_pixel};
use raytree::tracer::{Film, draw};
use raytree::world::World;

const NONE: Arithmetic = Arithmetic {
    offset: Offset::None,
    ..Arithmetic::OURS
};

fn variants() -> Vec<Arithmetic> {
    let mut all = Vec::new();
    for triangle in TriangleTest::ALL {
        for offset in [Offset::None, Offset::Fixed(1e-4), Offset::Bounded] {
            for quadratic in Quadratic::ALL {
                for precision in Precision::ALL {
                    all.push(Arithmetic {
                        triangle,
                        offset,
                        quadratic,
                        precision,
                        ..Arithmetic::OURS
                    });
                }
            }
        }
    }
    all
}

fn world(name: &str, kind: AccelKind, arithmetic: Arithmetic) -> (World, Settings) {
    let scene = scene::load(name).expect("a built-in scene");
    let settings = scene.settings.with(|s| {
        s.image.width = 24;
        s.image.height = 18;
        s.light.samples = 2;
        s.arithmetic = arithmetic;
    });
    (World::new(scene.computed_with(arithmetic), kind), settings)
}

fn film(world: &World, settings: &Settings) -> Film {
    draw(world, settings, 1)
}

#[test]
fn every_choice_draws_a_picture_and_is_replayed_bit_for_bit() {
    for name in ["whitted", "nested-glass", "room", "teapot", "lamps"] {
        for arithmetic in variants() {
            let (world, settings) = world(name, AccelKind::Wide, arithmetic);
            let film = film(&world, &settings);
            assert!(
                film.pixels
                    .iter()
                    .all(|c| c.channels().iter().all(|x| x.is_finite()))
            );
            let (x, y) = (11, 9);
            let replayed = trace_pixel(&world, &settings, (x, y), false).pixel.color;
            let drawn = film.pixels[(y * film.width + x) as usize];
            assert_eq!(replayed, drawn, "{name} {arithmetic:?}");
        }
    }
}

#[test]
fn every_accelerator_ends_with_every_choice() {
    for kind in AccelKind::ALL {
        for arithmetic in variants().into_iter().step_by(3) {
            let (world, settings) = world("room", kind, arithmetic);
            assert!(!film(&world, &settings).truncated);
        }
    }
}

/// Whatever it is tested with, a light does not stand in its own way: these are off by little.
#[test]
fn area_lights_shine_with_every_choice_that_has_an_offset() {
    for name in ["soft-shadow", "lamps"] {
        let (ours, settings) = world(name, AccelKind::Wide, Arithmetic::default());
        let expected = film(&ours, &settings).pixels;
        for arithmetic in variants() {
            if arithmetic.offset == Offset::None {
                continue;
            }
            let (world, settings) = world(name, AccelKind::Wide, arithmetic);
            let found = film(&world, &settings).pixels;
            let differ = expected.iter().zip(&found).filter(|(a, b)| {
                let pairs = a.channels().into_iter().zip(b.channels());
                pairs.into_iter().any(|(a, b)| (a - b).abs() > 0.02)
            });
            let differ = differ.count();
            assert!(20 * differ < found.len(), "{name} {arithmetic:?}: {differ}");
        }
    }
}

#[test]
fn back_to_our_own_arithmetic_the_bits_are_the_same() {
    let (ours, settings) = world("whitted", AccelKind::Bsp, Arithmetic::default());
    let scene = scene::load("whitted").expect("built in");
    let scene = scene
        .computed_with(NONE)
        .computed_with(Arithmetic::default());
    let again = World::new(scene, AccelKind::Bsp);
    assert_eq!(
        film(&ours, &settings).pixels,
        film(&again, &settings).pixels
    );
}

/// Of the pixels, those with a ray that hits the surface that it left.
fn self_hits(name: &str, arithmetic: Arithmetic) -> (usize, usize) {
    let (world, settings) = world(name, AccelKind::Bsp, arithmetic);
    let (mut pixels, mut explained) = (0, 0);
    for i in 0..settings.image.width * settings.image.height {
        let trace = trace_pixel(
            &world,
            &settings,
            (i % settings.image.width, i / settings.image.width),
            false,
        );
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        let found = (0..trace.tree.nodes.len() as u32).find(|node| view.is_self_hit(*node));
        pixels += usize::from(found.is_some());
        // Such a hit is explained as what it is.
        let tree = &trace.tree;
        let told = (0..tree.events.len())
            .filter(|e| matches!(tree.events[*e], Event::Blocked(_) | Event::Hit(_)))
            .any(|e| {
                let explanation = raytree::trace::explain(view, e);
                explanation.rows.iter().any(|row| row.name == "self-hit")
            });
        explained += usize::from(told);
    }
    (pixels, explained)
}

#[test]
fn without_an_offset_rays_hit_their_own_surface_and_the_debugger_says_so() {
    for name in ["whitted", "room"] {
        let (pixels, explained) = self_hits(name, NONE);
        assert!(pixels > 40, "{name}: {pixels}");
        assert_eq!(pixels, explained);
        assert_eq!(self_hits(name, Arithmetic::default()), (0, 0), "{name}");
    }
}

#[test]
fn another_arithmetic_is_told_on_standard_error_and_in_the_tree() {
    let trace = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
        let output = command
            .args(["trace", "triangle", "--pixel", "5,5"])
            .args(more)
            .output();
        let output = output.expect("the program runs");
        assert!(output.status.success());
        let tree: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        (
            tree["settings"]["arithmetic"].clone(),
            String::from_utf8_lossy(&output.stderr).into_owned(),
        )
    };
    let (tree, said) = trace(&[]);
    assert!(tree.is_null() && said.is_empty());
    let (tree, said) = trace(&["--triangle", "plane-edges", "--offset", "fixed:1e-3"]);
    assert_eq!(tree["triangle"], "plane-edges");
    assert_eq!(tree["offset"], "fixed:1e-3");
    assert_eq!(tree["precision"], "double");
    assert!(
        said.contains("note: --triangle plane-edges: ")
            && said.contains("note: --offset fixed:1e-3: ")
    );
    // To ask for what is the default is no deviation.
    let (tree, said) = trace(&["--triangle", "watertight", "--offset", "bounded"]);
    assert!(tree.is_null() && said.is_empty());
}

#[test]
fn a_wrong_choice_is_told_with_the_right_ones() {
    for (flag, wrong, hint) in [
        ("--patch-test", "triangles:0", "from 1 to 64"),
        ("--offset", "1e-4", "fixed:EPS"),
        ("--offset", "fixed:-1", "above 0"),
        ("--triangle", "woop", "plane-edges"),
        ("--quadratic", "exact", "naive"),
        ("--precision", "half", "single"),
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
        let output = command
            .args(["render", "triangle", flag, wrong])
            .output()
            .expect("the program runs");
        assert_eq!(output.status.code(), Some(2), "{flag} {wrong}");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains(hint), "{said}");
    }
}
