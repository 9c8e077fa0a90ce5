//! Laws that hold for all trees and rays.

use super::*;
use crate::geometry::test_rays::many;
use crate::math::rounding::offset_origin;

/// A leaf near the origin: a ball, a box, a turned and stretched one of both, or a tetrahedron.
fn random_leaf(random: &mut TestRays) -> CsgTree {
    let (at, size) = (random.vector(), 0.2 + random.unit());
    let half = DVec3::splat(0.2) + random.vector().abs();
    let (center, turn) = (random.vector() * 0.1, random.direction());
    let map = DAffine3::from_translation(at)
        * DAffine3::from_axis_angle(turn, 3.0 * random.unit())
        * DAffine3::from_scale(half);
    match random.below(6) {
        0 | 1 => ball(at, size),
        2 => cube(at - half, at + half),
        3 => placed(ball_shape(center, 1.0), map),
        4 => placed(cube_shape(DVec3::NEG_ONE, DVec3::ONE), map),
        _ => {
            let corners =
                [-DVec3::ONE, DVec3::X, DVec3::Y, DVec3::Z].map(|p| map.transform_point3(p));
            let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
            let solid = Polyhedron::new(&corners, &faces).expect("convex");
            CsgTree::Leaf(Solid::Polyhedron(Box::new(solid)))
        }
    }
}

/// A tree up to `depth` operations deep.
fn random_tree(random: &mut TestRays, depth: usize) -> CsgTree {
    if depth == 0 || random.below(4) == 0 {
        return random_leaf(random);
    }
    let word = [Union, Common, Difference][random.below(3)];
    let count = 2 + random.below(2);
    let mut parts: Vec<CsgTree> = (0..count).map(|_| random_tree(random, depth - 1)).collect();
    // What has no end may cut what has one.
    if word != Union && random.below(3) == 0 {
        parts.push(behind(0.5 * random.vector(), random.direction()));
    }
    CsgTree::Op(word, parts)
}

/// A ray from around the solid towards it, its direction of any length.
fn random_ray(random: &mut TestRays) -> Ray {
    let far = [0.5, 4.0, 4.0, 1000.0][random.below(4)];
    let origin = random.direction() * far * random.unit();
    let target = random.vector();
    Ray::new(origin, (target - origin) * (0.01 + random.unit()))
}

fn membership(solid: &Csg, at: DVec3) -> u64 {
    let inside = |leaf: &Solid| {
        // A line in a direction of its own: whether t = 0 lies in one of its spans.
        let spans = leaf.spans(&Ray::new(at, DVec3::new(0.36, 0.48, 0.8)));
        spans
            .0
            .iter()
            .any(|span| span.enter.t < 0.0 && 0.0 < span.leave.t)
    };
    (0..)
        .zip(solid.leaves())
        .fold(0, |set, (i, leaf)| set | u64::from(inside(leaf)) << i)
}

/// Between crossings the point in the middle is inside or outside as the spans say. `cases` trees, 10 rays each.
fn check_membership(cases: u32) {
    let mut random = TestRays(17);
    for _ in 0..cases {
        let solid = csg(random_tree(&mut random, 3));
        for _ in 0..10 {
            let ray = random_ray(&mut random);
            let found = crossings(&solid, &ray);
            assert!(found.is_sorted_by(|a, b| a < b), "{found:?}");
            assert_eq!(found.len() % 2, 0);
            for (i, pair) in found.windows(2).enumerate() {
                let middle = ray.at(0.5 * (pair[0] + pair[1]));
                // Of a thin film the middle is not known well enough.
                if (pair[1] - pair[0]) * ray.direction.length() < 1e-9 {
                    continue;
                }
                let is_inside = solid.is_inside(membership(&solid, middle));
                assert_eq!(is_inside, i % 2 == 0, "{solid:?} {ray:?} {found:?}");
            }
        }
    }
}

#[test]
fn between_crossings_membership_is_constant() {
    check_membership(many(300));
}

#[test]
fn the_laws_of_sets_hold_to_the_bit() {
    let mut random = TestRays(23);
    for _ in 0..300 {
        let [a, b, c] = [(); 3].map(|()| random_tree(&mut random, 1));
        let part = |tree: &CsgTree| tree.clone();
        let word = |word, parts: [&CsgTree; 2]| op(word, parts.map(part));
        let rest = |second: &CsgTree| op(Difference, [c.clone(), second.clone()]);
        // De Morgan within C: C - (A u B) = (C - A) n (C - B), C - (A n B) = (C - A) u (C - B).
        let morgan = [
            [
                rest(&word(Union, [&a, &b])),
                op(Common, [rest(&a), rest(&b)]),
            ],
            [
                rest(&word(Common, [&a, &b])),
                op(Union, [rest(&a), rest(&b)]),
            ],
        ];
        let pairs = morgan.map(|pair| pair.map(csg));
        let alone = csg(a.clone());
        let same = [csg(word(Union, [&a, &a])), csg(word(Common, [&a, &a]))];
        let nothing = csg(word(Difference, [&a, &a]));
        for _ in 0..10 {
            let ray = random_ray(&mut random);
            assert_eq!(crossings(&nothing, &ray), [0.0; 0]);
            for twice in &same {
                assert_eq!(crossings(twice, &ray), crossings(&alone, &ray));
            }
            for [left, right] in &pairs {
                assert_eq!(crossings(left, &ray), crossings(right, &ray));
            }
        }
    }
}

