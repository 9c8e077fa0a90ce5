//! Tests of fields: values known on paper, names that are told, and the moment at which each becomes known.

use super::*;
use crate::accel::AccelKind;
use crate::scene::Settings;
use crate::trace::{Address, PixelTrace, trace_pixel};
use crate::world::World;

const SCENE: &str = r#"{
    "format": "raytree-scene/1",
    "name": "fields",
    "camera": { "eye": [0, 1, 4], "look_at": [0, 1, 0], "vertical_fov": 53.13010235415598 },
    "materials": {
        "matt": { "diffuse": [0.6, 0.6, 0.6] },
        "glass": { "transmission": [1, 1, 1], "ior": 1.5 }
    },
    "lights": [{ "point": { "name": "lamp", "position": [2, 4, 3], "intensity": [1, 1, 1] } }],
    "objects": [
        { "plane": { "name": "floor", "material": "matt", "point": [0, 0, 0], "normal": [0, 1, 0] } },
        { "sphere": { "name": "ball", "material": "matt", "center": [1, 0.5, 1], "radius": 0.5 } },
        { "triangle": { "name": "sail", "material": "matt", "corners": [[-1, 0, 0], [1, 0, 0], [0, 2, 0]] } },
        { "sphere": { "name": "pearl", "material": "glass", "center": [-1.5, 0.6, 1.5], "radius": 0.6 } }
    ]
}"#;

fn traced(world: &World, settings: &Settings, at: (u32, u32)) -> PixelTrace {
    trace_pixel(world, settings, at, true)
}

fn world() -> World {
    let scene = crate::scene::SceneSource::text(SCENE)
        .and_then(|source| source.scene())
        .expect("a scene");
    World::new(scene, AccelKind::List)
}

/// The value of a field by its address.
fn value(text: &str) -> Result<FieldValue, String> {
    let world = world();
    let settings = world.scene.settings;
    let address: Address = text.parse()?;
    let Some(crate::trace::address::AddressPart::Field(name)) = address.part else {
        return Err("no field".to_owned());
    };
    let trace = traced(&world, &settings, address.pixel);
    let view = View {
        world: &world,
        settings: &settings,
        trace: &trace,
    };
    field(view, &address.path, &name)
}

#[track_caller]
fn is(text: &str, right: &[f64]) {
    let told = value(text).expect(text);
    let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-5;
    let numbers = told.numbers();
    assert!(
        numbers.len() == right.len() && numbers.iter().zip(right).all(near),
        "{text}: {told:?}, not {right:?}"
    );
}

#[test]
fn values_known_on_paper() {
    is("160,100.t", &[4.01319]);
    is("160,180.t", &[4.09105]);
    is("160,120.direction.x", &[0.00208]);
    is("0,0.direction", &[-0.51128, 0.38306, -0.76932]);
    is("160,100.barycentric[2]", &[0.6625]);
    is("240,150.sphere.b", &[-6.39875]);
    is("240,150.sphere.c", &[10.0]);
    is("240,150.sphere.disc", &[0.94404]);
    is("240,150.sphere.t0", &[2.71357]);
    is("240,150.sphere.t1", &[3.68518]);
    is("240,150.normal", &[-0.28654, 0.3508, 0.89154]);
    is("240,150.terms.diffuse:lamp.n_dot_l", &[0.57866]);
    is("240,150.rays", &[2.0]);
    is("100,160/L:lamp.distance", &[7.23185]);
    for (text, word) in [
        ("100,160/L:lamp.lit", "blocked"),
        ("100,160/L:lamp.object", "sail"),
        ("160,100.object", "sail"),
        ("160,100.outcome", "hit"),
        ("60,10.outcome", "miss"),
        ("160,100.side", "front"),
        ("240,200.absent.L:lamp", "facing-away"),
        ("20,150.absent.T", "sent"),
        ("160,100.order[1]", "ball"),
    ] {
        assert_eq!(value(text), Ok(FieldValue::Word(word.to_owned())), "{text}");
    }
}

