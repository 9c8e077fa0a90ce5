//! What all cases share: how many rays, random numbers, meshes, and scenes from their text.

use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Hit, Intersection, Shape, Shear, Triangle};
use raytree::math::{DVec3, Interval, Ray};

pub use super::random::Random;
pub use crate::from_text::scene;

/// `full` rays in the long run, `share` of them in a plain `cargo test`.
pub fn count(full: usize, share: usize) -> usize {
    if std::env::var("RAYTREE_STABILITY").is_ok_and(|v| v == "full") {
        full
    } else {
        share
    }
}

/// A triangle mesh.
#[derive(Clone)]
pub struct Mesh {
    pub points: Vec<DVec3>,
    pub faces: Vec<[usize; 3]>,
}

impl Mesh {
    pub fn corners(&self, face: usize) -> [DVec3; 3] {
        self.faces[face].map(|i| self.points[i])
    }

    pub fn shapes(&self) -> Vec<Shape> {
        (0..self.faces.len())
            .map(|face| triangle(self.corners(face)))
            .collect()
    }

    /// Each point moved; a shared point stays one point.
    pub fn moved(mut self, map: impl Fn(DVec3) -> DVec3) -> Self {
        for p in &mut self.points {
            *p = map(*p);
        }
        self
    }

    /// A closed globe around the origin: two poles with `around` triangles each, and `rings` rings between them, pushed
    /// in and out by `bump` of the radius.
    pub fn globe(rings: usize, around: usize, bump: f64) -> Self {
        let mut points = vec![DVec3::Y, DVec3::NEG_Y];
        for i in 1..=rings {
            let theta = std::f64::consts::PI * i as f64 / (rings + 1) as f64;
            for j in 0..around {
                let phi = std::f64::consts::TAU * j as f64 / around as f64;
                let r = 1.0 + bump * libm::sin(7.0 * theta) * libm::cos(5.0 * phi);
                let flat = libm::sin(theta);
                let p = DVec3::new(
                    flat * libm::sin(phi),
                    libm::cos(theta),
                    flat * libm::cos(phi),
                );
                points.push(r * p);
            }
        }
        let at = |ring: usize, j: usize| 2 + ring * around + j % around;
        let mut faces = Vec::new();
        for j in 0..around {
            faces.push([0, at(0, j), at(0, j + 1)]);
            faces.push([1, at(rings - 1, j + 1), at(rings - 1, j)]);
            for ring in 0..rings - 1 {
                let (a, b) = (at(ring, j), at(ring + 1, j));
                let (c, d) = (at(ring + 1, j + 1), at(ring, j + 1));
                faces.push([a, b, c]);
                faces.push([a, c, d]);
            }
        }
        Self { points, faces }
    }
}

pub fn triangle(corners: [DVec3; 3]) -> Shape {
    Shape::Triangle(Triangle { corners })
}

/// One shape against one ray, everything before its origin left out.
pub fn test(shape: &Shape, ray: &Ray) -> Intersection {
    shape.intersect(ray, &Shear::new(ray), Interval::FORWARD)
}

pub fn hits(shape: &Shape, ray: &Ray) -> bool {
    matches!(test(shape, ray), Intersection::Hit { .. })
}

/// A ray from `origin` through `target`; `None` if they are the same.
pub fn towards(origin: DVec3, target: DVec3) -> Option<Ray> {
    Some(Ray::new(origin, (target - origin).try_normalize()?))
}

/// A hit as bits, so that equal means identical.
pub fn bits(hit: &Hit) -> (u32, u64, [u64; 3]) {
    let weights = hit.place.map(f64::to_bits);
    (hit.primitive, hit.t.to_bits(), weights)
}

/// Every accelerator over the shapes, the list first.
pub fn all(shapes: &[Shape]) -> Vec<(AccelKind, Accel)> {
    AccelKind::ALL
        .into_iter()
        .map(|kind| (kind, Accel::build(kind, shapes)))
        .collect()
}
