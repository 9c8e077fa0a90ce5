//! Reflection and refraction where they are hardest: critical and grazing angles, slabs, mirrors, endless bounces.

use raytree::accel::AccelKind;
use raytree::math::{DVec3, Rgb};
use raytree::probe::{Absence, Event, RayKind};
use raytree::scene::Settings;
use raytree::shading::optics::{Fresnel, reflect, refract};
use raytree::trace::{Outcome, PixelTrace, trace_pixel};
use raytree::tracer::draw;
use raytree::world::World;

use super::support::{Random, count, scene};

/// The direction that comes down to a floor at this angle from its normal.
fn down(angle: f64) -> DVec3 {
    DVec3::new(libm::sin(angle), -libm::cos(angle), 0.0)
}

/// The reflected share from index n1 into n2; 1 under total internal reflection.
fn share(incident: DVec3, n1: f64, n2: f64) -> f64 {
    refract(incident, DVec3::Y, n1, n2).map_or(1.0, |t| {
        assert!(t.is_finite() && (t.length() - 1.0).abs() < 1e-15);
        Fresnel::Exact.reflectance(-incident.y, -t.y, n1, n2)
    })
}

/// Source: case 62. Near the critical angle 1 - R = 2 (n + 1/n) sqrt(2 n cos(critical) d) / cos(critical) for an angle d
/// below it, from the first term of the series of Fresnel's equations.
#[test]
fn case_62_the_critical_angle_is_passed_without_a_jump() {
    for n in [1.000_001, 1.333, 1.5, 2.42, 1e3] {
        let critical = libm::asin(1.0 / n);
        let around = [critical.next_down(), critical, critical.next_up()];
        for angle in around {
            let r = share(down(angle), n, 1.0);
            assert!(r.is_finite() && r <= 1.0 + 1e-15);
            // sqrt of a few roundings of k, times the slope above.
            let slope = 2.0 * (n + 1.0 / n) / libm::cos(critical);
            assert!(1.0 - r <= slope * 1e-7, "n = {n}: {r}");
        }
        assert_eq!(share(down(critical + 1e-12 * n), n, 1.0), 1.0, "past it");
    }
    let (n, critical) = (1.5, libm::asin(1.0 / 1.5));
    let cos = libm::cos(critical);
    for d in [1e-8, 1e-10, 1e-12] {
        let expected = 2.0 * (n + 1.0 / n) * libm::sqrt(2.0 * n * cos * d) / cos;
        let found = 1.0 - share(down(critical - d), n, 1.0);
        // The angle itself is rounded: by 1e-16 of d.
        let tolerance = 1e-3 + 1e-16 / d;
        assert!((found / expected - 1.0).abs() < tolerance, "{d}: {found}");
    }
}

/// Source: case 64. At 89.9999999 degrees 1 - R is 1.0146954552407e-8 for index 1.5, with 50 digits from the formula.
#[test]
fn case_64_a_grazing_ray_is_almost_all_reflected() {
    let r = share(down(89.999_999_9f64.to_radians()), 1.0, 1.5);
    assert!(
        ((1.0 - r) / 1.014_695_455_240_7e-8 - 1.0).abs() < 1e-6,
        "{r}"
    );
    for tiny in [1e-12, 1e-15, f64::MIN_POSITIVE, 5e-324, 0.0] {
        let r = share(DVec3::new(1.0, -tiny, 0.0), 1.0, 1.5);
        assert!((1.0 - r).abs() < 1e-11, "{tiny}: {r}");
        assert_eq!(share(DVec3::new(1.0, -tiny, 0.0), 1.5, 1.0), 1.0);
    }
}

fn world(objects: &str, materials: &str, camera: &str, background: f64) -> World {
    let text = format!(
        r#"{{"format": "raytree-scene/1", "background": [{background}, {background}, {background}],
        "camera": {camera}, "materials": {{{materials}}}, "objects": [{objects}]}}"#
    );
    World::new(scene(&text), AccelKind::default())
}

const GLASS: &str = r#""glass": {"transmission": [1, 1, 1], "ior": 1.5}"#;

