//! The torus: a ring, by a polynomial of degree 4 that is solved where it keeps its digits.
//!
//! The answers are those for a torus that was moved by 24 u (R + r) at most (see [`Torus::surface`]), from any distance; only t
//! itself is rounded to its own size.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::pieces::{Pieces, pieces, point_at, spans};
use super::{Aabb, Cut, Intersection, Spans, SurfacePoint};
use crate::math::polynomial::{Evaluation, bernstein, evaluate};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval, Ray};

/// All points at distance `minor` from a circle of radius `major` around the y axis, in the plane y = 0: the torus' own frame.
/// Inside is what is nearer to the circle. Outwards is away from it.
///
/// If `minor` is larger than `major`, the tube runs through the axis (a spindle): what it would cover there once more, the
/// "lemon", is inside and no surface.
///
/// u runs once around the y axis, v once around the tube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    /// The radius R of the circle, above 0.
    pub major: f64,
    /// The radius r of the tube, above 0.
    pub minor: f64,
}

/// Why a ray misses a torus without a search for crossings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorusMiss {
    /// The ray's line misses the ball of radius R + r or the slab |y| < r, or both at once.
    Reach,
    /// All Bernstein coefficients are above zero.
    Bernstein,
}

/// All numbers of a torus' test against one ray. Places on the ray are counted from `closest`.
#[derive(Clone, Debug, PartialEq)]
pub struct TorusSteps {
    /// The t to which the ray's origin is moved: where it is closest to the torus' centre.
    pub closest: f64,
    /// The moved origin.
    pub origin: DVec3,
    /// The part of the line that the ball and the slab leave. Its ends are outside. Empty (from 0 to 0) if they leave nothing.
    pub reach: [f64; 2],
    /// The polynomial, lowest power first.
    pub coefficients: [f64; 5],
    /// Its Bernstein coefficients over `reach`.
    pub bernstein: [f64; 5],
    /// Why the line misses, if that was seen before the search.
    pub quick_miss: Option<TorusMiss>,
    /// The monotone pieces of the polynomial, with their crossings.
    pub pieces: Pieces,
}

impl TorusSteps {
    /// The number of evaluations for all crossings, before and after polishing.
    pub fn steps(&self) -> [u32; 2] {
        let crossings = self.pieces.iter().filter_map(|piece| piece.crossing);
        crossings.fold([0, 0], |[plain, polished], crossing| {
            [
                plain + crossing.plain.steps,
                polished + crossing.polished.steps,
            ]
        })
    }

    /// The spans that follow from the pieces.
    pub fn spans(&self) -> Spans {
        // Both ends of the line are outside, so no span starts or ends there.
        let nowhere = Cut {
            t: f64::NAN,
            part: 0,
        };
        spans(&self.pieces, self.closest, [nowhere; 2])
    }
}

