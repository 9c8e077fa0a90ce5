//! Projected solid angle sampling of a polygonal light: directions in proportion to their cosine on a matt surface.
//!
//! A matt surface weighs the light from a direction w by its cosine with the normal. So let w stand on the hemisphere
//! over the surface and drop it onto the floor below: what arrives from a polygon of radiance Le is Le times the area
//! P of the polygon's shadow in the unit disc (the Nusselt analog). A direction that is even in this shadow brings
//! Le P whatever it is, so the only noise that is left is that of occlusion.
//!
//! An edge of the polygon is a part of a great circle; dropped onto the disc, a part of an ellipse around the middle.
//! Cut at the azimuths of its corners the shadow is a fan of sectors between an outer and an inner ellipse. Both the
//! area under an ellipse and the ellipse itself have closed forms.
//!
//! In code: `clip` cuts the polygon at the horizon, [`ProjectedPolygon::new`] cuts its shadow into a fan of
//! `sector`s, whose borders are `edge`s; [`ProjectedPolygon::direction`] chooses a sector by its area, an azimuth in
//! it by the area before it, and a radius.
//!
//! Source: Lambert 1760 for P; Peters 2021, "BRDF importance sampling for polygonal lights", for the fan of sectors; the
//! area under an edge by the angle along it, and its inverse by Newton's method, are derived here.

mod clip;
mod edge;
mod sector;

use self::clip::{MAX_CORNERS, above_horizon};
use self::edge::{Edge, azimuth, rotated, turn};
use self::sector::Sector;
use crate::math::{DVec3, Frame};

/// The smallest P that is worth it: a light with less is so far away or so low that all its points bring nearly the
/// same, while P, a difference of sectors, would lose digits: its relative error is 1e-16 / P.
const MIN_AREA: f64 = 1e-3;

/// The height of an edge's unit normal below which its plane is upright: no area is under it, its ellipse is a line.
const UPRIGHT: f64 = 1e-12;

/// A polygon's shadow in the unit disc under the hemisphere over a point.
#[derive(Clone, Copy, Debug)]
pub struct ProjectedPolygon {
    frame: Frame,
    /// P, the shadow's area: the projected solid angle, from 0 to pi.
    pub area: f64,
    sectors: [Sector; MAX_CORNERS],
    count: usize,
}

impl ProjectedPolygon {
    /// The shadow of a flat convex polygon under a surface at `point` with the unit `normal`. `None` if it has no area,
    /// or too little to be worth it.
    pub fn new(point: DVec3, normal: DVec3, polygon: &[DVec3]) -> Option<Self> {
        let frame = Frame::around(normal);
        let (mut corners, mut count) = above_horizon(&frame, point, polygon);
        // Lambert's sum over the edges of angle x height of the edge's normal is twice P; negative if clockwise.
        let mut twice = 0.0;
        let mut next = |a: DVec3, b: DVec3| {
            let cross = a.cross(b);
            let length = cross.length();
            if length > 0.0 {
                twice += libm::atan2(length, a.dot(b)) * cross.z / length;
            }
        };
        for i in 0..count {
            next(corners[i], corners[(i + 1) % count]);
        }
        let area = twice.abs() / 2.0;
        if area.is_nan() || area < MIN_AREA {
            return None;
        }
        if twice < 0.0 {
            corners[..count].reverse();
        }
        count = count.min(MAX_CORNERS);
        let mut this = Self {
            frame,
            area,
            sectors: [Sector::default(); MAX_CORNERS],
            count: 0,
        };
        this.cut(&corners[..count]);
        (this.count > 0).then_some(this)
    }

    /// The unit direction that `u` in [0, 1)^2 chooses, uniform in the shadow.
    pub fn direction(&self, [u, v]: [f64; 2]) -> DVec3 {
        let target = u * self.cumulative_area(self.count);
        let number = self.sectors[..self.count].partition_point(|s| s.cumulative_area <= target);
        let number = number.min(self.count - 1);
        let (before, sector) = (self.cumulative_area(number), &self.sectors[number]);
        let rest = ((target - before) / (sector.cumulative_area - before)).clamp(0.0, 1.0);
        let [x, y] = sector.at(rest, v, sector.cumulative_area - before);
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        x * self.frame.u + y * self.frame.v + z * self.frame.w
    }

    /// Cuts the shadow of counterclockwise corners into sectors.
    fn cut(&mut self, corners: &[DVec3]) {
        // Far edges run counterclockwise around the middle, near ones clockwise; those that do neither have no area.
        let n = corners.len();
        let height = |i: usize| {
            let (a, b) = (corners[i], corners[(i + 1) % n]);
            a.cross(b).normalize_or_zero().z
        };
        let (is_far, is_near) = (|i| height(i) > UPRIGHT, |i| height(i) < -UPRIGHT);
        let edge = |i: usize| (Edge::new(corners[i], corners[(i + 1) % n]), i);
        if !(0..n).any(is_near) {
            // The middle is inside: each edge makes a sector of its own.
            for (outer, i) in (0..n).filter(|i| is_far(*i)).map(edge) {
                let (a, b) = (azimuth(corners[i]), azimuth(corners[(i + 1) % n]));
                self.push(a, turn(a, b), outer, None);
            }
            return;
        }
        // The far edges are a chain, and so are the near ones; both go from the same corner to the same corner.
        let Some(first) = (0..n).find(|i| is_far(*i) && !is_far((i + n - 1) % n)) else {
            return;
        };
        let origin = azimuth(corners[first]);
        let from_origin = |i: usize| turn(origin, azimuth(corners[i % n])).max(0.0);
        let mut far = (0..n).map(|k| (first + k) % n).filter(|i| is_far(*i));
        let mut near = (0..n)
            .map(|k| (first + n - 1 - k) % n)
            .filter(|i| is_near(*i));
        let (mut outer, mut inner) = (far.next(), near.next());
        let mut here = 0.0;
        while let (Some(o), Some(i)) = (outer, inner) {
            let (ends_outer, ends_inner) = (from_origin(o + 1), from_origin(i));
            let end = ends_outer.min(ends_inner);
            if end > here {
                let (sin, cos) = libm::sincos(here);
                let start = rotated(origin, sin, cos);
                self.push(start, end - here, edge(o).0, Some(edge(i).0));
                here = end;
            }
            if ends_outer <= end {
                outer = far.next();
            }
            if ends_inner <= end {
                inner = near.next();
            }
        }
    }

    /// Adds a sector, unless it has no area.
    fn push(&mut self, start: [f64; 2], sweep: f64, outer: Edge, inner: Option<Edge>) {
        let before = self.cumulative_area(self.count);
        let sector = Sector::new(start, sweep, outer, inner, before);
        if sector.cumulative_area > before && self.count < MAX_CORNERS {
            self.sectors[self.count] = sector;
            self.count += 1;
        }
    }

    /// The area of the first `count` sectors.
    fn cumulative_area(&self, count: usize) -> f64 {
        count
            .checked_sub(1)
            .map_or(0.0, |last| self.sectors[last].cumulative_area)
    }
}
