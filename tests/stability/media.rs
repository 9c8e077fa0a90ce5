//! Media that are nested, overlap, touch or are looked at from inside. Source of the rule: Schmidt and Budge 2002. Oracle:
//! where a ray is on its way, told from the coordinates of that place alone.

use raytree::accel::AccelKind;
use raytree::math::DVec3;
use raytree::probe::{Event, NONE, RayKind, Silent};
use raytree::scene::{Camera, Settings};
use raytree::trace::{Outcome, PixelTrace, trace_pixel};
use raytree::tracer::render;
use raytree::world::World;
use std::ops::ControlFlow;

use super::support::{count, scene};
use super::vessel::{Body, Make, Solid, vessel};

fn world(solids: &[Solid], make: Make, eye: [f64; 3], kind: AccelKind) -> World {
    let list = |one: fn(&Solid, Make) -> String| {
        let texts: Vec<String> = solids.iter().map(|s| one(s, make)).collect();
        texts.join(", ")
    };
    let text = format!(
        r#"{{"format": "raytree-scene/1", "background": [1, 1, 1],
        "camera": {{"eye": {eye:?}, "look_at": [0.01, 0.02, 0.03], "vertical_fov": 50}},
        "materials": {{{}}}, "objects": [{}]}}"#,
        list(|s, _| s.material()),
        list(Solid::object)
    );
    World::new(scene(&text), kind)
}

fn settings(size: u32) -> Settings {
    Settings::default().with(|s| {
        s.image.width = size;
        s.image.height = size;
        s.recursion.depth = 9;
        s.recursion.min_weight = 3e-3;
    })
}

/// What a check of all rays of a picture met.
#[derive(Default, Debug)]
struct Met {
    left: usize,
    told: usize,
    inside: usize,
}

/// Follows all rays of a picture. Each that leaves the scene must travel in air. Each must travel, half way, in the medium
/// of highest priority that contains the place where it is.
fn follow(world: &World, size: u32, solids: &[Solid], make: Make) -> Met {
    let settings = settings(size);
    let bodies: Vec<Body> = solids.iter().map(|s| Body::new(*s, make)).collect();
    let mut met = Met::default();
    let check = |met: &mut Met, trace: &PixelTrace| {
        for (id, node) in trace.tree.nodes.iter().enumerate() {
            let sent = &node.ray;
            let place = || format!("pixel ({}, {}), ray {id}", trace.x, trace.y);
            let end = match node.outcome {
                _ if sent.kind == RayKind::Light => continue,
                Some(Outcome::Hit(hit)) => hit.t,
                Some(Outcome::Miss) => {
                    met.left += 1;
                    assert_eq!(sent.medium, NONE, "{}", place());
                    continue;
                }
                other => panic!("{other:?}"),
            };
            let middle = sent.origin + 0.5 * end * sent.direction;
            let inside: Option<Vec<bool>> = bodies.iter().map(|b| b.contains(middle)).collect();
            let Some(inside) = inside else { continue };
            met.told += 1;
            let around = solids.iter().zip(inside).filter(|(_, inside)| *inside);
            let expected = around.max_by_key(|(s, _)| s.priority);
            met.inside += usize::from(expected.is_some());
            assert_eq!(
                world.scene.medium_name(sent.medium),
                expected.map_or("air", |(s, _)| s.name),
                "{}: at {middle}, in the middle of {end}",
                place()
            );
        }
    };
    for y in 0..size {
        for x in 0..size {
            check(&mut met, &trace_pixel(world, &settings, (x, y), false));
        }
    }
    met
}

const EYES: [(&str, [f64; 3]); 4] = [
    ("air", [2.1, 1.3, 3.2]),
    ("glass", [0.12, 0.07, 0.91]),
    ("water", [0.11, -0.45, 0.37]),
    ("bubble", [0.05, 0.21, 0.1]),
];

fn nested(overlap: f64) {
    let size = count(32, 6) as u32;
    for (place, eye) in EYES {
        for make in [Make::Sphere, Make::Box, Make::Globe] {
            let mut solids = vessel(overlap);
            for order in 0..2 {
                let world = world(&solids, make, eye, AccelKind::default());
                let met = follow(&world, size, &solids, make);
                assert!(met.left > 0, "{place} {make:?} {order}");
                assert!(met.inside > 30, "{place} {make:?}: {met:?}");
                solids.reverse();
            }
        }
    }
}

