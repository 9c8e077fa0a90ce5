//! Answers known on paper; laws, films, closed forms and an exact oracle stand in files of their own.

mod closed_forms;
mod films;
mod laws;
mod oracle;
mod twins;

use glam::DAffine3;

use super::*;
use crate::geometry::{Cuboid, Disc, Shape, Sphere, Transformed};
use crate::math::{DVec3, Transform};

use CsgOp::{Difference, Intersection as Common, Union};

/// Random numbers, always the same.
struct TestRays(u64);

impl TestRays {
    /// Between 0 and 1.
    fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        let mixed = (self.0 ^ self.0 >> 33).wrapping_mul(0xff51_afd7_ed55_8ccd);
        (mixed >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Between -1 and 1.
    fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A number from 0 to n - 1.
    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector();
            if v.length() < 1.0 && v.length() > 0.1 {
                return v.normalize();
            }
        }
    }
}

fn leaf(shape: Shape) -> CsgTree {
    CsgTree::Leaf(Solid::Shape(shape))
}

fn ball_shape(center: impl Into<DVec3>, radius: f64) -> Shape {
    let center = center.into();
    Shape::Sphere(Sphere { center, radius })
}

fn ball(center: impl Into<DVec3>, radius: f64) -> CsgTree {
    leaf(ball_shape(center, radius))
}

fn cube_shape(min: impl Into<DVec3>, max: impl Into<DVec3>) -> Shape {
    let (min, max) = (min.into(), max.into());
    Shape::Cuboid(Cuboid {
        bounds: Aabb { min, max },
    })
}

fn cube(min: impl Into<DVec3>, max: impl Into<DVec3>) -> CsgTree {
    leaf(cube_shape(min, max))
}

fn placed(shape: Shape, to_world: DAffine3) -> CsgTree {
    let transform = Transform::new(to_world).expect("invertible");
    leaf(Shape::Transformed(Box::new(Transformed {
        shape,
        transform,
    })))
}

fn behind(point: impl Into<DVec3>, normal: DVec3) -> CsgTree {
    CsgTree::Leaf(Solid::HalfSpace(Box::new(HalfSpace::new(
        point.into(),
        normal,
    ))))
}

fn op<const N: usize>(op: CsgOp, parts: [CsgTree; N]) -> CsgTree {
    CsgTree::Op(op, parts.into())
}

fn csg(tree: CsgTree) -> Csg {
    Csg::new(tree).expect("a solid")
}

fn refused(tree: CsgTree) -> String {
    Csg::new(tree).expect_err("no solid")
}

/// The t of all crossings of the whole.
fn crossings(solid: &Csg, ray: &Ray) -> Vec<f64> {
    solid.spans(ray).cuts().map(|(cut, _)| cut.t).collect()
}

fn along_x(from: [f64; 3]) -> Ray {
    Ray::new(from.into(), DVec3::X)
}

#[test]
fn a_ball_minus_a_ball_is_crossed_as_on_paper() {
    let bitten = csg(op(
        Difference,
        [ball([0.0; 3], 1.0), ball([1.0, 0.0, 0.0], 0.5)],
    ));
    let ray = along_x([-3.0, 0.0, 0.0]);
    assert_eq!(crossings(&bitten, &ray), [2.0, 3.5]);
    let back = Ray::new(DVec3::X * 3.0, DVec3::NEG_X);
    let Intersection::Hit { t, part, .. } = bitten.intersect(&back, Interval::FORWARD) else {
        panic!("in the hollow");
    };
    assert_eq!((t, Csg::leaf_of(part)), (2.5, 1));
    // The hollow's wall looks out of the whole: into the ball that was taken away.
    let hollow = bitten.surface(&back, t, part);
    assert_eq!((hollow.point, hollow.normal), (DVec3::X * 0.5, DVec3::X));
    assert_eq!(bitten.enters(&back, t), Some(true));
    assert!(bitten.is_subtracted(1) && !bitten.is_subtracted(0));
}

