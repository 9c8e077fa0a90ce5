//! Faces that coincide, solids that touch, cutters that are thinner than rounding: no film, no gap, no speckle.

use super::*;
use crate::geometry::test_rays::many;

/// A block with a square pocket whose mouth lies in the block's top face. Both are the unit box, each with a matrix of its own,
/// turned together by 1 radian, at a scale, away from the origin.
struct Pocket {
    solid: Csg,
    world: DAffine3,
}

impl Pocket {
    fn new(scale: f64, away: f64) -> Self {
        let axis = DVec3::new(1.0, 2.0, 3.0).normalize();
        let world = DAffine3::from_translation(away * scale * DVec3::new(0.3, -0.7, 0.2))
            * DAffine3::from_axis_angle(axis, 1.0)
            * DAffine3::from_scale(DVec3::splat(scale));
        let unit = || cube_shape([0.0; 3], [1.0; 3]);
        let part = |min: [f64; 3], size: [f64; 3]| {
            let map = DAffine3::from_translation(min.into()) * DAffine3::from_scale(size.into());
            placed(unit(), world * map)
        };
        let block = part([-1.0, -1.0, -1.0], [2.0, 2.0, 1.7]);
        let hole = part([-0.5, -0.5, 0.1], [1.0, 1.0, 0.6]);
        let solid = csg(op(Difference, [block, hole]));
        Self { solid, world }
    }

    /// A ray from an eye to a place in the mouth, x and y between -0.5 and 0.5.
    fn ray(&self, eye: DVec3, x: f64, y: f64) -> Ray {
        let world = |p: DVec3| self.world.transform_point3(p);
        let target = world(DVec3::new(x, y, 0.7));
        let eye = world(eye);
        Ray::new(eye, (target - eye).normalize())
    }
}

/// How many of the rays through the mouth meet a film there: with the rule, and without it.
fn films(scale: f64, away: f64, eye: DVec3, rays: u32) -> [u32; 2] {
    let pocket = Pocket::new(scale, away);
    let mut random = TestRays(7);
    let mut films = [0, 0];
    for _ in 0..rays {
        let (x, y) = (0.49 * random.signed(), 0.49 * random.signed());
        let ray = pocket.ray(eye, x, y);
        let told = pocket.solid.cuts(&ray);
        // The wall or the floor of the pocket is well behind its mouth.
        let mouth = (pocket.world.transform_point3(DVec3::new(x, y, 0.7)) - ray.origin).length();
        let at_mouth = |t: f64| (t - mouth).abs() < 1e-4 * scale;
        films[0] += u32::from(told.cuts.iter().any(|cut| cut.counts && at_mouth(cut.t)));
        let mut inside = told.before;
        let mut is_film = false;
        for cut in &told.cuts {
            let changes = pocket.solid.is_inside(cut.inside) != pocket.solid.is_inside(inside);
            is_film |= changes && at_mouth(cut.t);
            inside = cut.inside;
        }
        films[1] += u32::from(is_film);
    }
    films
}

const EYES: [DVec3; 4] = [
    DVec3::new(0.2, 0.1, 5.0),
    DVec3::new(4.0, -3.0, 1.5),
    DVec3::new(-40.0, 90.0, 120.0),
    DVec3::new(3e3, -5e3, 9e3),
];

#[test]
fn a_common_face_leaves_no_film() {
    let mut without = 0;
    for scale in [1e-3, 1.0, 1e3] {
        for eye in EYES {
            let [with_rule, without_rule] = films(scale, 1.0, eye, many(200));
            assert_eq!(with_rule, 0, "scale {scale}, eye {eye}");
            without += without_rule;
        }
    }
    assert!(without > 200, "the test shows nothing: {without}");
}

#[test]
fn balls_that_touch_in_a_point_have_nothing_in_common() {
    let mut random = TestRays(3);
    for _ in 0..2000 {
        // Balls around points on a line in any direction that touch as well as rounding lets them.
        let d = random.direction();
        let (r, s) = (0.1 + random.unit(), 0.1 + random.unit());
        let at = random.vector() * 10.0;
        let parts = || [ball(at, r), ball(at + (r + s) * d, s)];
        let common = csg(op(Common, parts()));
        let aside = random.direction() * 1e-9 * random.unit();
        let touch = at + r * d + aside;
        for direction in [d, (d + 0.5 * random.direction()).normalize()] {
            let ray = Ray::new(touch - 5.0 * direction, direction);
            assert_eq!(crossings(&common, &ray), [0.0; 0]);
        }
        // Together they have no gap: one span along their axis.
        let both = csg(op(Union, parts()));
        let ray = Ray::new(at - 5.0 * d, d);
        assert_eq!(crossings(&both, &ray).len(), 2);
    }
}

