//! Scan conversion: the same triangles as the eye rays of the tracer, and what is blended between their corners.

use raytree::accel::AccelKind;
use raytree::lab::raster::{Filling, RasterPicture, ScreenBlend, raster};
use raytree::math::{DVec3, Rgb};
use raytree::probe::{NONE, Silent};
use raytree::scene::effects::effects;
use raytree::scene::{self, Effect, Effects, Scene, Settings};
use raytree::shading::ShadingModel;
use raytree::tracer::draw;
use raytree::world::World;

use crate::cli::{refused, run};
use crate::from_text::scene as read;

/// The settings of a scene with what scan conversion has: one sample in a pixel's middle, eye rays only.
pub fn eye_rays_only(scene: &Scene, (width, height): (u32, u32)) -> Settings {
    scene.settings.with(|s| {
        (s.image.width, s.image.height) = (width, height);
        s.pixel.samples = 1;
        s.effects = [
            Effect::Shadows,
            Effect::SoftShadows,
            Effect::Reflection,
            Effect::Refraction,
        ]
        .into_iter()
        .fold(effects(scene), Effects::without);
    })
}

pub fn filled(scene: &Scene, settings: &Settings, shading: ShadingModel) -> RasterPicture {
    let filling = Filling {
        shading: Some(shading),
        blend: ScreenBlend::Perspective,
    };
    raster(scene, settings, filling, None)
}

pub fn largest_gap(a: Rgb, b: Rgb) -> f64 {
    let gaps = a.channels().into_iter().zip(b.channels());
    gaps.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// Asserts that scan conversion sees what the eye rays of the tracer see, and the same colours with Phong shading.
fn agrees_with_the_tracer(scene: Scene, size: (u32, u32), error: f64) {
    let settings = eye_rays_only(&scene, size);
    let drawn = filled(&scene, &settings, ShadingModel::Phong);
    let world = World::new(scene, AccelKind::default());
    let traced = draw(&world, &settings, 0);
    let mut covered = 0;
    for (i, primitive) in drawn.primitives.iter().enumerate() {
        let at = (i as u32 % size.0, i as u32 / size.0);
        let film = [f64::from(at.0) + 0.5, f64::from(at.1) + 0.5];
        let ray = world.scene.camera.ray(film, size);
        let hit = world.closest(&ray, 0.0, &mut Silent);
        assert_eq!(hit.map_or(NONE, |h| h.primitive), *primitive, "{at:?}");
        covered += u32::from(*primitive != NONE);
        let [ours, theirs] = [&drawn.film, &traced].map(|film| film.at(at.0, at.1));
        assert!(
            largest_gap(ours, theirs) <= error,
            "{at:?}: {ours:?} {theirs:?}"
        );
    }
    assert!(covered > size.0 * size.1 / 100, "{covered}");
}

#[test]
fn both_ways_see_the_same() {
    for name in ["triangle", "teapot", "bunny"] {
        agrees_with_the_tracer(triangles_of(name), (160, 120), 1e-12);
    }
}

/// A built-in scene without what is no triangle.
pub fn triangles_of(name: &str) -> Scene {
    let scene = scene::load(name).expect("a built-in scene");
    let is_triangle = |i: &u32| scene.shapes[*i as usize].kind() == "triangle";
    let kept = raytree::scene::kept::Kept {
        shapes: (0..scene.shapes.len() as u32).filter(is_triangle).collect(),
        ..raytree::scene::kept::Kept::all(&scene)
    };
    raytree::scene::part::part(&scene, &kept).scene
}

/// A scene of one mesh with normals, seen from `eye` towards the origin, with the lamp in the eye.
pub fn mesh(eye: [f64; 3], material: &str, mesh: &str) -> Scene {
    let [x, y, z] = eye;
    read(&format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [{x}, {y}, {z}], "look_at": [0, 0, 0], "vertical_fov": 60}},
        "materials": {{"m": {{{material}}}}},
        "lights": [{{"point": {{"name": "lamp", "position": [{x}, {y}, {z}], "intensity": [1, 1, 1]}}}}],
        "objects": [{{"mesh": {{"name": "o", "material": "m", {mesh}}}}}]}}"#
    ))
}

