//! Effects: what is derived from a scene is enough, what is off costs nothing, what is left out is said.

use proptest::prelude::*;
use raytree::math::Rgb;
use raytree::probe::{AbsenceReason, Event, TermKind};
use raytree::scene::effects::{effects, findings};
use raytree::scene::{self, Scene, Settings};
use raytree::shading::Effect::{
    self, Ambient, Diffuse, Highlights, Reflection, Refraction, Shadows, Smooth, SoftShadows,
};
use raytree::shading::Effects;
use raytree::trace::{Counts, PixelTrace, View, trace_pixel};
use raytree::tracer::{draw, render};
use raytree::world::World;
use std::ops::ControlFlow;

use crate::common;
use crate::from_text;

fn small(scene: &Scene, effects: Effects) -> Settings {
    scene.settings.with(|s| {
        s.image.width = 40;
        s.image.height = 30;
        s.pixel.samples = 2;
        s.light.samples = 4;
        s.effects = effects;
    })
}

fn bits(world: &World, settings: &Settings) -> Vec<[u64; 3]> {
    let film = draw(world, settings, 2);
    film.pixels
        .iter()
        .map(|p: &Rgb| p.channels().map(f64::to_bits))
        .collect()
}

fn counts(world: &World, settings: &Settings) -> Counts {
    let (_, counts) = render::<Counts>(world, settings, 2, &|_, _| ControlFlow::Continue(()));
    counts.iter().fold(Counts::default(), Counts::plus)
}

/// The picture with what the scene calls for is the picture with everything, and what is off was not done.
fn is_enough(scene: Scene) {
    let called_for = effects(&scene);
    let (few, all) = (small(&scene, called_for), small(&scene, Effects::ALL));
    let name = scene.name.clone();
    let world = World::new(scene, few.accel);
    assert_eq!(bits(&world, &few), bits(&world, &all), "{name}");
    let counts = counts(&world, &few);
    let shows_lights = called_for.has(Diffuse) || called_for.has(Highlights);
    if !(called_for.has(Shadows) && shows_lights) {
        assert_eq!(counts.light, 0, "{name}");
    }
    if !called_for.has(Effect::Reflection) {
        assert_eq!(counts.reflected, 0, "{name}");
    }
    if !called_for.has(Effect::Refraction) {
        assert_eq!(counts.transmitted, 0, "{name}");
    }
}

#[test]
fn what_the_built_in_scenes_call_for_is_enough() {
    for (name, _) in scene::list() {
        is_enough(scene::load(name).expect("a built-in scene"));
    }
}

#[test]
fn each_effect_is_found_where_it_is_and_not_where_it_is_not() {
    let on = |name: &str| {
        let scene = scene::load(name).expect("a built-in scene");
        let on = findings(&scene).into_iter().filter(|f| f.on);
        on.map(|f| f.effect).collect::<Vec<_>>()
    };
    assert_eq!(on("triangle"), [Shadows, Highlights, Ambient, Diffuse]);
    assert_eq!(
        on("soft-shadow"),
        [Shadows, SoftShadows, Highlights, Ambient, Diffuse]
    );
    assert_eq!(
        on("whitted"),
        [
            Shadows, Highlights, Reflection, Refraction, Ambient, Diffuse
        ]
    );
    assert!(on("teapot").contains(&Smooth));
}

