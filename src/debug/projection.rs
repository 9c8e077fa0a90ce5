//! Orthographic projection of the scene onto a drawing of the ray paths.

use crate::geometry::Aabb;
use crate::math::{DVec3, Ray};
use crate::trace::{Node, Outcome};

/// Viewing direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// From above: x to the right, z downwards.
    Top,
    /// From the front: x to the right, y upwards.
    Front,
    /// From the right side: z to the left, y upwards.
    Side,
}

impl Axis {
    /// The next view.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::Top => Self::Front,
            Self::Front => Self::Side,
            Self::Side => Self::Top,
        }
    }

    /// Coordinates of a point or a vector in the drawing: to the right, upwards.
    pub fn project(self, p: DVec3) -> [f64; 2] {
        match self {
            Self::Top => [p.x, -p.z],
            Self::Front => [p.x, p.y],
            Self::Side => [-p.z, p.y],
        }
    }
}

/// The part of the plane that is drawn, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// From left to right.
    pub x: [f64; 2],
    /// From the bottom to the top.
    pub y: [f64; 2],
    /// Width and height of a dot.
    pub dot: f64,
}

impl Viewport {
    /// The extent in the middle of so many dots, which are as wide as high. `None` if there is nothing to draw or no room.
    pub fn new(extent: Aabb, axis: Axis, columns: f64, rows: f64) -> Option<Self> {
        let corners = extent.corners().map(|corner| axis.project(corner));
        let range = |i: usize| {
            let values = corners.iter().map(|c| c[i]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
                (l.min(v), h.max(v))
            });
            (f64::midpoint(low, high), high - low)
        };
        let ((x, width), (y, height)) = (range(0), range(1));
        let dot = (width / columns).max(height / rows);
        let (half_x, half_y) = (dot * columns / 2.0, dot * rows / 2.0);
        let all = [x, y, half_x, half_y, dot];
        (all.iter().all(|v| v.is_finite()) && dot > 0.0).then_some(Self {
            x: [x - half_x, x + half_x],
            y: [y - half_y, y + half_y],
            dot,
        })
    }

    /// Width and height together.
    pub fn span(&self) -> f64 {
        (self.x[1] - self.x[0]) + (self.y[1] - self.y[0])
    }

    /// True if a point of the plane is drawn.
    pub fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let inside = |v: f64, [low, high]: [f64; 2]| low <= v && v <= high;
        inside(x, self.x) && inside(y, self.y)
    }

    /// Where a ray starts, and where it ends or has left the drawing.
    pub fn ends(&self, node: &Node) -> [DVec3; 2] {
        let ray = Ray::new(node.ray.origin, node.ray.direction);
        let t = match node.outcome {
            Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => hit.t,
            _ => node.ray.t_max.min(2.0 * self.span()),
        };
        [ray.origin, ray.at(t)]
    }

    /// The line a x + b y = d across the drawing, for a unit vector (a, b).
    pub fn line(&self, [a, b]: [f64; 2], d: f64) -> [[f64; 2]; 2] {
        let middle = [
            f64::midpoint(self.x[0], self.x[1]),
            f64::midpoint(self.y[0], self.y[1]),
        ];
        let off = a * middle[0] + b * middle[1] - d;
        let foot = [middle[0] - a * off, middle[1] - b * off];
        let end = |by: f64| [foot[0] - b * by, foot[1] + a * by];
        [end(-self.span()), end(self.span())]
    }
}
