//! A pinhole camera whose rays go exactly at what is thinner than a pixel.

use super::picture::Place;
use crate::math::{DVec3, Ray};

/// Where one looks from, and three directions: to the right and up as far as the window's borders are at distance 1, and ahead.
pub struct Eye {
    at: DVec3,
    axes: [DVec3; 3],
}

impl Eye {
    /// From a point to another, y up, so that the window's borders are `reach` from its middle at distance 1.
    pub fn new(at: DVec3, to: DVec3, reach: f64) -> Self {
        let ahead = (to - at).normalize();
        let right = ahead.cross(DVec3::Y).normalize();
        let axes = [right * reach, right.cross(ahead) * reach, ahead];
        Self { at, axes }
    }

    /// The ray through a pixel's middle.
    pub fn ray(&self, place: Place) -> Ray {
        let [right, up, ahead] = self.axes;
        Ray::new(
            self.at,
            (place.x * right + place.y * up + ahead).normalize(),
        )
    }

    /// The ray at the first edge that goes through a pixel, at its point nearest to the pixel's middle.
    pub fn ray_at_edge(&self, edges: &[[DVec3; 2]], place: Place) -> Option<Ray> {
        let point = |edge: &[DVec3; 2]| {
            let [(a, depth_a), (b, depth_b)] =
                [self.seen(edge[0], place)?, self.seen(edge[1], place)?];
            // The share of the way from a to b, in the window and then along the edge itself: depth draws it together.
            let way = [b[0] - a[0], b[1] - a[1]];
            let length = way[0] * way[0] + way[1] * way[1];
            let s = -(a[0] * way[0] + a[1] * way[1]) / length;
            let nearest = [a[0] + s * way[0], a[1] + s * way[1]];
            let s_along = s * depth_a / (depth_b + s * (depth_a - depth_b));
            let inside = (0.0..=1.0).contains(&s) && nearest.iter().all(|x| x.abs() <= 1.0);
            inside.then(|| edge[0].lerp(edge[1], s_along))
        };
        self.towards(edges.iter().find_map(point)?)
    }

    /// The ray at the first corner that is inside a pixel.
    pub fn ray_at_corner(&self, corners: &[DVec3], place: Place) -> Option<Ray> {
        let inside = |corner: &&DVec3| {
            let seen = self.seen(**corner, place);
            seen.is_some_and(|(p, _)| p.iter().all(|x| x.abs() <= 1.0))
        };
        self.towards(*corners.iter().find(inside)?)
    }

    fn towards(&self, target: DVec3) -> Option<Ray> {
        Some(Ray::new(self.at, (target - self.at).try_normalize()?))
    }

    /// Where a point before the eye is seen, in half pixels from a pixel's middle, and how deep it is.
    fn seen(&self, point: DVec3, place: Place) -> Option<([f64; 2], f64)> {
        let [right, up, ahead] = self.axes;
        let way = point - self.at;
        let depth = way.dot(ahead);
        let on = |axis: DVec3| way.dot(axis) / (depth * axis.length_squared());
        let [x, y] = [on(right) - place.x, on(up) - place.y];
        (depth > 0.0).then_some(([x / place.half[0], y / place.half[1]], depth))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_go_at_the_point_of_an_edge_that_is_in_the_pixel() {
        let eye = Eye::new(DVec3::ZERO, DVec3::NEG_Z, 1.0);
        let place = Place {
            x: 0.25,
            y: 0.25,
            half: [0.25; 2],
        };
        // Seen as a line from the window's middle to its right upper corner, at depths from 1 to 3.
        let edge = [DVec3::new(0.0, 0.0, -1.0), DVec3::new(3.0, 3.0, -3.0)];
        let ray = eye.ray_at_edge(&[edge], place).expect("it goes through");
        let wanted = DVec3::new(0.25, 0.25, -1.0).normalize();
        assert!((ray.direction - wanted).length() < 1e-15, "{ray:?}");
        let outside = Place { y: -0.3, ..place };
        assert_eq!(eye.ray_at_edge(&[edge], outside), None);
        assert_eq!(eye.ray_at_corner(&edge, outside), None);
        assert!(eye.ray_at_corner(&edge, place).is_some());
    }
}
