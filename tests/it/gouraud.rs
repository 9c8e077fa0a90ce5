//! Gouraud's model in the tracer: light at the corners, blended; flat shading; the same as scan conversion has.

mod graded;

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::probe::{Absence, Event, Term, TermKind};
use raytree::scene::effects::effects;
use raytree::scene::{self, Effect, Scene, Settings};
use raytree::shading::{LightKind, ShadingModel};
use raytree::trace::export::Text;
use raytree::trace::facts::TreePath;
use raytree::trace::field::field;
use raytree::trace::{PixelTrace, View, document, ledger, trace_pixel};
use raytree::tracer::{Film, draw};
use raytree::world::World;

use crate::from_text::scene as read;
use crate::raster::{TRIANGLE, eye_rays_only, filled, largest_gap, mesh, sphere, triangles_of};

/// Settings with a model for all triangles.
fn by(settings: &Settings, model: ShadingModel) -> Settings {
    settings.with(|s| s.shading = Some(model))
}

fn traced(scene: &Scene, settings: &Settings) -> Film {
    draw(
        &World::new(scene.clone(), AccelKind::default()),
        settings,
        0,
    )
}

#[test]
fn eye_rays_see_what_scan_conversion_fills() {
    let scenes = ["gouraud", "teapot", "bunny"].map(triangles_of);
    // A checker whose corners have different colours, and a spot light whose cone ends on the mesh.
    let floor = r#""vertices": [[-2, -1, 1], [2, -1, 1], [2, -1, -3], [-2, -1, -3]],
        "triangles": [[0, 1, 2], [0, 2, 3]], "uvs": [[0, 0], [1, 0], [1, 1], [0, 1]]"#;
    let checker = r#""diffuse": [0.8, 0.6, 0.2], "checker": {"diffuse": [0.1, 0.1, 0.5], "size": 0.3},
        "specular": [0.5, 0.5, 0.5]"#;
    let mut spot = mesh([0.0, 0.5, 2.5], checker, floor);
    spot.ambient = Rgb::grey(0.3);
    spot.lights[0].kind = LightKind::Spot {
        position: [-1.5, 1.0, 0.5].into(),
        direction: raytree::math::DVec3::new(-0.2, -1.0, 0.1).normalize(),
        intensity: Rgb::new(2.0, 1.5, 1.0),
        attenuation: [0.5, 0.1, 0.3],
        cos_cutoff: 0.6,
        exponent: 2.0,
    };
    for scene in scenes.into_iter().chain([spot]) {
        let size = (160, 120);
        let settings = by(&eye_rays_only(&scene, size), ShadingModel::Gouraud);
        let drawn = filled(&scene, &settings, ShadingModel::Gouraud).film;
        let ours = traced(&scene, &settings);
        let phong = traced(&scene, &by(&settings, ShadingModel::Phong));
        let (mut worst, mut differ) = (0.0f64, 0);
        for (x, y) in (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y))) {
            let gap = largest_gap(drawn.at(x, y), ours.at(x, y));
            assert!(gap <= 1e-12, "{} at {x},{y}: {gap:e}", scene.name);
            worst = worst.max(gap);
            differ += u32::from(largest_gap(phong.at(x, y), ours.at(x, y)) > 1e-3);
        }
        println!(
            "{}: {worst:e}, {differ} pixels differ from Phong's",
            scene.name
        );
        assert!(differ > 300, "{}: {differ}", scene.name);
    }
}

/// The first channel of the specular term of a light at the eye ray through the middle.
fn specular(scene: &Scene, settings: &Settings) -> f64 {
    let world = World::new(scene.clone(), AccelKind::default());
    let trace = trace_pixel(&world, settings, (32, 32), false);
    let mut terms = trace.tree.events.iter().filter_map(|event| match event {
        Event::Term { term, .. } if term.kind() == TermKind::Specular => Some(term.value()),
        _ => None,
    });
    terms.next().map_or(0.0, |value| value.channels()[0])
}

