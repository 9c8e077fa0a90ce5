//! Edges of formulas: where a root is 0, and where a power has the base 0.

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::shading::Fresnel;
use raytree::trace::trace_pixel;
use raytree::world::World;
use serde_json::Value;

use crate::from_text;

/// The tree of the middle of a picture.
fn traced(text: &str, size: (u32, u32), pixel: (u32, u32), fresnel: Fresnel) -> Value {
    let scene = from_text::scene(text);
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = size;
        s.fresnel = fresnel;
    });
    let world = World::new(scene, AccelKind::List);
    let trace = trace_pixel(&world, &settings, pixel, false);
    let document = raytree::trace::document::of(raytree::trace::View {
        world: &world,
        settings: &settings,
        trace: &trace,
    });
    serde_json::to_value(document).expect("JSON")
}

#[test]
fn at_the_critical_angle_itself_all_light_is_reflected_in_every_model() {
    // tan of asin(1 / 1.5), as near as 64 bits come: the number under the root is 0.
    let text = r#"{"format": "raytree-scene/1",
        "camera": {"eye": [0, -1, 0], "look_at": [0.8944271909999159, 0, 0]}, "background": [1, 1, 1],
        "materials": {"glass": {"transmission": [1, 1, 1], "ior": 1.5}},
        "objects": [{"box": {"name": "b", "material": "glass", "min": [-9, -9, -9], "max": [9, 0, 9]}}]}"#;
    for model in [Fresnel::None, Fresnel::Schlick, Fresnel::Exact] {
        let tree = traced(text, (9, 9), (4, 4), model);
        let root = &tree["samples"][0]["root"];
        assert_eq!(root["boundary"]["reflectance"], 1.0, "{model:?}");
        let reason = |absent: &&Value| absent["reason"] == "total-internal-reflection";
        let absences = root["absent"].as_array().expect("a list");
        let told = absences.iter().find(reason).expect("told");
        assert_eq!(told["k"], 0.0, "the case is the edge itself");
        let kinds: Vec<&Value> = root["children"]
            .as_array()
            .expect("a list")
            .iter()
            .collect();
        assert!(
            matches!(&kinds[..], [ray] if ray["kind"] == "R"),
            "{kinds:?}"
        );
        assert_eq!(kinds[0]["weight"], serde_json::json!([1.0, 1.0, 1.0]));
    }
}

#[test]
fn a_highlight_of_exponent_0_is_black_where_the_mirrored_light_goes_away() {
    let text = r#"{"format": "raytree-scene/1",
        "camera": {"eye": [0, 0.3, 4], "look_at": [0, 0, 0]},
        "materials": {"a": {"specular": [1, 1, 1], "shininess": 0}},
        "lights": [{"directional": {"name": "l", "direction": [-1, -0.05, 0], "intensity": [1, 1, 1]}}],
        "objects": [{"plane": {"name": "a", "material": "a", "point": [0, 0, 0], "normal": [0, 1, 0]}}]}"#;
    // The mirrored light goes to the left and is seen from there.
    for (x, expected) in [(5, Rgb::BLACK), (60, Rgb::WHITE)] {
        let tree = traced(text, (64, 48), (x, 40), Fresnel::Exact);
        let root = &tree["samples"][0]["root"];
        let terms = root["terms"].as_array().expect("a list").iter();
        let highlight: Vec<&Value> = terms.filter(|t| t["term"] == "specular").collect();
        assert_eq!(highlight.len(), 1, "{root}");
        let is_black = highlight[0]["r_dot_v"] == 0.0;
        assert_eq!(is_black, expected.is_black(), "pixel {x}");
        assert_eq!(
            highlight[0]["value"],
            serde_json::json!(expected.channels())
        );
    }
}
