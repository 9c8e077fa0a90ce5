//! Scanline: the span of a polygon in a row of pixels, and what is blended along it.
//!
//! Values are blended along the two edges that the row crosses, then along the row between them (the lectures' algorithm).
//! What is linear in space is not linear on the screen: at the part s of the way between two points at depths z0 and z1 the
//! second has the weight (s / z1) / ((1 - s) / z0 + s / z1). So weights are divided by the depth, blended, and divided by the
//! blended 1 / depth (Heckbert and Moreton 1991, "Interpolation for polygon texture mapping and shading").

use std::ops::Range;

use super::projection::ScreenCorner;

/// How far a row may be beyond a polygon by rounding, in pixels.
const ROUNDING: f64 = 1e-6;

/// How values are blended between corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ScreenBlend {
    /// As they are in space.
    #[default]
    Perspective,
    /// Linearly on the screen: wrong where depths differ.
    Affine,
}

/// Span of a polygon in a row.
#[derive(Clone, Copy, Debug)]
pub struct RowSpan {
    /// The left end.
    pub from: SpanPoint,
    /// The right end.
    pub to: SpanPoint,
    blend: ScreenBlend,
}

/// Point of a span.
#[derive(Clone, Copy, Debug)]
pub struct SpanPoint {
    /// To the right, in pixels.
    pub x: f64,
    /// 1 / depth.
    pub inverse_depth: f64,
    /// Weights of the triangle's corners.
    pub weights: [f64; 3],
}

/// Rows of pixels whose middle lines a polygon may cross, of a screen that is so high.
pub fn rows(corners: &[ScreenCorner], height: u32) -> Option<Range<u32>> {
    let [lowest, highest] = extent(corners)?;
    let first = (lowest - 0.5 - ROUNDING).ceil().max(0.0);
    let end = (highest - 0.5 + ROUNDING).floor() + 1.0;
    let rows = first as u32..end.clamp(0.0, f64::from(height)) as u32;
    (!rows.is_empty()).then_some(rows)
}

/// The least and the largest y.
fn extent(corners: &[ScreenCorner]) -> Option<[f64; 2]> {
    let first = corners.first()?.y;
    let step = |[low, high]: [f64; 2], c: &ScreenCorner| [low.min(c.y), high.max(c.y)];
    Some(corners.iter().fold([first; 2], step))
}

impl RowSpan {
    /// The span of a convex polygon in the middle line of a row; `None` if the line misses it.
    pub fn of(corners: &[ScreenCorner], row: u32, blend: ScreenBlend) -> Option<Self> {
        let [lowest, highest] = extent(corners)?;
        let y = (f64::from(row) + 0.5).max(lowest).min(highest);
        let mut ends: Option<[SpanPoint; 2]> = None;
        let mut last = corners.last()?;
        for corner in corners {
            let (from, to) = (last, corner);
            last = corner;
            if (from.y - y) * (to.y - y) > 0.0 {
                continue;
            }
            let crossings = if from.y == to.y {
                [SpanPoint::from(from), SpanPoint::from(to)]
            } else {
                let s = (y - from.y) / (to.y - from.y);
                [SpanPoint::between(&from.into(), &to.into(), s, blend); 2]
            };
            for crossing in crossings {
                let [left, right] = ends.get_or_insert([crossing; 2]);
                if crossing.x < left.x {
                    *left = crossing;
                }
                if crossing.x > right.x {
                    *right = crossing;
                }
            }
        }
        ends.map(|[from, to]| Self { from, to, blend })
    }

    /// The pixels that it may cover: those whose middles lie in it, and one more at each end.
    pub fn pixels(&self, width: u32) -> Range<u32> {
        let first = (self.from.x - 1.5).ceil().max(0.0);
        let end = (self.to.x + 0.5).floor() + 1.0;
        first as u32..end.clamp(0.0, f64::from(width)) as u32
    }

    /// What is blended at a point of the row.
    pub fn at(&self, x: f64) -> SpanPoint {
        if self.from.x == self.to.x {
            return SpanPoint { x, ..self.from };
        }
        let s = (x - self.from.x) / (self.to.x - self.from.x);
        SpanPoint::between(&self.from, &self.to, s, self.blend)
    }
}

impl From<&ScreenCorner> for SpanPoint {
    fn from(corner: &ScreenCorner) -> Self {
        Self {
            x: corner.x,
            inverse_depth: corner.inverse_depth,
            weights: corner.weights,
        }
    }
}

impl SpanPoint {
    /// The point at the part `s` of the way on the screen from `a` to `b`.
    fn between(a: &Self, b: &Self, s: f64, blend: ScreenBlend) -> Self {
        let (mut near, mut far) = (1.0 - s, s);
        let inverse_depth = near * a.inverse_depth + far * b.inverse_depth;
        if blend == ScreenBlend::Perspective {
            near *= a.inverse_depth / inverse_depth;
            far *= b.inverse_depth / inverse_depth;
        }
        Self {
            x: (1.0 - s) * a.x + s * b.x,
            inverse_depth,
            weights: std::array::from_fn(|i| near * a.weights[i] + far * b.weights[i]),
        }
    }
}
