//! Meshes of parts that are kept once: each use is one shape, and is seen as if its triangles stood in the world one by one.

mod places;
mod same;

use std::ops::ControlFlow;

use raytree::accel::AccelKind;
use raytree::math::{DVec3, Ray};
use raytree::probe::Silent;
use raytree::reduce::{Kept, part};
use raytree::scene::flat;
use raytree::scene::write::scene_file;
use raytree::scene::{self, Scene, Settings};
use raytree::shading::ShadingModel;
use raytree::trace::explain::explain;
use raytree::trace::{Counts, Outcome, View, ledger, trace_pixel};
use raytree::tracer::{draw, render};
use raytree::world::World;

use places::{PLACES, in_parts, instances, many_bunnies, scene_of, small, written_out};

#[test]
fn a_mesh_of_a_part_is_kept_once() {
    let scene = in_parts(&PLACES);
    let kept: Vec<_> = scene.shapes.iter().filter_map(|s| s.mesh()).collect();
    // Three meshes in the part, and none of them is copied.
    assert_eq!(kept.len(), 3 * PLACES.len());
    for (i, (mesh, _)) in kept.iter().enumerate() {
        assert!(std::ptr::eq(*mesh, kept[i % 3].0));
    }
    let data = |name: &str| {
        let object = scene.objects.iter().find(|o| o.name == name);
        object.and_then(|o| o.vertices.as_ref()).expect("normals")
    };
    assert!(std::sync::Arc::ptr_eq(data("u0/pot"), data("u3/pot")));
    assert_eq!(instances(&scene), 3 * PLACES.len());
    assert_eq!(instances(&written_out(&PLACES)), 0);
}

