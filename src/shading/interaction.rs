//! The place where a ray meets a surface, with all that shading asks for. Built once, after the closest hit is known.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::SurfacePoint;
use crate::math::rounding::offset_origin;
use crate::math::{DVec2, DVec3};

/// Which side of a surface the ray came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// The outside: the geometric normal points against the ray.
    Front,
    /// The inside.
    Back,
}

/// A ray's arrival at a surface. Both normals are unit and face the side that the ray came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    /// The point, in world space.
    pub point: DVec3,
    /// How far the true surface may be from it, per axis.
    pub error: DVec3,
    /// V: the unit vector back along the ray.
    pub to_viewer: DVec3,
    /// The normal of the shape itself: it decides on which side a direction is.
    pub geometric_normal: DVec3,
    /// N, for shading: blended from the corners of a smooth mesh, else the geometric one.
    pub normal: DVec3,
    /// The side that the ray came to.
    pub side: Side,
    /// Surface coordinates.
    pub uv: DVec2,
}

impl Interaction {
    /// The arrival of a ray with unit `direction` at `surface`. `shading_normal`, outwards and unit, is that of a
    /// smooth mesh; where it would face away from the viewer (at the silhouette of a coarse mesh) the geometric
    /// normal takes its place.
    pub fn new(surface: &SurfacePoint, direction: DVec3, shading_normal: Option<DVec3>) -> Self {
        let side = if surface.normal.dot(direction) <= 0.0 {
            Side::Front
        } else {
            Side::Back
        };
        let facing = |n: DVec3| if side == Side::Front { n } else { -n };
        let geometric_normal = facing(surface.normal);
        let normal = shading_normal
            .map(facing)
            .filter(|n| n.dot(direction) < 0.0)
            .unwrap_or(geometric_normal);
        Self {
            point: surface.point,
            error: surface.error,
            to_viewer: -direction,
            geometric_normal,
            normal,
            side,
            uv: surface.uv,
        }
    }

    /// Arrival at a flat surface: N is the geometric normal.
    #[must_use]
    pub fn flat(self) -> Self {
        Self {
            normal: self.geometric_normal,
            ..self
        }
    }

    /// How far off the computed point the true surface may lie, along its normal.
    pub fn normal_error(&self) -> f64 {
        self.geometric_normal.abs().dot(self.error)
    }

    /// Hit point with an error that reaches at least this far along the normal.
    #[must_use]
    pub fn with_normal_error(mut self, error: f64) -> Self {
        let more = (error - self.normal_error()).max(0.0);
        // n is unit, so |n|.(more |n|) = more.
        self.error += more * self.geometric_normal.abs();
        self
    }

    /// The origin of a ray that leaves along `direction`: clear of the surface, on the side that it goes to.
    #[inline]
    pub fn origin_towards(&self, direction: DVec3) -> DVec3 {
        offset_origin(self.point, self.error, self.geometric_normal, direction)
    }
}
