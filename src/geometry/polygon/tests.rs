//! Polygons: areas, shared edges, sides, and the cases in which a walk to infinity could go wrong.

use super::*;
use crate::geometry::Triangle;
use crate::sampling::stream::uniform2;

/// A polygon in the plane z = 0.
fn flat(loops: &[&[[f64; 2]]]) -> Polygon {
    let lift = |corners: &&[[f64; 2]]| {
        corners
            .iter()
            .map(|[x, y]| DVec3::new(*x, *y, 0.0))
            .collect()
    };
    let loops: Vec<Vec<DVec3>> = loops.iter().map(lift).collect();
    Polygon::new(&loops).expect("an area")
}

/// Whether a ray straight down on (x, y) hits.
fn hits(polygon: &Polygon, [x, y]: [f64; 2]) -> bool {
    let ray = Ray::new(DVec3::new(x, y, 1.0), DVec3::NEG_Z);
    let found = polygon.intersect(&ray, &Shear::new(&ray), Interval::FORWARD);
    matches!(found, Intersection::Hit { t: 1.0, .. })
}

const L: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [2.0, 0.0],
    [2.0, 1.0],
    [1.0, 1.0],
    [1.0, 2.0],
    [0.0, 2.0],
];

#[test]
fn a_concave_polygon_is_hit_where_it_is() {
    let l = flat(&[&L]);
    assert_eq!(l.normal(), DVec3::Z);
    assert_eq!(l.area_vector(), DVec3::Z * 3.0);
    for (at, expected) in [
        ([0.5, 0.5], true),
        ([1.5, 0.5], true),
        ([0.5, 1.5], true),
        ([1.5, 1.5], false),
        ([2.5, 0.5], false),
        ([-0.5, 1.0], false),
    ] {
        assert_eq!(hits(&l, at), expected, "{at:?}");
    }
}

/// Rays exactly through all corners and edges of a tiling of polygons with three neighbours or more at a corner.
#[test]
fn polygons_that_share_edges_and_corners_are_hit_once() {
    // A square of 4 x 4 made of five pieces: an L in each corner but one, and what is left.
    let moved = |by: [f64; 2], turn: usize| -> Vec<[f64; 2]> {
        let turned = |[x, y]: [f64; 2]| (0..turn).fold([x - 1.0, y - 1.0], |[x, y], _| [-y, x]);
        L.map(turned)
            .map(|[x, y]| [x + 1.0 + by[0], y + 1.0 + by[1]])
            .to_vec()
    };
    let pieces = [
        moved([0.0, 0.0], 0),
        moved([2.0, 0.0], 1),
        moved([2.0, 2.0], 2),
        moved([0.0, 2.0], 3),
        vec![[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]],
    ];
    for shift in [0.0, 1e9] {
        let tiles: Vec<Polygon> = pieces
            .iter()
            .map(|corners| {
                let corners: Vec<_> = corners.iter().map(|[x, y]| [x + shift, *y]).collect();
                flat(&[&corners])
            })
            .collect();
        for i in 1..16 {
            for j in 1..16 {
                let at = [shift + f64::from(i) / 4.0, f64::from(j) / 4.0];
                let count = tiles.iter().filter(|tile| hits(tile, at)).count();
                assert_eq!(count, 1, "{at:?}");
            }
        }
    }
}

/// A polygon and the triangles of a fan that fills the rest of a square, with rays aimed at the shared edges in any direction.
#[test]
fn polygons_meet_triangles_without_gap() {
    let rim = [[0.0, 0.0], [3.0, 0.1], [2.9, 3.0], [0.2, 2.8]];
    let lift = |[x, y]: [f64; 2]| DVec3::new(x, y, 0.3 * x - 0.2 * y);
    let middle = [[1.0, 1.0], [2.0, 1.2], [1.4, 2.0]];
    let inner = Polygon::new(&[middle.map(lift).to_vec()]).expect("an area");
    let ring = Polygon::new(&[rim.map(lift).to_vec(), middle.map(lift).to_vec()]).expect("an area");
    let triangle = Triangle {
        corners: middle.map(lift),
    };
    for i in 0..2000u32 {
        let [s, r] = uniform2(1, i);
        let [a, b] = [middle[i as usize % 3], middle[(i as usize + 1) % 3]];
        let on = lift([a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]);
        let from = DVec3::new(4.0 * r - 2.0, 5.0 * s - 1.0, 3.0 + r);
        let ray = Ray::new(from, (on - from).normalize());
        let shear = Shear::new(&ray);
        let hit = |found| matches!(found, Intersection::Hit { .. });
        let in_ring = hit(ring.intersect(&ray, &shear, Interval::FORWARD));
        let in_inner = hit(inner.intersect(&ray, &shear, Interval::FORWARD));
        let in_triangle = hit(triangle.intersect(&shear, Interval::FORWARD));
        assert_eq!(in_inner, in_triangle);
        assert!(in_ring != in_inner, "{ray:?}");
    }
}

