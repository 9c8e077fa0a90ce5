//! A quadric along a line: a quadratic in t, its roots, and where it is negative.

use crate::geometry::{Cut, Span, Spans};

/// Up to two pieces of a line, each from one t to a later one; infinite where there is no end.
pub(super) type Pieces = [Option<[f64; 2]>; 2];

/// All of a line.
pub(super) const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// F(o' + t d) = A t^2 + 2 B t + C.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnLine {
    /// A, the quadratic form of d: what decides whether far away is outside (A > 0) or inside (A < 0).
    pub a: f64,
    /// B, half the slope of F at o'.
    pub b: f64,
    /// C = F(o').
    pub c: f64,
    /// D = B^2 - A C.
    pub discriminant: f64,
}

impl OnLine {
    /// The quadratic with its discriminant.
    ///
    /// B^2 - A C subtracts numbers that nearly agree where the line nearly touches, at t': B is about -A t' and C about A t'^2.
    /// That is harmless from o', where |t' d| is a few sizes of the shape at most: what the products are rounded by moves the
    /// surface by a few u of its size. From a far origin it is what makes the school formula fail.
    pub fn new(a: f64, b: f64, c: f64) -> Self {
        let discriminant = b * b - a * c;
        Self {
            a,
            b,
            c,
            discriminant,
        }
    }

    /// q = -(B + sign(B) sqrt D), where equal signs are added, so that nothing cancels.
    pub fn q(&self) -> f64 {
        -(self.b + self.discriminant.max(0.0).sqrt().copysign(self.b))
    }

    /// The roots C/q and q/A, not in order. Source: Press, Teukolsky, Vetterling and Flannery, "Numerical Recipes", 5.6.
    ///
    /// There is no case for "A is about 0": C/q then becomes the root of the line that is left, and q/A runs far away, to
    /// where the shape has ended. If q = 0 both roots are 0, as then B = 0 and A C = 0.
    pub fn roots(&self) -> [f64; 2] {
        let q = self.q();
        if q == 0.0 && self.a != 0.0 {
            return [0.0; 2];
        }
        [self.c / q, q / self.a]
    }

    /// Where F < 0. A line that only touches F = 0 from outside is nowhere inside, one that touches from inside is inside on
    /// both sides of that point. NaN is nowhere.
    #[inline]
    pub fn inside(&self) -> Pieces {
        let Self { a, b, c, .. } = *self;
        let [start, end] = ALL;
        let [r0, r1] = self.roots();
        let (t0, t1) = (r0.min(r1), r0.max(r1));
        if a > 0.0 {
            let crosses = self.discriminant > 0.0 && t0 < t1;
            [crosses.then_some([t0, t1]), None]
        } else if a < 0.0 && self.discriminant >= 0.0 {
            [Some([start, t0]), Some([t1, end])]
        } else if a < 0.0 && self.discriminant < 0.0 {
            [Some(ALL), None]
        } else if a == 0.0 {
            // Linear: 2 B t + C < 0. If B = 0 as well, the sign of C holds for the whole line.
            let piece = if b < 0.0 {
                Some([r0, end])
            } else if b > 0.0 {
                Some([start, r0])
            } else {
                (c < 0.0).then_some(ALL)
            };
            [piece, None]
        } else {
            [None; 2]
        }
    }
}

/// The spans of pieces of a line, cut with `clip`, then brought back to the ray's own t by `unmoved`.
///
/// Spans too short to have two different t, and those with NaN, are dropped; those that touch become one.
#[inline]
pub(super) fn clipped(pieces: Pieces, clip: Span, unmoved: impl Fn(Cut) -> Cut) -> Spans {
    let mut spans = Spans::none();
    for [enter, leave] in pieces.into_iter().flatten() {
        // At equal t the cut is the wall's.
        let Some(span) = Span::between(enter, leave).and(clip) else {
            continue;
        };
        let (enter, leave) = (unmoved(span.enter), unmoved(span.leave));
        match spans.0.last_mut() {
            Some(before) if enter.t <= before.leave.t => before.leave = leave,
            _ if enter.t < leave.t => spans.0.push(Span { enter, leave }),
            _ => {}
        }
    }
    spans
}
