//! Trees: whatever they are made of, they say what the list says, which has no tree to go wrong.

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Hit, Intersection, Shape, Sphere};
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::Silent;

use super::support::{Mesh, Random, all, bits, count, test, towards, triangle};

/// Shapes that trees find hard: points on a coarse grid, so that corners, edges and planes coincide; the same triangle
/// many times; needles; all of it far off.
fn adversarial(random: &mut Random) -> (Vec<Shape>, DVec3, f64) {
    let size = libm::pow(10.0, [-3.0, 0.0, 3.0][random.below(3)]);
    let offset = size * [0.0, 1.0, 1e3, 1e6][random.below(4)] * random.point();
    let steps = [2.0, 4.0, 1e6][random.below(3)];
    let needle = [1.0, 1e-8][random.below(2)];
    let mut shapes = Vec::new();
    for _ in 0..=random.below(60) {
        let mut corner = || {
            let p = (steps * random.point()).round() / steps;
            offset + size * DVec3::new(p.x, p.y * needle, p.z)
        };
        let shape = triangle([corner(), corner(), corner()]);
        for _ in 0..[1, 1, 1, 9][random.below(4)] {
            shapes.push(shape.clone());
        }
    }
    for _ in 0..random.below(8) {
        shapes.push(Shape::Sphere(Sphere {
            center: offset + size * (2.0 * random.point()).round() / 2.0,
            radius: size * (0.01 + 0.5 * random.share()),
        }));
    }
    (shapes, offset, size)
}

/// Along an axis, in planes where trees split, or anyhow.
fn any_ray(random: &mut Random, offset: DVec3, size: f64) -> Ray {
    let on_grid = random.below(2) == 0;
    let place = |v: DVec3| if on_grid { (2.0 * v).round() / 2.0 } else { v };
    let origin = offset + size * place(2.0 * random.point());
    let direction = match random.below(3) {
        0 => DVec3::AXES[random.below(3)] * [1.0, -1.0][random.below(2)],
        1 => place(random.point()).normalize_or(DVec3::Z),
        _ => random.direction(),
    };
    Ray::new(origin, direction)
}

#[test]
fn case_17_every_tree_finds_what_the_list_finds() {
    let mut random = Random(17);
    let (scenes, rays) = (count(200, 40), count(500, 100));
    let mut met = 0;
    for scene in 0..scenes {
        let (shapes, offset, size) = adversarial(&mut random);
        let accels = all(&shapes);
        for _ in 0..rays {
            let ray = any_ray(&mut random, offset, size);
            let answers = accels.iter().map(|(kind, accel)| {
                let closest = accel.closest(&shapes, &ray, Interval::FORWARD, &mut Silent);
                let crossings = accel.all_hits(&shapes, &ray, Interval::FORWARD);
                let crossings: Vec<_> = crossings.iter().map(bits).collect();
                (kind, closest.as_ref().map(bits), crossings)
            });
            let answers: Vec<_> = answers.collect();
            let (_, closest, crossings) = &answers[0];
            assert_eq!(
                closest.as_ref(),
                crossings.first(),
                "scene {scene}: {ray:?}"
            );
            for (kind, other, others) in &answers {
                assert_eq!(other, closest, "{kind:?}, scene {scene}: {ray:?}");
                assert_eq!(others, crossings, "{kind:?}, scene {scene}: {ray:?}");
            }
            met += usize::from(closest.is_some());
        }
    }
    println!("{scenes} scenes, {} rays, {met} hits", scenes * rays);
    assert!(met > scenes * rays / 20, "{met}");
}

/// Any ray, any tree: what the list says.
fn as_the_list(name: &str, shapes: &[Shape], rays: impl Iterator<Item = Ray>) -> usize {
    let accels = all(shapes);
    let mut met = 0;
    for ray in rays {
        let closest = |accel: &Accel| accel.closest(shapes, &ray, Interval::FORWARD, &mut Silent);
        let expected = closest(&accels[0].1);
        met += usize::from(expected.is_some());
        for (kind, accel) in &accels {
            let found = closest(accel);
            assert_eq!(found, expected, "{name}, {kind:?}: {ray:?}");
        }
    }
    met
}

