//! Glass spheres that rest on a floor and on each other: what is left out there, the search for all that a ray crosses, changes no bit.

use raytree::accel::AccelKind;
use raytree::scene::Effects;
use raytree::tracer::draw;
use raytree::world::{Contact, World};
use serde_json::{Value, json};

use crate::from_text;

/// Radii of spheres in a row, each of which touches the floor and the one before it, and what they are made of.
const ROW: [(f64, &str); 6] = [
    (1.0, "glass"),
    (0.7, "mirror"),
    (0.5, "glass"),
    (0.3, "glass"),
    (0.4, "chalk"),
    (0.8, "water"),
];

/// The row, moved along x; with `specks` there is a disc, too small to be seen, in a corner of the box around each sphere. So none
/// of them is known to touch others at points only.
fn scene(moved: f64, specks: bool, camera: &Value) -> World {
    let (mut x, mut before) = (moved, None::<f64>);
    let (mut objects, mut small) = (Vec::new(), Vec::new());
    for (i, (radius, material)) in ROW.into_iter().enumerate() {
        x += before.map_or(0.0, |before| 2.0 * (before * radius).sqrt());
        before = Some(radius);
        objects.push(json!({"sphere": {
            "name": format!("sphere {i}"), "material": material, "center": [x, radius, 0], "radius": radius
        }}));
        small.push(json!({"disc": {
            "name": format!("speck {i}"), "material": "chalk", "normal": [0, 1, 0], "radius": 1e-13,
            "center": [x + 0.9 * radius, 1.9 * radius, 0.9 * radius]
        }}));
    }
    objects.push(json!({"plane": {"name": "floor", "material": "floor", "point": [0, 0, 0], "normal": [0, 1, 0]}}));
    if specks {
        objects.extend(small);
    }
    let text = json!({
        "format": "raytree-scene/1",
        "camera": camera,
        "background": [0.3, 0.5, 0.8],
        "materials": {
            "glass": {"mirror": [1, 1, 1], "transmission": [1, 1, 1], "ior": 1.5},
            "water": {"mirror": [1, 1, 1], "transmission": [0.9, 1, 1], "ior": 1.33},
            "mirror": {"mirror": [0.9, 0.9, 0.9]},
            "chalk": {"diffuse": [0.8, 0.7, 0.6]},
            "floor": {"diffuse": [0.5, 0.5, 0.5], "checker": {"diffuse": [0.1, 0.1, 0.1], "size": 0.3}}
        },
        "lights": [{"point": {"name": "lamp", "position": [moved + 1.0, 6, 4], "intensity": [30, 30, 30]}}],
        "objects": objects,
        "settings": {"depth": 9, "fresnel": "exact"}
    });
    World::new(from_text::scene(&text.to_string()), AccelKind::List)
}

#[test]
fn what_touches_at_points_looks_as_if_all_were_asked() {
    for moved in [0.0, 1e3, -1e6] {
        // From afar, into the points where the first sphere touches the floor and where it touches the second, and from inside.
        let second = 2.0 * 0.7f64.sqrt();
        let touching = [second / 1.7, 1.4 / 1.7, 0.0];
        for (eye, look_at, fov) in [
            ([2.0, 2.5, 7.0], [2.0, 0.5, 0.0], 50.0),
            ([0.0, 0.5, 5.0], [0.0, 0.0, 0.0], 0.01),
            ([0.0, 1e-3, 5.0], [0.0, 0.0, 0.0], 1e-4),
            ([1.0, 2.5, 3.0], touching, 1e-3),
            ([0.1, 1.2, 0.1], [0.0, 0.0, 0.0], 90.0),
            ([0.1, 1.2, 0.1], [0.0, 0.0, 0.0], 1e-3),
            ([0.1, 1.2, 0.1], [0.0, 0.0, 0.0], 1e-6),
            ([0.1, 1.2, 0.1], touching, 1e-3),
            ([0.1, 1.2, 0.1], touching, 1e-6),
        ] {
            let at = |p: [f64; 3]| [p[0] + moved, p[1], p[2]];
            let camera = json!({"eye": at(eye), "look_at": at(look_at), "vertical_fov": fov});
            let pixels = [false, true].map(|specks| {
                let world = scene(moved, specks, &camera);
                let expected = if specks {
                    Contact::Touching
                } else {
                    Contact::Resting
                };
                assert_eq!(world.contact(0), expected, "{moved}");
                let settings = world.scene.settings.with(|s| {
                    (s.image.width, s.image.height) = (60, 44);
                    s.effects = Effects::ALL;
                });
                draw(&world, &settings, 1).pixels
            });
            let [resting, touching] = &pixels;
            assert!(resting == touching, "{moved} {eye:?} {look_at:?}");
        }
    }
}
