//! The general equation of second degree in x, y and z.

use super::moved::Moved;
use super::on_line::OnLine;
use crate::math::DVec3;

/// F = A x2 + B y2 + C z2 + D xy + E xz + F yz + G x + H y + I z + J, its ten coefficients in this order. F <= 0 is inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadricForm(pub [f64; 10]);

impl QuadricForm {
    /// The ten terms of F at a point.
    fn terms(&self, p: DVec3) -> [f64; 10] {
        let DVec3 { x, y, z } = p;
        let products = [x * x, y * y, z * z, x * y, x * z, y * z, x, y, z, 1.0];
        std::array::from_fn(|i| self.0[i] * products[i])
    }

    /// F at a point.
    pub fn value(&self, p: DVec3) -> f64 {
        self.terms(p).iter().sum()
    }

    /// The sum of the sizes of the terms: what roundings of F are multiples of.
    pub fn magnitude(&self, p: DVec3) -> f64 {
        self.terms(p).iter().map(|term| term.abs()).sum()
    }

    /// Half the gradient of the terms of second degree, Q v with Q the symmetric matrix of the form.
    fn halved(&self, v: DVec3) -> DVec3 {
        let [a, b, c, d, e, f, ..] = self.0;
        DVec3::new(
            a * v.x + 0.5 * (d * v.y + e * v.z),
            b * v.y + 0.5 * (d * v.x + f * v.z),
            c * v.z + 0.5 * (e * v.x + f * v.y),
        )
    }

    /// The terms of first degree.
    fn linear(&self) -> DVec3 {
        DVec3::new(self.0[6], self.0[7], self.0[8])
    }

    /// The gradient of F at a point; it points to where F grows, which is outwards.
    pub fn gradient(&self, p: DVec3) -> DVec3 {
        2.0 * self.halved(p) + self.linear()
    }

    /// F along a line.
    pub(super) fn on_line(&self, line: &Moved) -> OnLine {
        let [a, b, c] = self.along(line.origin, line.direction);
        OnLine::new(a, b, c)
    }

    /// A, B and C of a line: A = d'Q d, B = o'Q d + (G, H, I).d / 2, C = F(o).
    pub(super) fn along(&self, o: DVec3, d: DVec3) -> [f64; 3] {
        let qd = self.halved(d);
        let b = o.dot(qd) + 0.5 * self.linear().dot(d);
        [d.dot(qd), b, self.value(o)]
    }
}
