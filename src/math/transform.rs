//! Affine transforms between an object's own space and the world.

use glam::{DAffine3, DMat3};

use super::rounding::gamma;
use super::{DVec3, Ray};

/// An affine map that can be undone, kept together with its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    to_world: DAffine3,
    to_object: DAffine3,
}

impl Transform {
    /// The transform and its inverse; `None` if it flattens space or holds a number that is not finite.
    pub fn new(to_world: DAffine3) -> Option<Self> {
        let to_object = to_world.inverse();
        let usable =
            to_world.is_finite() && to_world.matrix3.determinant() != 0.0 && to_object.is_finite();
        usable.then_some(Self {
            to_world,
            to_object,
        })
    }

    /// The map from object space to world space.
    pub fn to_world(&self) -> DAffine3 {
        self.to_world
    }

    /// A point of the object in the world.
    pub fn point(&self, p: DVec3) -> DVec3 {
        self.to_world.transform_point3(p)
    }

    /// A vector of the object in the world (no translation, length not kept).
    pub fn vector(&self, v: DVec3) -> DVec3 {
        self.to_world.transform_vector3(v)
    }

    /// A unit normal of the object as a unit normal in the world: by the transposed inverse, so that it stays at
    /// right angles to the surface when that is stretched.
    pub fn normal(&self, n: DVec3) -> DVec3 {
        self.gradient(n).normalize()
    }

    /// The gradient of an equation of the object, at a point of the world, from its gradient at the same point of the object: F is
    /// there what it is here, so by the chain rule the transposed inverse times it.
    pub fn gradient(&self, g: DVec3) -> DVec3 {
        self.to_object.matrix3.transpose() * g
    }

    /// A point of the world in the object's space.
    pub fn point_to_object(&self, p: DVec3) -> DVec3 {
        self.to_object.transform_point3(p)
    }

    /// A world-space ray in the object's space. The direction keeps its scale, so `t` means the same in both.
    pub fn ray_to_object(&self, ray: &Ray) -> Ray {
        Ray::new(
            self.to_object.transform_point3(ray.origin),
            self.to_object.transform_vector3(ray.direction),
        )
    }

    /// A bound for the error of `point(p)`, per axis, when `p` itself is off by at most `error` per axis:
    /// (gamma_3 + 1) |M| error + gamma_3 (|M| |p| + |translation|). Source: PBR 4th edition, section 6.8.5.
    pub fn point_error(&self, p: DVec3, error: DVec3) -> DVec3 {
        let m = &self.to_world.matrix3;
        let abs = DMat3::from_cols(m.x_axis.abs(), m.y_axis.abs(), m.z_axis.abs());
        (gamma(3) + 1.0) * (abs * error)
            + gamma(3) * (abs * p.abs() + self.to_world.translation.abs())
    }

    /// How much the map and its inverse together may magnify a relative error: |M| |M^-1| in the Frobenius norm. 3
    /// for turns and even scales, more for uneven ones.
    pub fn condition(&self) -> f64 {
        let norm = |m: &DMat3| {
            let squares = m.to_cols_array().map(|x| x * x);
            squares.iter().sum::<f64>().sqrt()
        };
        norm(&self.to_world.matrix3) * norm(&self.to_object.matrix3)
    }

    /// How many times as large as in its own space a volume is in world space.
    pub fn volume_ratio(&self) -> f64 {
        self.to_world.matrix3.determinant().abs()
    }

    /// True if the map turns right-handed frames into left-handed ones (a mirror image).
    pub fn flips_handedness(&self) -> bool {
        self.to_world.matrix3.determinant() < 0.0
    }

    /// If the map mirrors along the axes and does nothing else, what coordinates are multiplied with: 1 or -1.
    pub fn axis_mirror(&self) -> Option<DVec3> {
        let DAffine3 {
            matrix3,
            translation,
        } = self.to_world;
        let signs = DVec3::new(matrix3.x_axis.x, matrix3.y_axis.y, matrix3.z_axis.z);
        let mirrors = matrix3 == DMat3::from_diagonal(signs)
            && translation == DVec3::ZERO
            && signs.abs() == DVec3::ONE
            && self.flips_handedness();
        mirrors.then_some(signs)
    }

    /// If the map only moves, turns and scales evenly: the factor by which lengths grow.
    pub fn uniform_scale(&self) -> Option<f64> {
        let m = self.to_world.matrix3;
        let s = m.x_axis.length();
        let gram = m.transpose() * m;
        gram.abs_diff_eq(DMat3::from_diagonal(DVec3::splat(s * s)), 1e-14 * s * s)
            .then_some(s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_stay_at_right_angles_to_a_stretched_surface() {
        let t =
            Transform::new(DAffine3::from_scale(DVec3::new(1.0, 4.0, 1.0))).expect("invertible");
        let (tangent, normal) = (
            DVec3::new(1.0, -1.0, 0.0),
            DVec3::new(1.0, 1.0, 0.0).normalize(),
        );
        assert!(t.vector(tangent).dot(t.normal(normal)).abs() < 1e-15);
        assert_eq!(t.uniform_scale(), None);
    }

    #[test]
    fn a_mirror_along_axes_is_told_from_all_else() {
        let mirror = |x, y, z| {
            let map = Transform::new(DAffine3::from_scale(DVec3::new(x, y, z)));
            map.expect("invertible").axis_mirror()
        };
        assert_eq!(mirror(-1.0, 1.0, 1.0), Some(DVec3::new(-1.0, 1.0, 1.0)));
        assert_eq!(mirror(-1.0, -1.0, -1.0), Some(-DVec3::ONE));
        assert_eq!(mirror(-1.0, -1.0, 1.0), None);
        assert_eq!(mirror(-2.0, 1.0, 1.0), None);
        let moved = DAffine3::from_translation(DVec3::X) * DAffine3::from_scale(-DVec3::ONE);
        assert_eq!(
            Transform::new(moved).expect("invertible").axis_mirror(),
            None
        );
    }

    #[test]
    fn a_flattening_transform_is_refused() {
        assert!(Transform::new(DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0))).is_none());
        assert!(Transform::new(DAffine3::from_translation(DVec3::splat(f64::NAN))).is_none());
    }
}
