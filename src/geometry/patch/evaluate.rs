//! The point of a patch at (u, v), its normal and its error.

use glam::DVec4;

use super::SurfacePatch;
use super::grid::ControlGrid;
use crate::geometry::SurfacePoint;
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3};

impl SurfacePatch {
    /// The point at u and v of the leaf, 0 to 1, with u and v of the whole surface.
    ///
    /// The point by de Casteljau is within gamma_32 of the largest coordinate, since each of up to 10 mixes a + t (b - a) rounds
    /// three times. The next test of the same patch acts as if that had been moved by 64 u, and puts the place within gamma_32
    /// of the size, which is up to twice the largest coordinate. The bound covers both, so that the ray is found on the
    /// side to which it left. Weights magnify: what counts is the largest w |P| over the w at the place.
    pub fn surface(&self, place: [f64; 2]) -> SurfacePoint {
        let control = self.grid();
        let at = control.at(place).value;
        let point = at.truncate() / at.w;
        let error = gamma(128) * largest(&control) / at.w;
        let mix = |axis: usize| self.low[axis] + (self.high[axis] - self.low[axis]) * place[axis];
        SurfacePoint {
            point,
            error: DVec3::splat(error),
            normal: normal(&control, place),
            uv: DVec2::new(mix(0), mix(1)),
        }
    }

    /// S(u, v) and its derivatives S_u and S_v.
    pub fn derivatives(&self, place: [f64; 2]) -> [DVec3; 3] {
        let control = self.grid();
        let at = control.at(place).value;
        let point = at.truncate() / at.w;
        let jet = around(&control, point).at(place);
        [point, jet.du / at.w, jet.dv / at.w]
    }

    /// The control points (w x, w y, w z, w), whose mixes are points of the surface.
    fn grid(&self) -> ControlGrid<DVec4> {
        let all = self.control.iter();
        ControlGrid::of(self.size, all.map(|p| (p.truncate() * p.w).extend(p.w)))
    }
}

/// The unit normal S_u x S_v. Where an edge has collapsed to a point, S_u = 0 there, it is the limit from inside, where S_u is
/// about S_uv times the way. Where that is nothing either, it is the normal of the nearest place towards the middle that
/// has one.
fn normal(control: &ControlGrid<DVec4>, [u, v]: [f64; 2]) -> DVec3 {
    let inwards = [u, v].map(|x| if x < 0.5 { 1.0 } else { -1.0 });
    let steps = (1..=5).map(|k| 0.5f64.powi(25 - 5 * k));
    let towards_the_middle =
        steps.map(|step| ([u + (0.5 - u) * step, v + (0.5 - v) * step], [0.0; 2]));
    std::iter::once(([u, v], inwards))
        .chain(towards_the_middle)
        .find_map(|(place, inwards)| unit_normal(control, place, inwards))
        .unwrap_or(DVec3::Y)
}

/// The largest coordinate of the points, times w.
fn largest(control: &ControlGrid<DVec4>) -> f64 {
    let all = control
        .points()
        .iter()
        .map(|p| p.truncate().abs().max_element());
    all.fold(0.0, f64::max)
}

/// The patch as seen from one of its points s: w (S - s). There its derivatives are w S_u and w S_v, also if w varies.
fn around(control: &ControlGrid<DVec4>, s: DVec3) -> ControlGrid<DVec3> {
    control.map(|p| p.truncate() - s * p.w)
}

/// The unit normal at a place; `None` if the derivatives are too small to have one. `inwards` are the senses of u and of v
/// towards the middle, or 0 to do without the limit at a collapsed edge.
fn unit_normal(control: &ControlGrid<DVec4>, place: [f64; 2], inwards: [f64; 2]) -> Option<DVec3> {
    let at = control.at(place).value;
    let local = around(control, at.truncate() / at.w);
    let size = local.points().iter().map(|p| p.abs().max_element());
    let size = size.fold(0.0, f64::max);
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let jet = local.at(place);
    let [du, dv, duv] = [jet.du / size, jet.dv / size, jet.duv / size];
    // Steps between the control points of a collapsed edge are 0 exactly; with weights they are rounded as the points are.
    let rational = control
        .points()
        .iter()
        .any(|p| p.w != control.point(0, 0).w);
    let noise = gamma(128)
        * if rational {
            largest(control) / size
        } else {
            1.0
        };
    let known = |a: DVec3, b: DVec3| {
        let n = a.cross(b);
        (n.length() > noise * (a.length() + b.length()))
            .then(|| n.try_normalize())
            .flatten()
    };
    known(du, dv)
        .or_else(|| known(duv * inwards[1], dv))
        .or_else(|| known(du, duv * inwards[0]))
}
