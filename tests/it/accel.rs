//! Every accelerator answers as the list does: same primitive, same bits of t and of the weights.

mod large;
pub mod scenes;

use proptest::prelude::*;
use raytree::accel::{Accel, AccelKind, AccelStats};
use raytree::geometry::{Hit, Plane, Shape};
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::{Choice, Event, Probe, Silent, Verdict};
use scenes::{Frame, STYLES, fan, ray, scene, triangle};

use crate::common;
use crate::random::Random;

const TREES: [AccelKind; 10] = [
    AccelKind::Bsp,
    AccelKind::BspAxis,
    AccelKind::BspPolygon,
    AccelKind::BspSah,
    AccelKind::Kd,
    AccelKind::Grid,
    AccelKind::Octree,
    AccelKind::Bvh,
    AccelKind::BvhSpheres,
    AccelKind::Wide,
];

/// A hit with its numbers as bits, so that equal means identical.
fn bits(hit: Option<Hit>) -> Option<(u32, u32, u64, [u64; 3])> {
    hit.map(|h| {
        (
            h.primitive,
            h.part,
            h.t.to_bits(),
            h.place.map(f64::to_bits),
        )
    })
}

/// Asks all accelerators the same. The error says which one differs, and for which ray.
fn agree(shapes: &[Shape], rays: &[(Ray, Interval)]) -> Result<(), String> {
    agree_on(&TREES, shapes, rays)
}

/// Asks these accelerators the same.
fn agree_on(trees: &[AccelKind], shapes: &[Shape], rays: &[(Ray, Interval)]) -> Result<(), String> {
    let list = Accel::build(AccelKind::List, shapes);
    let ask = |accel: &Accel, (ray, interval): &(Ray, Interval)| {
        bits(accel.closest(shapes, ray, *interval, &mut Silent))
    };
    let expected: Vec<_> = rays.iter().map(|ray| ask(&list, ray)).collect();
    for &kind in trees {
        let tree = Accel::build(kind, shapes);
        for (asked, expected) in rays.iter().zip(&expected) {
            let (ray, interval) = asked;
            let found = ask(&tree, asked);
            if *expected != found {
                return Err(format!(
                    "{kind:?}: {ray:?} {interval:?}: {found:?}, the list {expected:?}"
                ));
            }
            let any = tree.any_hit(shapes, ray, *interval, &mut Silent);
            if any.is_some() != expected.is_some() {
                return Err(format!("{kind:?}: any for {ray:?} {interval:?}: {any:?}"));
            }
        }
        // All at once: the same again.
        let mut closest = vec![None; rays.len()];
        tree.closest_many(shapes, rays, &mut closest);
        let mut any = vec![false; rays.len()];
        tree.occluded_many(shapes, rays, &mut any);
        let found = closest.into_iter().zip(any);
        for (((ray, interval), expected), (closest, any)) in rays.iter().zip(&expected).zip(found) {
            if (*expected, expected.is_some()) != (bits(closest), any) {
                return Err(format!(
                    "{kind:?}, in a bundle: {ray:?} {interval:?}: {closest:?} {any}, the list {expected:?}"
                ));
            }
        }
    }
    Ok(())
}

// 60 rays through each scene, 32 of them in two bundles. 10^7 rays are
// `RAYTREE_CASES=3400 RAYTREE_ROUNDS=50 cargo test --release --test it accel::trees_answer`.
proptest! {
    #![proptest_config(common::config(600))]

    #[test]
    fn trees_answer_as_the_list_does(
        seed: u64,
        style in prop::sample::select(&STYLES[..]),
        count in 1usize..120,
        scale in prop::sample::select(&[1e-6, 1.0, 1e6][..]),
        offset in prop::sample::select(&[0.0, 0.0, 1.0, 1e3, 1e9][..]),
    ) {
        let mut random = Random(seed);
        let frame = Frame { scale, offset: offset * random.point() };
        let shapes = scene(style, count, frame, &mut random);
        let rounds = common::number("RAYTREE_ROUNDS").unwrap_or(1);
        let mut rays = Vec::new();
        for _ in 0..2 * rounds {
            rays.extend(fan(&shapes, frame, &mut random));
        }
        rays.extend((0..28 * rounds).map(|_| ray(&shapes, frame, &mut random)));
        prop_assert_eq!(agree(&shapes, &rays), Ok(()));
    }

    #[test]
    fn garbage_neither_panics_nor_differs(seed: u64, count in 1usize..60) {
        // Random bits, made finite: any exponent, both signs, and sometimes a plain number.
        let mut random = Random(seed);
        let number = |random: &mut Random| match random.below(3) {
            0 => random.unit(),
            _ => Some(f64::from_bits(random.bits())).filter(|x| x.is_finite()).unwrap_or(0.0),
        };
        let point = |random: &mut Random| DVec3::from_array([(); 3].map(|()| number(random)));
        let shapes: Vec<Shape> = (0..count)
            .map(|_| triangle([(); 3].map(|()| point(&mut random))))
            .collect();
        let rays: Vec<_> = (0..30)
            .map(|_| (Ray::new(point(&mut random), random.direction()), Interval::FORWARD))
            .collect();
        prop_assert_eq!(agree(&shapes, &rays), Ok(()));
    }
}

