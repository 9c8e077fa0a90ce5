//! Shadow rays at the very surface that sends them, and lights in impossible places.

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Aabb, Arithmetic, Cuboid, Offset, Shape, Sphere};
use raytree::math::{DVec3, Interval, Ray, Rgb};
use raytree::probe::Silent;
use raytree::scene::Settings;
use raytree::shading::Interaction;
use raytree::trace::trace_pixel;
use raytree::tracer::draw;
use raytree::world::World;

use super::support::{Mesh, Random, count, scene};

/// Where a ray arrives on flat-shaded shapes.
fn arrival(accel: &Accel, shapes: &[Shape], ray: &Ray) -> Option<Interaction> {
    let hit = accel.closest(shapes, ray, Interval::FORWARD, &mut Silent)?;
    let surface = shapes[hit.primitive as usize].surface(ray, hit.t, hit.place, hit.part);
    Some(Interaction::new(&surface, ray.direction, None))
}

/// Source: case 49. Expected: a convex solid never stands in the way of its own surface.
#[test]
fn case_49_a_convex_solid_does_not_shadow_itself() {
    let mut random = Random(49);
    let mut sent = 0;
    for offset in [0.0, 1e3, 1e6, 1e9] {
        let middle = offset * DVec3::new(1.0, -0.7, 0.3);
        let solids = [
            vec![Shape::Sphere(Sphere {
                center: middle,
                radius: 1.5,
            })],
            vec![Shape::Cuboid(Cuboid {
                bounds: Aabb {
                    min: middle - DVec3::new(1.0, 0.4, 1.3),
                    max: middle + DVec3::new(1.0, 0.4, 1.3),
                },
            })],
            Mesh::globe(1, 4, 0.0).moved(|p| middle + p).shapes(),
        ];
        for shapes in solids {
            let accel = Accel::build(AccelKind::Bsp, &shapes);
            for _ in 0..count(100_000, 4_000) {
                let origin = middle + 5.0 * random.direction();
                let target = middle + 0.9 * random.point();
                let ray = Ray::new(origin, (target - origin).normalize());
                let Some(at) = arrival(&accel, &shapes, &ray) else {
                    continue;
                };
                let direction = random.direction();
                if direction.dot(at.geometric_normal) <= 0.0 {
                    continue;
                }
                sent += 1;
                let shadow = Ray::new(at.origin_towards(direction), direction);
                let blocker = accel.any_hit(&shapes, &shadow, Interval::FORWARD, &mut Silent);
                assert_eq!(blocker, None, "{offset}: {at:?}, {shadow:?}");
            }
        }
    }
    assert!(sent > count(300_000, 12_000), "{sent}");
}

