//! The eye in impossible places, and pictures that may not depend on who computes them.

use raytree::accel::AccelKind;
use raytree::sampling::Sampler;
use raytree::scene::{Settings, load};
use raytree::trace::trace_pixel;
use raytree::tracer::draw;
use raytree::world::World;

/// A picture of a ball with this camera: its pixels, or the message.
fn picture(camera: &str) -> Result<Vec<[f64; 3]>, String> {
    let text = format!(
        r#"{{"format": "raytree-scene/1", "background": [0.1, 0.2, 0.3], "camera": {{{camera}}},
        "materials": {{"chalk": {{"ambient": [1, 1, 1]}}}}, "ambient": [1, 1, 1],
        "objects": [{{"sphere": {{"name": "ball", "material": "chalk", "center": [0, 0, 0], "radius": 1}}}}]}}"#
    );
    let scene = raytree::scene::from_json(&text).map_err(|error| error.to_string())?;
    let world = World::new(scene, AccelKind::default());
    let settings = Settings::default().with(|s| {
        s.image.width = 8;
        s.image.height = 8;
    });
    let pixel = |i: u32| trace_pixel(&world, &settings, (i % 8, i / 8), false).pixel;
    Ok((0..64).map(|i| pixel(i).color.channels()).collect())
}

/// Source: case 72. Expected: the narrowest and the widest angles are pictures, 0 and 180 degrees and more are refused.
#[test]
fn case_72_any_field_of_view_is_finite_or_refused() {
    for fov in ["1e-6", "1e-300", "179.999", "179.9999999999999"] {
        let eye = format!(r#""eye": [0, 0, 3], "look_at": [0, 0, 0], "vertical_fov": {fov}"#);
        let pixels = picture(&eye).unwrap_or_else(|error| panic!("{fov}: {error}"));
        assert!(pixels.iter().flatten().all(|c| c.is_finite()), "{fov}");
        // The narrow ones see the ball alone, the wide ones hardly anything of it.
        let narrow = fov.starts_with("1e");
        let ball = pixels.iter().filter(|p| **p == [1.0; 3]).count();
        assert_eq!(ball, if narrow { 64 } else { 0 }, "{fov}");
    }
    for fov in ["0", "-1", "180", "360", "1e999"] {
        let eye = format!(r#""eye": [0, 0, 3], "look_at": [0, 0, 0], "vertical_fov": {fov}"#);
        assert!(picture(&eye).is_err(), "{fov}");
    }
}

/// Source: case 73. Expected: refused with what to do, or a picture.
#[test]
fn case_73_up_along_the_view_is_refused() {
    for up in ["[0, 0, 1]", "[0, 0, -7]", "[0, 0, 1e-300]", "[0, 0, 0]"] {
        let camera = format!(r#""eye": [0, 0, 3], "look_at": [0, 0, 0], "up": {up}"#);
        let message = picture(&camera).expect_err(up);
        assert!(message.contains("up"), "{up}: {message}");
    }
    for up in ["[1e-7, 0, 1]", "[0, 1e-300, 0]", "[0, 1e12, 1]"] {
        let camera = format!(r#""eye": [0, 0, 3], "look_at": [0, 0, 0], "up": {up}"#);
        if let Ok(pixels) = picture(&camera) {
            assert!(pixels.iter().flatten().all(|c| c.is_finite()), "{up}");
        }
    }
}

/// Source: case 85. Expected: the same bits for any number of threads.
#[test]
fn case_85_any_number_of_threads_makes_the_same_picture() {
    let world = World::new(
        load("soft-shadow").expect("a built-in scene"),
        AccelKind::Wide,
    );
    let settings = world.scene.settings.with(|s| {
        s.image.width = 70;
        s.image.height = 40;
        s.pixel.samples = 2;
        s.pixel.sampler = Sampler::Stratified;
        s.light.samples = 4;
    });
    let film = |threads| draw(&world, &settings, threads);
    let one = film(1);
    for threads in [2, 3, 7, 64] {
        assert_eq!(film(threads), one, "{threads} threads");
    }
}
