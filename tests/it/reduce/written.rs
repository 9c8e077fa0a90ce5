//! Scenes that are written and read again: all numbers have the same bits.

use raytree::geometry::Shape;
use raytree::reduce::{Kept, part};
use raytree::scene::write::scene_file;
use raytree::scene::{self, Object, Scene, builtin};

/// What the corners of all triangles of an object carry.
fn corners(object: &Object, count: usize) -> Vec<String> {
    let Some(data) = &object.vertices else {
        return Vec::new();
    };
    let weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.2, 0.3, 0.5]];
    let of = |triangle: usize| {
        weights.map(|w| {
            let normal = data.normal(triangle, w);
            format!("{normal:?} {:?}", data.uv(triangle, w))
        })
    };
    (0..count).flat_map(of).collect()
}

/// All of a scene in a text that shows every bit.
fn shown(scene: &Scene) -> Vec<String> {
    let mut lines = vec![
        format!("{:?}", scene.camera),
        format!("{:?} {:?}", scene.background, scene.ambient),
        format!("{:?}", scene.settings),
    ];
    lines.extend(scene.lights.iter().map(|light| format!("{light:?}")));
    for (number, object) in (0..).zip(&scene.objects) {
        let material = &scene.materials[object.material as usize];
        lines.push(format!("{} {} {material:?}", object.name, object.mirrored));
        let shapes = scene.shapes_of(number);
        // The sign of a zero in a matrix decides nothing: of these the trees are compared.
        let is_moved = |shape: &Shape| matches!(shape, Shape::Transformed(_));
        lines.extend(
            shapes
                .iter()
                .filter(|s| !is_moved(s))
                .map(|s| format!("{s:?}")),
        );
        lines.extend(corners(object, shapes.len()));
    }
    lines
}

#[track_caller]
fn check(scene: &Scene) {
    // A scene file parts objects of many shapes: that is done already.
    let scene = part(scene, &Kept::all(scene)).scene;
    let text = scene_file(&scene, "a test").unwrap_or_else(|e| panic!("{}: {e}", scene.name));
    let read = scene::from_json(&text).unwrap_or_else(|e| panic!("{}: {e}", scene.name));
    let (before, after) = (shown(&scene), shown(&read));
    for (before, after) in before.iter().zip(&after) {
        assert_eq!(after, before, "{}", scene.name);
    }
    assert_eq!(after.len(), before.len(), "{}", scene.name);
}

#[test]
fn built_in_scenes_are_read_as_they_are_written() {
    for name in builtin::names() {
        check(&scene::load(name).expect("built in"));
    }
    for name in [
        "lecture-1000",
        "slanted",
        "spd:balls:2",
        "spd:gears:1",
        "spd:mount:2",
        "spd:rings:1",
        "spd:tetra:2",
        "spd:tree:2",
    ] {
        check(&scene::load(name).expect("computed"));
    }
}

/// Shapes that transforms carry, stretch, turn and mirror; lights of all kinds.
pub const MOVED: &str = r#"{
  "format": "raytree-scene/1",
  "camera": {"eye": [0.3, 1, 7], "look_at": [0.1, 0.2, 0.3], "up": [0.1, 1, 0.2], "vertical_fov": 41.3},
  "materials": {
    "m": {"diffuse": [0.5, 0.5, 0.5], "ambient": [0.1, 0.2, 0.3], "mirror": [0.2, 0.2, 0.2],
      "checker": {"diffuse": [0.1, 0.1, 0.1], "size": 0.3}},
    "lamp": {"emission": [2, 2, 2]}
  },
  "lights": [
    {"area": {"name": "lamp", "object": "all/lamp"}},
    {"directional": {"name": "sun", "direction": [1, -2, -3], "intensity": [0.2, 0.2, 0.2]}},
    {"spot": {"name": "spot", "position": [0.1, 5, 0.7], "look_at": [0.3, 0, 0.1], "intensity": [1, 1, 1], "cone_angle": 61.7, "exponent": 3}}
  ],
  "objects": [
    {"group": {
      "name": "all", "transform": [{"rotate": {"axis": [0, 1, 1], "degrees": 25}}],
      "objects": [
        {"sphere": {"name": "egg", "material": "m", "center": [-1.5, 0, 0], "radius": 0.5, "transform": [{"scale": [1, 2, 1]}]}},
        {"box": {"name": "block", "material": "m", "min": [1, -0.5, -0.5], "max": [2, 0.5, 0.5]}},
        {"disc": {"name": "plate", "material": "m", "center": [0, 1.3, 0], "normal": [0, 0.3, 1], "radius": 0.6, "transform": [{"scale": [1.5, 1, 1]}]}},
        {"plane": {"name": "floor", "material": "m", "point": [0, -1, 0], "normal": [0.1, 1, 0.2]}},
        {"quad": {"name": "lamp", "material": "lamp", "corner": [0, 2.5, 0], "u": [0.5, 0, 0], "v": [0, 0.1, 0.5]}},
        {"mesh": {
          "name": "tent", "material": "m", "transform": [{"scale": [-1, 1.3, 1]}],
          "vertices": [[-0.6, -0.6, 0], [0.6, -0.6, 0], [0, 0.6, 0.3], [0, -0.9, 0.5]], "triangles": [[0, 1, 2], [1, 0, 3]],
          "normals": [[-1, 0, 2], [1, 0, 2], [0, 1, 2], [0.3, -1, 1]]
        }}
      ]
    }},
    {"disc": {"name": "coin", "material": "m", "center": [2, 1, 1], "normal": [0.1, 0.2, 0.9], "radius": 0.3}},
    {"sphere": {"name": "ball", "material": "m", "center": [-2, 1, 1], "radius": 0.3}}
  ],
  "settings": {"size": [32, 24], "depth": 2, "light_samples": 2, "seed": 7, "exposure": 1.5, "fresnel": "schlick"}
}"#;