#[test]
fn a_highlight_inside_of_a_triangle_is_missed() {
    let shiny = r#""specular": [1, 1, 1], "shininess": 50"#;
    let written = TRIANGLE.replace("\"triangles\"", "\"shading\": \"gouraud\", \"triangles\"");
    let scene = mesh([0.0, 0.0, 2.0], shiny, &written);
    let settings = eye_rays_only(&scene, (65, 65));
    let right = 0.6f64.powi(50);
    assert!((specular(&scene, &settings) / right - 1.0).abs() < 1e-9);
    assert!((specular(&scene, &by(&settings, ShadingModel::Phong)) - 1.0).abs() < 1e-12);
    // The same in the built-in scene, whose triangle is lit by a second light, too.
    let scene = scene::load("gouraud").expect("built in");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (65, 65);
        s.effects = effects(&scene);
    });
    assert!((specular(&scene, &settings) / right - 1.0).abs() < 1e-9);
    assert!((specular(&scene, &by(&settings, ShadingModel::Phong)) - 1.0).abs() < 1e-12);
}

#[test]
fn the_corners_of_a_term_are_fields() {
    let scene = scene::load("gouraud").expect("built in");
    let settings = settings_of(&scene).with(|s| {
        (s.image.width, s.image.height) = (65, 65);
        s.pixel.samples = 1;
    });
    let world = World::new(scene, AccelKind::default());
    let trace = trace_pixel(&world, &settings, (32, 32), false);
    let number = |name: &str| {
        let value = field(view(&world, &settings, &trace), &TreePath::eye(0), name);
        let value = value.unwrap_or_else(|e| panic!("{name}: {e}"));
        let [number] = value.numbers() else {
            panic!("{name}: {value:?}")
        };
        *number
    };
    for i in 0..3 {
        let of = |light: &str, what: &str| number(&format!("terms.{light}.{what}[{i}]"));
        assert!((of("specular:lamp", "r_dot_v") - 0.6).abs() < 1e-12);
        assert!((of("diffuse:lamp", "n_dot_l") - 2.0 / 5.0f64.sqrt()).abs() < 1e-12);
        assert!((of("diffuse:lamp", "weight") - 1.0 / 3.0).abs() < 1e-12);
        let red = number(&format!("terms.diffuse:lamp.corners[{i}].r"));
        assert!((red - 0.15 * 2.0 / 5.0f64.sqrt()).abs() < 1e-12, "{red}");
    }
}

#[test]
fn text_says_what_is_blended() {
    let scene = scene::load("gouraud").expect("built in");
    let settings = settings_of(&scene);
    let world = World::new(scene, AccelKind::default());
    let told = |settings: &Settings| {
        let trace = trace_pixel(&world, settings, (24, 18), false);
        Text(&document::of(view(&world, settings, &trace))).to_string()
    };
    let blended = told(&settings);
    assert!(blended.contains("+ diffuse lamp blended ("), "{blended}");
    let phong = told(&by(&settings, ShadingModel::Phong));
    assert!(phong.contains("+ diffuse lamp ("), "{phong}");
}

#[test]
fn a_turning_ball_flickers_with_gouraud_and_not_with_phong() {
    let shiny = r#""specular": [1, 1, 1], "shininess": 100"#;
    let ratio = |model| {
        let brightest = (0..90).step_by(3).map(|frame| {
            let scene = mesh([0.4, 0.3, 3.0], shiny, &sphere(f64::from(frame) * 0.0175));
            let settings = by(&eye_rays_only(&scene, (128, 128)), model);
            let film = traced(&scene, &settings);
            let brightness = film.pixels.iter().map(|p| p.max_channel());
            brightness.fold(0.0, f64::max)
        });
        let (low, high) = brightest.fold((f64::INFINITY, 0.0f64), |(low, high), b| {
            (low.min(b), high.max(b))
        });
        high / low
    };
    let [gouraud, phong] = [ShadingModel::Gouraud, ShadingModel::Phong].map(ratio);
    println!("brightest over darkest frame: Gouraud {gouraud}, Phong {phong}");
    assert!(gouraud > 1.5, "{gouraud}");
    assert!(phong < 1.02, "{phong}");
}

