//! The quartic: any surface of degree 4, cut off by a box.

use super::pieces::{Pieces, pieces, point_at, spans};
use super::{Aabb, Cut, Intersection, Spans, SurfacePoint};
use crate::math::polynomial::{Evaluation, bernstein, evaluate};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval, Ray};

/// All points of a box where F(x, y, z) <= 0, F a polynomial of degree 4. Outwards is where F grows; the box's faces close it.
///
/// The coefficients stand in POV-Ray's order: by falling power of x, then of y, then of z, the constant last: x^4, x^3 y, x^3 z,
/// x^3, x^2 y^2, x^2 y z, x^2 y, x^2 z^2, x^2 z, x^2, x y^3, ..., z^2, z, 1. F is best centred: far from the origin, its terms
/// cancel.
///
/// Part 0 is the surface F = 0 (the wall); parts 1 to 6 are the faces at low x, high x, low y, high y, low z, high z. On the
/// wall u and v are those of a sphere around the box's middle; on a face they run from 0 to 1 along the next two axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartic {
    /// The 35 coefficients.
    pub coefficients: [f64; 35],
    /// The box.
    pub bounds: Aabb,
}

/// All numbers of a quartic's test against one ray. Places on the ray are counted from `middle`.
#[derive(Clone, Debug, PartialEq)]
pub struct QuarticSteps {
    /// The t to which the ray's origin is moved: the middle of its way through the box.
    pub middle: f64,
    /// The moved origin.
    pub origin: DVec3,
    /// Where the line comes into the box and where it goes out, as t on the ray; `None` if it misses the box.
    pub faces: Option<[Cut; 2]>,
    /// The polynomial along the ray, lowest power first.
    pub coefficients: [f64; 5],
    /// Its Bernstein coefficients in the box. If all are above zero, there is no search.
    pub bernstein: [f64; 5],
    /// The monotone pieces of the polynomial, with their crossings.
    pub pieces: Pieces,
}

impl QuarticSteps {
    /// The spans that follow from the pieces.
    pub fn spans(&self) -> Spans {
        match self.faces {
            Some(faces) => spans(&self.pieces, self.middle, faces),
            None => Spans::none(),
        }
    }
}

impl Quartic {
    /// The box itself, which holds all of the solid, a little wider.
    pub fn bounds(&self) -> Aabb {
        let Aabb { min, max } = self.bounds;
        self.bounds.padded(gamma(16) * min.abs().max(max.abs()))
    }