impl Torus {
    /// The first crossing inside the interval.
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        self.spans(ray).first(interval)
    }

    /// The spans of the ray's line inside the torus, two at most. A touch is none.
    pub fn spans(&self, ray: &Ray) -> Spans {
        self.arithmetic(ray).spans()
    }

    /// Every step of the test.
    ///
    /// 1. The ray's origin is moved to o' = o + t_c d, t_c = -(o.d)/(d.d). From far away, the polynomial's coefficients would
    ///    be large numbers that cancel. A fused multiply-add rounds o' once, so it lies at t_c exactly but for a rounding of
    ///    its own size: the distance of the origin costs no digit but those of t_c + crossing in the end.
    /// 2. What lies outside of the ball and the slab around the torus is outside.
    /// 3. The polynomial; if its Bernstein coefficients are all above zero, the ray misses.
    /// 4. Its monotone pieces, in each the crossing. Both ends are *set* to be outside, so there is an even number of crossings.
    pub fn arithmetic(&self, ray: &Ray) -> TorusSteps {
        self.arithmetic_with(ray, |torus, moved, _, x| torus.along(moved, x))
    }

    /// The test with the polynomial's own signs and roots, not polished: for comparison.
    pub(in crate::geometry) fn arithmetic_unpolished(&self, ray: &Ray) -> TorusSteps {
        self.arithmetic_with(ray, |torus, moved, polynomial, x| {
            let mut found = evaluate(polynomial, x);
            // Where g < 0, in the lemon, f g is above zero and the place inside all the same.
            let lemon = (torus.minor - torus.major) * (torus.minor + torus.major);
            if moved.at(x).length_squared() < lemon {
                found.value = -found.value.abs();
            }
            found
        })
    }

    /// The steps, where `surface` says what is inside at a place on the moved ray.
    #[inline]
    fn arithmetic_with(
        &self,
        ray: &Ray,
        surface: impl Fn(&Self, &Ray, &[f64; 5], f64) -> Evaluation,
    ) -> TorusSteps {
        let d = ray.direction;
        let closest = -ray.origin.dot(d) / d.length_squared();
        let mut steps = TorusSteps {
            closest,
            origin: point_at(ray, closest),
            reach: [0.0; 2],
            coefficients: [0.0; 5],
            bernstein: [0.0; 5],
            quick_miss: None,
            pieces: Pieces::new(),
        };
        let moved = Ray::new(steps.origin, d);
        let Some(reach) = self.reach(&moved) else {
            steps.quick_miss = Some(TorusMiss::Reach);
            return steps;
        };
        steps.reach = reach;
        steps.coefficients = self.coefficients(&moved);
        steps.bernstein = bernstein(&steps.coefficients, reach);
        // With s = R + r, all terms of the polynomial are below 8 s^4 in the ball, and below 81 times that in the sums of
        // `bernstein`, which take |from| and the width together; each passes 50 roundings at most. To be generous costs time
        // only: such a ray is searched.
        let rounding = gamma(50 * 81 * 8) * (self.major + self.minor).powi(4);
        if steps.bernstein.iter().all(|&b| b > rounding) {
            steps.quick_miss = Some(TorusMiss::Bernstein);
            return steps;
        }
        let polynomial = steps.coefficients;
        let along = |x| surface(self, &moved, &polynomial, x);
        steps.pieces = pieces(&polynomial, reach, [false; 2], along);
        steps
    }

    /// The part of the ray's line that lies in the ball of radius R + r and in the slab |y| < r; `None` if there is none.
    fn reach(&self, ray: &Ray) -> Option<[f64; 2]> {
        let (o, d) = (ray.origin, ray.direction);
        let radius = self.major + self.minor;
        let (a, b) = (d.length_squared(), o.dot(d));
        let discriminant = b * b - a * (o.length_squared() - radius * radius);
        if discriminant.is_nan() || discriminant <= 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let [mut from, mut to] = [(-b - root) / a, (-b + root) / a];
        if d.y != 0.0 {
            let (t0, t1) = ((-self.minor - o.y) / d.y, (self.minor - o.y) / d.y);
            from = from.max(t0.min(t1));
            to = to.min(t0.max(t1));
        } else if o.y.abs() >= self.minor {
            return None;
        }
        (from < to).then_some([from, to])
    }

    /// The torus as a polynomial along the ray, lowest power first:
    /// (p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), where p = o + t d. It is f g, where f = (rho - R)^2 + y^2 - r^2 is zero
    /// on the surface, and g = (rho + R)^2 + y^2 - r^2 is zero on the lemon of a spindle only.
    pub fn coefficients(&self, ray: &Ray) -> [f64; 5] {
        let (o, d) = (ray.origin, ray.direction);
        // p.p + R^2 - r^2 = a t^2 + 2 b t + c, and x^2 + z^2 = a' t^2 + 2 b' t + c'.
        let [a, b] = [d.length_squared(), o.dot(d)];
        let c = o.length_squared() + (self.major - self.minor) * (self.major + self.minor);
        let across = |u: DVec3, v: DVec3| u.x * v.x + u.z * v.z;
        let m = 4.0 * self.major * self.major;
        [
            c * c - m * across(o, o),
            4.0 * b * c - 2.0 * m * across(o, d),
            2.0 * a * c + 4.0 * b * b - m * across(d, d),
            4.0 * a * b,
            a * a,
        ]
    }

    /// f = (rho - R)^2 + y^2 - r^2 at t, rho = sqrt(x^2 + z^2). It is what the polynomial stands for, but loses no digits on the
    /// surface: it is rounded as if the point had been moved by gamma_8 (R + r), see [`Torus::surface`]. Its sign is right in
    /// the lemon of a spindle, too: inside.
    #[inline]
    fn along(&self, ray: &Ray, t: f64) -> Evaluation {
        let (p, d) = (ray.at(t), ray.direction);
        let rho = (p.x * p.x + p.z * p.z).sqrt();
        let ring = rho - self.major;
        // Across the axis, where rho is 0, the slope jumps.
        let rho_slope = if rho > 0.0 {
            (p.x * d.x + p.z * d.z) / rho
        } else {
            0.0
        };
        Evaluation {
            value: ring * ring + (p.y - self.minor) * (p.y + self.minor),
            slope: 2.0 * (ring * rho_slope + p.y * d.y),
            rounding: 2.0 * self.minor * gamma(8) * (self.major + self.minor),
        }
    }

    /// The nearest point of the circle in the tube's middle. On the axis all of them are as near; it is that on the x axis.
    fn nearest_on_circle(&self, p: DVec3) -> DVec3 {
        let rho = (p.x * p.x + p.z * p.z).sqrt();
        if rho > 0.0 {
            DVec3::new(p.x / rho, 0.0, p.z / rho) * self.major
        } else {
            DVec3::X * self.major
        }
    }

    /// The point at `t`, pulled back to distance r from the circle.
    ///
    /// The bound: on its way from o to f, the next test rounds the moved origin (1 u of it), the product and the sum of
    /// o' + x d (2), rho (2), R off rho (1) and the sum t_c + x (1), all of them numbers up to R + r, and squares and sums of
    /// numbers up to r (6 u of r). The pull itself rounds 6 u of R and 4 u of r. Along the normal that is below gamma_24 (R + r).
    /// f changes by 2 r a unit of the normal, so its roundings act as if the surface had moved by so much.
    pub fn surface(&self, ray: &Ray, t: f64, _part: u32) -> SurfacePoint {
        let at = point_at(ray, t);
        let circle = self.nearest_on_circle(at);
        let away = (at - circle).normalize_or(DVec3::Y);
        let point = circle + away * self.minor;
        let on_axis = at.x == 0.0 && at.z == 0.0;
        let rho = (at.x * at.x + at.z * at.z).sqrt();
        SurfacePoint {
            point,
            error: DVec3::splat(gamma(32) * (self.major + self.minor)),
            normal: if on_axis { DVec3::Y.copysign(at) } else { away },
            uv: DVec2::new(
                libm::atan2(-at.z, at.x) / TAU + 0.5,
                libm::atan2(at.y, rho - self.major) / TAU + 0.5,
            ),
        }
    }

    /// The gradient of f = (rho - R)^2 + y^2 - r^2: from the circle to the point, doubled. Along y on the axis.
    pub fn gradient(&self, point: DVec3) -> DVec3 {
        if point.x == 0.0 && point.z == 0.0 {
            return DVec3::new(0.0, 2.0 * point.y, 0.0);
        }
        2.0 * (point - self.nearest_on_circle(point))
    }

    /// The box around the torus, a little wider than computed.
    pub fn bounds(&self) -> Aabb {
        let across = self.major + self.minor;
        let corner = DVec3::new(across, self.minor, across);
        Aabb {
            min: -corner,
            max: corner,
        }
        .padded(DVec3::splat(gamma(16) * across))
    }

    /// Its volume: 2 pi^2 R r^2 (Pappus). Of a spindle, the integral of 2 pi rho over the part of the tube's section that has
    /// rho >= 0.
    pub fn volume(&self) -> f64 {
        let (big, small) = (self.major, self.minor);
        if small <= big {
            return 2.0 * PI * PI * big * small * small;
        }
        // Half the height of the section at the axis.
        let h = ((small - big) * (small + big)).sqrt();
        let angle = FRAC_PI_2 + libm::asin(big / small);
        TAU * (2.0 / 3.0 * h * h * h + big * small * small * angle + big * big * h)
    }
}

#[cfg(test)]
mod tests;
