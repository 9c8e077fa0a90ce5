//! Scenes that are built in parts answer like all others.

use std::sync::Mutex;

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Shape, Sphere, Triangle};
use raytree::math::{DVec3, Interval, Ray};

use super::agree_on;
use crate::random::Random;

/// Those that are built in parts.
const IN_PARTS: [AccelKind; 2] = [AccelKind::Kd, AccelKind::Wide];

/// More than one part of either has room for.
const COUNT: usize = 20_000;

/// A triangle around a place, `size` large.
fn triangle(random: &mut Random, at: DVec3, size: f64) -> Shape {
    Shape::Triangle(Triangle {
        corners: [0; 3].map(|_| at + size * random.direction()),
    })
}

/// Small triangles everywhere; among them spheres, and triangles that reach through the whole scene.
fn mixed(random: &mut Random) -> Vec<Shape> {
    let shape = |i| {
        let at = random.point();
        match i % 1000 {
            0 => triangle(random, at, 2.0),
            1 => Shape::Sphere(Sphere {
                center: at,
                radius: 0.05,
            }),
            _ => triangle(random, at, 0.02),
        }
    };
    (0..COUNT).map(shape).collect()
}

/// Many triangles in one and the same place, and one far away.
fn heap(random: &mut Random) -> Vec<Shape> {
    let one = triangle(random, DVec3::ZERO, 0.3);
    let mut shapes = vec![one; COUNT];
    shapes.push(triangle(random, DVec3::X, 0.3));
    shapes
}

#[test]
fn scenes_in_parts_answer_as_the_list_does() {
    let mut random = Random(12);
    for make in [mixed, heap] {
        let shapes = make(&mut random);
        let ray = |_| {
            let (from, to) = (2.0 * random.direction(), 0.8 * random.point());
            let ray = Ray::new(from, (to - from).normalize());
            (ray, Interval::FORWARD)
        };
        let rays: Vec<_> = (0..300).map(ray).collect();
        assert_eq!(agree_on(&IN_PARTS, &shapes, &rays), Ok(()));
    }
}

#[test]
fn who_waits_is_told_how_far_it_is() {
    let shapes = mixed(&mut Random(3));
    for kind in IN_PARTS {
        let told = Mutex::new(vec![0.0]);
        Accel::build_with_progress(kind, &shapes, &|done| told.lock().unwrap().push(done));
        let told = told.into_inner().unwrap();
        assert!(told.len() > 1 && told.is_sorted(), "{kind:?}: {told:?}");
        assert!(told.last().is_some_and(|done| *done <= 1.0));
    }
}