fn one_pixel(depth: u32, min_weight: f64) -> Settings {
    Settings::default().with(|s| {
        s.image.width = 1;
        s.image.height = 1;
        s.recursion.depth = depth;
        s.recursion.min_weight = min_weight;
    })
}

/// The rays of kind T, from the eye on: the straight way through.
fn straight(trace: &PixelTrace) -> Vec<u32> {
    let mut way = vec![0];
    while let Some(next) = trace.tree.children(way[way.len() - 1]).find(|c| {
        let kind = trace.tree.node(*c).ray.kind;
        kind == RayKind::Transmitted
    }) {
        way.push(next);
    }
    way
}

/// Source: case 63. Glass of the index of air is not there: no R ray, and the same picture, to rounding.
#[test]
fn case_63_a_boundary_between_equal_indices_is_not_seen() {
    let ball =
        r#"{"sphere": {"name": "ball", "material": "red", "center": [0, 0, -2], "radius": 1}}"#;
    let block = r#"{"box": {"name": "block", "material": "none", "min": [-1, -1, -0.5], "max": [0.8, 1, 0.5]}}"#;
    let materials = r#""red": {"ambient": [1, 0.2, 0.1], "mirror": [0.5, 0.5, 0.5]},
        "none": {"transmission": [1, 1, 1], "ior": 1}"#;
    let camera = r#"{"eye": [0.3, 0.4, 4], "look_at": [0, 0, 0], "vertical_fov": 50}"#;
    let ambient = |world: &mut World| world.scene.ambient = Rgb::WHITE;
    let [mut with, mut without] =
        [format!("{ball}, {block}"), ball.to_owned()].map(|o| world(&o, materials, camera, 0.3));
    ambient(&mut with);
    ambient(&mut without);
    let settings = Settings::default().with(|s| {
        s.image.width = 24;
        s.image.height = 24;
    });
    let film = |w| draw(w, &settings, 2);
    let (with, without) = (film(&with), film(&without));
    for (i, (a, b)) in with.pixels.iter().zip(&without.pixels).enumerate() {
        let off = (*a + *b * -1.0).channels().map(f64::abs);
        assert!(
            off.iter().all(|c| *c < 1e-13),
            "pixel {i}: {a:?}, not {b:?}"
        );
    }
    assert!(with.rays > without.rays);
}

/// Source: case 65. A ray leaves a slab as it came, shifted by d sin i (1 - cos i / sqrt(n^2 - sin^2 i)).
#[test]
fn case_65_a_slab_only_shifts_a_ray() {
    let slab = r#"{"box": {"name": "slab", "material": "glass", "min": [-1e3, -1, -1e3], "max": [1e3, 0, 1e3]}}"#;
    for angle in [1e-6, 0.1, 0.5, std::f64::consts::FRAC_PI_4, 1.2, 1.5] {
        let eye = -2.0 * down(angle);
        let camera = format!(
            r#"{{"eye": [{}, {}, 0], "look_at": [0, 0, 0], "vertical_fov": 1}}"#,
            eye.x, eye.y
        );
        let world = world(slab, GLASS, &camera, 1.0);
        let trace = trace_pixel(&world, &one_pixel(2, 0.0), (0, 0), false);
        let way = straight(&trace);
        assert_eq!(way.len(), 3, "in and out");
        let (first, last) = (trace.tree.node(way[0]).ray, trace.tree.node(way[2]).ray);
        let turned = (last.direction - first.direction).length();
        assert!(turned < 1e-15, "{angle}: turned by {turned:e}");
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let expected = sin * (1.0 - cos / libm::sqrt(2.25 - sin * sin));
        let shift = (last.origin - first.origin).cross(first.direction).length();
        assert!(
            (shift - expected).abs() < 4e-15,
            "{angle}: {shift}, not {expected}"
        );
    }
}

