//! Projection of triangles onto the screen, cut at its edges.
//!
//! x' = x / (z tan(fov / 2) aspect), y' = y / (z tan(fov / 2)), where z is the depth along the view direction. What is behind the eye
//! has no place on the screen, so a triangle is cut before it is projected (Sutherland and Hodgman 1974, "Reentrant polygon clipping").

use smallvec::{SmallVec, smallvec};

use crate::geometry::Triangle;
use crate::math::{DVec3, Ray};
use crate::scene::Camera;

/// A triangle is cut before the eye at this part of its distance.
const NEAR: f64 = 1e-12;

/// Projection onto the screen of a camera: pixels from its left and upper edge.
pub struct Projection<'a> {
    camera: &'a Camera,
    /// Width and height, in pixels.
    pub size: (u32, u32),
}

/// Corner of a polygon on the screen.
#[derive(Clone, Copy, Debug)]
pub struct ScreenCorner {
    /// To the right, in pixels.
    pub x: f64,
    /// Downwards, in pixels.
    pub y: f64,
    /// 1 / depth.
    pub inverse_depth: f64,
    /// Weights of the triangle's corners.
    pub weights: [f64; 3],
}

/// Polygon on the screen: a triangle has up to eight corners after it was cut at five planes.
pub type ScreenPolygon = SmallVec<[ScreenCorner; 8]>;

/// Corner before the camera: x to the right, y up, z the depth.
#[derive(Clone, Copy)]
struct ViewCorner {
    at: DVec3,
    weights: DVec3,
}

impl<'a> Projection<'a> {
    /// The screen of a camera with so many pixels.
    pub fn new(camera: &'a Camera, size: (u32, u32)) -> Self {
        Self { camera, size }
    }

    /// The eye ray through a point of a row's middle line.
    pub fn ray(&self, x: f64, row: u32) -> Ray {
        self.camera.ray([x, f64::from(row) + 0.5], self.size)
    }

    /// Half of the width and of the height that is seen at depth 1.
    fn half(&self) -> [f64; 2] {
        let aspect = f64::from(self.size.0) / f64::from(self.size.1);
        [self.camera.half_height * aspect, self.camera.half_height]
    }

    /// A triangle on the screen, cut a pixel beyond the screen's edges. Empty if nothing of it is there.
    pub fn polygon(&self, triangle: &Triangle) -> ScreenPolygon {
        let frame = &self.camera.frame;
        let weights = [DVec3::X, DVec3::Y, DVec3::Z];
        let mut polygon: SmallVec<[ViewCorner; 8]> = smallvec![];
        for (corner, weights) in triangle.corners.iter().zip(weights) {
            let p = *corner - self.camera.eye;
            let at = DVec3::new(p.dot(frame.u), p.dot(frame.v), -p.dot(frame.w));
            polygon.push(ViewCorner { at, weights });
        }
        let largest = polygon.iter().map(|c| c.at.abs().max_element());
        let near = NEAR * largest.fold(0.0, f64::max);
        let [half_width, half_height] = self.half();
        let right = half_width * (1.0 + 2.0 / f64::from(self.size.0));
        let top = half_height * (1.0 + 2.0 / f64::from(self.size.1));
        // Each plane as a function that is positive on the inner side.
        let planes: [&dyn Fn(DVec3) -> f64; 5] = [
            &|p| p.z - near,
            &|p| right * p.z - p.x,
            &|p| right * p.z + p.x,
            &|p| top * p.z - p.y,
            &|p| top * p.z + p.y,
        ];
        for plane in planes {
            polygon = cut(&polygon, plane);
        }
        polygon.iter().map(|corner| self.project(corner)).collect()
    }

    fn project(&self, corner: &ViewCorner) -> ScreenCorner {
        let [half_width, half_height] = self.half();
        let (width, height) = (f64::from(self.size.0), f64::from(self.size.1));
        let inverse_depth = 1.0 / corner.at.z;
        ScreenCorner {
            x: (1.0 + corner.at.x * inverse_depth / half_width) * width / 2.0,
            y: (1.0 - corner.at.y * inverse_depth / half_height) * height / 2.0,
            inverse_depth,
            weights: corner.weights.to_array(),
        }
    }
}

/// The part of a convex polygon where `inside` is not negative.
fn cut(polygon: &[ViewCorner], inside: &dyn Fn(DVec3) -> f64) -> SmallVec<[ViewCorner; 8]> {
    let mut kept = SmallVec::new();
    let mut before = polygon.last();
    for corner in polygon {
        let Some(last) = before.replace(corner) else {
            continue;
        };
        let [from, to] = [last, corner].map(|c| inside(c.at));
        if (from < 0.0) != (to < 0.0) {
            let s = from / (from - to);
            kept.push(ViewCorner {
                at: last.at + s * (corner.at - last.at),
                weights: last.weights + s * (corner.weights - last.weights),
            });
        }
        if to >= 0.0 {
            kept.push(*corner);
        }
    }
    kept
}
