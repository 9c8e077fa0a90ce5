//! The triangle, watertight: no ray slips between two triangles that share an edge, and none hits both.
//!
//! Source: Woop, Benthin and Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1); with exact signs and a tie
//! rule, so that a ray through an edge or a corner crosses a closed mesh an odd number of times.

use super::edge::edge;
use super::{Aabb, Intersection, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval, Ray};

/// A flat triangle. Outwards is the side from which the corners run counter-clockwise.
///
/// Without texture coordinates of its own, (u, v) are the weights of corners b and c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The corners a, b, c.
    pub corners: [DVec3; 3],
}

/// The ray's own view: coordinates in which the ray starts at the origin and runs along +z.
///
/// It depends on the ray alone, so a vertex shared by two triangles gets the same coordinates in both: that is what
/// makes the test watertight.
#[derive(Clone, Copy, Debug)]
pub struct Shear {
    /// The ray's origin.
    pub origin: DVec3,
    /// The axes that take the parts of x, y and z: z is where the direction is longest.
    pub axes: [usize; 3],
    /// x' = x - s.x z, y' = y - s.y z, z' = s.z z.
    pub s: DVec3,
}

impl Shear {
    /// No view, for shapes that are tested without one: whatever is seen in it is NaN.
    pub const NONE: Self = Self {
        origin: DVec3::NAN,
        axes: [0, 1, 2],
        s: DVec3::NAN,
    };

    /// The view along `ray`.
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let d = ray.direction;
        let [x, y, z] = Self::axes(d);
        Self {
            origin: ray.origin,
            axes: [x, y, z],
            s: DVec3::new(d[x] / d[z], d[y] / d[z], 1.0 / d[z]),
        }
    }

    /// The axes that take the parts of x, y and z along direction `d`.
    #[inline]
    pub fn axes(d: DVec3) -> [usize; 3] {
        let abs = d.abs();
        let z = if abs.x > abs.y && abs.x > abs.z {
            0
        } else if abs.y > abs.z {
            1
        } else {
            2
        };
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        // A direction against the axis would turn the winding over; swapping x and y turns it back.
        if d[z] < 0.0 { [y, x, z] } else { [x, y, z] }
    }

    /// A point in the ray's view; z is its ray parameter.
    #[inline]
    pub(super) fn view(&self, p: DVec3) -> DVec3 {
        let p = (p - self.origin).to_array();
        let [x, y, z] = self.axes;
        let (x, y, z) = (p[x], p[y], p[z]);
        DVec3::new(x - self.s.x * z, y - self.s.y * z, self.s.z * z)
    }
}

/// The triangle seen along the ray: on which side of each edge the ray passes.
#[derive(Clone, Copy, Debug)]
pub struct Edges {
    /// The edge functions opposite to a, b and c: twice the areas that the ray cuts off, with sign.
    pub functions: [f64; 3],
    /// The corners' ray parameters.
    depths: [f64; 3],
    /// True if the ray passes all three edges on the same side.
    pub inside: bool,
}

impl Triangle {
    /// The edge functions of the ray whose view `shear` is. (Always inlined, as the test around it: left to the compiler, that
    /// depends on code that has nothing to do with it.)
    #[inline(always)]
    pub fn edges(&self, shear: &Shear) -> Edges {
        let [a, b, c] = self.corners;
        let (a, b, c) = (shear.view(a), shear.view(b), shear.view(c));
        let ((u, on_u), (v, on_v), (w, on_w)) = (edge(b, c), edge(c, a), edge(a, b));
        let mut functions = [u, v, w];
        let inside = on_u == on_v && on_v == on_w;
        // A sliver, or a triangle seen nearly edge-on: what is left of the products is mostly rounding, and the
        // point with these weights would not be on the ray. Compute them again, each to its last bits.
        let area = (u + v + w).abs();
        if inside && area < CANCELLED * (products(b, c) + products(c, a) + products(a, b)) {
            functions = [precise(b, c), precise(c, a), precise(a, b)];
        }
        Edges {
            functions,
            depths: [a.z, b.z, c.z],
            inside,
        }
    }