#[test]
fn a_ray_that_starts_in_the_removed_part_meets_its_wall() {
    let shell = csg(op(Difference, [ball([0.0; 3], 2.0), ball([0.0; 3], 1.0)]));
    let inside = along_x([0.25, 0.0, 0.0]);
    let found = shell.intersect(&inside, Interval::FORWARD);
    assert!(matches!(
        found,
        Intersection::Hit {
            t: 0.75,
            part: 16,
            ..
        }
    ));
    assert_eq!(
        shell.surface(&inside, 0.75, Csg::part(1, 0)).normal,
        DVec3::NEG_X
    );
    // With a core in the hollow, and a hollow in the core, from its middle.
    let core = op(Difference, [ball([0.0; 3], 0.5), ball([0.0; 3], 0.25)]);
    let hollow = op(Difference, [ball([0.0; 3], 1.0), core]);
    let nested = csg(op(Difference, [ball([0.0; 3], 2.0), hollow]));
    assert_eq!(
        crossings(&nested, &along_x([0.0; 3])),
        [-2.0, -1.0, -0.5, -0.25, 0.25, 0.5, 1.0, 2.0]
    );
    let turned = [false, true, false, true];
    assert!(
        (0..)
            .zip(turned)
            .all(|(leaf, turned)| nested.is_subtracted(leaf) == turned)
    );
    let middle = along_x([0.0; 3]);
    assert_eq!(
        nested.surface(&middle, 0.25, Csg::part(3, 0)).normal,
        DVec3::NEG_X
    );
    assert_eq!(
        nested.surface(&middle, 0.5, Csg::part(2, 0)).normal,
        DVec3::X
    );
}

#[test]
fn cuts_tell_what_each_of_them_does() {
    let bitten = csg(op(
        Difference,
        [ball([0.0; 3], 1.0), ball([1.0, 0.0, 0.0], 0.5)],
    ));
    let told = bitten.cuts(&along_x([-3.0, 0.0, 0.0]));
    assert_eq!((told.asked, told.before), (0b11, 0));
    let cut = |leaf, t, enters, inside, counts, group| CsgCut {
        leaf,
        part: 8 * (leaf + 1),
        t,
        enters,
        inside,
        counts,
        group,
    };
    let expected = [
        cut(0, 2.0, true, 0b01, true, 0),
        cut(1, 3.5, true, 0b11, true, 1),
        cut(0, 4.0, false, 0b10, false, 2),
        cut(1, 4.5, false, 0b00, false, 3),
    ];
    assert_eq!(told.cuts, expected);
    // Where the first ball is missed the second is not asked.
    let beside = bitten.cuts(&along_x([-3.0, 1.25, 0.0]));
    assert_eq!((beside.asked, beside.cuts.len()), (0b01, 0));
}

#[test]
fn half_spaces_cut_what_has_an_end() {
    let dome = csg(op(
        Common,
        [ball([0.0; 3], 1.0), behind([0.0; 3], DVec3::NEG_Y)],
    ));
    let down = Ray::new(DVec3::Y * 3.0, DVec3::NEG_Y);
    assert_eq!(crossings(&dome, &down), [2.0, 3.0]);
    assert!(dome.bounds().min.y <= 0.0 && dome.bounds().min.y > -1e-14);
    // In front of the plane there is nothing, along it either all or nothing.
    assert_eq!(crossings(&dome, &along_x([0.0, -0.5, 0.0])), [0.0; 0]);
    assert_eq!(crossings(&dome, &along_x([0.0, 0.0, 0.0])), [-1.0, 1.0]);
    // Taken away, a half-space has no end either, and does no harm.
    let same = csg(op(
        Difference,
        [ball([0.0; 3], 1.0), behind([0.0; 3], DVec3::Y)],
    ));
    assert_eq!(crossings(&same, &down), [2.0, 3.0]);
    assert_eq!(
        same.surface(&down, 3.0, Csg::part(1, 0)).normal,
        DVec3::NEG_Y
    );
    // Six along the axes are a box.
    let walls = [DVec3::X, DVec3::Y, DVec3::Z].map(|n| [behind(n, n), behind(-n, -n)]);
    let six = csg(CsgTree::Op(Common, walls.into_iter().flatten().collect()));
    assert_eq!(crossings(&six, &down), [2.0, 4.0]);
}

#[test]
fn what_is_no_solid_is_refused_in_plain_words() {
    let one = || ball([0.0; 3], 1.0);
    assert!(refused(behind([0.0; 3], DVec3::Y)).contains("such as a box"));
    assert!(refused(op(Union, [one(), behind([0.0; 3], DVec3::Y)])).contains("no end"));
    let disc = Shape::Disc(Box::new(Disc::new(DVec3::ZERO, DVec3::Y, 1.0)));
    let told = refused(op(Union, [one(), leaf(disc)]));
    assert!(
        told.contains("disc") && told.contains("part number 2"),
        "{told}"
    );
    assert!(refused(op(Difference, [])).contains("difference of no parts"));
    let many = |n| CsgTree::Op(Union, (0..n).map(|_| one()).collect());
    assert!(refused(many(65)).contains("more than 64 parts"));
    assert!(Csg::new(many(64)).is_ok());
    let deep = |n| (0..n).fold(one(), |inner, _| op(Union, [inner]));
    assert!(refused(deep(33)).contains("more than 32 operations"));
    assert!(Csg::new(deep(32)).is_ok());
}

