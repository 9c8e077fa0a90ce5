//! A slab of glass, straight on: what it reflects and lets through is a geometric series, so the error of a depth cut
//! is known on paper.
//!
//! One face reflects R = ((n - 1) / (n + 1))^2 = 0.04 for n = 1.5. All there and back in the slab added up, 1/13 comes
//! back and 12/13 goes through.

use raytree::accel::AccelKind;
use raytree::probe::Silent;
use raytree::tracer::pixel;
use raytree::world::World;

use crate::from_text;

/// Of one face, n = 1.5.
const R: f64 = 0.04;

/// The radiance that an eye before the slab sees, with a shining wall at this z and a sky as bright as this.
fn seen(wall: Option<f64>, sky: f64, depth: u32) -> f64 {
    let wall = wall.map_or(String::new(), |z| {
        format!(
            r#", {{"quad": {{"name": "wall", "material": "wall", "corner": [-9, -9, {z}], "u": [18, 0, 0], "v": [0, 18, 0]}}}}"#
        )
    });
    let text = format!(
        r#"{{
  "format": "raytree-scene/1", "name": "slab", "background": [{sky}, {sky}, {sky}], "ambient": [0, 0, 0],
  "camera": {{"eye": [0, 0, 2], "look_at": [0, 0, 0], "vertical_fov": 1e-6}},
  "materials": {{
    "glass": {{"diffuse": [0, 0, 0], "transmission": [1, 1, 1], "ior": 1.5}},
    "wall": {{"diffuse": [0, 0, 0], "emission": [1, 1, 1]}}
  }},
  "lights": [],
  "objects": [{{"box": {{"name": "slab", "material": "glass", "min": [-8, -8, -1], "max": [8, 8, 1]}}}}{wall}]
}}"#
    );
    let scene = from_text::scene(&text);
    let settings = scene.settings.with(|s| {
        s.image.width = 1;
        s.image.height = 1;
        s.recursion.depth = depth;
        s.recursion.min_weight = 0.0;
    });
    let world = World::new(scene, AccelKind::List);
    pixel(&world, &settings, (0, 0), &mut Silent)
        .color
        .channels()[0]
}

fn near(got: f64, truth: f64, what: &str) {
    assert!((got - truth).abs() < 1e-12, "{what}: {got}, not {truth}");
}

#[test]
fn a_thirteenth_comes_back_and_the_rest_goes_through() {
    near(seen(Some(9.0), 0.0, 30), 1.0 / 13.0, "reflected");
    near(seen(Some(-9.0), 0.0, 30), 12.0 / 13.0, "transmitted");
}

#[test]
fn a_depth_cut_after_k_times_there_and_back_leaves_out_r_to_the_2k_2() {
    for k in 0..4u32 {
        let left_out = libm::pow(R, f64::from(2 * k + 2));
        // Two faces on the straight way through, and two more each time; a bounce more cannot help.
        for depth in [2 + 2 * k, 3 + 2 * k] {
            let truth = 12.0 / 13.0 * (1.0 - left_out);
            near(seen(Some(-9.0), 0.0, depth), truth, "transmitted");
        }
        // What comes back does so at once, or after an odd number of faces inside.
        let back = R + 12.0 / 13.0 * R * (1.0 - libm::pow(R, f64::from(2 * k)));
        near(seen(Some(9.0), 0.0, 1 + 2 * k), back, "reflected");
    }
}

#[test]
fn in_a_white_sky_glass_cannot_be_seen_but_for_what_a_depth_cut_leaves_inside() {
    near(seen(None, 1.0, 30), 1.0, "white furnace");
    for depth in 1..6 {
        let inside = (1.0 - R) * libm::pow(R, f64::from(depth) - 1.0);
        near(seen(None, 1.0, depth), 1.0 - inside, "cut");
    }
}