#[test]
fn boxes_that_share_a_face_have_no_gap_and_nothing_in_common() {
    let mut random = TestRays(5);
    let turn = DAffine3::from_axis_angle(DVec3::new(3.0, 1.0, 2.0).normalize(), 1.0);
    let half = |x| {
        let map =
            DAffine3::from_translation(DVec3::X * x) * DAffine3::from_scale(DVec3::splat(0.3));
        placed(cube_shape([0.0, -1.0, -1.0], [1.0, 1.0, 1.0]), turn * map)
    };
    let parts = || [half(0.1), half(0.4)];
    let [both, common] = [Union, Common].map(|word| csg(op(word, parts())));
    for _ in 0..2000 {
        let target = turn.transform_point3(DVec3::new(
            0.4,
            0.29 * random.signed(),
            0.29 * random.signed(),
        ));
        let direction = random.direction();
        let ray = Ray::new(target - 4.0 * direction, direction);
        assert_eq!(crossings(&both, &ray).len(), 2, "{ray:?}");
        assert_eq!(crossings(&common, &ray), [0.0; 0], "{ray:?}");
    }
}

#[test]
fn a_cutter_thinner_than_rounding_changes_nothing() {
    let z = 0.3f64;
    let plate = cube([-2.0, -2.0, z], [2.0, 2.0, z.next_up()]);
    let whole = csg(ball([0.0; 3], 1.0));
    let cut = csg(op(Difference, [ball([0.0; 3], 1.0), plate]));
    // One that is 1e-9 thick is seen.
    let thick = csg(op(
        Difference,
        [
            ball([0.0; 3], 1.0),
            cube([-2.0, -2.0, z], [2.0, 2.0, z + 1e-9]),
        ],
    ));
    let mut random = TestRays(11);
    for _ in 0..1000 {
        let target = DVec3::new(0.5 * random.signed(), 0.5 * random.signed(), z);
        let direction = random.direction();
        let ray = Ray::new(target - 3.0 * direction, direction);
        assert_eq!(crossings(&cut, &ray), crossings(&whole, &ray), "{ray:?}");
        assert_eq!(
            crossings(&thick, &ray).len(),
            crossings(&whole, &ray).len() + 2
        );
    }
}

#[test]
fn the_group_stands_for_the_first_leaf_that_decides() {
    // The ball's box shares the face x = 1 with the second one: coming from the right, A - B begins at A's own face.
    let first = || cube([0.0; 3], [1.0; 3]);
    let second = || cube([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]);
    let from_right = Ray::new(DVec3::new(5.0, 0.5, 0.5), DVec3::NEG_X);
    let met = |solid: &Csg| match solid.intersect(&from_right, Interval::FORWARD) {
        Intersection::Hit { t, part, .. } => (t, Csg::leaf_of(part)),
        other => panic!("{other:?}"),
    };
    assert_eq!(met(&csg(op(Difference, [first(), second()]))), (4.0, 0));
    assert_eq!(met(&csg(op(Union, [first(), first()]))), (4.0, 0));
    assert_eq!(met(&csg(op(Common, [first(), first()]))), (4.0, 0));
    // Where each of four leaves needs another one, one that works towards the answer is found.
    let pair = || op(Common, [first(), first()]);
    let pairs = csg(op(Union, [pair(), pair()]));
    assert_eq!(met(&pairs), (4.0, 1));
    assert_eq!(
        pairs.surface(&from_right, 4.0, Csg::part(1, 0)).normal,
        DVec3::X
    );
    // A box whose left half is taken away, and put in again: no trace of the cut.
    let mended = csg(op(
        Union,
        [
            op(
                Difference,
                [first(), cube([-1.0, 0.0, 0.0], [0.5, 1.0, 1.0])],
            ),
            cube([0.0; 3], [0.5, 1.0, 1.0]),
        ],
    ));
    assert_eq!(crossings(&mended, &from_right), [4.0, 5.0]);
}

/// A block with a pocket that is filled with a lid of this thickness below its mouth, and a ray through it.
fn is_lid_met(thickness: f64, eye: f64) -> bool {
    let block = cube([-1.0; 3], [1.0, 1.0, 0.7]);
    let hole = cube([-0.5, -0.5, 0.1], [0.5, 0.5, 0.7 - thickness]);
    let solid = csg(op(Difference, [block, hole]));
    let origin = DVec3::new(0.3, 0.2, eye);
    let ray = Ray::new(origin, (DVec3::new(0.1, 0.0, 0.0) - origin).normalize());
    crossings(&solid, &ray).len() == 4
}

