//! Solids and their twins, which are the same but for rounding.

use super::laws::departs;
use super::*;
use crate::geometry::test_rays::many;

/// The box from -1 to 1, moved, as a polyhedron.
fn box_as_mesh(map: DAffine3) -> CsgTree {
    let (min, max) = (DVec3::NEG_ONE, DVec3::ONE);
    let corners = Aabb { min, max }.corners().map(|p| map.transform_point3(p));
    let sides = Aabb::SIDES.map(|side| side.map(|corner| corner as u32));
    let halves = sides
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let solid = Polyhedron::new(&corners, &halves.collect::<Vec<_>>()).expect("convex");
    assert_eq!(solid.face_count(), 6);
    CsgTree::Leaf(Solid::Polyhedron(Box::new(solid)))
}

/// A solid and its twin, which is the same but for rounding: the ball and a unit ball that was moved and scaled, the box and one
/// with a matrix of its own, a polyhedron and its box.
fn twins(random: &mut TestRays) -> [CsgTree; 2] {
    let (at, size) = (random.vector() * 3.0, 0.1 + random.unit());
    let map = DAffine3::from_translation(at) * DAffine3::from_scale(DVec3::splat(size));
    let turn = DAffine3::from_axis_angle(random.direction(), 1.0);
    match random.below(4) {
        0 => [ball(at, size), placed(ball_shape([0.0; 3], 1.0), map)],
        1 => [
            ball(at, size),
            placed(ball_shape([0.0; 3], 1.0), map * turn),
        ],
        2 => {
            let unit = cube_shape(DVec3::NEG_ONE, DVec3::ONE);
            [placed(unit, map * turn), box_as_mesh(map * turn)]
        }
        _ => {
            let third = DAffine3::from_translation(at / 3.0);
            let [one, two] = [
                turn * map,
                turn * third * third * third * DAffine3::from_scale(DVec3::splat(size)),
            ];
            [one, two].map(|map| placed(cube_shape(DVec3::NEG_ONE, DVec3::ONE), map))
        }
    }
}

/// Rays that meet something where a solid is taken away from its twin, of all and of those that meet the solid.
fn twin_films(cases: u32) -> [u32; 2] {
    let mut random = TestRays(53);
    let mut counts = [0, 0];
    for _ in 0..cases {
        let [one, two] = twins(&mut random);
        let (alone, rest) = (csg(one.clone()), csg(op(Difference, [one, two])));
        let bounds = alone.bounds();
        for _ in 0..20 {
            let far = [2.0, 10.0, 1e3, 1e6][random.below(4)];
            let direction = random.direction();
            let target = bounds.center() + bounds.size() * random.vector() * 0.6;
            let ray = Ray::new(target - far * direction, direction * (0.1 + random.unit()));
            counts[0] += u32::from(!crossings(&alone, &ray).is_empty());
            counts[1] += u32::from(!crossings(&rest, &ray).is_empty());
        }
    }
    counts
}

#[test]
fn nothing_is_left_of_a_solid_without_its_twin() {
    let [met, films] = twin_films(many(500));
    assert!(met > 2000 && films == 0, "{films} of {met}");
}

/// Rays that leave a surface that a solid and its twin have in common, until so many were followed.
fn check_twins_are_left(cases: u32) {
    let mut random = TestRays(61);
    let mut followed = 0;
    while followed < cases {
        let [one, two] = twins(&mut random);
        let both = [Union, Common].map(|word| csg(op(word, [one.clone(), two.clone()])));
        let bounds = both[0].bounds();
        for solid in &both {
            for _ in 0..10 {
                let far = [2.0, 10.0, 1e3, 1e6][random.below(4)];
                let direction = random.direction();
                let target = bounds.center() + bounds.size() * random.vector() * 0.5;
                let ray = Ray::new(target - far * direction, direction);
                let away = random.direction();
                followed += u32::from(departs(solid, &ray, away).is_some());
            }
        }
    }
}

#[test]
fn rays_that_leave_twins_are_clear_of_both() {
    check_twins_are_left(many(3000));
}

#[test]
fn tangents_leave_no_film_of_a_ball_and_its_twin() {
    // The discriminant of one may be above 0 where that of the other is not: such a span is thinner than its error.
    let mut random = TestRays(71);
    for exponent in 10..=18 {
        for _ in 0..200 {
            let (at, size) = (random.vector() * 3.0, 0.1 + random.unit());
            let map = DAffine3::from_translation(at) * DAffine3::from_scale(DVec3::splat(size));
            let turn = DAffine3::from_axis_angle(random.direction(), 1.0);
            let parts = [
                ball(at, size),
                placed(ball_shape([0.0; 3], 1.0), map * turn),
            ];
            let direction = random.direction();
            let side = direction.cross(random.direction()).normalize();
            let off = random.signed() * libm::exp10(-f64::from(exponent));
            let ray = Ray::new(at + size * (1.0 + off) * side - 5.0 * direction, direction);
            let [one, two] = parts;
            for rest in [[one.clone(), two.clone()], [two, one]] {
                assert_eq!(crossings(&csg(op(Difference, rest)), &ray), [0.0; 0]);
            }
        }
    }
}
