//! Neighbour: what a transparent sphere touches from outside at most, as the floor that it rests on.
//!
//! Where such a sphere is met far from all of them, its own surface alone decides which media meet there: a line crosses each
//! of them in front of that point or behind it, a solid as often in as out.

use crate::geometry::{Shape, Sphere};
use crate::math::{DVec3, Ray};
use crate::scene::Scene;
use crate::shading::Interaction;

/// What is near, as a part of the size of all that is measured: far more than rounding moves a surface, or a crossing on a ray that
/// does not graze.
const NEAR: f64 = 1e-5;

/// How deep touching surfaces may be in each other by rounding, as a part of their size.
const OVERLAP: f64 = 1e-12;

/// Cosine below which a ray grazes: what it meets at the same point may then be far along the ray.
const GRAZING: f64 = 1e-3;

/// Surface near a sphere.
#[derive(Clone, Copy, Debug)]
pub enum Neighbour {
    /// A sphere beside it.
    Sphere(Sphere),
    /// A plane n.p = d, all of it on one side.
    Plane(DVec3, f64),
}

impl Neighbour {
    /// The neighbours of the object `of`, if it is a sphere and all these `others` are outside of it: spheres, or opaque planes.
    pub fn all(scene: &Scene, of: usize, others: impl Iterator<Item = usize>) -> Option<Vec<Self>> {
        let sphere = match single(scene, of)? {
            Shape::Sphere(sphere) => *sphere,
            _ => return None,
        };
        others
            .map(|other| Self::outside(scene, &sphere, other))
            .collect()
    }

    fn outside(scene: &Scene, sphere: &Sphere, other: usize) -> Option<Self> {
        let is_transmissive =
            scene.materials[scene.objects[other].material as usize].is_transmissive();
        let found = match single(scene, other)? {
            Shape::Sphere(other) => Self::Sphere(*other),
            Shape::Plane(plane) if !is_transmissive => {
                Self::Plane(plane.normal(), plane.normal().dot(plane.origin()))
            }
            _ => return None,
        };
        let gap = found.distance(sphere.center) - sphere.radius;
        let is_outside = match found {
            Self::Sphere(other) => sphere.center.distance(other.center) > other.radius,
            Self::Plane(..) => true,
        };
        (is_outside && gap >= -OVERLAP * found.size(sphere.center)).then_some(found)
    }

    /// Distance of a point from the surface.
    fn distance(&self, point: DVec3) -> f64 {
        match self {
            Self::Sphere(sphere) => (point.distance(sphere.center) - sphere.radius).abs(),
            Self::Plane(normal, d) => (normal.dot(point) - d).abs(),
        }
    }

    /// The largest number that such a distance is computed from.
    fn size(&self, point: DVec3) -> f64 {
        let own = match self {
            Self::Sphere(sphere) => sphere.center.abs().max_element() + sphere.radius,
            Self::Plane(_, d) => d.abs(),
        };
        own + point.abs().max_element()
    }
}

/// True if no neighbour can be met together with the point `at` that a ray meets at `t`.
pub fn is_clear(neighbours: &[Neighbour], ray: &Ray, t: f64, at: &Interaction) -> bool {
    let way = ray.origin.abs().max_element() + t;
    at.geometric_normal.dot(at.to_viewer) > GRAZING
        && neighbours
            .iter()
            .all(|neighbour| neighbour.distance(at.point) > NEAR * (neighbour.size(at.point) + way))
}

/// The shape of an object that is one sphere or plane, as it stands in the scene.
fn single(scene: &Scene, object: usize) -> Option<&Shape> {
    match scene.shapes_of(object as u32) {
        [shape] => Some(shape),
        _ => None,
    }
}
