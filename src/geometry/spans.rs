//! Spans: the parts of a ray's line that lie inside a solid.
//!
//! The first hit, whether a ray goes in or comes out, and all further crossings come from this one list: a line crosses a solid
//! an even number of times by construction. Source: Roth 1982, "Ray casting for modeling solids".

use smallvec::SmallVec;

use super::Intersection;
use crate::math::Interval;

/// A crossing of a solid's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The ray parameter; infinite where the solid has no end.
    pub t: f64,
    /// The part of the shape that is crossed: see [`super::Hit::part`].
    pub part: u32,
}

impl Cut {
    /// The crossing as a result: before, inside or behind the interval.
    pub fn classify(self, interval: Interval) -> Intersection {
        match Intersection::classify(self.t, [0.0; 3], interval) {
            Intersection::Hit { t, place, .. } => Intersection::Hit {
                t,
                place,
                part: self.part,
            },
            other => other,
        }
    }
}

/// A part of a ray's line inside a solid: from `enter` to `leave`, with `enter.t < leave.t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Where the line goes in.
    pub enter: Cut,
    /// Where it comes out.
    pub leave: Cut,
}

/// The spans of a line in a solid, by t. They do not touch each other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spans(pub SmallVec<[Span; 2]>);

impl Span {
    /// A span between two crossings of part 0.
    pub fn between(enter: f64, leave: f64) -> Self {
        let cut = |t| Cut { t, part: 0 };
        Self {
            enter: cut(enter),
            leave: cut(leave),
        }
    }

    /// The part of this span that is inside `other` as well; of crossings at the same t that of `self`.
    #[must_use]
    pub fn and(self, other: Self) -> Option<Self> {
        let later = |a: Cut, b: Cut| if b.t > a.t { b } else { a };
        let sooner = |a: Cut, b: Cut| if b.t < a.t { b } else { a };
        let both = Self {
            enter: later(self.enter, other.enter),
            leave: sooner(self.leave, other.leave),
        };
        (both.enter.t < both.leave.t).then_some(both)
    }
}

impl Spans {
    /// No span: the line misses the solid.
    pub fn none() -> Self {
        Self::default()
    }

    /// The crossings by t, each with whether the ray goes in there.
    pub fn cuts(&self) -> impl Iterator<Item = (Cut, bool)> + '_ {
        let spans = self.0.iter();
        spans.flat_map(|span| [(span.enter, true), (span.leave, false)])
    }

    /// The first crossing inside the interval.
    pub fn first(&self, interval: Interval) -> Intersection {
        let mut found = Intersection::Miss;
        for (cut, _) in self.cuts().filter(|(cut, _)| cut.t.is_finite()) {
            match cut.classify(interval) {
                behind @ Intersection::Behind(_) => found = behind,
                other => return other,
            }
        }
        found
    }

    /// Whether the ray goes into the solid at a crossing at `t`; `None` if there is none.
    pub fn enters(&self, t: f64) -> Option<bool> {
        let mut cuts = self.cuts();
        cuts.find_map(|(cut, enters)| (cut.t == t).then_some(enters))
    }

    /// The length of line inside, in units of t.
    pub fn length(&self) -> f64 {
        let spans = self.0.iter();
        spans.map(|span| span.leave.t - span.enter.t).sum()
    }
}

impl From<Option<Span>> for Spans {
    fn from(span: Option<Span>) -> Self {
        let mut spans = Self::none();
        if let Some(span) = span {
            spans.0.push(span);
        }
        spans
    }
}