/// A sphere of triangles: rings of a uv grid, pushed outwards by `bump`.
fn globe(rings: usize, bump: impl Fn(f64, f64) -> f64) -> Vec<Shape> {
    let at = |i: usize, j: usize| {
        let (theta, phi) = (
            std::f64::consts::PI * i as f64 / rings as f64,
            std::f64::consts::PI * (j % (2 * rings)) as f64 / rings as f64,
        );
        let (sin, cos) = theta.sin_cos();
        bump(theta, phi) * DVec3::new(sin * libm::cos(phi), cos, sin * libm::sin(phi))
    };
    (0..rings)
        .flat_map(|i| (0..2 * rings).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            [triangle([a, b, c]), triangle([a, c, d])]
        })
        .collect()
}

/// The law for trees over `count` primitives, however bad.
fn within_bounds(stats: AccelStats, count: usize) {
    assert!(stats.depth <= 62, "{stats:?}");
    assert!(stats.references <= 8 * count, "{stats:?}");
    assert!(stats.nodes <= 20 * count + 1, "{stats:?}");
    assert!(stats.bytes <= 600 * count + 64, "{stats:?}");
}

#[test]
fn degenerate_scenes_end_in_bounded_size() {
    let n = 100_000;
    let mut random = Random(1);
    let mut flat = |normal: DVec3| -> Vec<Shape> {
        let (u, v) = normal.any_orthonormal_pair();
        let mut point = || random.unit() * u + random.unit() * v;
        let mut near = |p: DVec3| p + 0.01 * point();
        (0..n)
            .map(|_| {
                let center = 100.0 * near(DVec3::ZERO);
                triangle([near(center), near(center), near(center)])
            })
            .collect()
    };
    let slanted = flat(DVec3::new(1.0, 2.0, 3.0).normalize());
    let floor = flat(DVec3::Y);
    let one = triangle([DVec3::X, DVec3::Y, DVec3::Z]);
    let point = triangle([DVec3::ONE; 3]);
    let hull = globe(158, |_, _| 1.0);
    let scenes = [
        ("slanted", slanted),
        ("floor", floor),
        ("copies", vec![one; n]),
        ("points", vec![point; n]),
        ("hull", hull),
    ];
    for (name, shapes) in &scenes {
        for kind in TREES {
            let tree = Accel::build(kind, shapes);
            let stats = tree.stats();
            within_bounds(stats, shapes.len());
            assert!(stats.references >= shapes.len(), "{name}, {kind:?}");
        }
    }
    // All coplanar: one plane and everything on it, or, as a small triangle tells its plane less exactly, a few.
    let size = |scene: usize| Accel::build(AccelKind::BspPolygon, &scenes[scene].1).stats();
    let floor = size(1);
    assert_eq!((floor.depth, floor.nodes, floor.references), (1, 3, n));
    assert!(size(0).nodes < 1000);
}

#[test]
fn a_convex_hull_does_not_make_a_list_of_the_tree() {
    // Every polygon's plane has all others behind it: without planes along the axes the depth would be n.
    let shapes = globe(32, |_, _| 1.0);
    for kind in TREES {
        let tree = Accel::build(kind, &shapes);
        let mut work = Steps::default();
        for i in 0..100 {
            let from = DVec3::new(0.01 * f64::from(i) - 0.5, 0.3, 3.0);
            let ray = Ray::new(from, DVec3::NEG_Z);
            tree.closest(&shapes, &ray, Interval::FORWARD, &mut work);
        }
        assert!(work.tests < 100 * 60, "{kind:?}: {}", work.tests);
    }
}

/// Listens to the steps and checks that they tell a coherent story.
#[derive(Default)]
struct Steps {
    tests: usize,
    visits: Vec<(u32, Choice)>,
    hits: Vec<u32>,
}

impl Probe for Steps {
    const TRAVERSAL: bool = true;

    fn event(&mut self, event: Event) {
        match event {
            Event::Test {
                primitive, verdict, ..
            } => {
                self.tests += 1;
                if verdict == Verdict::Hit {
                    self.hits.push(primitive);
                }
            }
            Event::Visit(visit) => self.visits.push((visit.node, visit.choice)),
            _ => {}
        }
    }
}