#[test]
fn a_quad_shows_its_diagonal() {
    let corners = r#""vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]"#;
    let middle = |triangles: &str, model| {
        let text = format!("{corners}, \"triangles\": {triangles}");
        let mut scene = mesh([0.0, 0.0, 3.0], r#""diffuse": [1, 1, 1]"#, &text);
        scene.lights[0].kind = LightKind::Point {
            position: [1.0, 1.0, 0.6].into(),
            attenuation: [1.0, 0.0, 1.0],
            intensity: Rgb::WHITE,
        };
        let settings = by(&eye_rays_only(&scene, (65, 65)), model);
        traced(&scene, &settings).at(32, 32).channels()[0]
    };
    let [one, other] = ["[[0, 1, 2], [0, 2, 3]]", "[[0, 1, 3], [1, 2, 3]]"];
    let gap = |model| (middle(one, model) - middle(other, model)).abs();
    // By hand: at the near corner 1 / (1 + 0.36), at the far one 0.6 / sqrt(8.36) / 9.36, at the others 0.6 / sqrt(4.36) / 5.36.
    let at = |d2: f64| 0.6 / (d2 + 0.36).sqrt() / (1.0 + d2 + 0.36);
    let right = f64::midpoint(at(0.0), at(8.0)) - at(4.0);
    let gouraud = gap(ShadingModel::Gouraud);
    assert!((gouraud - right).abs() < 1e-9, "{gouraud} {right}");
    assert!(gap(ShadingModel::Phong) < 1e-12);
}

/// A scene in which all happens: glass, mirrors, a mirrored mesh, a checker, a cone that ends on triangles, area lights, shadows.
fn everything() -> Scene {
    let ball = sphere(0.3);
    read(&format!(
        r#"{{"format": "raytree-scene/1", "ambient": [0.2, 0.2, 0.3],
        "camera": {{"eye": [0.5, 1.5, 5], "look_at": [0, 0.2, 0], "vertical_fov": 50}},
        "materials": {{
            "glass": {{"specular": [0.6, 0.6, 0.6], "transmission": [0.9, 0.9, 0.9], "ior": 1.5, "diffuse": [0.1, 0, 0]}},
            "chrome": {{"diffuse": [0.2, 0.2, 0.3], "specular": [1, 1, 1], "mirror": [0.4, 0.4, 0.4]}},
            "tiles": {{"diffuse": [0.8, 0.7, 0.2], "ambient": [0.5, 0.2, 0.2],
                "checker": {{"diffuse": [0.1, 0.1, 0.5], "ambient": [0.1, 0.3, 0.1], "size": 0.09}}}},
            "matt": {{"diffuse": [0.5, 0.6, 0.5]}},
            "lamp": {{"emission": [4, 4, 3]}}}},
        "lights": [
            {{"point": {{"name": "bulb", "position": [-3, 4, 2], "intensity": [12, 12, 12], "attenuation": [0, 0, 1]}}}},
            {{"spot": {{"name": "spot", "position": [2, 3, 1], "look_at": [0.3, -1, 0], "cone_angle": 35, "intensity": [1, 0.6, 0.6]}}}},
            {{"area": {{"name": "panel", "object": "panel"}}}},
            {{"area": {{"name": "globe", "object": "globe"}}}}],
        "objects": [
            {{"quad": {{"name": "panel", "material": "lamp", "corner": [-1, 3, -1], "u": [1, 0, 0], "v": [0, 0, 1]}}}},
            {{"sphere": {{"name": "globe", "material": "lamp", "center": [3, 1, 2], "radius": 0.3}}}},
            {{"quad": {{"name": "floor", "material": "tiles", "shading": "gouraud", "corner": [-3, -1, 3], "u": [6, 0, 0], "v": [0, 0, -6]}}}},
            {{"polygon": {{"name": "wall", "material": "matt", "shading": "gouraud",
                "points": [[-3, -1, -3], [3, -1, -3], [3, 2, -3], [0, 1, -3], [-3, 2, -3]]}}}},
            {{"mesh": {{"name": "left", "material": "glass", "shading": "gouraud", "transform": [{{"translate": [-1.1, 0, 0]}}], {ball}}}}},
            {{"mesh": {{"name": "right", "material": "chrome", "shading": "gouraud",
                "transform": [{{"scale": [-0.9, 0.9, 0.9]}}, {{"translate": [1.1, 0, 0]}}], {ball}}}}},
            {{"mesh": {{"name": "top", "material": "matt", "shading": "flat", "transform": [{{"scale": 0.4}}, {{"translate": [0, 1.2, 0]}}], {ball}}}}}]}}"#
    ))
}