/// Source: case 50. Expected, on paper: the eye sees the film of light e, lit by the sun (k n.l); through it, 1e-9 below, a mirror that
/// lies in the film's shadow; in the mirror the film's other side, e again; and through that the sky. A film that shadows
/// itself, or a mirror that loses the film, has other pixels: as with a fixed offset, which starts the rays behind the film.
#[test]
fn case_50_a_picture_of_plates_a_billionth_apart() {
    let (e, k, sky) = (0.25, 0.5, 0.125);
    let mut random = Random(50);
    for i in 0..count(40, 8) {
        let middle = [0.0, 1e3][i % 2] * random.direction();
        let n = random.direction();
        let (u, v) = n.any_orthonormal_pair();
        let slanted = |random: &mut Random| {
            (n + 0.5 * random.unit() * u + 0.5 * random.unit() * v).normalize()
        };
        let (eye, sun) = (slanted(&mut random), slanted(&mut random));
        let plate = |height: f64| {
            let corners = [[-50.0, -50.0], [50.0, -50.0], [0.0, 90.0]];
            corners.map(|[x, y]| (middle + height * n + x * u + y * v).to_array())
        };
        let text = format!(
            r#"{{"format": "raytree-scene/1", "background": [{sky}, {sky}, {sky}],
            "camera": {{"eye": {:?}, "look_at": {:?}, "vertical_fov": 40}},
            "materials": {{
                "film": {{"emission": [{e}, {e}, {e}], "diffuse": [{k}, {k}, {k}], "transmission": [1, 1, 1], "ior": 1}},
                "mirror": {{"mirror": [1, 1, 1], "diffuse": [{k}, {k}, {k}]}}}},
            "lights": [{{"directional": {{"name": "sun", "direction": {:?}, "intensity": [1, 1, 1]}}}}],
            "objects": [{{"triangle": {{"name": "film", "material": "film", "corners": {:?}}}}},
                {{"triangle": {{"name": "mirror", "material": "mirror", "corners": {:?}}}}}]}}"#,
            (middle + 3.0 * eye).to_array(),
            middle.to_array(),
            (-sun).to_array(),
            plate(1e-9),
            plate(0.0)
        );
        let [film, ..] = plate(1e-9).map(DVec3::from);
        let [.., b, c] = plate(1e-9).map(DVec3::from);
        let lit = (b - film).cross(c - film).normalize().dot(sun.normalize());
        let expected = 2.0 * e + k * lit + sky;
        let picture = |kind: AccelKind, offset: Offset| {
            let arithmetic = Arithmetic {
                offset,
                ..Arithmetic::default()
            };
            let world = World::new(scene(&text).computed_with(arithmetic), kind);
            let settings = Settings::default().with(|s| {
                s.image.width = 16;
                s.image.height = 16;
                s.accel = kind;
                s.arithmetic = arithmetic;
            });
            let film = draw(&world, &settings, 1);
            film.pixels
        };
        let off = |color: &Rgb| (color.channels()[0] - expected).abs();
        for kind in AccelKind::ALL {
            for color in picture(kind, Offset::Bounded) {
                assert!(
                    off(&color) < 1e-12,
                    "{kind:?}: {color:?} is not {expected}: {text}"
                );
            }
        }
        let wrong = picture(AccelKind::List, Offset::Fixed(1e-6));
        assert!(wrong.iter().all(|color| off(color) > 0.1), "{wrong:?}");
    }
}

fn world(eye: [f64; 3], look_at: [f64; 3], light: [f64; 3], objects: &str) -> World {
    let text = format!(
        r#"{{"format": "raytree-scene/1",
        "camera": {{"eye": {eye:?}, "look_at": {look_at:?}, "vertical_fov": 60}},
        "materials": {{"chalk": {{"diffuse": [0.5, 0.5, 0.5], "specular": [0.2, 0.2, 0.2]}}}},
        "lights": [{{"point": {{"name": "lamp", "position": {light:?}, "intensity": [1, 1, 1], "attenuation": [0, 0, 1]}}}}],
        "objects": [{objects}]}}"#
    );
    World::new(scene(&text), AccelKind::default())
}

fn pixels(world: &World, size: u32) -> Vec<Rgb> {
    let settings = Settings::default().with(|s| {
        s.image.width = size;
        s.image.height = size;
    });
    let pixel = |i: u32| trace_pixel(world, &settings, (i % size, i / size), false);
    (0..size * size).map(|i| pixel(i).pixel.color).collect()
}

/// Source: case 51. Expected: a light on the surface, and at the very point that is shaded, where its distance is 0 and its
/// strength without bound, makes no pixel that is not a number.
#[test]
fn case_51_a_light_on_the_surface_makes_no_nan() {
    let floor = r#"{"plane": {"name": "floor", "material": "chalk", "point": [0, 0, 0], "normal": [0, 1, 0]}}"#;
    for light in [
        [0.0, 0.0, 0.0],
        [0.0, 1e-300, 0.0],
        [0.0, -1e-300, 0.0],
        [0.0, 5e-324, 0.0],
    ] {
        // The middle of the picture is the light itself.
        let world = world([0.0, 2.0, 2.0], [0.0; 3], light, floor);
        for color in pixels(&world, 9) {
            assert!(
                color.channels().iter().all(|c| c.is_finite() && *c >= 0.0),
                "{color:?}"
            );
        }
    }
}

