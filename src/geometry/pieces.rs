//! Crossings of a ray with a surface of degree 4, piece by piece.
//!
//! Along a ray such a surface is a polynomial of degree 4. Its turns cut the line into pieces, each with one crossing at most
//! (see [`crate::math::polynomial`]). The polynomial has lost digits when it was multiplied out; so it only says *where* the
//! pieces lie. Whether a piece's end is inside, and where exactly the crossing is, says the surface itself.

use smallvec::SmallVec;

use super::{Cut, Span, Spans};
use crate::math::polynomial::{
    Evaluation, RefinedRoot, bracketed_newton, cubic_roots, derivative, evaluate, rounding_of,
};
use crate::math::{DVec3, Ray};

/// A crossing in a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceCrossing {
    /// The root of the polynomial, and the steps to it.
    pub plain: RefinedRoot,
    /// The zero of the surface's own function, found from there, and the steps to it.
    pub polished: RefinedRoot,
}

/// A part of the ray's line on which the polynomial only rises or only falls. Its ends are counted from where the ray's origin
/// was moved to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Where it starts.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Whether its start and its end are inside the solid.
    pub inside: [bool; 2],
    /// The crossing, if one end is inside and the other is not.
    pub crossing: Option<PieceCrossing>,
}

/// The pieces of a line, in order; four at most.
pub type Pieces = SmallVec<[Piece; 4]>;

/// The pieces of `polynomial` between the two ends of `reach`, whose sides are given. `surface` is the surface's own function
/// along the ray: below zero inside.
#[inline]
pub fn pieces(
    polynomial: &[f64; 5],
    reach: [f64; 2],
    inside_at_ends: [bool; 2],
    surface: impl Fn(f64) -> Evaluation,
) -> Pieces {
    let shortest = rounding_of(reach);
    let turns = cubic_roots(&derivative(polynomial), reach);
    let [mut from, end] = reach;
    let [mut inside, inside_at_end] = inside_at_ends;
    let mut list = Pieces::new();
    for i in 0..=turns.len() {
        let (to, inside_there) = match turns.get(i) {
            Some(&turn) => (turn, surface(turn).value < 0.0),
            None => (end, inside_at_end),
        };
        let crossing = (inside != inside_there).then(|| {
            let plain_value = |x| evaluate(polynomial, x);
            let middle = 0.5 * (from + to);
            let plain = bracketed_newton(plain_value, [from, to], inside, middle, shortest);
            let polished = bracketed_newton(&surface, [from, to], inside, plain.root, shortest);
            PieceCrossing { plain, polished }
        });
        list.push(Piece {
            from,
            to,
            inside: [inside, inside_there],
            crossing,
        });
        (from, inside) = (to, inside_there);
    }
    list
}

/// The spans that pieces make, as t = `moved` + crossing. `ends` are the cuts where the line comes in and goes out, for a line
/// that is inside there.
///
/// Crossings may be so near to each other, or so far from the ray's origin, that their t are the same number: such a span is
/// dropped, such a gap is closed.
pub fn spans(pieces: &[Piece], moved: f64, ends: [Cut; 2]) -> Spans {
    let mut spans = Spans::none();
    let Some(first) = pieces.first() else {
        return spans;
    };
    let mut close = |enter: Cut, leave: Cut| {
        let is_empty = enter.t.partial_cmp(&leave.t) != Some(std::cmp::Ordering::Less);
        match spans.0.last_mut() {
            _ if is_empty => {}
            Some(before) if enter.t <= before.leave.t => before.leave = leave,
            _ => spans.0.push(Span { enter, leave }),
        }
    };
    let mut open = first.inside[0].then_some(ends[0]);
    for crossing in pieces.iter().filter_map(|piece| piece.crossing) {
        let cut = Cut {
            t: moved + crossing.polished.root,
            part: 0,
        };
        match open.take() {
            Some(enter) => close(enter, cut),
            None => open = Some(cut),
        }
    }
    if let Some(enter) = open {
        close(enter, ends[1]);
    }
    spans
}

/// The point at t, each coordinate rounded once: far from the origin o + t d cancels, and a product that was rounded before
/// would be all that is left.
pub(super) fn point_at(ray: &Ray, t: f64) -> DVec3 {
    let (o, d) = (ray.origin, ray.direction);
    DVec3::new(
        t.mul_add(d.x, o.x),
        t.mul_add(d.y, o.y),
        t.mul_add(d.z, o.z),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(inside: [bool; 2], root: f64) -> Piece {
        let found = RefinedRoot { root, steps: 1 };
        Piece {
            from: root,
            to: root,
            inside,
            crossing: Some(PieceCrossing {
                plain: found,
                polished: found,
            }),
        }
    }

    #[test]
    fn spans_that_no_number_can_tell_are_dropped_and_such_gaps_are_closed() {
        let [low, high] = [1, 2].map(|part| Cut {
            t: f64::from(part),
            part,
        });
        let (enter, leave) = ([false, true], [true, false]);
        let list = [
            piece(enter, 0.25),
            piece(leave, 0.5),
            piece(enter, 0.5 + 1e-12),
            piece(leave, 0.75),
        ];
        let near = spans(&list, 0.0, [low, high]);
        assert_eq!(near.0.len(), 2);
        // From 1e6 away, 1e-12 is no difference any more.
        let far = spans(&list, 1e6, [low, high]);
        assert_eq!(far.0[..], [Span::between(1e6 + 0.25, 1e6 + 0.75)]);
        let gone = spans(&list, 1e20, [low, high]);
        assert!(gone.0.is_empty());
        // A line that is inside at both ends.
        let through = spans(&[piece(leave, 1.25), piece(enter, 1.5)], 0.0, [low, high]);
        assert_eq!(
            through.cuts().map(|(cut, _)| cut.part).collect::<Vec<_>>(),
            [1, 0, 0, 2]
        );
    }
}