#[test]
fn a_triangle_through_the_plane_of_the_eye_is_cut() {
    // From far behind the eye to far before it, below it.
    let floor = r#""vertices": [[-9, -1, 9], [9, -1, 9], [0, -1, -40]], "triangles": [[0, 1, 2]]"#;
    agrees_with_the_tracer(
        mesh([0.0, 0.0, 2.0], r#""diffuse": [1, 1, 1]"#, floor),
        (96, 72),
        1e-12,
    );
    // Behind the eye altogether.
    let behind = r#""vertices": [[-9, -1, 9], [9, -1, 9], [0, 3, 9]], "triangles": [[0, 1, 2]]"#;
    let scene = mesh([0.0, 0.0, 2.0], r#""diffuse": [1, 1, 1]"#, behind);
    let drawn = filled(
        &scene,
        &eye_rays_only(&scene, (32, 24)),
        ShadingModel::Gouraud,
    );
    assert!(drawn.primitives.iter().all(|p| *p == NONE));
}

#[test]
fn slivers_are_where_the_rays_meet_them() {
    let mut vertices = String::new();
    let mut triangles = String::new();
    for i in 0..60 {
        let x = f64::from(i) * 0.03 - 0.9;
        let comma = if i == 0 { "" } else { ", " };
        let sliver = format!(
            "{comma}[{x}, -1, 0], [{}, -1, 0], [{}, 1, 0.2]",
            x + 0.002,
            x + 0.6
        );
        vertices.push_str(&sliver);
        let triangle = format!("{comma}[{}, {}, {}]", 3 * i, 3 * i + 1, 3 * i + 2);
        triangles.push_str(&triangle);
    }
    let slivers = format!(r#""vertices": [{vertices}], "triangles": [{triangles}]"#);
    let scene = mesh([0.0, 0.0, 2.0], r#""diffuse": [1, 1, 1]"#, &slivers);
    agrees_with_the_tracer(scene, (96, 72), 1e-11);
}

/// A triangle whose corners are 1 from the axis, with the normal of its plane at each.
pub const TRIANGLE: &str = r#""vertices": [[1, 0, 0], [-0.5, 0.8660254037844386, 0], [-0.5, -0.8660254037844386, 0]],
    "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]], "triangles": [[0, 1, 2]]"#;

#[test]
fn gouraud_misses_a_highlight_inside_of_a_triangle() {
    let shiny = r#""specular": [1, 1, 1], "shininess": 50"#;
    let scene = mesh([0.0, 0.0, 2.0], shiny, TRIANGLE);
    let settings = eye_rays_only(&scene, (65, 65));
    let middle = |shading| {
        filled(&scene, &settings, shading)
            .film
            .at(32, 32)
            .channels()[0]
    };
    assert!((middle(ShadingModel::Phong) - 1.0).abs() < 1e-12);
    // R.V = 3/5 at the corners.
    let blended = middle(ShadingModel::Gouraud);
    assert!(
        (blended / 0.6f64.powi(50) - 1.0).abs() < 1e-9,
        "{blended:e}"
    );
    // Flat: computed in the middle, which is where the highlight is.
    assert!((middle(ShadingModel::Flat) - 1.0).abs() < 1e-12);
}

#[test]
fn affine_weights_are_off_by_the_formula() {
    // An edge from depth 1 to depth 3.
    let edge =
        r#""vertices": [[-0.5, -0.2, 1], [-0.5, 0.2, 1], [1.5, 0, -1]], "triangles": [[0, 1, 2]]"#;
    let scene = mesh([0.0, 0.0, 2.0], r#""diffuse": [1, 1, 1]"#, edge);
    let settings = eye_rays_only(&scene, (101, 81));
    let span = |blend| {
        let filling = Filling {
            shading: Some(ShadingModel::Phong),
            blend,
        };
        raster(&scene, &settings, filling, Some(40)).spans[0].span
    };
    let [right, affine] = [ScreenBlend::Perspective, ScreenBlend::Affine].map(span);
    assert_eq!([right.from.x, right.to.x], [affine.from.x, affine.to.x]);
    for part in [0.0, 0.1, 0.25, 0.5, 0.8, 1.0] {
        let x = right.from.x + part * (right.to.x - right.from.x);
        let (z0, z1) = (1.0, 3.0);
        let true_weight = (part / z1) / ((1.0 - part) / z0 + part / z1);
        assert!((right.at(x).weights[2] - true_weight).abs() < 1e-12);
        assert!((affine.at(x).weights[2] - part).abs() < 1e-12);
    }
    let half = right.at(f64::midpoint(right.from.x, right.to.x));
    assert!((half.weights[2] - 0.25).abs() < 1e-12);
}

/// The corners of an icosahedron, each face cut into four: 80 triangles of a unit sphere, turned by an angle around y.
pub fn sphere(angle: f64) -> String {
    let golden = f64::midpoint(1.0, 5.0f64.sqrt());
    let mut points: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [
        (1.0, golden),
        (-1.0, golden),
        (1.0, -golden),
        (-1.0, -golden),
    ] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let distance = |p: [f64; 3], q: [f64; 3]| -> f64 {
        (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt()
    };
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [p, q, r] = [points[i], points[j], points[k]];
                if [distance(p, q), distance(q, r), distance(r, p)]
                    .iter()
                    .any(|d| *d > 2.1)
                {
                    continue;
                }
                let mid = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|i| f64::midpoint(p[i], q[i]));
                let (a, b, c) = (mid(p, q), mid(q, r), mid(r, p));
                for [u, v, w] in [[p, a, c], [a, q, b], [c, b, r], [a, b, c]] {
                    // Counter-clockwise, seen from outside.
                    let [e, f, g] = [u, v, w].map(DVec3::from);
                    let outwards = (f - e).cross(g - e).dot(e) > 0.0;
                    corners.extend(if outwards { [u, v, w] } else { [u, w, v] });
                }
            }
        }
    }
    let unit = |p: &[f64; 3]| {
        let length = distance(*p, [0.0; 3]);
        let [x, y, z] = p.map(|c| c / length);
        let (sin, cos) = libm::sincos(angle);
        format!("[{}, {y}, {}]", cos * x + sin * z, cos * z - sin * x)
    };
    let points: Vec<String> = corners.iter().map(unit).collect();
    let triangles: Vec<String> = (0..corners.len() / 3)
        .map(|t| format!("[{}, {}, {}]", 3 * t, 3 * t + 1, 3 * t + 2))
        .collect();
    assert_eq!(triangles.len(), 80);
    let points = points.join(", ");
    format!(
        r#""vertices": [{points}], "normals": [{points}], "triangles": [{}]"#,
        triangles.join(", ")
    )
}

#[test]
fn a_turning_sphere_flickers_with_gouraud_and_not_with_phong() {
    let shiny = r#""specular": [1, 1, 1], "shininess": 100"#;
    let brightest = |shading: ShadingModel, frame: u32| {
        let scene = mesh([0.4, 0.3, 3.0], shiny, &sphere(f64::from(frame) * 0.0175));
        let settings = eye_rays_only(&scene, (128, 128));
        let film = filled(&scene, &settings, shading).film;
        film.pixels
            .iter()
            .map(|p| p.max_channel())
            .fold(0.0, f64::max)
    };
    let ratio = |shading| {
        let frames: Vec<f64> = (0..90)
            .step_by(3)
            .map(|frame| brightest(shading, frame))
            .collect();
        let [low, high] =
            [f64::min, f64::max].map(|f| frames.iter().copied().reduce(f).expect("frames"));
        high / low
    };
    let [gouraud, phong] = [ShadingModel::Gouraud, ShadingModel::Phong].map(ratio);
    assert!(gouraud > 1.5, "{gouraud}");
    assert!(phong < 1.02, "{phong}");
}

#[test]
fn gouraud_shows_the_diagonal_of_a_quad() {
    // The lamp stands close to one corner.
    let corners = r#""vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]"#;
    let middle = |triangles: &str, shading| {
        let text = format!("{corners}, \"triangles\": {triangles}");
        let mut scene = mesh([0.0, 0.0, 3.0], r#""diffuse": [1, 1, 1]"#, &text);
        scene.lights[0].kind = raytree::shading::LightKind::Point {
            position: [1.0, 1.0, 0.6].into(),
            attenuation: [1.0, 0.0, 1.0],
            intensity: Rgb::WHITE,
        };
        let settings = eye_rays_only(&scene, (65, 65));
        filled(&scene, &settings, shading)
            .film
            .at(32, 32)
            .channels()[0]
    };
    let [one, other] = ["[[0, 1, 2], [0, 2, 3]]", "[[0, 1, 3], [1, 2, 3]]"];
    let gap = |shading| (middle(one, shading) - middle(other, shading)).abs();
    assert!(gap(ShadingModel::Gouraud) > 0.1);
    assert!(gap(ShadingModel::Phong) < 1e-12);
}

#[test]
fn each_pixel_of_a_shared_edge_is_covered_once() {
    let fan: Vec<String> = (0..24)
        .map(|i| {
            let angle = std::f64::consts::TAU * f64::from(i) / 24.0;
            format!("[{}, {}, 0]", libm::cos(angle), libm::sin(angle))
        })
        .collect();
    let triangles: Vec<String> = (0..24)
        .map(|i| format!("[24, {i}, {}]", (i + 1) % 24))
        .collect();
    let text = format!(
        r#""vertices": [{}, [0, 0, 0]], "triangles": [{}]"#,
        fan.join(", "),
        triangles.join(", ")
    );
    let scene = mesh([0.0, 0.0, 3.0], r#""diffuse": [1, 1, 1]"#, &text);
    // Odd sizes: pixel middles lie on edges and on the corner in the middle.
    let settings = eye_rays_only(&scene, (63, 63));
    for row in 0..63 {
        let drawn = raster(&scene, &settings, Filling::default(), Some(row));
        let covered: u32 = drawn.spans.iter().map(|s| s.covered).sum();
        let seen = &drawn.primitives[row as usize * 63..][..63];
        let seen = seen.iter().filter(|p| **p != NONE).count();
        assert_eq!(covered as usize, seen, "row {row}");
        assert!(drawn.spans.iter().all(|s| s.covered == s.drawn));
    }
}

#[test]
fn normals_that_cancel_leave_the_normal_of_the_plane() {
    let opposed = TRIANGLE.replace(
        "[[0, 0, 1], [0, 0, 1], [0, 0, 1]]",
        "[[1, 0, 0], [-0.5, 0.8660254037844386, 0], [-0.5, -0.8660254037844386, 0]]",
    );
    let scene = mesh([0.0, 0.0, 2.0], r#""diffuse": [1, 1, 1]"#, &opposed);
    let settings = eye_rays_only(&scene, (65, 65));
    for shading in [
        ShadingModel::Flat,
        ShadingModel::Gouraud,
        ShadingModel::Phong,
    ] {
        let film = filled(&scene, &settings, shading).film;
        assert!(film.pixels.iter().all(|p| p.is_finite()));
    }
    agrees_with_the_tracer(scene, (64, 48), 1e-9);
}

#[test]
fn the_command_draws_and_tells() {
    let ran = run(&["raster", "teapot", "--size", "40x30", "--color", "never"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(String::from_utf8_lossy(&ran.out).lines().count(), 15);
    let ran = run(&[
        "raster",
        "teapot",
        "--size",
        "40x30",
        "--row",
        "15",
        "--shading",
        "gouraud",
    ]);
    let text = String::from_utf8(ran.out).expect("UTF-8");
    assert!(text.starts_with("Row 15 (y = 15.5), "), "{text}");
    assert!(text.contains("\nteapot "), "{text}");
    assert!(
        text.lines().all(|line| line.chars().count() <= 80),
        "{text}"
    );
    let ran = run(&["raster", "whitted", "--size", "8x6"]);
    assert!(
        ran.err.contains("only triangles are filled: the "),
        "{}",
        ran.err
    );
    refused(
        &["raster", "teapot", "--size", "8x6", "--row", "6"],
        2,
        &["rows 0 to 5"],
    );
}
