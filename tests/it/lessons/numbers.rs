//! Numbers that the course is built on, worked out on paper or measured when it was planned: the tracer gives them still.

use raytree::lesson::stage::Stage;
use raytree::lesson::value::LessonValue;
use raytree::trace::field::FieldValue;

use super::course;

/// The stage of a chapter, in one of its scenes, with settings.
fn stage(chapter: usize, scene: Option<&str>, settings: &str) -> Stage {
    let course = course();
    let chapter = &course.chapters[chapter - 1];
    let pairs: Vec<(String, String)> = settings
        .split_whitespace()
        .filter_map(|pair| pair.split_once('='))
        .map(|(name, value)| (name.to_owned(), value.to_owned()))
        .collect();
    course.stage(chapter, scene, &pairs).expect("a stage")
}

#[track_caller]
fn is(stage: &Stage, asked: &str, right: &[f64], off: f64) {
    let value = LessonValue::parse(asked)
        .and_then(|asked| asked.value(stage))
        .expect(asked);
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= off;
    let told = value.numbers();
    assert!(
        told.len() == right.len() && told.iter().zip(right).all(near),
        "{asked}: {told:?}, not {right:?}"
    );
}

#[track_caller]
fn word(stage: &Stage, asked: &str, right: &str) {
    let value = LessonValue::parse(asked).and_then(|asked| asked.value(stage));
    assert_eq!(value, Ok(FieldValue::Word(right.to_owned())), "{asked}");
}

#[test]
fn rays_floor_triangle_closest() {
    let rays = stage(1, None, "");
    is(&rays, "trace 160,120.direction.x", &[0.00208], 5e-6);
    is(
        &rays,
        "trace 0,0.direction",
        &[-0.51128, 0.38306, -0.76932],
        5e-6,
    );
    is(
        &rays,
        "trace 240,150.direction",
        &[0.31572, -0.11962, -0.94128],
        5e-6,
    );
    let floor = stage(2, None, "");
    is(&floor, "trace 160,180.t", &[4.09105], 5e-6);
    is(&floor, "trace 160,120.t", &[480.002], 5e-4);
    word(&floor, "trace 220,100.outcome", "miss");
    let sail = stage(3, None, "");
    is(&sail, "trace 160,100.t", &[4.01319], 5e-6);
    is(&sail, "trace 160,100.barycentric[2]", &[0.6625], 5e-6);
    is(&sail, "count hits:sail", &[7200.0], 0.0);
    let closest = stage(4, None, "");
    word(&closest, "trace 140,120.object", "sail");
    is(&closest, "trace 140,120.t", &[4.01319], 2e-2);
    word(&closest, "trace 110,150.object", "wall");
    is(&closest, "trace 110,150.t", &[6.17356], 5e-6);
    is(&closest, "tests-per-ray", &[3.0], 0.0);
}

#[test]
fn sphere_normals_light_highlights() {
    let sphere = stage(5, None, "");
    is(&sphere, "trace 240,150.sphere.b", &[-6.39875], 5e-6);
    is(&sphere, "trace 240,150.sphere.c", &[10.0], 1e-12);
    is(&sphere, "trace 240,150.sphere.disc", &[0.94404], 5e-6);
    is(&sphere, "trace 240,150.sphere.t0", &[2.71357], 5e-6);
    is(&sphere, "trace 240,150.sphere.t1", &[3.68518], 5e-6);
    let normals = stage(6, None, "");
    is(
        &normals,
        "trace 240,150.normal",
        &[-0.28654, 0.3508, 0.89154],
        5e-6,
    );
    let teapot = stage(6, Some("teapot"), "");
    is(
        &teapot,
        "trace 160,120.barycentric",
        &[0.13511, 0.74176, 0.12313],
        5e-6,
    );
    is(&teapot, "trace 160,120.normal_angle", &[8.0], 5e-3);
    let light = stage(7, None, "");
    is(
        &light,
        "trace 240,150.terms.diffuse:lamp.n_dot_l",
        &[0.57866],
        5e-6,
    );
    is(
        &light,
        "trace 240,150.radiance",
        &[0.62293, 0.15573, 0.07787],
        5e-6,
    );
    let shine = stage(8, None, "");
    is(
        &shine,
        "trace 250,140.terms.specular:lamp.r_dot_v",
        &[0.99962],
        5e-6,
    );
    is(
        &shine,
        "trace 250,140.terms.specular:lamp.r",
        &[0.49622],
        5e-6,
    );
    is(
        &shine,
        "trace 225,140.terms.specular:lamp.r_dot_v",
        &[0.49813],
        5e-6,
    );
}

