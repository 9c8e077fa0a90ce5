//! An orthonormal right-handed frame.

use super::DVec3;

/// Three unit vectors at right angles, `u x v = w`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// To the right, seen against `w`.
    pub u: DVec3,
    /// Upwards.
    pub v: DVec3,
    /// Towards the viewer.
    pub w: DVec3,
}

impl Frame {
    /// The frame whose `w` points along `w` and whose `v` lies as near to `up` as it can; `None` if `w` is zero or
    /// `up` is parallel to it, so that no such frame exists.
    pub fn from_w_up(w: DVec3, up: DVec3) -> Option<Self> {
        let w = w.try_normalize()?;
        // u = up x w has length sin(angle) for unit vectors; under 1e-9 the direction of u is noise.
        let u = up.try_normalize()?.cross(w);
        if u.length() < 1e-9 {
            return None;
        }
        let u = u.normalize();
        Some(Self {
            u,
            v: w.cross(u),
            w,
        })
    }

    /// A frame around the unit vector `w` where nothing says which way is up: the axis that is farthest from `w`
    /// takes that part, z before y before x, so that a floor's u runs along x and its v along -z.
    pub fn around(w: DVec3) -> Self {
        let a = w.abs();
        let up = if a.z <= a.x && a.z <= a.y {
            DVec3::NEG_Z
        } else if a.y <= a.x {
            DVec3::Y
        } else {
            DVec3::X
        };
        let u = up.cross(w).normalize();
        Self {
            u,
            v: w.cross(u),
            w,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floor_has_u_along_x() {
        let frame = Frame::around(DVec3::Y);
        assert_eq!((frame.u, frame.v), (DVec3::X, DVec3::NEG_Z));
    }

    #[test]
    fn no_frame_without_a_direction_or_an_up() {
        assert!(Frame::from_w_up(DVec3::Z, DVec3::Z * 3.0).is_none());
        assert!(Frame::from_w_up(DVec3::ZERO, DVec3::Y).is_none());
        let frame = Frame::from_w_up(DVec3::Z, DVec3::new(0.0, 2.0, 5.0)).expect("not parallel");
        assert!((frame.u - DVec3::X).length() < 1e-15 && (frame.v - DVec3::Y).length() < 1e-15);
    }
}