/// Source: case 66. Expected: no ray leaves the scene inside anything, and none is taken to be where it is not.
#[test]
fn case_66_water_in_glass_overlapping() {
    nested(1e-6);
}

#[test]
fn case_66_water_in_glass_exactly_coincident() {
    nested(0.0);
}

#[test]
fn case_66_water_in_glass_with_a_gap() {
    nested(-1e-6);
}

/// A gap or an overlap of a few floats: less than rounding can tell apart.
#[test]
fn case_66_water_in_glass_almost_coincident() {
    for floats in [1.0, -1.0, 3.0, -3.0] {
        nested(floats * f64::EPSILON);
    }
}

/// Source: the medium at the eye is known on paper.
#[test]
fn case_66_the_eye_knows_what_it_is_in() {
    for make in [Make::Sphere, Make::Box] {
        for overlap in [0.0, 1e-6] {
            for (name, eye) in EYES {
                let solids = vessel(overlap);
                let world = world(&solids, make, eye, AccelKind::default());
                let trace = trace_pixel(&world, &settings(1), (0, 0), false);
                let medium = trace.tree.node(0).ray.medium;
                assert_eq!(world.scene.medium_name(medium), name);
            }
        }
    }
}

/// The straight way of the middle ray, T after T, which starts where the index is `start`: the indices of refraction and the
/// objects that it meets.
fn straight(world: &World, start: f64) -> (Vec<f64>, Vec<&str>) {
    let trace = trace_pixel(world, &settings(1), (0, 0), false);
    let (mut indices, mut objects) = (vec![start], Vec::new());
    let mut id = 0;
    loop {
        for (_, event) in trace.tree.own_events(id) {
            match event {
                Event::Boundary { n1, n2, .. } => {
                    assert_eq!(indices.last(), Some(n1));
                    indices.push(*n2);
                }
                Event::Hit(hit) => {
                    objects.push(&world.scene.object_of(hit.primitive).name[..]);
                }
                _ => {}
            }
        }
        let through = |c: &u32| trace.tree.node(*c).ray.kind == RayKind::Transmitted;
        match trace.tree.children(id).find(through) {
            Some(next) => id = next,
            None => return (indices, objects),
        }
    }
}

/// A pool whose water has a surface and no bottom, with a ball of glass in it.
#[test]
fn case_66_open_water_is_entered_by_the_front_and_left_by_the_back() {
    let surfaces = [
        r#"{"quad": {"name": "surface", "material": "water", "corner": [-9, 0, 9], "u": [18, 0, 0], "v": [0, 0, -18]}}"#,
        r#"{"plane": {"name": "surface", "material": "water", "point": [0, 0, 0], "normal": [0, 1, 0]}}"#,
    ];
    for surface in surfaces {
        let down = (
            [0.1, 3.0, 0.0],
            vec![1.0, 1.33, 1.5, 1.33],
            vec!["surface", "ball", "ball", "floor"],
        );
        let up = (
            [0.1, -0.95, 0.0],
            vec![1.33, 1.5, 1.33, 1.0],
            vec!["ball", "ball", "surface"],
        );
        for (eye, way, objects) in [down, up] {
            let text = format!(
                r#"{{"format": "raytree-scene/1",
                "camera": {{"eye": {eye:?}, "look_at": [0, -0.6, 0], "vertical_fov": 1, "up": [0, 0, 1]}},
                "materials": {{
                  "floor": {{"diffuse": [1, 1, 1]}},
                  "glass": {{"transmission": [1, 1, 1], "ior": 1.5}},
                  "water": {{"transmission": [1, 1, 1], "ior": 1.33}}
                }}, "objects": [{surface},
                {{"sphere": {{"name": "ball", "material": "glass", "center": [0, -0.6, 0], "radius": 0.3}}}},
                {{"plane": {{"name": "floor", "material": "floor", "point": [0, -1, 0], "normal": [0, 1, 0]}}}}]}}"#
            );
            let world = World::new(scene(&text), AccelKind::default());
            let under_water = eye[1] < 0.0;
            let trace = trace_pixel(&world, &settings(1), (0, 0), false);
            let medium = world.scene.medium_name(trace.tree.node(0).ray.medium);
            assert_eq!(medium, if under_water { "water" } else { "air" });
            let (indices, met) = straight(&world, way[0]);
            assert_eq!((indices, met), (way, objects));
        }
    }
}