#[test]
fn shadows_mirrors_the_tree() {
    let shadows = stage(9, None, "");
    word(&shadows, "trace 100,160/L:lamp.lit", "blocked");
    word(&shadows, "trace 100,160/L:lamp.object", "sail");
    word(&shadows, "trace 100,160/L:fill.lit", "lit");
    is(&shadows, "trace 100,160/L:lamp.distance", &[7.2318], 5e-5);
    is(&shadows, "trace 250,205.color", &[0.12; 3], 5e-6);
    let mirror = stage(10, None, "");
    is(
        &mirror,
        "trace 196,125.direction",
        &[0.15032, -0.02265, -0.98838],
        5e-6,
    );
    is(
        &mirror,
        "trace 196,125/R.direction",
        &[0.15032, -0.02265, 0.98838],
        5e-6,
    );
    word(&mirror, "trace 196,125/R.object", "ball");
    is(&mirror, "trace 196,125/R.t", &[2.81297], 5e-6);
    is(&mirror, "trace 196,125/R.weight", &[0.8; 3], 1e-12);
    is(&mirror, "trace 190,120/R.t", &[477.8], 0.05);
    let tree = |depth: u32| stage(11, Some("mirrors"), &format!("depth={depth}"));
    for (depth, rays) in [(0, 2.0), (1, 4.0), (2, 6.0), (6, 14.0), (16, 24.0)] {
        is(&tree(depth), "trace 208,96.rays", &[rays], 0.0);
    }
}

#[test]
fn glass_media_transforms() {
    let glass = stage(12, None, "");
    is(&glass, "trace 70,150.angle", &[9.72], 5e-3);
    is(
        &glass,
        "trace 70,150/T/T.direction",
        &[-0.40765, -0.20524, -0.88978],
        5e-6,
    );
    let block = stage(12, Some("glass-block"), "");
    is(
        &block,
        "trace 160,120/T/T.direction",
        &[-0.07581, -0.24865, -0.96562],
        5e-6,
    );
    let media = stage(13, Some("glass-block"), "");
    is(&media, "trace 80,120/T.angle", &[50.46], 5e-3);
    is(&media, "trace 80,120/T.absent.T.k", &[-0.33813], 5e-6);
    word(
        &media,
        "trace 80,120/T.absent.T",
        "total-internal-reflection",
    );
    let nested = stage(13, Some("nested-glass"), "");
    for (path, medium) in [
        ("", "air"),
        ("/T", "glass"),
        ("/T/T", "water"),
        ("/T/T/T", "glass"),
        ("/T/T/T/T", "air"),
    ] {
        word(&nested, &format!("trace 160,120{path}.medium"), medium);
    }
    let egg = stage(14, None, "");
    is(
        &egg,
        "trace 70,120.point",
        &[-0.89812, 0.99498, 1.59164],
        5e-6,
    );
    is(
        &egg,
        "trace 70,120.normal",
        &[0.55323, 0.27968, 0.78467],
        5e-6,
    );
}

#[test]
fn speed_bsp_samples_area_lights() {
    let bunny = stage(15, Some("bunny"), "");
    is(&bunny, "nodes-per-ray", &[16.9], 0.05);
    is(&bunny, "tests-per-ray", &[3.3], 0.05);
    let bsp = stage(16, None, "accel=bsp-polygon");
    is(&bsp, "trace 160,100.t", &[4.01319], 5e-6);
    let one = stage(18, None, "samples=1");
    is(&one, "trace 139,100.color", &[0.02, 0.06, 0.16], 5e-6);
    let many = stage(18, None, "samples=256");
    is(&many, "trace 139,100.color", &[0.055, 0.055, 0.125], 5e-6);
    let grid = |n: u32| stage(19, None, &format!("light-samples={n}"));
    // The light itself brings 0.1825 and 0.18959; ambient light is 0.12.
    is(&grid(4), "trace 205,205.color.r", &[0.3025], 5e-6);
    is(&grid(16), "trace 205,205.color.r", &[0.30959], 5e-6);
}