/// Source: case 14. Expected: building ends with memory in proportion, and of many equal triangles the first is hit.
#[test]
fn case_14_a_triangle_many_times() {
    let n = count(100_000, 1_000);
    let corners = [
        DVec3::ZERO,
        DVec3::new(3.0, 0.1, 0.2),
        DVec3::new(0.3, 2.0, 1.0),
    ];
    let shapes = vec![triangle(corners); n];
    let target = (corners[0] + corners[1] + corners[2]) / 3.0;
    let ray = Ray::new(DVec3::Z * 9.0, (target - DVec3::Z * 9.0).normalize());
    for (kind, accel) in all(&shapes) {
        let hit = accel.closest(&shapes, &ray, Interval::FORWARD, &mut Silent);
        assert_eq!(hit.map(|hit| hit.primitive), Some(0), "{kind:?}");
        let stats = accel.stats();
        assert!(stats.bytes <= 400 * n, "{kind:?}: {stats:?}");
        assert!(stats.references <= 8 * n, "{kind:?}: {stats:?}");
    }
}

/// Polygons on a grid in a plane that is not along the axes, whose points are on it exactly: 2x + y + 4z = 0.
fn slanted(random: &mut Random) -> Shape {
    let mut corner = || {
        let [x, z] = [0; 2].map(|_| (64.0 * random.unit()).round() / 16.0);
        DVec3::new(x, -2.0 * x - 4.0 * z, z)
    };
    triangle([corner(), corner(), corner()])
}

/// Source: case 15. Expected: of polygons that overlap in one plane every tree, and every number of rays at once, finds the same,
/// from everywhere. Which one that is, rounding decides: what t is of each of them differs by it and by no more, so the
/// smaller number does not always win, but what does is as near as any can be told to be.
#[test]
fn case_15_polygons_that_overlap_in_one_plane() {
    let mut random = Random(15);
    let (mut met, mut overlaps, mut later, mut most) = (0, 0, 0, 0.0f64);
    for _ in 0..count(100, 10) {
        let shapes: Vec<Shape> = (0..12).map(|_| slanted(&mut random)).collect();
        for eye in [
            DVec3::new(3.0, 9.0, 20.0),
            DVec3::new(-20.0, 3.0, 1.0),
            DVec3::splat(-7.0),
        ] {
            let rays: Vec<Ray> = (0..count(500, 200))
                .filter_map(|_| {
                    let [x, z] = [0; 2].map(|_| 4.0 * random.unit());
                    towards(eye, DVec3::new(x, -2.0 * x - 4.0 * z, z))
                })
                .collect();
            for ray in &rays {
                let found: Vec<f64> = shapes
                    .iter()
                    .filter_map(|shape| match test(shape, ray) {
                        Intersection::Hit { t, .. } => Some(t),
                        _ => None,
                    })
                    .collect();
                let nearest = found.iter().copied().fold(f64::INFINITY, f64::min);
                for t in &found {
                    most = most.max((t - nearest) / nearest);
                }
                overlaps += usize::from(found.len() > 1);
                later += usize::from(found.first().is_some_and(|t| *t > nearest));
            }
            met += as_the_list("slanted", &shapes, rays.iter().copied());
            let accels = all(&shapes);
            let asked: Vec<_> = rays.iter().map(|ray| (*ray, Interval::FORWARD)).collect();
            let together = |accel: &Accel| {
                let mut hits = vec![None; asked.len()];
                accel.closest_many(&shapes, &asked, &mut hits);
                hits
            };
            let expected = together(&accels[0].1);
            for (kind, accel) in &accels {
                assert_eq!(together(accel), expected, "{kind:?}");
            }
        }
    }
    println!("{met} hits, {overlaps} of several, {later} not of the first; t apart by {most:e}");
    assert!(met > 1000 && overlaps > met / 4, "{met} {overlaps}");
    // A few roundings of coordinates up to 30, seen at a slant.
    assert!(most < 1e-13, "{most:e}");
}

/// Source: case 16. Expected: whatever the corners are, building and searching end, and all say the same.
#[test]
fn case_16_a_mesh_of_random_bits() {
    let mut random = Random(16);
    for _ in 0..count(1000, 60) {
        let mut number = || loop {
            // The bits of any number that a file may hold.
            let x = match random.below(3) {
                0 => f64::from_bits(random.bits()),
                1 => f64::from(f32::from_bits(random.bits() as u32)),
                _ => random.unit(),
            };
            if x.abs() <= 1e12 {
                return x;
            }
        };
        let mut corner = || DVec3::new(number(), number(), number());
        let shapes: Vec<Shape> = (0..20)
            .map(|_| triangle([corner(), corner(), corner()]))
            .collect();
        let rays: Vec<Ray> = (0..20)
            .filter_map(|_| towards(corner(), corner()))
            .collect();
        as_the_list("random bits", &shapes, rays.into_iter());
    }
}

