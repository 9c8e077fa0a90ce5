//! The convex polyhedron: what lies behind all of its planes.

mod mesh;

use crate::geometry::{Aabb, Span, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Frame, Ray};
use mesh::ConvexMesh;

/// A convex solid with flat faces, made of a closed mesh.
///
/// u and v are metres along two axes of the face that is met, as on a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyhedron {
    /// The middle: planes are kept relative to it, so that a body far from the origin loses nothing.
    center: DVec3,
    faces: Vec<Face>,
    /// The mesh that it is made of.
    points: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    bounds: Aabb,
    /// The distance of the farthest corner from the middle.
    radius: f64,
}

/// The points p with n.(p - center) <= d.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Face {
    n: DVec3,
    d: f64,
}

impl Polyhedron {
    /// The solid inside a closed convex mesh of triangles, given by their corners' numbers, all wound the same way round.
    /// Errors, in words that go behind its name: a corner that is not there or not finite, a mesh that is not closed, a flat
    /// one, one that is not convex.
    pub fn new(points: &[DVec3], triangles: &[[u32; 3]]) -> Result<Self, String> {
        let mesh = ConvexMesh::new(points, triangles)?;
        let faces = mesh.faces()?;
        let ConvexMesh {
            center,
            bounds,
            radius,
            reach,
            ..
        } = mesh;
        Ok(Self {
            center,
            faces,
            points: points.to_vec(),
            triangles: triangles.to_vec(),
            bounds: bounds.padded(DVec3::splat(gamma(16) * reach)),
            radius,
        })
    }

    /// The part of the ray's line inside: it enters with the last plane that it goes behind, and leaves with the first that it
    /// comes out of. Source: Haines 1991, "Fast ray-convex polyhedron intersection", Graphics Gems II.
    pub fn span(&self, ray: &Ray) -> Option<Span> {
        let origin = ray.origin - self.center;
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for face in &self.faces {
            let (speed, ahead) = face.along(origin, ray.direction);
            if speed == 0.0 && ahead >= 0.0 {
                // Along the plane, behind it.
                continue;
            }
            let t = ahead / speed;
            if t.is_nan() || speed == 0.0 {
                return None;
            }
            if speed < 0.0 {
                enter = enter.max(t);
            } else {
                leave = leave.min(t);
            }
        }
        (enter < leave).then(|| Span::between(enter, leave))
    }

    /// The point at `t`, pulled back into the plane that is crossed there.
    ///
    /// The bound covers: the point's rounding (u |p|), the plane's own at the pull back and at the next test (3 u radius each,
    /// and u |p| when the middle is taken away); and how far the normal's rounding turns the plane, 4 u radius.
    pub fn surface(&self, ray: &Ray, t: f64) -> SurfacePoint {
        let origin = ray.origin - self.center;
        let face = self.face_at(origin, ray.direction, t);
        let at = origin + t * ray.direction;
        let local = at - (face.n.dot(at) - face.d) * face.n;
        let Frame { u, v, w } = Frame::around(face.n);
        SurfacePoint {
            point: self.center + local,
            error: DVec3::splat(gamma(16) * self.radius) + gamma(4) * self.center.abs(),
            normal: w,
            uv: DVec2::new(u.dot(local), v.dot(local)),
        }
    }

    /// The face whose plane is crossed at `t`, to the bit; else the nearest.
    fn face_at(&self, origin: DVec3, direction: DVec3, t: f64) -> Face {
        let off = |face: &Face| {
            let (speed, ahead) = face.along(origin, direction);
            let off = (ahead / speed - t).abs();
            if off.is_nan() { f64::INFINITY } else { off }
        };
        let nearer = |a: &&Face, b: &&Face| off(a).total_cmp(&off(b));
        let anything = Face {
            n: DVec3::Y,
            d: 0.0,
        };
        self.faces
            .iter()
            .min_by(nearer)
            .copied()
            .unwrap_or(anything)
    }

    /// The box around the corners, a little wider.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The mesh that it is made of: points, and triangles between them.
    pub fn mesh(&self) -> (&[DVec3], &[[u32; 3]]) {
        (&self.points, &self.triangles)
    }

    /// How many planes it has.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }
}

