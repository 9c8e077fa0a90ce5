//! The numbers of one test of a quadric, to be read.

use super::moved::Moved;
use super::on_line::OnLine;
use super::{BoxedQuadric, Quadric, QuadricForm};
use crate::geometry::Span;
use crate::math::{DVec3, Interval, Ray};

/// The arithmetic of one ray and one quadric, in the order in which it is done; all of it in the quadric's own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadricSteps {
    /// The equation F = 0.
    pub form: QuadricForm,
    /// t_c, where the ray comes closest to the middle.
    pub t_c: f64,
    /// The point there, from which the rest is computed.
    pub origin: DVec3,
    /// A of F = A t^2 + 2 B t + C, t from there on.
    pub a: f64,
    /// B, half the slope.
    pub b: f64,
    /// C, the value at the moved origin.
    pub c: f64,
    /// The discriminant B^2 - A C. The ray's line misses the endless surface if it is not above 0 (and A above 0).
    pub discriminant: f64,
    /// q = -(B + sign(B) sqrt D).
    pub q: f64,
    /// t_c + C/q and t_c + q/A: where the line crosses the endless surface. Of no meaning if D is below 0.
    pub roots: [f64; 2],
    /// Where the line is between the planes, or in the box, that end the shape; `None` if nowhere.
    pub clip: Option<Interval>,
}

impl QuadricSteps {
    fn new(form: QuadricForm, moved: &Moved, line: &OnLine, clip: Option<Span>) -> Self {
        let t_c = moved.t_c;
        Self {
            form,
            t_c,
            origin: moved.origin,
            a: line.a,
            b: line.b,
            c: line.c,
            discriminant: line.discriminant,
            q: line.q(),
            roots: line.roots().map(|root| t_c + root),
            clip: clip.map(|span| Interval::new(t_c + span.enter.t, t_c + span.leave.t)),
        }
    }
}

impl Quadric {
    /// F as a general form: x^2 + z^2 - R(y)^2.
    pub fn form(&self) -> QuadricForm {
        let [a, b, c] = self.profile.square();
        QuadricForm([1.0, -a, 1.0, 0.0, 0.0, 0.0, 0.0, -b, 0.0, -c])
    }

    /// What [`Quadric::intersect`] computes for a ray.
    pub fn arithmetic(&self, ray: &Ray) -> QuadricSteps {
        let moved = self.moved(ray);
        let line = self.profile.on_line(&moved);
        let clip = self.slab(&moved);
        QuadricSteps::new(self.form(), &moved, &line, clip)
    }
}

impl BoxedQuadric {
    /// What [`BoxedQuadric::intersect`] computes for a ray.
    pub fn arithmetic(&self, ray: &Ray) -> QuadricSteps {
        let moved = self.moved(ray);
        let line = self.form.on_line(&moved);
        let clip = self.clip(&moved);
        QuadricSteps::new(self.form, &moved, &line, clip)
    }
}
