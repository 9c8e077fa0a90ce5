//! Quadrics by the school formula, to show what goes wrong.
//!
//! A, B and C are taken where the ray starts, t = (-b +- sqrt(b^2 - 4 a c)) / 2a as it stands. From far away b^2 and 4 a c agree
//! in nearly all digits, and so do b and the root near the surface: hits and misses are then told by what was rounded.

use super::moved::Moved;
use super::on_line::{ALL, Pieces, clipped};
use super::{BoxedQuadric, Quadric, QuadricForm};
use crate::geometry::{Intersection, Spans};
use crate::math::{Interval, Ray};

impl Quadric {
    /// The spans as the school formula finds them; also of a quadric without caps, as if it had them.
    pub fn school_spans(&self, ray: &Ray) -> Spans {
        let Some(slab) = self.slab(&Moved::not_at_all(ray)) else {
            return Spans::none();
        };
        clipped(school(&self.form(), ray), slab, |cut| cut)
    }

    /// The first crossing inside the interval as the school formula finds it.
    pub fn school_intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        self.first(&self.school_spans(ray), interval)
    }
}

impl BoxedQuadric {
    /// The spans as the school formula finds them.
    pub fn school_spans(&self, ray: &Ray) -> Spans {
        let Some(inside_box) = self.clip(&Moved::not_at_all(ray)) else {
            return Spans::none();
        };
        clipped(school(&self.form, ray), inside_box, |cut| cut)
    }

    /// The first crossing inside the interval as the school formula finds it.
    pub fn school_intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        self.school_spans(ray).first(interval)
    }
}

/// Where F < 0 along the ray's line, with no care for rounding.
fn school(form: &QuadricForm, ray: &Ray) -> Pieces {
    let [a, half_b, c] = form.along(ray.origin, ray.direction);
    let b = 2.0 * half_b;
    let discriminant = b * b - 4.0 * a * c;
    let root = discriminant.sqrt();
    let (t0, t1) = ((-b - root) / (2.0 * a), (-b + root) / (2.0 * a));
    let ([start, end], touches) = (ALL, discriminant <= 0.0);
    if a > 0.0 && discriminant > 0.0 {
        [Some([t0, t1]), None]
    } else if a < 0.0 && discriminant > 0.0 {
        [Some([start, t1]), Some([t0, end])]
    } else if a < 0.0 && touches || a == 0.0 && b == 0.0 && c < 0.0 {
        [Some(ALL), None]
    } else if a == 0.0 && b < 0.0 {
        [Some([-c / b, end]), None]
    } else if a == 0.0 && b > 0.0 {
        [Some([start, -c / b]), None]
    } else {
        [None; 2]
    }
}