/// What light passes, what shines, what is small and what is stretched beyond all measure is written out as before.
#[test]
fn other_meshes_are_written_out_at_each_use() {
    let one = |part: &str, place: &str| {
        let used = format!(r#"{{"use": {{"name": "u", "part": "p", "transform": [{place}]}}}}"#);
        scene_of(&format!("\"p\": [{part}]"), &used).expect("a scene")
    };
    let pot = |material: &str| {
        format!(r#"{{"obj": {{"name": "pot", "material": "{material}", "file": "teapot.obj"}}}}"#)
    };
    let plain = r#"{"scale": 1}"#;
    assert_eq!(instances(&one(&pot("clay"), plain)), 1);
    assert_eq!(instances(&one(&pot("glass"), plain)), 0);
    assert_eq!(instances(&one(&pot("lamp"), plain)), 0);
    assert_eq!(
        instances(&one(&pot("clay"), r#"{"scale": [1e-4, 1, 1e4]}"#)),
        0
    );
    // Beside uses that are kept, too.
    let used = r#"{"use": {"name": "a", "part": "p"}}, {"use": {"name": "b", "part": "p", "material": "glass"}},
        {"use": {"name": "c", "part": "p"}}"#;
    let mixed = scene_of(&format!("\"p\": [{}]", places::ball("clay", 8, 5)), used);
    let mixed = mixed.expect("a scene");
    let kept: Vec<bool> = mixed.objects.iter().map(|o| o.instance).collect();
    assert_eq!(kept, [true, false, true]);
    assert_eq!(mixed.shapes.len(), 82);
    let ball = |rows: u32| places::ball("clay", 8, rows);
    assert_eq!(instances(&one(&ball(4), plain)), 0, "64 triangles");
    assert_eq!(instances(&one(&ball(5), plain)), 1, "80 triangles");
}

/// With a material of the use a model is one mesh, without it is one for each of its parts; both may be seen in one scene.
#[test]
fn parts_of_a_model_are_kept_by_themselves() {
    let used = r#"{"use": {"name": "whole", "part": "p", "material": "clay"}}, {"use": {"name": "apart", "part": "p"}},
        {"use": {"name": "again", "part": "p"}}"#;
    let part = r#""p": [{"obj": {"name": "m", "file": "two.obj"}}]"#;
    let scene = scene_of(part, used).expect("a scene");
    let counts: Vec<(&str, u32)> = (scene.objects.iter().zip(&scene.shapes))
        .map(|(object, shape)| (object.name.as_str(), shape.triangle_count()))
        .collect();
    assert_eq!(
        counts,
        [
            ("whole/m", 170),
            ("apart/m/left", 100),
            ("apart/m/right", 70),
            ("again/m/left", 100),
            ("again/m/right", 70)
        ]
    );
    assert_eq!(instances(&scene), 5);
}

#[test]
fn a_place_that_is_flat_is_refused() {
    let used = r#"{"use": {"name": "u", "part": "p", "transform": [{"scale": [1, 0, 1]}]}}"#;
    let pot = r#""p": [{"obj": {"name": "pot", "material": "clay", "file": "teapot.obj"}}]"#;
    let said = scene_of(pot, used).expect_err("flat");
    assert!(
        said.contains("objects[0].use.transform: the transform squeezes everything flat"),
        "{said}"
    );
}

#[test]
fn all_accelerators_draw_the_same_bits() {
    let scene = in_parts(&PLACES);
    let settings = small(&scene, (48, 36));
    let expected = draw(&World::new(scene.clone(), AccelKind::List), &settings, 1);
    assert!(expected.pixels.iter().any(|p| *p != expected.pixels[0]));
    for kind in AccelKind::ALL {
        let world = World::new(scene.clone(), kind);
        for threads in [1, 8] {
            let got = draw(&world, &settings, threads);
            assert!(expected.pixels == got.pixels, "{} {threads}", kind.name());
        }
        let (counted, counts) =
            render::<Counts>(&world, &settings, 2, &|_, _| ControlFlow::Continue(()));
        assert!(expected.pixels == counted.pixels, "{}", kind.name());
        assert!(counts.iter().map(|c| c.tests).sum::<u64>() > 0);
    }
}

/// Recording is rendering, sums close, and no ray finds the surface that it left.
#[test]
fn trees_close_and_rays_leave_their_surfaces() {
    let scene = in_parts(&PLACES);
    let settings = small(&scene, (48, 36));
    let world = World::new(scene, AccelKind::Wide);
    for model in [None, Some(ShadingModel::Gouraud)] {
        trees_close(&world, &settings.with(|s| s.shading = model));
    }
}

fn trees_close(world: &World, settings: &Settings) {
    let film = draw(world, settings, 2);
    let mut met = 0;
    for (x, y) in (0..48 * 36).map(|i| (i % 48, i / 48)) {
        let trace = trace_pixel(world, settings, (x, y), true);
        assert_eq!(trace.pixel.color, film.at(x, y), "({x}, {y})");
        assert_eq!(ledger::first_open(&trace.tree), None);
        let view = View {
            world,
            settings,
            trace: &trace,
        };
        for node in 0..trace.tree.nodes.len() as u32 {
            assert!(!view.is_self_hit(node), "({x}, {y}) {node}");
            let Some(Outcome::Hit(hit)) = trace.tree.node(node).outcome else {
                continue;
            };
            met += u32::from(world.scene.object_of(hit.primitive).instance);
        }
    }
    assert!(met > 300, "{met}");
}

#[test]
fn a_hit_tells_its_triangle_and_is_explained() {
    let scene = in_parts(&PLACES[..1]);
    let settings = small(&scene, (48, 36));
    let world = World::new(scene, AccelKind::List);
    let hit = (0..48 * 36).find_map(|i| {
        let trace = trace_pixel(&world, &settings, (i % 48, i / 48), true);
        match trace.tree.nodes.first()?.outcome? {
            Outcome::Hit(hit) if world.scene.object_of(hit.primitive).name == "u0/pot" => {
                Some((trace, hit))
            }
            _ => None,
        }
    });
    let (trace, hit) = hit.expect("the pot is seen");
    let view = View {
        world: &world,
        settings: &settings,
        trace: &trace,
    };
    let surface = view.surface_hit(0).expect("a hit");
    assert_eq!(surface.primitive, hit.part);
    assert!(
        surface
            .barycentric
            .is_some_and(|w| (w.iter().sum::<f64>() - 1.0).abs() < 1e-14)
    );
    let told: Vec<String> = (0..trace.tree.events.len())
        .map(|event| format!("{:?}", explain(view, event)))
        .collect();
    let tests: Vec<&String> = told.iter().filter(|t| t.contains("kept once")).collect();
    assert!(
        tests.iter().any(|t| t.contains("992 triangles, kept once")),
        "{told:#?}"
    );
    assert!(tests.iter().any(|t| t.contains("boxes looked at")
        && t.contains(&format!("number {}", hit.part))
        && t.contains("o in its space")));
    let met = format!("the triangle {} of `u0/pot`", hit.part);
    assert!(
        told.iter()
            .any(|t| t.contains(&met) && t.contains("stands in")),
        "{met}"
    );
}

#[test]
fn what_is_written_is_read_with_the_same_bits() {
    let scene = in_parts(&PLACES);
    let settings = small(&scene, (48, 36));
    let text = scene_file(&part(&scene, &Kept::all(&scene)).scene, "a test").expect("a text");
    let read = scene::from_json(&text).expect("a scene");
    assert_eq!(instances(&read), instances(&scene));
    assert_eq!(text.matches("\"obj\"").count(), 0);
    // Each of the three meshes once, and the floor.
    assert_eq!(text.matches("\"vertices\"").count(), 4);
    let names = |s: &Scene| -> Vec<String> { s.objects.iter().map(|o| o.name.clone()).collect() };
    assert_eq!(names(&read), names(&scene));
    let [a, b] = [scene, read].map(|s| draw(&World::new(s, AccelKind::Bvh), &settings, 1));
    assert_eq!(a.pixels, b.pixels);
}

#[test]
fn limits_count_a_mesh_once_and_what_is_taken_one_by_one_each_time() {
    // 1,000 times 3,674 triangles are more than a scene may have.
    let scene = many_bunnies(1000);
    assert_eq!(instances(&scene), 1000);
    let said = scene.check_faces().expect_err("too many").to_string();
    assert!(said.contains("3674000 triangles"), "{said}");
    let few = many_bunnies(500);
    assert!(few.check_faces().is_ok());
    assert_eq!(flat::objects(&few).count(), 500 * 3674 + 1);
    // What a use takes beside the mesh.
    let per_use = size_of::<raytree::geometry::Transformed>() + size_of::<scene::Object>();
    assert!(per_use < 1024, "{per_use}");
}

/// A mesh in 32 nested turns by 360 / 32 degrees stands where it would without.
#[test]
fn thirty_two_turns_are_none() {
    let turn = r#"[{"rotate": {"axis": [1, 2, -0.5], "degrees": 11.25}}]"#;
    let ball = places::ball("clay", 12, 8);
    let mut parts = vec![format!("\"p0\": [{ball}]")];
    for i in 1..32 {
        let inner = i - 1;
        parts.push(format!(
            r#""p{i}": [{{"use": {{"name": "u{i}", "part": "p{inner}", "transform": {turn}}}}}]"#
        ));
    }
    let used = format!(r#"{{"use": {{"name": "u", "part": "p31", "transform": {turn}}}}}"#);
    let scene = scene_of(&parts.join(",\n"), &used).expect("a scene");
    let (_, map) = scene.shapes[0].mesh().expect("kept once");
    let map = map.expect("turned").to_world();
    // The ball is moved by itself.
    let wanted = glam::DAffine3::from_translation(DVec3::new(0.2, 1.2, 0.0));
    let pairs = map.to_cols_array().into_iter().zip(wanted.to_cols_array());
    for (a, b) in pairs {
        assert!((a - b).abs() <= 1e-14, "{map:?}");
    }
    let plain = scene_of("", &ball).expect("a scene");
    let ray = Ray::new(DVec3::new(0.3, 1.3, 9.0), DVec3::new(0.0, 0.0, -1.0));
    let t = |scene: Scene| {
        let world = World::new(scene, AccelKind::List);
        world.closest(&ray, 0.0, &mut Silent).expect("a hit").t
    };
    assert!((t(scene) - t(plain)).abs() < 1e-13);
}