#[test]
fn the_steps_of_a_ray_through_three_walls_are_those_drawn_on_paper() {
    let wall = |x: f64| {
        let p = |y, z| DVec3::new(x, y, z);
        triangle([p(-9.0, -9.0), p(9.0, -9.0), p(0.0, 9.0)])
    };
    let shapes = [wall(1.0), wall(2.0), wall(3.0)];
    let tree = Accel::build(AccelKind::BspPolygon, &shapes);
    // The middle wall's plane is the root, with a leaf on either side of it.
    let root = tree.node(0).expect("there is a root");
    assert_eq!(root.primitives, [1]);
    let (normal, d) = root.plane.expect("it is split");
    assert_eq!((normal.abs(), d.abs(), root.axis), (DVec3::X, 2.0, None));
    let children = root.children.expect("it has two");
    let leaf_of = |primitive: u32| {
        let holds = |id: &u32| tree.node(*id).is_some_and(|n| n.primitives == [primitive]);
        children.into_iter().find(holds).expect("a leaf")
    };
    assert_eq!(tree.node(3), None);

    let walk = |origin: DVec3, direction: DVec3| {
        let mut steps = Steps::default();
        let ray = Ray::new(origin, direction);
        let hit = tree.closest(&shapes, &ray, Interval::FORWARD, &mut steps);
        (hit.map(|h| h.primitive), steps)
    };
    // From the left the near wall is hit, and what is behind it is skipped.
    let (hit, steps) = walk(DVec3::ZERO, DVec3::X);
    assert_eq!(hit, Some(0));
    assert_eq!((steps.tests, &steps.hits[..]), (1, &[0][..]));
    let expected = [
        (0, Choice::Both),
        (leaf_of(0), Choice::Leaf),
        (leaf_of(2), Choice::SkippedCloserHit),
    ];
    assert_eq!(steps.visits, expected);
    // From between the first two to the left: away from the middle plane.
    let (hit, steps) = walk(DVec3::X * 1.5, DVec3::NEG_X);
    assert_eq!(hit, Some(0));
    assert_eq!(steps.visits[0], (0, Choice::NearRunsAway));
    // From between the first two to the right: nothing near, then the wall on the plane.
    let (hit, steps) = walk(DVec3::X * 1.5, DVec3::X);
    assert_eq!((hit, &steps.hits[..]), (Some(1), &[1][..]));
    // Beside everything.
    let (hit, steps) = walk(DVec3::Y * 20.0, DVec3::X);
    assert_eq!(hit, None);
    assert_eq!(steps.visits, [(0, Choice::SkippedOutside)]);
}

#[test]
fn two_polygons_that_sent_another_library_into_endless_recursion() {
    // evanw/csg.js, issue 11: a triangle and a quad, here as two triangles.
    let p = DVec3::new;
    let quad = [
        p(1.26216, 0.46369, -0.43822),
        p(1.36719, 0.29688, -0.5),
        p(1.35204, 0.32133, -0.34461),
        p(1.25679, 0.47373, -0.34461),
    ];
    let shapes = [
        triangle([
            p(1.23079, 0.35525, -0.39928),
            p(1.26563, 0.28906, -0.40625),
            p(1.24346, 0.44424, -0.41733),
        ]),
        triangle([quad[0], quad[1], quad[2]]),
        triangle([quad[0], quad[2], quad[3]]),
    ];
    for kind in TREES {
        within_bounds(Accel::build(kind, &shapes).stats(), shapes.len());
    }
    let mut random = Random(11);
    let frame = Frame {
        scale: 0.1,
        offset: p(1.3, 0.4, -0.4),
    };
    let rays: Vec<_> = (0..2000)
        .map(|_| ray(&shapes, frame, &mut random))
        .collect();
    assert_eq!(agree(&shapes, &rays), Ok(()));
}

/// Small triangles seen from as far as single precision is trusted, by rays that graze the corners of their boxes:
/// there the rounding of a ray's origin is larger than all else, and only the bound for it keeps the hits.
#[test]
fn a_far_eye_loses_nothing_to_single_precision() {
    let mut random = Random(7);
    let corner = |p: DVec3, x: f64, y: f64| p + 1e-3 * DVec3::new(x, y, 0.0);
    let spots: Vec<DVec3> = (0..100).map(|_| random.point()).collect();
    let shapes: Vec<Shape> = spots
        .iter()
        .map(|p| {
            triangle([
                corner(*p, 0.0, 0.0),
                corner(*p, 1.0, 0.0),
                corner(*p, 0.0, 1.0),
            ])
        })
        .collect();
    let mut rays = Vec::new();
    for i in 0..24 {
        let distance = 8.0 + 0.3 * f64::from(i);
        for spot in &spots {
            for (x, y) in [(1e-9, 1e-9), (1.0 - 1e-8, 1e-9), (1e-9, 1.0 - 1e-8)] {
                let target = corner(*spot, x, y);
                let origin = target + random.direction() * distance;
                let ray = Ray::new(origin, (target - origin).normalize());
                rays.push((ray, Interval::FORWARD));
            }
        }
    }
    agree(&shapes, &rays).unwrap();
}

#[test]
fn nothing_to_build_on_is_no_trouble() {
    let ray = Ray::new(DVec3::Y, DVec3::NEG_Y);
    for kind in TREES {
        let empty = Accel::build(kind, &[]);
        assert_eq!(
            empty.closest(&[], &ray, Interval::FORWARD, &mut Silent),
            None
        );
        assert_eq!((empty.node(0), empty.stats().nodes), (None, 0));
    }
    // An endless plane has no place in the tree.
    let floor = [Shape::Plane(Box::new(Plane::new(DVec3::ZERO, DVec3::Y)))];
    assert_eq!(agree(&floor, &[(ray, Interval::FORWARD)]), Ok(()));
}
