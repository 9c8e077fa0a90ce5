//! What is found in a mesh does not depend on its tree, and a use of it lies where its triangles would.

use std::sync::Arc;

use glam::{DAffine3, DQuat};
use proptest::prelude::*;

use super::*;
use crate::geometry::{Shape, Transformed};
use crate::math::Transform;

/// Numbers of which many are equal, so that rays run in planes and through corners, and others.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![(-4..=4_i32).prop_map(|n| f64::from(n) * 0.5), -2.0..2.0_f64]
}

fn point() -> impl Strategy<Value = DVec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn triangles(most: usize) -> impl Strategy<Value = Vec<Triangle>> {
    let one = (point(), point(), point()).prop_map(|(a, b, c)| Triangle { corners: [a, b, c] });
    prop::collection::vec(one, 1..most)
}

fn ray() -> impl Strategy<Value = Ray> {
    (point(), point())
        .prop_filter("a direction", |(_, d)| *d != DVec3::ZERO)
        .prop_map(|(o, d)| Ray::new(o * 2.0, d))
}

/// The hit with the smallest t, and of equal t the first: by a loop over all.
fn by_loop(triangles: &[Triangle], ray: &Ray, interval: Interval) -> Option<(f64, u32, [f64; 3])> {
    let shear = Shear::new(ray);
    let hits = triangles.iter().zip(0..).filter_map(|(triangle, part)| {
        match triangle.intersect(&shear, interval) {
            Intersection::Hit { t, place, .. } => Some((t, part, place)),
            _ => None,
        }
    });
    hits.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
}

fn found(intersection: Intersection) -> Option<(f64, u32, [f64; 3])> {
    match intersection {
        Intersection::Hit { t, place, part } => Some((t, part, place)),
        _ => None,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_tree_finds_what_a_loop_finds(triangles in triangles(40), rays in prop::collection::vec(ray(), 16), end in number()) {
        let mesh = SharedMesh::new(triangles.clone());
        for ray in &rays {
            for interval in [Interval::FORWARD, Interval::LINE, Interval::before(end)] {
                let wanted = by_loop(&triangles, ray, interval);
                prop_assert_eq!(found(mesh.intersect(ray, interval)), wanted);
            }
        }
    }

    #[test]
    fn a_point_lies_on_its_triangle_in_the_world(
        triangles in triangles(20), ray in ray(), turn in point(), by in point(), size in prop::sample::select(vec![1e-4, 1.0, 1e4]), mirrored: bool
    ) {
        let flip = DVec3::new(if mirrored { -size } else { size }, size, size);
        let turn = DQuat::from_scaled_axis(turn);
        let map = Transform::new(DAffine3::from_scale_rotation_translation(flip, turn, by * 10.0)).expect("can be undone");
        let shape = Shape::Transformed(Box::new(Transformed {
            shape: Shape::Mesh(Arc::new(SharedMesh::new(triangles))),
            transform: map,
        }));
        // Towards a point of the first triangle, so that something is met as a rule.
        let [a, b, c] = shape.triangle(0).expect("a triangle").corners;
        let origin = map.point(ray.origin);
        let direction = (0.3 * a + 0.3 * b + 0.4 * c - origin).normalize_or(DVec3::X);
        let ray = Ray::new(origin, direction);
        let hit = shape.intersect(&ray, &Shear::new(&ray), Interval::FORWARD);
        let Some((t, part, place)) = found(hit) else { return Ok(()); };
        let surface = shape.surface(&ray, t, place, part);
        let triangle = shape.triangle(part).expect("a triangle");
        let Some(normal) = triangle.normal() else { return Ok(()); };
        // On the plane of the triangle in the world, within the error that is told.
        let off = (surface.point - triangle.corners[0]).dot(normal).abs();
        prop_assert!(off <= surface.error.dot(normal.abs()), "{off:e}");
        // The triangle of the world runs counter-clockwise around the normal of the surface.
        let thin = triangle.corners.map(|c| c.abs().max_element()).into_iter().fold(0.0, f64::max) * 1e-6;
        let [a, b, c] = triangle.corners;
        if (b - a).cross(c - a).length() > thin * (b - a).length().max((c - a).length()) {
            prop_assert!(surface.normal.dot(normal) > 1.0 - 1e-6);
        }
    }
}

#[test]
fn triangles_that_cannot_be_told_apart_make_a_tree_of_few_levels() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let mesh = SharedMesh::new(vec![Triangle { corners }; 100_000]);
    let ray = Ray::new(DVec3::new(0.2, 0.2, 1.0), -DVec3::Z);
    assert_eq!(
        found(mesh.intersect(&ray, Interval::FORWARD)).map(|f| (f.0, f.1)),
        Some((1.0, 0))
    );
    // The middles of the others come ever closer to a point: each cut leaves most of them on one side.
    let far = |i: i32| Triangle {
        corners: corners.map(|c| c * 1e-3 * 0.5_f64.powi(i) + DVec3::X * 0.5_f64.powi(i)),
    };
    let mesh = SharedMesh::new((0..900).map(far).collect());
    let ray = Ray::new(far(500).corners[0] + DVec3::Z, -DVec3::Z);
    let wanted = by_loop(mesh.triangles(), &ray, Interval::FORWARD);
    assert_eq!(found(mesh.intersect(&ray, Interval::FORWARD)), wanted);
}

#[test]
fn a_search_leaves_most_triangles_out() {
    let sheet: Vec<Triangle> = (0..10_000)
        .map(|i| {
            let at = DVec3::new(f64::from(i % 100), f64::from(i / 100), 0.0);
            Triangle {
                corners: [at, at + DVec3::X, at + DVec3::Y],
            }
        })
        .collect();
    let mesh = SharedMesh::new(sheet);
    let ray = Ray::new(DVec3::new(50.2, 50.2, 3.0), -DVec3::Z);
    let steps = mesh.steps(&ray, Interval::FORWARD);
    assert!(steps.triangles <= 8 && steps.boxes <= 60, "{steps:?}");
    assert!(mesh.bytes() < 10_000 * 120);
}

#[test]
fn nothing_is_found_in_nothing() {
    let mesh = SharedMesh::new(Vec::new());
    let ray = Ray::new(DVec3::Z, -DVec3::Z);
    assert_eq!(mesh.intersect(&ray, Interval::FORWARD), Intersection::Miss);
    assert!(mesh.bounds().is_empty());
}
