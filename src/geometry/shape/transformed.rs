//! A shape that was turned, stretched or moved: it is tested in its own space.

use super::{Aabb, Intersection, Shape, Shear, SurfacePoint};
use crate::math::{DVec3, Interval, Ray, Transform};

/// A shape in its own space, and the way from there into the world.
#[derive(Clone, Debug)]
pub struct Transformed {
    /// The shape in object space.
    pub shape: Shape,
    /// Object space to world space.
    pub transform: Transform,
}

impl Transformed {
    /// See [`Shape::intersect`]: t means the same in both spaces.
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        let ray = self.transform.ray_to_object(ray);
        match &self.shape {
            // It needs no shear.
            Shape::Body(body) => body.intersect(&ray, interval),
            other => other.intersect(&ray, &Shear::new(&ray), interval),
        }
    }

    /// See [`Shape::enters`].
    #[inline(never)]
    pub fn enters(&self, ray: &Ray, t: f64) -> Option<bool> {
        let ray = self.transform.ray_to_object(ray);
        self.shape.enters(&ray, &Shear::new(&ray), t)
    }

    /// The point at `t`.
    pub fn surface(&self, ray: &Ray, t: f64, place: [f64; 3], part: u32) -> SurfacePoint {
        let ray = self.transform.ray_to_object(ray);
        self.in_world(self.shape.surface(&ray, t, place, part))
    }

    /// See [`Shape::bare_surface`].
    pub fn bare_surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        let ray = self.transform.ray_to_object(ray);
        self.in_world(self.shape.bare_surface(&ray, t, part))
    }

    /// A point of the shape in the world. The next test takes the way back as well: the inverse is only known as well as the
    /// transform is conditioned, and a turn brings the error of each axis to all others.
    fn in_world(&self, local: SurfacePoint) -> SurfacePoint {
        let error = self.transform.point_error(local.point, local.error);
        let there_and_back = 1.0 + 2.0 * self.transform.condition();
        SurfacePoint {
            point: self.transform.point(local.point),
            error: DVec3::splat(there_and_back * error.max_element()),
            normal: self.transform.normal(local.normal),
            uv: local.uv,
        }
    }

    /// See [`Shape::gradient`].
    pub fn gradient(&self, point: DVec3, part: u32) -> Option<DVec3> {
        let local = self.transform.point_to_object(point);
        let gradient = self.shape.gradient(local, part)?;
        Some(self.transform.gradient(gradient))
    }

    /// The box around the shape; `None` if it is endless.
    pub fn bounds(&self) -> Option<Aabb> {
        let bounds = self.shape.bounds()?;
        Some(bounds.transformed(&self.transform))
    }
}