#[test]
fn a_leaf_alone_is_the_shape_itself() {
    let mut random = TestRays(29);
    for _ in 0..300 {
        let tree = random_leaf(&mut random);
        let CsgTree::Leaf(Solid::Shape(shape)) = &tree else {
            continue;
        };
        let solid = csg(tree.clone());
        for _ in 0..10 {
            let ray = random_ray(&mut random);
            let of_whole = |(mut cut, enters): (Cut, bool)| {
                cut.part = Csg::part(0, cut.part);
                (cut, enters)
            };
            let expected = shape.spans(&ray).expect("a solid");
            let expected: Vec<_> = expected.cuts().map(of_whole).collect();
            assert_eq!(solid.spans(&ray).cuts().collect::<Vec<_>>(), expected);
        }
    }
}

#[test]
fn hits_normals_and_cuts_agree_with_the_spans() {
    let mut random = TestRays(31);
    for _ in 0..500 {
        let solid = csg(random_tree(&mut random, 3));
        for _ in 0..5 {
            let ray = random_ray(&mut random);
            let spans = solid.spans(&ray);
            let told = solid.cuts(&ray);
            let counted: Vec<f64> = told
                .cuts
                .iter()
                .filter(|cut| cut.counts)
                .map(|cut| cut.t)
                .collect();
            assert_eq!(counted, crossings(&solid, &ray));
            assert_eq!(
                solid.intersect(&ray, Interval::FORWARD),
                spans.first(Interval::FORWARD)
            );
            for (cut, enters) in spans.cuts() {
                let surface = solid.surface(&ray, cut.t, cut.part);
                assert_eq!(surface.normal.dot(ray.direction) < 0.0, enters);
                assert_eq!(solid.enters(&ray, cut.t), Some(enters));
                let scale = ray.origin.length() + 4.0;
                assert!((surface.point - ray.at(cut.t)).length() < 1e-9 * scale);
                let inside = solid.bounds().padded(DVec3::splat(1e-13 * scale));
                assert!(
                    surface.point.cmpge(inside.min).all() && surface.point.cmple(inside.max).all()
                );
            }
        }
    }
}

/// Follows a ray that leaves the first hit of `ray` in this direction. It must start on the side that it goes to, for sure:
/// nothing is met again, nothing is missed, and inside glass it comes out as often as it went in. `None` if nothing is hit.
pub(super) fn departs(solid: &Csg, ray: &Ray, direction: DVec3) -> Option<()> {
    let Intersection::Hit { t, part, .. } = solid.intersect(ray, Interval::FORWARD) else {
        return None;
    };
    let surface = solid.surface(ray, t, part);
    // Along the surface rounding decides.
    if direction.dot(surface.normal).abs() < 1e-6 {
        return None;
    }
    let origin = offset_origin(surface.point, surface.error, surface.normal, direction);
    let spans = solid.spans(&Ray::new(origin, direction));
    let is_inside = spans
        .0
        .iter()
        .any(|span| span.enter.t <= 0.0 && 0.0 < span.leave.t);
    let goes_in = direction.dot(surface.normal) < 0.0;
    assert_eq!(
        is_inside, goes_in,
        "{solid:?}\n{ray:?}\n{surface:?}\n{direction:?} {spans:?}"
    );
    Some(())
}

/// Rays that leave hits of random trees, until so many were followed.
fn check_departures(cases: u32) {
    let mut random = TestRays(37);
    let mut followed = 0;
    while followed < cases {
        let solid = csg(random_tree(&mut random, 3));
        for _ in 0..20 {
            let ray = random_ray(&mut random);
            let direction = random.direction();
            followed += u32::from(departs(&solid, &ray, direction).is_some());
        }
    }
}

#[test]
fn rays_that_leave_a_hit_are_clear_of_it() {
    check_departures(many(3000));
}

/// A path through glass that turns anywhere at each surface: it goes in and out in turn, and never leaves the scene inside.
fn check_glass(paths: u32) -> u32 {
    let mut random = TestRays(67);
    let mut events = 0;
    for _ in 0..paths / 20 {
        let solid = csg(random_tree(&mut random, 3));
        for _ in 0..20 {
            let mut ray = random_ray(&mut random);
            ray.origin += 20.0 * random.direction();
            ray.direction = random.vector() - ray.origin;
            let mut is_inside = false;
            for _ in 0..12 {
                let Intersection::Hit { t, part, .. } = solid.intersect(&ray, Interval::FORWARD)
                else {
                    assert!(!is_inside, "lost inside of {solid:?}\n{ray:?}");
                    break;
                };
                events += 1;
                assert_eq!(
                    solid.enters(&ray, t),
                    Some(!is_inside),
                    "{solid:?}\n{ray:?}"
                );
                let surface = solid.surface(&ray, t, part);
                let direction = random.direction();
                is_inside = direction.dot(surface.normal) < 0.0;
                let origin = offset_origin(surface.point, surface.error, surface.normal, direction);
                ray = Ray::new(origin, direction);
            }
        }
    }
    events
}

#[test]
fn a_path_through_glass_ends_in_air() {
    assert!(check_glass(many(4000)) > many(2000));
}