fn settings_of(scene: &Scene) -> Settings {
    scene.settings.with(|s| {
        (s.image.width, s.image.height) = (48, 36);
        s.effects = effects(scene);
        s.light.samples = 3;
        s.pixel.samples = 2;
    })
}

fn view<'a>(world: &'a World, settings: &'a Settings, trace: &'a PixelTrace) -> View<'a> {
    View {
        world,
        settings,
        trace,
    }
}

#[test]
fn the_replay_is_the_picture_and_every_sum_closes() {
    let scene = everything();
    let settings = settings_of(&scene);
    let film = traced(&scene, &settings);
    let world = World::new(scene.clone(), AccelKind::Bsp);
    let (mut blended, mut ambient, mut away) = (0, 0, 0);
    for (x, y) in (0..36).flat_map(|y| (0..48).map(move |x| (x, y))) {
        let trace = trace_pixel(&world, &settings, (x, y), false);
        assert_eq!(trace.pixel.color, film.at(x, y), "{x},{y}");
        assert_eq!(ledger::first_open(&trace.tree), None, "{x},{y}");
        assert_eq!(ledger::pixel_sum(&trace), trace.pixel.color, "{x},{y}");
        let view = view(&world, &settings, &trace);
        for (at, event) in trace.tree.events.iter().enumerate() {
            if matches!(
                event,
                Event::Absent {
                    reason: Absence::FacingAway { .. },
                    ..
                }
            ) {
                away += 1;
            }
            let Event::Term {
                term,
                light,
                sample,
            } = event
            else {
                continue;
            };
            let Term::Blended { kind, corners } = term else {
                continue;
            };
            // Each share is what is computed again from the hit, to the last bit.
            let node = trace.tree.node_of_event(at).expect("a ray's");
            let again = view.corner_terms(node, *kind, (*light, u32::from(*sample)));
            let again = again.expect("blended").map(|c| c.value() * c.weight);
            assert_eq!(again, *corners, "{x},{y}: {kind:?}");
            blended += 1;
            ambient += u32::from(*kind == TermKind::Ambient);
        }
        // What JSON tells adds up to the same bits.
        let document = document::of(view);
        let nodes = document.samples.iter().flat_map(document::SampleTree::rays);
        for term in nodes.flat_map(|ray| &ray.node.terms) {
            if let Some(corners) = &term.corners {
                let [a, b, c] = corners.each_ref().map(|c| c.value * c.weight);
                assert_eq!(a + b + c, term.value);
            }
        }
    }
    println!(
        "{blended} blended terms, {ambient} of them ambient, {away} lights behind all corners"
    );
    assert!(
        blended > 5000 && ambient > 300 && away > 100,
        "{blended} {ambient} {away}"
    );
    // Whatever finds the hits, and however many threads there are.
    for accel in [AccelKind::List, AccelKind::Wide, AccelKind::Kd] {
        let world = World::new(scene.clone(), accel);
        assert_eq!(draw(&world, &settings, 1).pixels, film.pixels, "{accel:?}");
    }
}

#[test]
fn flat_is_what_a_mesh_without_normals_is() {
    let ball = sphere(0.3);
    let (_, plain) = ball.split_once("\"triangles\"").expect("triangles");
    let vertices = ball.split_once(", \"normals\"").expect("normals").0;
    let plain = format!("{vertices}, \"triangles\"{plain}");
    let shiny = r#""diffuse": [0.5, 0.5, 0.5], "specular": [1, 1, 1], "shininess": 20"#;
    let eye = [0.4, 0.3, 3.0];
    let [plain, smooth, flat] = [
        plain,
        ball.clone(),
        format!("\"shading\": \"flat\", {ball}"),
    ]
    .map(|text| mesh(eye, shiny, &text));
    let settings = settings_of(&smooth);
    let expected = traced(&plain, &settings).pixels;
    assert_eq!(traced(&flat, &settings).pixels, expected);
    assert_eq!(
        traced(&smooth, &by(&settings, ShadingModel::Flat)).pixels,
        expected
    );
    let without = settings.with(|s| s.effects = s.effects.without(Effect::Smooth));
    assert_eq!(traced(&smooth, &without).pixels, expected);
    let phong = traced(&flat, &by(&settings, ShadingModel::Phong)).pixels;
    assert_eq!(phong, traced(&smooth, &settings).pixels);
    assert_ne!(phong, expected);
}