#[test]
fn a_box_that_nothing_is_left_of_is_empty() {
    let apart = csg(op(
        Common,
        [ball([0.0; 3], 1.0), ball([3.0, 0.0, 0.0], 1.0)],
    ));
    assert!(apart.bounds().is_empty());
    assert_eq!(crossings(&apart, &along_x([-3.0, 0.0, 0.0])), [0.0; 0]);
    let with_more = csg(op(
        Union,
        [
            ball([9.0; 3], 1.0),
            op(Common, [ball([0.0; 3], 1.0), ball([3.0, 0.0, 0.0], 1.0)]),
        ],
    ));
    assert!(with_more.bounds().min.min_element() > 7.9);
}

#[test]
fn rays_that_are_none_miss() {
    let solid = csg(op(
        Difference,
        [
            cube([-1.0; 3], [1.0; 3]),
            ball([0.0; 3], 1.0),
            behind([0.0; 3], DVec3::ONE.normalize()),
        ],
    ));
    let bad = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        f64::MAX,
        f64::MIN_POSITIVE,
    ];
    for o in bad {
        for d in bad {
            let ray = Ray::new(DVec3::splat(o), DVec3::splat(d));
            let found = solid.intersect(&ray, Interval::FORWARD);
            let is_ray = o.is_finite() && d.is_finite() && d != 0.0;
            assert!(
                is_ray || !matches!(found, Intersection::Hit { .. }),
                "{o:e} {d:e}"
            );
            for cut in solid.cuts(&ray).cuts {
                assert!(!solid.surface(&ray, cut.t, cut.part).point.x.is_infinite() || !is_ray);
            }
        }
    }
}

#[test]
fn a_chain_of_64_leaves_is_followed_to_its_end() {
    // Balls in a row, each overlapping the next: every second one is taken away from the others.
    let row = |n: usize| ball([n as f64, 0.0, 0.0], 0.75);
    let odd = CsgTree::Op(Union, (0..32).map(|n| row(2 * n)).collect());
    let even = CsgTree::Op(Union, (0..32).map(|n| row(2 * n + 1)).collect());
    let comb = csg(op(Difference, [odd, even]));
    let found = crossings(&comb, &along_x([-2.0, 0.0, 0.0]));
    assert_eq!(found.len(), 64);
    assert_eq!(&found[..4], [1.25, 2.25, 3.75, 4.25]);
    // All 128 cuts are in the list, and none of them on the heap.
    let mut list = CutList::default();
    comb.collect(&along_x([-2.0, 0.0, 0.0]), &mut list);
    assert!(list.cuts.len() == 128 && !list.cuts.spilled());
}

#[test]
fn operations_may_be_32_deep() {
    let row = |n: usize| ball([n as f64, 0.0, 0.0], 0.75);
    let word = |n: usize| if n % 2 == 1 { Difference } else { Union };
    let comb = csg((1..=32).fold(row(0), |so_far, n| op(word(n), [so_far, row(n)])));
    let found = crossings(&comb, &along_x([-2.0, 0.0, 0.0]));
    // An even ball n keeps [n - 0.75, n + 0.25], since ball n + 1 is taken away after it, and ball n - 1 before it.
    assert_eq!(found.len(), 34);
    assert_eq!(&found[..4], [1.25, 2.25, 3.25, 4.25]);
    assert_eq!(&found[32..], [33.25, 34.75]);
}

/// A line that misses what is cut from need not ask the cutter; who asks for all cuts hears of it all the same.
#[test]
fn all_cuts_are_those_of_leaves_that_do_not_matter_as_well() {
    let solid = csg(op(
        Difference,
        [ball((0.0, 0.0, 0.0), 1.0), ball((0.0, 3.0, 0.0), 1.0)],
    ));
    let ray = Ray::new(DVec3::new(-5.0, 3.0, 0.0), DVec3::X);
    assert_eq!(solid.cuts(&ray).cuts, []);
    let all = solid.cuts_of_all_leaves(&ray);
    let told: Vec<(f64, u32)> = all.iter().map(|c| (c.t, Csg::leaf_of(c.part))).collect();
    assert_eq!(told, [(4.0, 1), (6.0, 1)]);
}