/// Source: case 68. Three mirrors at right angles send every ray back; how far off, the normals decide, which are unit and
/// at right angles to each other to a few roundings.
#[test]
fn case_68_a_corner_cube_sends_rays_back() {
    let mut random = Random(68);
    for round in 0..count(100_000, 10_000) {
        let axes = if round % 2 == 0 {
            [DVec3::X, DVec3::Y, DVec3::Z]
        } else {
            let u = random.direction();
            let aside = random.direction();
            // Twice, so that what is left of u is a rounding.
            let v = (0..2).fold(aside, |v, _| (v - v.dot(u) * u).normalize());
            [u, v, u.cross(v).normalize()]
        };
        let incident = random.direction();
        let out = axes.iter().fold(incident, |d, n| reflect(d, *n));
        let off = (out + incident).abs().max_element();
        let allowed = if round % 2 == 0 {
            0.0
        } else {
            8.0 * f64::EPSILON
        };
        assert!(off <= allowed, "{axes:?}, {incident}: {off:e}");
    }
}

/// Source: case 69. Two parallel mirrors that shine with 1 and reflect k: 1 + k + k^2 + ... k^depth.
#[test]
fn case_69_parallel_mirrors_make_a_geometric_series() {
    let wall = |name: &str, x: f64| {
        format!(
            r#"{{"plane": {{"name": "{name}", "material": "mirror", "point": [{x}, 0, 0], "normal": [{}, 0, 0]}}}}"#,
            -x
        )
    };
    let objects = format!("{}, {}", wall("left", -1.0), wall("right", 1.0));
    let camera = r#"{"eye": [0, 0, 0], "look_at": [1, 0.0001, 0], "vertical_fov": 1}"#;
    for k in [0.5, 0.99, 1.0] {
        let mirror = format!(r#""mirror": {{"emission": [1, 1, 1], "mirror": [{k}, {k}, {k}]}}"#);
        let world = world(&objects, &mirror, camera, 0.0);
        for depth in [0, 1, 64, 1000] {
            let trace = trace_pixel(&world, &one_pixel(depth, 0.0), (0, 0), false);
            assert_eq!(trace.pixel.rays, u64::from(depth) + 1);
            let expected: f64 = (0..=depth).rev().fold(0.0, |sum, _| 1.0 + k * sum);
            let [found, ..] = trace.pixel.color.channels();
            assert!(
                (found / expected - 1.0).abs() < 1e-13,
                "{k} {depth}: {found}"
            );
        }
    }
}

/// Source: case 70; pbrt-v3 issue 254. A white sky is seen through clear glass as through air: what is missing in a pixel
/// is what the rays would have brought that were left out as too weak, to the last roundings.
#[test]
fn case_70_clear_glass_in_a_white_sky_is_not_seen() {
    let shapes = [
        r#"{"box": {"name": "block", "material": "glass", "min": [-1, -1, -1], "max": [1, 1, 1]}}"#,
        r#"{"sphere": {"name": "ball", "material": "glass", "center": [0, 0, 0], "radius": 1}}"#,
    ];
    for shape in shapes {
        let camera = r#"{"eye": [2.2, 1.3, 2.9], "look_at": [0, 0, 0], "vertical_fov": 50}"#;
        let world = world(shape, GLASS, camera, 1.0);
        let size = count(64, 16) as u32;
        let settings = Settings::default().with(|s| {
            s.image.width = size;
            s.image.height = size;
            s.recursion.depth = 1000;
            s.recursion.min_weight = 1e-3;
        });
        let mut bent = 0;
        for (x, y) in (0..size).flat_map(|y| (0..size).map(move |x| (x, y))) {
            let trace = trace_pixel(&world, &settings, (x, y), false);
            let left_out = trace.tree.events.iter().map(|event| match event {
                Event::Absent {
                    reason: Absence::MinWeight { weight },
                    ..
                } => *weight,
                Event::Absent {
                    reason: Absence::DepthLimit,
                    ..
                } => panic!("the depth is enough"),
                _ => 0.0,
            });
            let left_out: f64 = left_out.sum();
            let [found, ..] = trace.pixel.color.channels();
            let misses = |node: &raytree::trace::Node| node.outcome == Some(Outcome::Miss);
            bent += usize::from(!misses(trace.tree.node(0)));
            assert!(left_out < 0.05, "({x}, {y}): {left_out}");
            assert!(
                (found + left_out - 1.0).abs() < 1e-13,
                "({x}, {y}): {found} + {left_out}"
            );
        }
        assert!(bent as u32 > size * size / 5, "{bent}");
    }
}