#[test]
fn what_is_no_field_is_told_with_what_there_is() {
    for (text, said) in [
        ("160,100.objekt", "did you mean `object`?"),
        ("160,100.boundary", "no field `boundary`"),
        ("160,100.hit", "is a group of"),
        ("160,100.t.x", "it has no parts"),
        ("160,100.direction[3]", "there are 3, counted from 0"),
        ("160,100.lit", "is a field of L rays"),
        ("160,100.sphere.b", "rays that hit a sphere"),
        ("240,150.sphere.q", "sphere.a, b, c, disc"),
        ("240,150.quadric.a", "rays that hit a quadric"),
        ("60,10.torus.c4", "rays that hit a torus"),
        ("160,100.terms.specular:lamp", "there are diffuse:lamp"),
        ("160,100.terms.diffuse:lamp.x2", "has the factors"),
        ("160,100.absent.Q", "no ray Q is sent"),
        ("160,100.absent.L:lamp.k", "is no number here"),
        ("160,100/R.t", "there is no step R"),
        ("160,100.x", "no field `x`"),
    ] {
        let error = value(text).expect_err(text);
        assert!(error.contains(said), "{text}: {error}");
    }
}

/// Calls `check` with the fields of the eye ray of each pixel of a small picture.
fn for_each_pixel(
    scene: &str,
    mut check: impl FnMut((u32, u32), &dyn Fn(&str) -> Result<FieldValue, String>),
) {
    let scene = crate::scene::load(scene).expect(scene);
    let settings = scene
        .settings
        .with(|s| (s.image.width, s.image.height) = (48, 36));
    let world = World::new(scene, AccelKind::default());
    for at in (0..48 * 36).map(|i| (i % 48, i / 48)) {
        let trace = traced(&world, &settings, at);
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        check(at, &|name| field(view, &TreePath::default(), name));
    }
}

/// The equation of what is hit is 0 at the hit, and the hit is one of its crossings.
#[test]
fn equations_have_their_roots_where_the_hit_is() {
    for (name, surface, least) in [("quadrics", "quadric", 40), ("torus", "torus", 40)] {
        let mut told = 0;
        for_each_pixel(name, |at, all| {
            let number = |name: &str| match all(&format!("{surface}.{name}")) {
                Ok(value) => value.numbers().first().copied().unwrap_or(f64::NAN),
                Err(error) => panic!("{name}: {error}"),
            };
            if all(&format!("{surface}.t_c")).is_err() || all("gradient").is_err() {
                return;
            }
            told += 1;
            let t = all("t").expect("a hit").numbers()[0];
            let s = t - number("t_c");
            let (terms, crossings) = if surface == "quadric" {
                let terms = [number("c"), 2.0 * number("b") * s, number("a") * s * s];
                (terms.to_vec(), vec![number("t0"), number("t1")])
            } else {
                let power = |i: i32| number(&format!("c{i}")) * s.powi(i);
                let crossings = all("torus.crossings").expect("crossings");
                ((0..5).map(power).collect(), crossings.numbers().to_vec())
            };
            let size: f64 = terms.iter().map(|term| term.abs()).sum();
            let sum: f64 = terms.iter().sum();
            assert!(
                sum.abs() < 1e-12 * size.max(1.0),
                "{name} {at:?}: {terms:?}"
            );
            let near = |crossing: &f64| (crossing - t).abs() < 1e-12 * t;
            assert!(
                crossings.iter().any(near),
                "{name} {at:?}: {t} {crossings:?}"
            );
        });
        assert!(told >= least, "{name}: {told}");
    }
}

/// On curved walls with an equation; on flat faces there is none.
#[test]
fn a_gradient_is_along_the_normal_and_points_outwards() {
    for (name, least) in [("quadrics", 60), ("torus", 60), ("csg", 20)] {
        let (mut curved, mut flat) = (0, 0);
        for_each_pixel(name, |at, of| {
            let Ok(side) = of("side") else {
                return;
            };
            let Ok(FieldValue::Numbers(gradient)) = of("gradient") else {
                flat += 1;
                return;
            };
            curved += 1;
            let normal = of("geometric_normal").expect("a normal");
            let to_viewer = if side == FieldValue::Word("front".to_owned()) {
                1.0
            } else {
                -1.0
            };
            let length = gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
            for (g, n) in gradient.iter().zip(normal.numbers()) {
                let off = g / length - to_viewer * n;
                assert!(off.abs() < 1e-9, "{name} {at:?}: {gradient:?} {normal:?}");
            }
        });
        assert!(curved >= least && flat > 0, "{name}: {curved} {flat}");
    }
}