/// A triangle at z = 0 with these normals, seen from above its middle, and a lamp low at the side of corner a.
fn low_lamp(normals: &str, more: &str) -> (World, Settings) {
    let scene = read(&format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 2], "look_at": [0, 0, 0], "vertical_fov": 60}},
        "materials": {{"m": {{"diffuse": [1, 1, 1]}}}},
        "lights": [{{"directional": {{"name": "lamp", "direction": [-1, 0, -0.1], "intensity": [1, 1, 1]}}}}],
        "objects": [{{"triangle": {{"name": "t", "material": "m", "shading": "gouraud", "normals": {normals},
            "corners": [[1, 0, 0], [-0.5, 0.8660254037844386, 0], [-0.5, -0.8660254037844386, 0]]}}}}{more}]}}"#
    ));
    let settings = eye_rays_only(&scene, (65, 65)).with(|s| s.effects = effects(&scene));
    (World::new(scene, AccelKind::default()), settings)
}

#[test]
fn a_light_faces_away_only_if_it_does_so_at_all_corners() {
    // Away from the lamp at b and c, and in the middle.
    let (world, settings) = low_lamp("[[1, 0, 1], [-1, 0, 1], [-1, 0, 1]]", "");
    let trace = trace_pixel(&world, &settings, (32, 32), false);
    let lit = (1.0 + 0.1) / (2.0f64.sqrt() * 1.01f64.sqrt());
    let value = trace.pixel.color.channels()[0];
    assert!((value - lit / 3.0).abs() < 1e-9, "{value} {lit}");
    let phong = trace_pixel(&world, &by(&settings, ShadingModel::Phong), (32, 32), false);
    assert_eq!(phong.pixel.color, Rgb::BLACK);
    // Whichever corner shows it.
    for normals in [
        "[[-1, 0, 1], [1, 0, 1], [-1, 0, 1]]",
        "[[-1, 0, 1], [-1, 0, 1], [1, 0, 1]]",
    ] {
        let (world, settings) = low_lamp(normals, "");
        let trace = trace_pixel(&world, &settings, (32, 32), false);
        assert!(trace.pixel.color.channels()[0] > 0.01, "{normals}");
    }
    // Away from it at all three: the nearest to it is told.
    let (world, settings) = low_lamp("[[-1, 0, 2], [-1, 0, 1], [-1, 0, 1]]", "");
    let trace = trace_pixel(&world, &settings, (32, 32), false);
    let told = trace.tree.events.iter().find_map(|event| match event {
        Event::Absent {
            reason: Absence::FacingAway { n_dot_l },
            ..
        } => Some(*n_dot_l),
        _ => None,
    });
    let nearest = (-1.0 + 0.2) / (5.0f64.sqrt() * 1.01f64.sqrt());
    assert!((told.expect("absent") - nearest).abs() < 1e-12, "{told:?}");
}

#[test]
fn whether_a_light_is_seen_is_asked_at_the_hit() {
    let normals = "[[0, 0, 1], [0, 0, 1], [0, 0, 1]]";
    let wall = |x: f64| {
        format!(
            r#", {{"quad": {{"name": "wall", "material": "m", "corner": [{x}, -1, 0.02], "u": [0, 2, 0], "v": [0.002, 0, 0.02]}}}}"#
        )
    };
    let color = |wall: &str| {
        let (world, settings) = low_lamp(normals, wall);
        trace_pixel(&world, &settings, (32, 32), false).pixel.color
    };
    let free = color("");
    assert!(free.channels()[0] > 0.09, "{free:?}");
    // Between the lamp and the middle of the triangle, and behind the middle, where it shades both other corners.
    assert_eq!(color(&wall(0.3)), Rgb::BLACK);
    assert_eq!(color(&wall(-0.2)), free);
}