#[test]
fn the_side_is_that_of_the_triangle() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let polygon = Polygon::new(&[corners.to_vec()]).expect("an area");
    let triangle = Triangle { corners };
    for (from, front) in [(1.0, true), (-1.0, false)] {
        for tilt in [-0.2, 0.0, 0.2] {
            let ray = Ray::new(DVec3::new(0.25, 0.25, from), DVec3::new(0.0, tilt, -from));
            let shear = Shear::new(&ray);
            assert_eq!(triangle.is_met_in_front(&shear), front);
            assert_eq!(polygon.is_met_in_front(&shear), front);
        }
    }
}

#[test]
fn a_pentagram_is_out_in_its_middle() {
    let tip = |i: usize| {
        let (sin, cos) = libm::sincos(f64::from(i as u32 * 2) * std::f64::consts::TAU / 5.0);
        [sin, cos]
    };
    let corners = [0, 1, 2, 3, 4].map(tip);
    let star = flat(&[&corners]);
    assert!(!hits(&star, [0.0, 0.0]));
    assert!(hits(&star, [0.0, 0.7]));
}

#[test]
fn repeated_and_collinear_corners_and_a_spike_without_width_change_nothing() {
    let plain = flat(&[&L]);
    let odd = flat(&[&[
        [0.0, 0.0],
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.5, 1.5],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ]]);
    for i in 0..40 {
        for j in 0..40 {
            let at = [f64::from(i) / 16.0 - 0.25, f64::from(j) / 16.0 - 0.25];
            assert_eq!(hits(&plain, at), hits(&odd, at), "{at:?}");
        }
    }
}

#[test]
fn a_hole_that_shares_a_corner_with_the_rim_takes_its_area() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let hole = [[0.0, 0.0], [2.0, 1.0], [1.0, 2.0]];
    let polygon = flat(&[&square, &hole]);
    assert_eq!(polygon.area_vector().z, 16.0 - 1.5);
    let count = 20_000;
    let inside = (0..count)
        .filter(|i| hits(&polygon, uniform2(7, *i).map(|x| 4.0 * x)))
        .count();
    let share = inside as f64 / f64::from(count);
    let expected = 14.5 / 16.0;
    let sigma = (expected * (1.0 - expected) / f64::from(count)).sqrt();
    assert!((share - expected).abs() < 3.0 * sigma, "{share}");
}

#[test]
fn a_ray_in_the_plane_and_a_needle() {
    let l = flat(&[&L]);
    let along = Ray::new(DVec3::new(-1.0, 0.5, 0.0), DVec3::X);
    let found = l.intersect(&along, &Shear::new(&along), Interval::FORWARD);
    assert_eq!(found, Intersection::Miss);
    let needle = flat(&[&[[0.0, 0.0], [1e8, 0.0], [1e8, 1.0], [0.0, 1.0]]]);
    assert!(hits(&needle, [5e7, 0.5]));
    assert!(!hits(&needle, [5e7, 1.0 + 1e-9]));
}

#[test]
fn planar_is_what_rounding_leaves_planar() {
    let turn = glam::DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let turned = |z: f64| {
        let corner = |[x, y]: [f64; 2]| turn * (DVec3::new(x, y, z * x * y) + DVec3::splat(10.0));
        Polygon::new(&[L.map(corner).to_vec()]).expect("an area")
    };
    assert!(turned(0.0).is_planar());
    assert!(!turned(1e-9).is_planar());
    assert!((turned(0.1).deviation() - 0.1).abs() < 0.1);
}