impl Face {
    /// How fast a ray comes out of the plane, and how far it is ahead of the origin: the crossing is at t = ahead / speed.
    fn along(&self, origin: DVec3, direction: DVec3) -> (f64, f64) {
        (self.n.dot(direction), self.d - self.n.dot(origin))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    fn corner_of_space(at: DVec3) -> Vec<DVec3> {
        [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]
            .map(|p| p + at)
            .to_vec()
    }

    /// The six faces of a box as triangles.
    fn box_mesh() -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let unit = Aabb {
            min: DVec3::ZERO,
            max: DVec3::ONE,
        };
        let sides = Aabb::SIDES.map(|side| side.map(|corner| corner as u32));
        let halves = sides
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
        (unit.corners().to_vec(), halves.collect())
    }

    #[test]
    fn a_tetrahedron_is_crossed_where_it_is_on_paper() {
        for at in [DVec3::ZERO, DVec3::splat(1_048_576.0)] {
            let solid =
                Polyhedron::new(&corner_of_space(at), &TETRAHEDRON).expect("closed, convex");
            assert_eq!(solid.face_count(), 4);
            let ray = Ray::new(at + DVec3::new(0.25, 0.25, -1.0), DVec3::Z * 2.0);
            let span = solid.span(&ray).expect("through it");
            assert_eq!([span.enter.t, span.leave.t], [0.5, 0.75]);
            let top = solid.surface(&ray, 0.75);
            assert!((top.normal - DVec3::ONE.normalize()).length() < 1e-15);
            assert_eq!(solid.surface(&ray, 0.5).normal, DVec3::NEG_Z);
            let beside = Ray::new(at + DVec3::new(0.75, 0.75, -1.0), DVec3::Z);
            assert_eq!(solid.span(&beside), None);
        }
    }

    #[test]
    fn the_winding_may_be_either_but_must_be_one() {
        let points = corner_of_space(DVec3::ZERO);
        let turned = TETRAHEDRON.map(|[a, b, c]| [a, c, b]);
        assert_eq!(
            Polyhedron::new(&points, &turned).map(|p| p.face_count()),
            Ok(4)
        );
        let mut mixed = TETRAHEDRON;
        mixed[0].swap(0, 1);
        assert!(Polyhedron::new(&points, &mixed).is_err());
    }

    #[test]
    fn a_box_has_six_planes() {
        let (points, triangles) = box_mesh();
        let solid = Polyhedron::new(&points, &triangles).expect("closed, convex");
        assert_eq!(solid.face_count(), 6);
    }

    #[test]
    fn what_is_no_convex_body_is_refused() {
        let (points, triangles) = box_mesh();
        let told = |points: &[DVec3], triangles: &[[u32; 3]]| {
            Polyhedron::new(points, triangles).expect_err("no convex body")
        };
        assert!(told(&points, &triangles[1..]).contains("closed"));
        assert!(told(&points, &[]).contains("no triangles"));
        let flat = points.iter().map(|p| p.with_z(0.0)).collect::<Vec<_>>();
        assert!(told(&flat, &triangles).contains("flat"));
        let mut dented = points.clone();
        dented[7] = DVec3::splat(0.25);
        assert!(told(&dented, &triangles).contains("convex"));
        assert!(told(&points[1..], &triangles).contains("only 7 points"));
        dented[7] = DVec3::NAN;
        assert!(told(&dented, &triangles).contains("finite"));
    }

    #[test]
    fn a_triangle_that_is_thinner_than_rounding_cuts_nothing_off() {
        // A pyramid whose base is split at a point beside its diagonal, by rounding only.
        let s = 1.0 / 3.0;
        let points = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.5, 0.5, 1.0],
            [s, s + 1e-17, 1e-17],
        ];
        let triangles = [
            [0, 1, 4],
            [1, 2, 4],
            [2, 3, 4],
            [3, 0, 4],
            [0, 5, 1],
            [5, 2, 1],
            [0, 3, 5],
            [5, 3, 2],
        ];
        let solid = Polyhedron::new(&points.map(DVec3::from), &triangles).expect("closed, convex");
        let ray = Ray::new(DVec3::new(0.5, 0.5, -1.0), DVec3::Z);
        let span = solid.span(&ray).expect("through its middle");
        assert!((span.leave.t - 2.0).abs() < 1e-15 && (span.enter.t - 1.0).abs() < 1e-15);
    }
}