#[test]
fn leaving_an_effect_out_changes_the_picture_and_nothing_else() {
    let differs = |name: &str, effect: Effect| {
        let scene = scene::load(name).expect("a built-in scene");
        let whole = small(&scene, Effects::ALL);
        let part = small(&scene, Effects::ALL.without(effect));
        assert_eq!(part.left_out(&scene).collect::<Vec<_>>(), [effect]);
        assert_eq!(whole.left_out(&scene).count(), 0);
        let world = World::new(scene, whole.accel);
        assert_ne!(
            bits(&world, &whole),
            bits(&world, &part),
            "{name}, {effect:?}"
        );
        (counts(&world, &whole), counts(&world, &part))
    };
    let (_, part) = differs("whitted", Effect::Shadows);
    assert_eq!(part.light, 0);
    let (_, part) = differs("whitted", Effect::Reflection);
    assert_eq!(part.reflected, 0);
    let (whole, part) = differs("nested-glass", Effect::Refraction);
    assert!(whole.transmitted > 0 && part.transmitted == 0);
    let (whole, part) = differs("soft-shadow", Effect::SoftShadows);
    assert!(part.light > 0 && whole.light > 3 * part.light);
    let (whole, part) = differs("whitted", Effect::Highlights);
    assert_eq!(whole, part, "highlights cost no rays");
    let (whole, part) = differs("whitted", Ambient);
    assert_eq!(whole, part, "ambient light costs no rays");
    let (whole, part) = differs("whitted", Diffuse);
    assert!(part.light > 0 && part.light < whole.light);
    differs("teapot", Smooth);
}

/// Trees of the pixels of a small picture, without these effects; each is the picture's pixel, to the last bit.
fn trees(name: &str, without: &[Effect], check: impl Fn(View, &PixelTrace)) {
    let scene = scene::load(name).expect("a built-in scene");
    let effects = without.iter().copied().fold(Effects::ALL, Effects::without);
    let settings = small(&scene, effects);
    let world = World::new(scene, settings.accel);
    let film = draw(&world, &settings, 2);
    for at in (0..30).flat_map(|y| (0..40).map(move |x| (x, y))) {
        let trace = trace_pixel(&world, &settings, at, false);
        let [told, drawn] =
            [trace.pixel.color, film.at(at.0, at.1)].map(|c| c.channels().map(f64::to_bits));
        assert_eq!(told, drawn, "{name} {at:?} without {without:?}");
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        check(view, &trace);
    }
}

fn has_term(trace: &PixelTrace, kind: TermKind) -> bool {
    let mut events = trace.tree.events.iter();
    events.any(|e| matches!(e, Event::Term { term, .. } if term.kind() == kind))
}

#[test]
fn terms_that_are_left_out_are_in_no_tree() {
    for scene in ["whitted", "soft-shadow", "teapot"] {
        trees(scene, &[Ambient], |_, trace| {
            assert!(!has_term(trace, TermKind::Ambient));
        });
        trees(scene, &[Diffuse], |_, trace| {
            assert!(!has_term(trace, TermKind::Diffuse));
        });
    }
}

#[test]
fn where_no_term_of_a_light_is_left_no_ray_asks_for_it_and_the_tree_says_why() {
    trees("triangle", &[Diffuse, Highlights], |_, trace| {
        assert!(
            trace
                .tree
                .nodes
                .iter()
                .all(|n| n.ray.kind != raytree::probe::RayKind::Light)
        );
        let absent = |e: &Event| {
            matches!(e, Event::Absent { kind: raytree::probe::RayKind::Light, reason, .. }
            if AbsenceReason::from(*reason) == AbsenceReason::EffectOff)
        };
        let is_hit = trace.tree.events.iter().any(|e| matches!(e, Event::Hit(_)));
        assert_eq!(trace.tree.events.iter().any(absent), is_hit);
    });
}

#[test]
fn without_smooth_the_normal_is_the_geometric_one() {
    let leans = |view: View| {
        let hits = (0..view.trace.tree.nodes.len() as u32).filter_map(|n| view.surface_hit(n));
        hits.into_iter()
            .any(|surface| surface.at.normal != surface.at.geometric_normal)
    };
    let (smooth, flat) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    trees("teapot", &[], |view, _| {
        smooth.set(smooth.get() + u32::from(leans(view)));
    });
    trees("teapot", &[Smooth], |view, _| {
        flat.set(flat.get() + u32::from(leans(view)));
    });
    assert!(smooth.get() > 50 && flat.get() == 0, "{smooth:?} {flat:?}");
}

#[test]
fn the_noise_of_one_effect_does_not_move_with_another() {
    // Without highlights the soft shadows on what has none are the same, sample by sample.
    let scene = scene::load("soft-shadow").expect("a built-in scene");
    let whole = small(&scene, Effects::ALL);
    let part = small(&scene, Effects::ALL.without(Effect::Highlights));
    let world = World::new(scene, whole.accel);
    let (whole, part) = (bits(&world, &whole), bits(&world, &part));
    let same = whole.iter().zip(&part).filter(|(a, b)| a == b).count();
    assert!(same > 1000, "only {same} of 1200 pixels are the same");
}