#[test]
fn what_was_moved_is_written_where_it_is() {
    let scene = scene::from_json(MOVED).expect("a scene");
    check(&scene);
    let whole = super::Whole::new(scene, |_| ());
    let mut met = 0;
    for (x, y) in (1..24)
        .step_by(5)
        .flat_map(|y| (1..32).step_by(5).map(move |x| (x, y)))
    {
        let found = whole.reduced((x, y), false);
        super::check_tree(&whole, &found, (x, y));
        met = met.max(found.counts[0][0]);
    }
    assert!(met >= 3);
}

#[test]
fn a_smooth_model_in_a_mirror_is_written_with_all_its_normals() {
    let scene = r#"{"format": "raytree-scene/1", "camera": {"eye": [1.2, 2.6, 5.4], "look_at": [0, 0.7, 0]},
      "materials": {"m": {"diffuse": [1, 1, 1]}}, "objects": [{"obj": {"name": "a", "material": "m", "file": "a.obj",
      "transform": [{"scale": [-1, 1.3, 0.7]}, {"rotate": {"axis": [1, 2, 3], "degrees": 20}}]}}]}"#;
    let model = include_bytes!("../../../scenes/teapot.obj");
    let files = [("a.json", scene.as_bytes()), ("a.obj", &model[..])];
    let files = files.map(|(name, bytes)| (name.to_owned(), bytes.to_vec()));
    let scene = scene::load_from_memory("a.json", files.into_iter().collect()).expect("a scene");
    assert!(scene.objects[0].mirrored && scene.shapes.len() > 900);
    check(&scene);
}

#[test]
fn a_flat_triangle_of_a_smooth_model_stays_flat() {
    // Corners without normals stand for none in a model; a scene file has one for each corner or none at all.
    let files = [
        (
            "a.json",
            r#"{"format": "raytree-scene/1", "camera": {"eye": [0.5, 0.5, 4], "look_at": [0.5, 0.5, 0]},
          "materials": {"m": {"diffuse": [1, 1, 1]}}, "objects": [{"obj": {"name": "a", "material": "m", "file": "a.obj"}}],
          "lights": [{"point": {"name": "l", "position": [0, 0, 5], "intensity": [1, 1, 1]}}]}"#,
        ),
        (
            "a.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvn 0.3 0.1 1\nf 1//1 2//1 3//1\nf 2 4 3\n",
        ),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), text.as_bytes().to_vec()));
    let scene = scene::load_from_memory("a.json", files.into_iter().collect()).expect("a scene");
    let part = part(&scene, &Kept::all(&scene)).scene;
    let text = scene_file(&part, "a test").expect("a file");
    let read = scene::from_json(&text).expect("a scene");
    let whole = super::Whole::new(part, |_| ());
    let again = super::Whole::new(read, |_| ());
    let mut smooth = 0;
    for pixel in (0..24).flat_map(|y| (0..32).map(move |x| (x, y))) {
        let tree = |whole: &super::Whole| super::plain_tree(&whole.world, &whole.settings, pixel);
        assert_eq!(tree(&again), tree(&whole), "{pixel:?}");
        let hit = &tree(&whole)["samples"][0]["root"]["hit"];
        smooth += usize::from(!hit.is_null() && hit["normal"] != hit["geometric_normal"]);
    }
    assert!(smooth > 3);
}

#[test]
fn unit_directions_are_taken_as_they_are() {
    let text = |normal: &str| {
        format!(
            r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 4], "look_at": [0, 0, 0], "half_height": 0.3}},
            "materials": {{"m": {{}}}}, "objects": [{{"plane": {{"name": "p", "material": "m", "point": [0, 0, 0], "normal": {normal}}}}}]}}"#
        )
    };
    let normal = |text: &str| match &scene::from_json(text).expect("a scene").shapes[0] {
        Shape::Plane(plane) => plane.normal().to_array(),
        other => panic!("{other:?}"),
    };
    assert_eq!(normal(&text("[0.6, 0.8, 0]")), [0.6, 0.8, 0.0]);
    assert_eq!(normal(&text("[0.36, 0.48, 0.8]")), [0.36, 0.48, 0.8]);
    assert_eq!(normal(&text("[0, 0, -3]")), [0.0, 0.0, -1.0]);
    let scene = scene::from_json(&text("[0, 1, 0]")).expect("a scene");
    assert_eq!(scene.camera.half_height, 0.3);
    for wrong in ["0", "-1"] {
        let text = text("[0, 1, 0]").replace("0.3}", &format!("{wrong}}}"));
        let error = scene::from_json(&text).expect_err("no height").to_string();
        assert!(
            error.contains("camera.half_height") && error.contains("above 0"),
            "{error}"
        );
    }
}