/// Straight through the middle of touching boxes the indices follow each other as on paper: 1, 1.5, 1.33, 1.5, 1, with no
/// film of anything in between; and overlapping surfaces that do not count are told of.
#[test]
fn case_66_boundaries_are_those_on_paper() {
    for overlap in [0.0, 1e-6] {
        for water_first in [true, false] {
            let block = |name: &str, material: &str, from: f64, to: f64| {
                format!(
                    r#"{{"box": {{"name": "{name}", "material": "{material}", "min": [{from}, -1, -1], "max": [{to}, 1, 1]}}}}"#
                )
            };
            let mut objects = [
                block("left", "glass", -1.0, -0.5),
                block("right", "glass", 0.5, 1.0),
                block("water", "water", -0.5 - overlap, 0.5 + overlap),
            ];
            if water_first {
                objects.reverse();
            }
            let text = format!(
                r#"{{"format": "raytree-scene/1", "background": [1, 1, 1],
                "camera": {{"eye": [-3, 0.1, 0.2], "look_at": [0, 0.11, 0.17], "vertical_fov": 1}},
                "materials": {{
                  "glass": {{"transmission": [1, 1, 1], "ior": 1.5, "priority": 1}},
                  "water": {{"transmission": [1, 1, 1], "ior": 1.33}}
                }}, "objects": [{}]}}"#,
                objects.join(", ")
            );
            let world = World::new(scene(&text), AccelKind::default());
            let (indices, surfaces) = straight(&world, 1.0);
            let what = format!("{overlap} {water_first}");
            assert_eq!(indices, [1.0, 1.5, 1.33, 1.5, 1.0], "{what}");
            assert_eq!(surfaces, ["left", "left", "right", "right"], "{what}");
            let trace = trace_pixel(&world, &settings(1), (0, 0), false);
            let passed = |e: &&Event| matches!(e, Event::Passed { .. });
            let told = trace.tree.events.iter().filter(passed).count();
            assert_eq!(told > 0, overlap > 0.0);
        }
    }
}

/// Expected: all accelerators show the same picture, and a recorded pixel is the rendered one.
#[test]
fn case_66_the_picture_is_the_same_for_all_accelerators() {
    let size = count(24, 6) as u32;
    for make in [Make::Sphere, Make::Box, Make::Globe] {
        for overlap in [0.0, 1e-6] {
            let solids = vessel(overlap);
            let picture = |kind| {
                let world = world(&solids, make, EYES[0].1, kind);
                let whole = |_, _| ControlFlow::Continue(());
                let (film, _) = render::<Silent>(&world, &settings(size), 2, &whole);
                (world, film.pixels)
            };
            let (world, expected) = picture(AccelKind::List);
            for (i, color) in expected.iter().enumerate() {
                let (x, y) = (i as u32 % size, i as u32 / size);
                let trace = trace_pixel(&world, &settings(size), (x, y), false);
                assert_eq!(trace.pixel.color, *color, "replay of ({x}, {y})");
            }
            for kind in AccelKind::ALL {
                assert_eq!(picture(kind).1, expected, "{kind:?}");
            }
        }
    }
}

/// Rays aimed at the edges and corners of a glass cube, into it and past it.
#[test]
fn case_67_rays_through_the_edges_of_a_glass_cube() {
    let cube = [Solid {
        name: "cube",
        ior: 1.5,
        priority: 0,
        half: 1.0,
        y: 0.0,
    }];
    // Along the axes and the diagonals, so that middles of pixels lie on edges and corners.
    for eye in [
        [0.0, 0.0, 2.0],
        [2.0, 0.0, 2.0],
        [2.0, 2.0, 2.0],
        [0.0, 0.0, 0.5],
    ] {
        let mut world = world(&cube, Make::Box, eye, AccelKind::default());
        world.scene.camera =
            Camera::new(eye.into(), DVec3::ZERO, DVec3::Y, 1.5).expect("up is not along z");
        for size in [count(40, 8) as u32, count(41, 9) as u32] {
            let met = follow(&world, size, &cube, Make::Box);
            assert!(met.left > 0 && met.inside > 0, "{met:?}");
        }
    }
}