    /// The first crossing inside the interval.
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        self.spans(ray).first(interval)
    }

    /// The spans of the ray's line inside the solid, three at most. A touch from outside is none.
    pub fn spans(&self, ray: &Ray) -> Spans {
        self.arithmetic(ray).spans()
    }

    /// Every step of the test: as [`super::Torus::arithmetic`], but the line starts and ends at the box, where it may be inside,
    /// and its origin is moved to the middle between.
    pub fn arithmetic(&self, ray: &Ray) -> QuarticSteps {
        self.arithmetic_with(ray, |quartic, moved, _, x| quartic.along(moved, x))
    }

    /// The test with the polynomial's own signs and roots, not polished: for comparison.
    pub(in crate::geometry) fn arithmetic_unpolished(&self, ray: &Ray) -> QuarticSteps {
        self.arithmetic_with(ray, |_, _, polynomial, x| {
            let Evaluation { value, slope, .. } = evaluate(polynomial, x);
            [value, slope]
        })
    }

    /// The steps, where `surface` gives F and its slope at a place on the moved ray.
    #[inline]
    fn arithmetic_with(
        &self,
        ray: &Ray,
        surface: impl Fn(&Self, &Ray, &[f64; 5], f64) -> [f64; 2],
    ) -> QuarticSteps {
        let mut steps = QuarticSteps {
            middle: 0.0,
            origin: ray.origin,
            faces: None,
            coefficients: [0.0; 5],
            bernstein: [0.0; 5],
            pieces: Pieces::new(),
        };
        let Some([enter, leave]) = self.faces(ray) else {
            return steps;
        };
        steps.middle = 0.5 * (enter.t + leave.t);
        steps.origin = point_at(ray, steps.middle);
        let moved = Ray::new(steps.origin, ray.direction);
        // The same faces as seen from there, where nothing cancels.
        let Some(faces) = self.faces(&moved) else {
            return steps;
        };
        let reach = faces.map(|cut| cut.t);
        steps.faces = Some(faces.map(|cut| Cut {
            t: steps.middle + cut.t,
            ..cut
        }));
        steps.coefficients = self.coefficients_along(&moved);
        steps.bernstein = bernstein(&steps.coefficients, reach);
        // All terms together are below `largest` in the box, and below 4^4 times that in the sums of `bernstein`: they take the
        // origin, half the way and the whole way together. Each passes 64 roundings at most. To be generous costs time only.
        let rounding = gamma(64) * self.largest();
        if steps.bernstein.iter().all(|&b| b > 256.0 * rounding) {
            return steps;
        }
        let polynomial = steps.coefficients;
        let along = |x| {
            let [value, slope] = surface(self, &moved, &polynomial, x);
            Evaluation {
                value,
                slope,
                rounding,
            }
        };
        let inside = reach.map(|x| along(x).value < 0.0);
        steps.pieces = pieces(&polynomial, reach, inside, along);
        steps
    }

    /// Where the ray's line comes into the box, and where it goes out: the last of the three slabs that it enters, the first that
    /// it leaves. Source: Kay and Kajiya 1986.
    fn faces(&self, ray: &Ray) -> Option<[Cut; 2]> {
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let (min, max) = (self.bounds.min.to_array(), self.bounds.max.to_array());
        let cut = |t, part| Cut { t, part };
        let mut enter = cut(f64::NEG_INFINITY, 0);
        let mut leave = cut(f64::INFINITY, 0);
        for axis in 0..3 {
            if d[axis] == 0.0 {
                // Along the slab: inside it for ever, or never.
                if o[axis] <= min[axis] || o[axis] >= max[axis] {
                    return None;
                }
                continue;
            }
            let part = 2 * axis as u32 + 1;
            let low = cut((min[axis] - o[axis]) / d[axis], part);
            let high = cut((max[axis] - o[axis]) / d[axis], part + 1);
            let (near, far) = if d[axis] > 0.0 {
                (low, high)
            } else {
                (high, low)
            };
            enter = if near.t > enter.t { near } else { enter };
            leave = if far.t < leave.t { far } else { leave };
        }
        (enter.t < leave.t && enter.part > 0 && leave.part > 0).then_some([enter, leave])
    }

    /// F by Horner's rule in z, within that in y, within that in x: POV-Ray's order of the coefficients is just that.
    ///
    /// `times(value, axis)` multiplies by the coordinate of an axis. A value is an array, a coefficient is added to its first
    /// element: so the same walk gives F at a point, F and its gradient, and F along a ray.
    #[inline]
    fn nested<const N: usize>(
        coefficients: &[f64; 35],
        times: impl Fn([f64; N], usize) -> [f64; N],
    ) -> [f64; N] {
        let plus = |a: [f64; N], b: [f64; N]| -> [f64; N] { std::array::from_fn(|i| a[i] + b[i]) };
        let mut next = 0;
        let mut in_x = [0.0; N];
        for x in (0..=4).rev() {
            let mut in_y = [0.0; N];
            for y in (0..=4 - x).rev() {
                let mut in_z = [0.0; N];
                for _ in 0..=4 - x - y {
                    in_z = times(in_z, 2);
                    in_z[0] += coefficients[next];
                    next += 1;
                }
                in_y = plus(times(in_y, 1), in_z);
            }
            in_x = plus(times(in_x, 0), in_y);
        }
        in_x
    }

    /// F at a point.
    pub fn value(&self, p: DVec3) -> f64 {
        let [value] = Self::nested(&self.coefficients, |[v], axis| [v * p[axis]]);
        value
    }

    /// The gradient of F.
    pub fn gradient(&self, p: DVec3) -> DVec3 {
        let [_, x, y, z] = self.value_and_gradient(p);
        DVec3::new(x, y, z)
    }

    /// F and its gradient, by the product rule: (v p_k)' = v' p_k + v along axis k.
    fn value_and_gradient(&self, p: DVec3) -> [f64; 4] {
        Self::nested(&self.coefficients, |v: [f64; 4], axis| {
            let mut product = v.map(|value| value * p[axis]);
            product[1 + axis] += v[0];
            product
        })
    }

    /// F along a ray as a polynomial in t, lowest power first: each coordinate is o + t d.
    pub fn coefficients_along(&self, ray: &Ray) -> [f64; 5] {
        Self::nested(&self.coefficients, |v: [f64; 5], axis| {
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            std::array::from_fn(|k| {
                if k > 0 {
                    o * v[k] + d * v[k - 1]
                } else {
                    o * v[0]
                }
            })
        })
    }

    /// F at t, and its slope along the ray.
    fn along(&self, ray: &Ray, t: f64) -> [f64; 2] {
        let (p, d) = (ray.at(t), ray.direction);
        Self::nested(&self.coefficients, |[value, slope], axis| {
            [value * p[axis], slope * p[axis] + value * d[axis]]
        })
    }

    /// The sum of the absolute values of all terms of F at a point.
    fn size_of_terms(&self, p: DVec3) -> f64 {
        let p = p.abs();
        let [size] = Self::nested(&self.coefficients.map(f64::abs), |[v], axis| [v * p[axis]]);
        size
    }

    /// The most that the terms of F can sum up to in the box.
    fn largest(&self) -> f64 {
        self.size_of_terms(self.bounds.min.abs().max(self.bounds.max.abs()))
    }

    /// The point at `t` of a part: on a face exactly; on the wall after one Newton step along the gradient.
    ///
    /// The bound on the wall: a term of F passes 4 products and 15 sums, here and in the next test, so F is wrong by gamma_64
    /// (sum of |terms|) at most, and the surface seems to move by that over |grad F|. The next test's place o' + x d has four
    /// roundings of numbers up to the box's largest coordinate. Where the gradient vanishes the surface has no normal, and
    /// the bound is the size of the box.
    pub fn surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        let at = point_at(ray, t);
        if part > 0 {
            return self.surface_of_face(at, part);
        }
        let Aabb { min, max } = self.bounds;
        let size = self.bounds.size().max_element();
        let [value, x, y, z] = self.value_and_gradient(at);
        let gradient = DVec3::new(x, y, z);
        let step = gradient * (value / gradient.length_squared());
        let is_step = step.is_finite() && step.length() < size;
        let point = if is_step { at - step } else { at };
        let gradient = self.gradient(point);
        let of_value = gamma(64) * self.size_of_terms(point) / gradient.length();
        let error = of_value + gamma(8) * min.abs().max(max.abs()).max_element();
        let normal = gradient.normalize_or(DVec3::Y);
        let from_middle = (point - self.bounds.center()).normalize_or(DVec3::Y);
        SurfacePoint {
            point: point.clamp(min, max),
            error: DVec3::splat(error.min(size)),
            normal,
            uv: DVec2::new(
                libm::atan2(-from_middle.z, from_middle.x) / std::f64::consts::TAU + 0.5,
                libm::acos((-from_middle.y).clamp(-1.0, 1.0)) / std::f64::consts::PI,
            ),
        }
    }

    /// The point of a face of the box, as [`super::Cuboid::surface`] gives it. Rounding moves it along the face, never off.
    fn surface_of_face(&self, at: DVec3, part: u32) -> SurfacePoint {
        let Aabb { min, max } = self.bounds;
        let axis = ((part - 1) / 2).min(2) as usize;
        let is_high = part.is_multiple_of(2);
        let mut point = at.clamp(min, max);
        let mut normal = DVec3::ZERO;
        point[axis] = if is_high { max[axis] } else { min[axis] };
        normal[axis] = if is_high { 1.0 } else { -1.0 };
        // In the next test the moved origin is rounded, the difference to the face (twice the largest coordinate), the quotient,
        // and the sum of both t.
        let mut error = gamma(16) * min.abs().max(max.abs());
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        (error[i], error[j]) = (0.0, 0.0);
        let place = |k: usize| (point[k] - min[k]) / (max[k] - min[k]);
        SurfacePoint {
            point,
            error,
            normal,
            uv: DVec2::new(place(i), place(j)),
        }
    }
}

#[cfg(test)]
mod tests;