    /// Of a ray that crosses the triangle: true if it comes from where the corners run counter-clockwise. The side of any one
    /// edge tells, as exactly as it is known.
    pub fn is_met_in_front(&self, shear: &Shear) -> bool {
        let [_, b, c] = self.corners;
        edge(shear.view(b), shear.view(c)).1
    }

    /// The crossing inside the interval. A triangle seen edge-on, or without area, is missed.
    #[inline(always)]
    pub fn intersect(&self, shear: &Shear, interval: Interval) -> Intersection {
        let Edges {
            functions: [u, v, w],
            depths,
            inside,
        } = self.edges(shear);
        let area = u + v + w;
        if !inside || area == 0.0 {
            return Intersection::Miss;
        }
        // The weights of the corners are the areas opposite to them; t is their depth, weighted.
        let barycentric = [u / area, v / area, w / area];
        let t = (u * depths[0] + v * depths[1] + w * depths[2]) / area;
        Intersection::classify(t, barycentric, interval)
    }

    /// The point with these weights: more exact than origin + t direction, whose error grows with t.
    ///
    /// The point itself is within gamma_7 sum |b_i p_i| (PBR 4th edition, section 6.8.4). A ray that leaves it must
    /// not find the triangle again, so the bound covers the next test as well, which is right for a triangle that is
    /// moved by 40 u of its largest coordinate: on every axis, since it is the longest that the others inherit.
    pub fn surface(&self, barycentric: [f64; 3]) -> SurfacePoint {
        let [a, b, c] = self.corners;
        let [u, v, w] = barycentric;
        let max_coordinate = a.abs().max(b.abs()).max(c.abs()).max_element();
        SurfacePoint {
            point: u * a + v * b + w * c,
            error: DVec3::splat(gamma(64) * max_coordinate),
            normal: self.normal().unwrap_or(DVec3::Y),
            uv: DVec2::new(v, w),
        }
    }

    /// The unit normal (b - a) x (c - a) / |..|; `None` for a triangle without area.
    pub fn normal(&self) -> Option<DVec3> {
        let [a, b, c] = self.corners;
        let (e, f) = (b - a, c - a);
        let normal = e.cross(f);
        let square = normal.length_squared();
        if square > 1e-200 && square < 1e200 {
            return Some(normal / square.sqrt());
        }
        // Scaled first, so that the product neither overflows nor vanishes for very large and very small triangles.
        let size = e.abs().max_element().max(f.abs().max_element());
        (e / size).cross(f / size).try_normalize()
    }

    /// The smallest box around the corners.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.corners)
    }
}

/// If the areas add up to less than this part of the products that they are differences of, too many bits are gone.
pub const CANCELLED: f64 = 1.0 / 64.0;

/// How large the products in an edge function are.
fn products(p: DVec3, q: DVec3) -> f64 {
    (q.x * p.y).abs() + (q.y * p.x).abs()
}

