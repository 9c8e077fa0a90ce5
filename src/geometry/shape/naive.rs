//! A shape that is tested with other arithmetic than ours, to show what goes wrong then, and where.
//!
//! Nothing is built of these unless a user asks for it, so the usual way costs nothing. What the accelerators promise
//! stands on tests that are backward stable; these are not, so accelerators may differ where such shapes are hit near
//! an edge. They still end, and never panic.

use super::{Body, Shape};
use crate::geometry::arithmetic::{
    Arithmetic, Offset, Precision, Quadratic, TriangleTest, flat, quartic as fourth, real, sphere,
    triangle,
};
use crate::geometry::{Aabb, Intersection, Shear, SurfacePoint, Triangle};
use crate::math::rounding::gamma;
use crate::math::{DVec3, Interval, Ray};

/// The unit roundoff of single precision over that of double precision: 2^-24 / 2^-53.
const COARSER: f64 = (1u64 << 29) as f64;

/// A shape, and the arithmetic to test it with.
#[derive(Clone, Debug)]
pub struct Naive {
    /// The shape itself; never naive.
    pub shape: Shape,
    /// Its arithmetic.
    pub arithmetic: Arithmetic,
}

impl Naive {
    /// Where the ray first crosses the shape inside the interval, as the chosen arithmetic finds it.
    #[inline(never)]
    pub fn intersect(&self, ray: &Ray, shear: &Shear, interval: Interval) -> Intersection {
        self.intersect_shape(&self.shape, ray, shear, interval)
    }

    fn intersect_shape(
        &self,
        shape: &Shape,
        ray: &Ray,
        shear: &Shear,
        interval: Interval,
    ) -> Intersection {
        let Arithmetic {
            quadratic,
            precision,
            ..
        } = self.arithmetic;
        match (shape, precision) {
            (Shape::Triangle(corners), _) => self.intersect_triangle(corners, ray, shear, interval),
            (Shape::Mesh(mesh), _) => {
                let shear = &Shear::new(ray);
                mesh.intersect_with(ray, interval, |corners| {
                    self.intersect_triangle(corners, ray, shear, interval)
                })
            }
            (Shape::Sphere(ball), precision) => match (quadratic, precision) {
                (Quadratic::Naive, Precision::Single) => sphere::school::<f32>(ball, ray, interval),
                (Quadratic::Naive, Precision::Double) => sphere::school::<f64>(ball, ray, interval),
                (Quadratic::Stable, Precision::Single) => {
                    sphere::stable::<f32>(ball, ray, interval)
                }
                (Quadratic::Stable, Precision::Double) => ball.intersect(ray, interval),
            },
            (Shape::Plane(plane), Precision::Single) => flat::plane::<f32>(plane, ray, interval),
            (Shape::Disc(disc), Precision::Single) => flat::disc::<f32>(disc, ray, interval),
            (Shape::Cuboid(cuboid), Precision::Single) => {
                flat::cuboid::<f32>(cuboid, ray, interval)
            }
            (Shape::Transformed(transformed), _) => {
                let ray = transformed.transform.ray_to_object(ray);
                self.intersect_shape(&transformed.shape, &ray, &Shear::new(&ray), interval)
            }
            (Shape::Body(body), _) => self.intersect_body(body, ray, interval),
            (other, _) => other.intersect(ray, shear, interval),
        }
    }

    fn intersect_triangle(
        &self,
        corners: &Triangle,
        ray: &Ray,
        shear: &Shear,
        interval: Interval,
    ) -> Intersection {
        match (self.arithmetic.triangle, self.arithmetic.precision) {
            (TriangleTest::PlaneEdges, Precision::Single) => {
                triangle::plane_edges::<f32>(corners, ray, interval)
            }
            (TriangleTest::PlaneEdges, Precision::Double) => {
                triangle::plane_edges::<f64>(corners, ray, interval)
            }
            (TriangleTest::MollerTrumbore, Precision::Single) => {
                triangle::moller_trumbore::<f32>(corners, ray, interval)
            }
            (TriangleTest::MollerTrumbore, Precision::Double) => {
                triangle::moller_trumbore::<f64>(corners, ray, interval)
            }
            (TriangleTest::Watertight, Precision::Single) => {
                triangle::watertight(corners, ray, interval)
            }
            (TriangleTest::Watertight, Precision::Double) => corners.intersect(shear, interval),
        }
    }

    /// Bodies are tested in double precision always.
    fn intersect_body(&self, body: &Body, ray: &Ray, interval: Interval) -> Intersection {
        let Arithmetic {
            quadratic, quartic, ..
        } = self.arithmetic;
        match (body, quadratic) {
            (Body::Quadric(own), Quadratic::Naive) => own.school_intersect(ray, interval),
            (Body::BoxedQuadric(own), Quadratic::Naive) => own.school_intersect(ray, interval),
            (Body::Torus(own), _) => fourth::torus(own, ray, quartic).first(interval),
            (Body::Quartic(own), _) => fourth::quartic(own, ray, quartic).first(interval),
            (other, _) => other.intersect(ray, interval),
        }
    }

    /// The point at which the ray crosses the shape. Its error is what [`crate::math::rounding::offset_origin`] makes
    /// the chosen offset of, and only with the bounded offset a bound.
    #[inline(never)]
    pub fn surface(&self, ray: &Ray, t: f64, place: [f64; 3], part: u32) -> SurfacePoint {
        let mut surface = self.shape.surface(ray, t, place, part);
        let single = self.arithmetic.precision == Precision::Single;
        if self.arithmetic.offset != Offset::Bounded {
            surface.point = if single {
                real::at::<f32>(ray, t)
            } else {
                ray.at(t)
            };
        } else if single {
            surface.point = real::rounded::<f32>(surface.point);
        }
        surface.error = match self.arithmetic.offset {
            Offset::None => DVec3::ZERO,
            // The step along the normal is the sum of |n_k| error_k.
            Offset::Fixed(epsilon) => DVec3::splat(epsilon / surface.normal.abs().element_sum()),
            // The bounds are multiples of the unit roundoff; the ray and the shape are rounded as well.
            Offset::Bounded if single => {
                let rounded = DVec3::splat(gamma(4) * surface.point.abs().max_element());
                (surface.error + rounded) * COARSER
            }
            Offset::Bounded => surface.error,
        };
        surface
    }

    /// A box around the shape, grown by what rounding to the chosen precision may move it.
    pub fn bounds(&self) -> Option<Aabb> {
        let bounds = self.shape.bounds()?;
        if self.arithmetic.precision == Precision::Double {
            return Some(bounds);
        }
        let max_coordinate = bounds.min.abs().max(bounds.max.abs()).max_element();
        Some(bounds.padded(DVec3::splat(
            64.0 * f64::from(f32::EPSILON) * max_coordinate,
        )))
    }
}

impl Shape {
    /// The shape to be tested with this arithmetic; ours needs no wrapper.
    #[must_use]
    pub fn computed_with(&self, arithmetic: Arithmetic) -> Self {
        let shape = self.plain().clone();
        if arithmetic == Arithmetic::default() {
            return shape;
        }
        Self::Naive(Box::new(Naive { shape, arithmetic }))
    }

    /// The shape itself, whatever it is tested with.
    pub fn plain(&self) -> &Self {
        match self {
            Self::Naive(naive) => &naive.shape,
            shape => shape,
        }
    }
}

#[cfg(test)]
mod tests;