#[test]
fn a_film_that_is_there_is_not_lost() {
    // What is thinner than some u (|o| + t) is lost; no more than that.
    for (eye, thinnest) in [(2.0, 4e-15), (1e3, 2e-12), (1e6, 2e-9)] {
        assert!(is_lid_met(thinnest, eye), "{eye}");
        assert!(!is_lid_met(thinnest / 100.0, eye), "{eye}");
    }
}

#[test]
fn what_only_a_near_eye_tells_apart_is_left_together() {
    // From afar both tops are one, and the lower stands for them. From there both are told apart: the ray must start above.
    let lower = || cube([-1.0; 3], [1.0, 1.0, 0.3]);
    let upper = || cube([-1.0; 3], [1.0, 1.0, 0.3 + 1e-11]);
    let both = csg(op(Union, [lower(), upper()]));
    let ray = Ray::new(DVec3::new(0.1, 0.2, 1e6), DVec3::NEG_Z);
    let top = both.intersect(&ray, Interval::FORWARD);
    assert!(matches!(top, Intersection::Hit { part: 8, .. }));
    for direction in [DVec3::Z, DVec3::NEG_Z] {
        assert!(super::laws::departs(&both, &ray, direction).is_some());
    }
}

#[test]
fn rays_that_run_along_a_common_face_meet_no_film() {
    let mut random = TestRays(59);
    let pocket = Pocket::new(1.0, 1.0);
    let back = pocket.world.inverse();
    for exponent in 0..=12 {
        for _ in 0..200 {
            let (x, y) = (0.45 * random.signed(), 0.45 * random.signed());
            let along = random.direction().with_z(0.0).normalize();
            let eye = DVec3::new(x, y, 0.7)
                + 5.0 * (along + libm::exp10(-f64::from(exponent)) * DVec3::Z);
            let ray = pocket.ray(eye, x, y);
            let in_mouth = |t: &f64| {
                let p = back.transform_point3(ray.at(*t));
                p.x.abs() < 0.499 && p.y.abs() < 0.499 && (p.z - 0.7).abs() < 1e-13
            };
            let found = crossings(&pocket.solid, &ray);
            assert!(!found.iter().any(in_mouth), "slope 1e-{exponent}: {ray:?}");
        }
    }
}

#[test]
fn a_steep_wall_is_told_from_a_face_that_the_ray_grazes() {
    // The ray sinks by 1e-10 a metre: it goes into the floor, and a micrometre later into the pit. At right angles to the floor
    // both places are the same; at right angles to the wall of the pit they are not.
    let pit = cube([1e-6, -1.0, -0.5], [0.5, 1.0, 0.5]);
    let floor = csg(op(Difference, [cube([-1.0; 3], [1.0, 1.0, 0.0]), pit]));
    let ray = Ray::new(DVec3::new(-0.5, 0.0, 0.5e-10), DVec3::new(1.0, 0.0, -1e-10));
    let found = crossings(&floor, &ray);
    assert_eq!(found.len(), 4, "{found:?}");
    assert!((found[0] - 0.5).abs() < 1e-12 && (found[1] - 0.500_001).abs() < 1e-12);
}

#[test]
fn groups_are_the_same_from_both_sides() {
    // Each of three faces cannot be told from its neighbours.
    let slab = |bottom: f64, top: f64| cube([-1.0, -1.0, bottom], [1.0, 1.0, top]);
    let stack = csg(op(
        Union,
        [slab(-0.5, 0.0), slab(-0.4, 1e-15), slab(-0.3, 2e-15)],
    ));
    for direction in [DVec3::Z, DVec3::NEG_Z] {
        let told = stack.cuts(&Ray::new(-direction, direction));
        let mut tops = told.cuts.iter().filter(|cut| (cut.t - 1.0).abs() < 0.1);
        let first = tops.next().expect("a face").group;
        assert_eq!(tops.filter(|cut| cut.group == first).count(), 2);
    }
}

#[test]
fn a_wrong_t_is_known_to_be_wrong() {
    // Whatever error a shape makes in t is seen as the distance between the ray's point and the surface.
    let solid = csg(ball([0.0; 3], 1.0));
    let ray = Ray::new(DVec3::new(0.6, 0.0, -3.0), DVec3::Z * 2.0);
    let mut list = CutList::default();
    solid.collect(&ray, &mut list);
    let mut cut = list.cuts[0];
    let right = solid.sharpness(&ray, &cut);
    assert!((right.steepness - 1.6).abs() < 1e-15 && right.error < 1e-14);
    cut.cut.t += 1e-9;
    let error = solid.sharpness(&ray, &cut).error;
    assert!(error > 1.59e-9 && error < 1.61e-9, "{error}");
}