/// Source: case 18. Expected: the order in which triangles are given changes nothing but their numbers.
#[test]
fn case_18_permuted_triangles_are_hit_alike() {
    let mut random = Random(18);
    let shapes = Mesh::globe(12, 24, 0.2).shapes();
    let mut order: Vec<usize> = (0..shapes.len()).collect();
    for i in (1..order.len()).rev() {
        order.swap(i, random.below(i + 1));
    }
    let permuted: Vec<Shape> = order.iter().map(|i| shapes[*i].clone()).collect();
    for ((kind, accel), (_, other)) in all(&shapes).iter().zip(all(&permuted)) {
        for _ in 0..count(10_000, 500) {
            let Some(ray) = towards(3.0 * random.direction(), random.point()) else {
                continue;
            };
            let a = accel.closest(&shapes, &ray, Interval::FORWARD, &mut Silent);
            let b = other.closest(&permuted, &ray, Interval::FORWARD, &mut Silent);
            let b = b.map(|hit| Hit {
                primitive: order[hit.primitive as usize] as u32,
                ..hit
            });
            assert_eq!(
                a.as_ref().map(bits),
                b.as_ref().map(bits),
                "{kind:?}: {ray:?}"
            );
        }
    }
}

/// Source: case 35. Expected: rays at an edge are caught, though a plane cuts only one of its two triangles.
#[test]
fn case_35_an_edge_that_is_cut_on_one_side() {
    let mut random = Random(35);
    let mut met = 0;
    let rays = count(500, 100);
    for _ in 0..count(200, 20) {
        let (a, b) = (random.point(), random.point());
        let left = [a, b, random.point()];
        // The other triangle, and triangles whose planes run through points of the edge.
        let mut shapes = vec![triangle(left), triangle([b, a, random.point()])];
        for _ in 0..6 {
            let m = a.lerp(b, random.share());
            shapes.push(triangle([m, random.point(), random.point()]));
        }
        let at_the_edge: Vec<Ray> = (0..rays)
            .filter_map(|_| towards(3.0 * random.direction(), a.lerp(b, random.share())))
            .collect();
        met += as_the_list("edge", &shapes, at_the_edge.into_iter());
    }
    assert!(met > rays, "{met}");
}

/// Source: cases 36 and 38. Expected: what only touches a polygon's plane, or lies in it, is not cut by it.
#[test]
fn case_36_38_what_touches_a_plane_is_not_cut() {
    let p = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let wall = [p(0.0, -9.0, -9.0), p(0.0, 9.0, -9.0), p(0.0, 0.0, 9.0)];
    let corner = [p(0.0, 0.0, 0.0), p(1.0, 0.3, 0.1), p(1.0, -0.2, 0.4)];
    let edge = [p(0.0, 1.0, 0.0), p(0.0, 2.0, 0.0), p(-1.0, 1.5, 0.3)];
    let shapes = [wall, corner, edge].map(triangle);
    let tree = Accel::build(AccelKind::BspPolygon, &shapes);
    assert_eq!(tree.stats().references, 3, "{:?}", tree.stats());

    let mut random = Random(38);
    let flat: Vec<Shape> = (0..count(10_000, 2_000))
        .map(|_| {
            let mut corner = || p(9.0 * random.unit(), 0.0, 9.0 * random.unit());
            triangle([corner(), corner(), corner()])
        })
        .collect();
    let stats = Accel::build(AccelKind::BspPolygon, &flat).stats();
    assert_eq!(
        (stats.depth, stats.references),
        (1, flat.len()),
        "{stats:?}"
    );
}