/// A coefficient that is often nothing.
fn share() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 1 => 0.1..0.9f64]
}

fn material() -> impl Strategy<Value = String> {
    (share(), share(), share(), share(), any::<bool>()).prop_map(
        |(diffuse, specular, mirror, transmission, checker)| {
            let checker = if checker {
                r#", "checker": {"diffuse": [0.3, 0.3, 0.3], "size": 0.4}"#
            } else {
                ""
            };
            format!(
                r#"{{"diffuse": [{diffuse}, {diffuse}, 0], "specular": [0, {specular}, {specular}], "shininess": 9,
                "mirror": [{mirror}, 0, {mirror}], "transmission": [0, {transmission}, 0], "ior": 1.4{checker}}}"#
            )
        },
    )
}

fn light() -> impl Strategy<Value = &'static str> {
    prop_oneof![
        Just(r#"{"point": {"name": "NAME", "position": [1, 3, 2], "intensity": [1, 1, 1]}}"#),
        Just(
            r#"{"directional": {"name": "NAME", "direction": [1, -2, -1], "intensity": [0, 1, 1]}}"#
        ),
        Just(
            r#"{"spot": {"name": "NAME", "position": [0, 3, 0], "look_at": [0, 0, 0], "intensity": [1, 1, 0], "cone_angle": 30}}"#
        ),
        Just(r#"{"area": {"name": "NAME", "object": "lamp of NAME"}}"#),
    ]
}

fn random_scene() -> impl Strategy<Value = String> {
    (
        prop::array::uniform3(material()),
        prop::collection::vec(light(), 0..3),
        share(),
        any::<bool>(),
    )
        .prop_map(|([a, b, c], lights, ambient, smooth)| {
            let normals = if smooth {
                r#", "normals": [[-0.5, 0, 1], [0.5, 0, 1], [0, 0.5, 1]]"#
            } else {
                ""
            };
            let lights: Vec<String> = (0..)
                .zip(lights)
                .map(|(i, light)| light.replace("NAME", &format!("light {i}")))
                .collect();
            let lights = lights.join(", ");
            format!(
                r#"{{"format": "raytree-scene/1", "name": "random", "background": [0.1, 0.2, 0.3], "ambient": [{ambient}, 0, {ambient}],
                "camera": {{"eye": [0, 1.5, 4], "look_at": [0, 0.5, 0], "vertical_fov": 50}},
                "materials": {{"a": {a}, "b": {b}, "c": {c}, "lamp": {{"diffuse": [0, 0, 0], "emission": [2, 2, 2]}}}},
                "lights": [{lights}],
                "objects": [
                  {{"sphere": {{"name": "ball", "material": "a", "center": [-0.7, 0.6, 0], "radius": 0.6}}}},
                  {{"box": {{"name": "box", "material": "b", "min": [0.2, 0, -0.5], "max": [1, 0.9, 0.3]}}}},
                  {{"triangle": {{"name": "sail", "material": "b", "corners": [[-1.2, 0, 0.8], [0, 0, 0.9], [-0.5, 1.3, 0.8]]{normals}}}}},
                  {{"plane": {{"name": "floor", "material": "c", "point": [0, 0, 0], "normal": [0, 1, 0]}}}},
                  {{"disc": {{"name": "lamp of light 0", "material": "lamp", "center": [0, 2.5, 0], "normal": [0, -1, 0], "radius": 0.5}}}},
                  {{"disc": {{"name": "lamp of light 1", "material": "lamp", "center": [0.8, 2, 1], "normal": [0, -1, 0], "radius": 0.3}}}}
                ]}}"#
            )
        })
}

proptest! {
    #![proptest_config(common::config(48))]

    #[test]
    fn what_a_random_scene_calls_for_is_enough(text in random_scene()) {
        is_enough(from_text::scene(&text));
    }
}