/// Source: case 52. Expected: a light inside a sphere lights nothing outside of it; on its centre it lights the inside evenly,
/// Kd I / r^2 and, where R points to the eye, a highlight.
#[test]
fn case_52_a_light_inside_a_sphere_stays_inside() {
    for r in [1.0, 1e-3, 1e6] {
        let ball = format!(
            r#"{{"sphere": {{"name": "ball", "material": "chalk", "center": [0, 0, 0], "radius": {r}}}}}"#
        );
        let outside = world([0.0, 0.5 * r, 3.0 * r], [0.0; 3], [0.0; 3], &ball);
        assert!(pixels(&outside, 12).iter().all(|c| c.is_black()));
        let inside = world([0.0, 0.1 * r, 0.5 * r], [0.0; 3], [0.0; 3], &ball);
        for color in pixels(&inside, 12) {
            let [lit, ..] = color.channels().map(|c| c * r * r);
            assert!((0.5 - 1e-12..=0.7 + 1e-12).contains(&lit), "{lit}");
        }
    }
}

/// Source: case 60; Hanika 2021, "Hacking the shadow terminator". A smooth-shaded globe of few triangles is dark where the
/// light is behind the triangle, though the blended normal still sees it. What is lost is bounded by how far the normal is
/// bent: no more than the sine of the angle between the two normals. What is lit has exactly the light of a true ball.
#[test]
fn case_60_the_terminator_loses_no_more_than_normals_are_bent() {
    let Mesh { points, faces } = Mesh::globe(7, 12, 0.0);
    let points: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
    let globe = format!(
        r#"{{"mesh": {{"name": "globe", "material": "chalk", "vertices": {points:?}, "normals": {points:?}, "triangles": {faces:?}}}}}"#
    );
    let size = count(128, 24) as u32;
    let text = format!(
        r#"{{"format": "raytree-scene/1",
        "camera": {{"eye": [0, 0, 4], "look_at": [0, 0, 0], "vertical_fov": 32}},
        "materials": {{"chalk": {{"diffuse": [1, 1, 1]}}}},
        "lights": [{{"directional": {{"name": "sun", "direction": [-1, -0.2, 0.1], "intensity": [1, 1, 1]}}}}],
        "objects": [{globe}]}}"#
    );
    let world = World::new(scene(&text), AccelKind::default());
    let to_light = DVec3::new(1.0, 0.2, -0.1).normalize();
    let settings = Settings::default().with(|s| {
        s.image.width = size;
        s.image.height = size;
    });
    let (mut lit, mut lost, mut most) = (0, 0, 0.0f64);
    for (x, y) in (0..size).flat_map(|y| (0..size).map(move |x| (x, y))) {
        let ray = world
            .scene
            .camera
            .ray([f64::from(x) + 0.5, f64::from(y) + 0.5], (size, size));
        let Some(hit) = world.closest(&ray, 0.0, &mut Silent) else {
            continue;
        };
        let at = world.scene.interaction(&ray, &hit);
        let true_light = at.normal.dot(to_light).max(0.0);
        let color = trace_pixel(&world, &settings, (x, y), false).pixel.color;
        let [found, ..] = color.channels();
        if found > 0.0 {
            assert!((found - true_light).abs() < 1e-15, "({x}, {y})");
            lit += 1;
        } else {
            let bent = at.normal.cross(at.geometric_normal).length();
            assert!(
                true_light <= bent + 1e-15,
                "({x}, {y}): {true_light}, {bent}"
            );
            lost += usize::from(true_light > 0.0);
            most = most.max(true_light);
        }
    }
    println!("{lit} lit, {lost} lost at the terminator, at most {most:.3} of the light");
    assert!(lit > 50 && lost > 0, "{lit} {lost}");
}