/// The edge function within 2 u of its value, however much cancels.
/// Source: Kahan; Jeannerod, Louvet and Muller 2013, "Further analysis of Kahan's algorithm".
fn precise(p: DVec3, q: DVec3) -> f64 {
    let n = q.y * p.x;
    let rest = (-q.y).mul_add(p.x, n);
    q.x.mul_add(p.y, -n) + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Triangle {
        Triangle {
            corners: [a, b, c].map(DVec3::from),
        }
    }

    fn test(t: &Triangle, origin: DVec3, direction: DVec3) -> Intersection {
        t.intersect(&Shear::new(&Ray::new(origin, direction)), Interval::FORWARD)
    }

    fn hits(t: &Triangle, origin: DVec3, direction: DVec3) -> bool {
        matches!(test(t, origin, direction), Intersection::Hit { .. })
    }

    #[test]
    fn t_and_weights_are_those_known_on_paper() {
        let t = triangle([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]);
        let Intersection::Hit {
            t,
            place: barycentric,
            ..
        } = test(&t, DVec3::new(1.0, 2.0, 5.0), DVec3::NEG_Z)
        else {
            panic!("inside");
        };
        assert_eq!((t, barycentric), (5.0, [0.25, 0.25, 0.5]));
    }

    #[test]
    fn a_ray_through_a_shared_edge_or_corner_hits_exactly_one() {
        // A square of four triangles around its middle, seen from six sides with both windings.
        let ring = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        for axis in 0..3 {
            for flip in [false, true] {
                let lift = |[x, y]: [f64; 2]| {
                    let mut p = DVec3::ZERO;
                    p[(axis + 1) % 3] = if flip { y } else { x };
                    p[(axis + 2) % 3] = if flip { x } else { y };
                    p
                };
                let fan: Vec<Triangle> = (0..4)
                    .map(|i| Triangle {
                        corners: [DVec3::ZERO, lift(ring[i]), lift(ring[(i + 1) % 4])],
                    })
                    .collect();
                for target in [[0.0, 0.0], [0.5, 0.0], [0.0, -0.25], [0.125, 0.0]] {
                    for side in [1.0, -1.0] {
                        let mut d = DVec3::ZERO;
                        d[axis] = -side;
                        let from = lift(target) - 3.0 * d;
                        let count = fan.iter().filter(|t| hits(t, from, d)).count();
                        assert_eq!(count, 1, "axis {axis}, flip {flip}, at {target:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_weighted_point_is_on_the_ray_even_in_a_sliver() {
        // Long slivers a few floats wide, met at random places: however little of the edge functions is left, the
        // point with these weights must be where the ray is.
        let mut state = 1u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut met = 0;
        for _ in 0..4000 {
            let along = DVec3::new(random(), random(), random());
            let aside = DVec3::new(random(), -random(), random()) * 1e-15;
            let (a, b, c) = (-along, along + aside, along * 0.3 - aside * 2.0);
            let sliver = Triangle { corners: [a, b, c] };
            let target = a * 0.2 + b * 0.3 + c * 0.5;
            let direction = DVec3::new(random(), random(), -1.0).normalize();
            let ray = Ray::new(target - 3.0 * direction, direction);
            let shear = Shear::new(&ray);
            if let Intersection::Hit {
                t,
                place: barycentric,
                ..
            } = sliver.intersect(&shear, Interval::FORWARD)
            {
                met += 1;
                let off = (sliver.surface(barycentric).point - ray.at(t)).length();
                assert!(off < 1e-14, "{off:e} at t = {t}");
            }
        }
        assert!(met > 400, "{met}");
    }

    #[test]
    fn what_has_no_area_is_never_hit() {
        let flat = triangle([0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]);
        let point = triangle([0.0; 3], [0.0; 3], [0.0; 3]);
        for t in [flat, point] {
            assert!(!hits(&t, DVec3::new(0.5, 0.5, 1.0), DVec3::NEG_Z));
            assert!(!hits(&t, DVec3::new(0.0, 0.0, 1.0), DVec3::NEG_Z));
            assert_eq!(t.normal(), None);
        }
        // Edge-on: the ray runs in the triangle's plane.
        let wall = triangle([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        assert!(!hits(&wall, DVec3::new(0.0, 0.2, 5.0), DVec3::NEG_Z));
    }

    #[test]
    fn the_bad_case_of_pbrt_is_missed() {
        let x = -1_113.454_59;
        let t = triangle(
            [x, -79.049_614, -56.243_190_8],
            [x, -87.092_269_9, -56.243_190_8],
            [x, -79.209_014_9, -56.243_190_8],
        );
        let origin = DVec3::new(-1_081.479_25, 99.999_954_2, 87.770_111_1);
        let direction = DVec3::new(-32.107_299_8, -183.355_865, -144.607_635);
        assert!(!hits(&t, origin, direction));
    }

    #[test]
    fn rays_that_are_none_miss() {
        let t = triangle([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        for bad in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
            assert!(!hits(&t, DVec3::new(0.2, 0.2, 1.0), bad));
            assert!(!hits(&t, DVec3::NAN, DVec3::NEG_Z));
        }
    }
}
