//! What becomes of polygons that are cut, all the way down the tree.

use num_rational::BigRational;

use super::*;
use crate::geometry::Triangle;
use crate::math::DVec3;
use crate::sampling::stream::{splitmix64, to_unit_f64};

/// A part of a polygon at the end of its way down, and the planes on that way, each with the side that it is on.
struct Fragment {
    item: Item,
    way: Vec<(Splitter, bool)>,
}

/// The fragments of all shapes, made by the steps of [`Builder::grow`].
fn fragments(shapes: &[Shape], polygons: bool) -> Vec<Fragment> {
    let (mut builder, root) = Builder::new(shapes, polygons);
    let mut work = vec![(root, Vec::new())];
    let mut found = Vec::new();
    while let Some((task, way)) = work.pop() {
        let mut keep = |item: &Item| {
            found.push(Fragment {
                item: item.clone(),
                way: way.clone(),
            });
        };
        let Some((plane, sides)) = builder.choose(&task) else {
            task.items.iter().for_each(keep);
            builder.push(&task.items);
            continue;
        };
        let on = task
            .items
            .iter()
            .zip(&sides)
            .filter(|(_, side)| **side == PlaneSide::On);
        on.for_each(|(item, _)| keep(item));
        let [back, front] = builder.split(task, &plane, &sides);
        for (child, is_front) in [(back, false), (front, true)] {
            work.push((child, [&way[..], &[(plane, is_front)]].concat()));
        }
    }
    assert_eq!(found.len(), builder.tree.references.len());
    found
}

/// Twice the area of a convex polygon.
fn area(corners: &[DVec3]) -> f64 {
    let from = |p: &DVec3| *p - corners[0];
    let parts = corners.windows(2).map(|w| from(&w[0]).cross(from(&w[1])));
    parts.sum::<DVec3>().length()
}

/// n.p - d without any rounding.
fn exact_distance(plane: &Splitter, p: DVec3) -> BigRational {
    let exact = |x: f64| BigRational::from_float(x).expect("a finite number");
    let products = (0..3).map(|i| exact(plane.normal[i]) * exact(p[i]));
    products.fold(-exact(plane.d), |sum, product| sum + product)
}

/// Triangles in a cube of edge 3 around `middle`, a third of it in size; every third is as good as a line, every fifth has a corner
/// one float over the plane of the triangle before it.
fn triangles(count: usize, middle: DVec3) -> Vec<Shape> {
    let number = |i: usize| 2.0 * to_unit_f64(splitmix64(i as u64)) - 1.0;
    let point = |i: usize| middle + DVec3::new(number(3 * i), number(3 * i + 1), number(3 * i + 2));
    let mut all: Vec<[DVec3; 3]> = Vec::new();
    for i in 0..count {
        let near = point(1000 + i);
        let [a, b, mut c] = [0, 1, 2].map(|k| near + 0.5 * (point(3 * i + k) - middle));
        if i % 3 == 0 {
            c = a.lerp(b, 0.4) + 1e-9 * (c - middle);
        }
        if let (0, Some(before)) = (i % 5, all.last()) {
            c = before[0].lerp(before[1], 0.3);
            c.x = c.x.next_up();
        }
        all.push([a, b, c]);
    }
    let shape = |corners| Shape::Triangle(Triangle { corners });
    all.into_iter().map(shape).collect()
}

/// Source: cases 34 and 37 of `tests/stability`. Expected: nothing of a polygon is lost and nothing is there twice, every part
/// is where the tree says, and there are not too many of them.
#[test]
fn the_fragments_of_a_polygon_are_the_polygon() {
    for (offset, polygons) in [(0.0, false), (0.0, true), (1e6, false), (1e6, true)] {
        let shapes = triangles(120, offset * DVec3::new(1.0, -0.7, 0.3));
        let found = fragments(&shapes, polygons);
        let reach = offset + 1.5;
        let mut areas = vec![0.0; shapes.len()];
        for Fragment { item, way } in &found {
            assert!(item.corners.len() >= 3, "{:?}", item.corners);
            areas[item.primitive as usize] += area(&item.corners);
            for (plane, is_front) in way {
                // Two tolerances: one that counts as on the plane, one for the cuts that follow.
                let allowed = BigRational::from_float(-64.0 * UNIT_ROUNDOFF * reach);
                let allowed = allowed.expect("a finite number");
                for &corner in &item.corners {
                    let distance = exact_distance(plane, corner);
                    let inwards = if *is_front { distance } else { -distance };
                    assert!(inwards >= allowed, "{plane:?}, {corner}: {inwards}");
                }
            }
        }
        for (shape, sum) in shapes.iter().zip(&areas) {
            let Shape::Triangle(Triangle { corners }) = shape else {
                panic!("they are all triangles");
            };
            let whole = area(corners);
            assert!((sum - whole).abs() < 1e-12 * reach, "{sum} of {whole}");
        }
        let (parts, most) = (found.len(), MAX_REFERENCES * shapes.len());
        assert!(parts > shapes.len() && parts <= most, "{parts}");
    }
}

/// Source: case 37 of `tests/stability`. Expected: a corner that is over a polygon's plane by a float is on it.
#[test]
fn a_polygon_a_float_over_a_plane_is_not_on_both_sides() {
    let number = |i: usize| 8.0 * to_unit_f64(splitmix64(i as u64));
    let wall = [[1.0, -9.0, -9.0], [1.0, 9.0, -9.0], [1.0, 0.0, 9.0]].map(DVec3::from);
    let wall = Shape::Triangle(Triangle { corners: wall });
    let (over, reach) = (1.0f64.next_up(), 9.0);
    let plane = Splitter::of_triangle(0, &wall, 32.0 * UNIT_ROUNDOFF * reach);
    let plane = plane.expect("it has area");
    for i in 0..1000 {
        let at = |x: f64, k: usize| DVec3::new(x, number(6 * i + k), number(6 * i + k + 3));
        let corners = [at(over, 0), at(1.0, 1), at(-1.0, 2)];
        let shape = Shape::Triangle(Triangle { corners });
        let item = Item::whole(1, &shape).expect("it has an end");
        assert_ne!(plane.side(&item), PlaneSide::Both, "{corners:?}");
    }
}