/// Source: case 37. Expected: what reaches over a polygon's plane by less than rounding can tell is not cut by it: not one
/// polygon, and not thousands.
#[test]
fn case_37_what_reaches_over_a_plane_by_a_float_is_not_cut() {
    let p = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let wall = [p(1.0, -9.0, -9.0), p(1.0, 9.0, -9.0), p(1.0, 0.0, 9.0)];
    let mut random = Random(37);
    for over in [1.0_f64.next_up(), 1.0_f64.next_down()] {
        let beyond = if over > 1.0 { -1.0 } else { 3.0 };
        let mut shapes = vec![triangle(wall)];
        for _ in 0..count(3_000, 500) {
            let mut at = |x: f64| p(x, 8.0 * random.unit(), 8.0 * random.unit());
            shapes.push(triangle([at(over), at(1.0), at(beyond)]));
        }
        // The wall's plane alone parts these, and cuts none of them.
        let near = |z: f64| triangle([p(over, 0.0, z), p(1.0, 1.0, z), p(beyond, 0.0, z)]);
        let few = [triangle(wall), near(0.0), near(1.0)];
        let stats = Accel::build(AccelKind::BspPolygon, &few).stats();
        assert_eq!(stats.references, 3, "{over}: {stats:?}");
        // What planes cut otherwise is bounded for all.
        for (kind, accel) in all(&shapes) {
            let stats = accel.stats();
            assert!(stats.references <= 8 * shapes.len(), "{kind:?}: {stats:?}");
        }
        let rays = (0..count(500, 100)).filter_map(|_| {
            let to = p(1.0, 8.0 * random.unit(), 8.0 * random.unit());
            towards(p(20.0 * random.unit(), 0.0, 0.0), to)
        });
        assert!(as_the_list("over", &shapes, rays) > 50);
    }
}

/// Source: cases 40 and 41. Expected: rays in the planes that split, from points on them, and from points on polygons find what
/// the list finds.
#[test]
fn case_40_41_rays_in_and_from_the_planes_that_split() {
    let mut random = Random(40);
    let mut met = 0;
    for _ in 0..count(100, 10) {
        let shapes: Vec<Shape> = (0..30)
            .map(|_| {
                let mut corner = || (4.0 * random.point()).round() / 4.0;
                triangle([corner(), corner(), corner()])
            })
            .collect();
        let tree = Accel::build(AccelKind::BspPolygon, &shapes);
        let planes: Vec<_> = (0..200).filter_map(|id| tree.plane(id)).collect();
        let mut rays = Vec::new();
        for (n, d) in planes {
            let on = |p: DVec3| p - (n.dot(p) - d) * n;
            let (from, to) = (on(2.0 * random.point()), on(random.point()));
            rays.extend(towards(from, to));
            rays.push(Ray::new(from, random.direction()));
        }
        for shape in &shapes {
            if let Shape::Triangle(t) = shape {
                let [a, b, c] = t.corners;
                rays.push(Ray::new((a + b + c) / 3.0, random.direction()));
                rays.extend(towards(a, b.lerp(c, random.share())));
            }
        }
        met += as_the_list("planes", &shapes, rays.into_iter());
    }
    assert!(met > 500, "{met}");
}

/// Source: case 42. Expected: a scene that is moved by 1e9 and turned by 1e-12 shows the same shapes, in 99.99 % of rays.
#[test]
fn case_42_a_scene_moved_far_away_shows_the_same() {
    let mut random = Random(42);
    let corners: Vec<[DVec3; 3]> = (0..300)
        .map(|_| {
            let middle = 5.0 * random.point();
            [0; 3].map(|_| middle + random.point())
        })
        .collect();
    let turn = |p: DVec3| DVec3::new(p.x - 1e-12 * p.y, p.y + 1e-12 * p.x, p.z);
    let offset = 1e9 * DVec3::new(1.0, -1.0, 0.5);
    let here: Vec<Shape> = corners.iter().map(|c| triangle(*c)).collect();
    let there: Vec<Shape> = corners
        .iter()
        .map(|c| triangle(c.map(|p| offset + turn(p))))
        .collect();
    let (near, far) = (
        Accel::build(AccelKind::BspPolygon, &here),
        Accel::build(AccelKind::BspPolygon, &there),
    );
    let (mut met, mut other) = (0, 0);
    for _ in 0..count(1_000_000, 20_000) {
        let Some(ray) = towards(10.0 * random.direction(), 4.0 * random.point()) else {
            continue;
        };
        let moved = Ray::new(offset + turn(ray.origin), ray.direction);
        let id = |accel: &Accel, shapes: &[Shape], ray: &Ray| {
            let hit = accel.closest(shapes, ray, Interval::FORWARD, &mut Silent);
            hit.map(|hit| hit.primitive)
        };
        let (a, b) = (id(&near, &here, &ray), id(&far, &there, &moved));
        met += usize::from(a.is_some());
        other += usize::from(a != b);
    }
    println!("{met} hits, {other} of them another shape");
    assert!(met > 5_000 && other * 10_000 <= met, "{other} of {met}");
}
