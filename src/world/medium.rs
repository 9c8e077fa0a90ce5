//! Which medium a ray travels in, where transparent objects are nested, overlap or touch.
//!
//! Two rules. *A ray is inside of what it leaves, further on, more often than it enters it.* So what it is inside of is
//! read off the very crossings that it is going to meet; nothing is carried from ray to ray that rounding could bring out
//! of step. *Where objects overlap, the medium is that of the highest priority; of equal ones, that of the smaller object; of
//! equally large ones, that of the later in the file.* So a point has one medium, from wherever a ray comes, and a path can be
//! followed backwards. Source of the second: Schmidt and Budge 2002, "Simple nested dielectrics in ray traced images".
//!
//! A surface that bounds no part of space, as a square for a pool's, cannot be read off in this way: a ray is inside
//! because it came in through the front. Only these are kept in mind, in [`OpenMedia`].

use std::collections::BTreeMap;

use crate::geometry::Hit;
use crate::probe::NONE;

/// How many open objects may be nested in each other before the outermost is forgotten.
pub const NESTING: usize = 16;

/// A place where a ray crosses a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The place.
    pub hit: Hit,
    /// The object whose surface it is.
    pub object: u32,
    /// True if the ray goes into the object, false if it comes out; `None` if the object is opaque, or only touched.
    pub enters: Option<bool>,
}

/// The object in whose medium a ray travels that is going to meet the crossings `ahead`, in order, and came into the open
/// objects `entered`; [`NONE`] for air: of all that the ray is inside of, the one of the highest rank. See `src/world/rank.rs`.
#[inline(never)]
pub fn medium(entered: &OpenMedia, ahead: &[Crossing], rank: impl Fn(u32) -> u32) -> u32 {
    let mut best = NONE;
    let mut inside = |object: u32| {
        if best == NONE || rank(object) > rank(best) {
            best = object;
        }
    };
    // How often each object was entered and not yet left again.
    let mut depths: BTreeMap<u32, usize> = BTreeMap::new();
    for crossing in ahead {
        let object = crossing.object;
        match (crossing.enters, depths.get_mut(&object)) {
            (Some(true), _) => *depths.entry(object).or_default() += 1,
            (Some(false), Some(depth @ 1..)) => *depth -= 1,
            (Some(false), _) => inside(object),
            (None, _) => {}
        }
    }
    // Those that it never comes out of.
    entered.objects[..entered.depth]
        .iter()
        .for_each(|&object| inside(object));
    best
}

/// The open objects that a ray came into by the front and did not leave, outermost first, by index. Plain data, so that the
/// reflected and the transmitted ray each carry their own copy without allocation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenMedia {
    objects: [u32; NESTING],
    depth: usize,
}

impl OpenMedia {
    /// None.
    pub const NOTHING: Self = Self {
        objects: [NONE; NESTING],
        depth: 0,
    };

    /// The objects after the ray went into `object`.
    #[must_use]
    #[inline(always)]
    pub fn and(mut self, object: u32) -> Self {
        if self.depth == NESTING {
            self.objects.rotate_left(1);
            self.depth -= 1;
        }
        self.objects[self.depth] = object;
        self.depth += 1;
        self
    }

    /// The objects after the ray came out of `object`: its innermost entry goes, wherever it stands, so that objects that
    /// overlap are left in any order. Nothing changes if the ray was not inside.
    #[must_use]
    #[inline(always)]
    pub fn without(mut self, object: u32) -> Self {
        let inside = &self.objects[..self.depth];
        if let Some(i) = inside.iter().rposition(|&o| o == object) {
            self.objects.copy_within(i + 1..self.depth, i);
            self.depth -= 1;
            self.objects[self.depth] = NONE;
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The medium of a ray that goes into `+` and comes out of `-` these objects, whose ranks are their numbers.
    fn before(entered: &[u32], way: &[(char, u32)]) -> u32 {
        let ahead: Vec<Crossing> = way
            .iter()
            .map(|&(sign, object)| Crossing {
                hit: Hit {
                    t: 1.0,
                    primitive: 0,
                    part: 0,
                    place: [0.0; 3],
                },
                object,
                enters: Some(sign == '+'),
            })
            .collect();
        let entered = entered
            .iter()
            .fold(OpenMedia::NOTHING, |open, &object| open.and(object));
        medium(&entered, &ahead, |object| object)
    }

    #[test]
    fn a_ray_is_inside_of_what_it_leaves_without_entering() {
        assert_eq!(before(&[], &[]), NONE);
        assert_eq!(before(&[], &[('+', 1), ('-', 1)]), NONE);
        assert_eq!(before(&[], &[('-', 1)]), 1);
        assert_eq!(before(&[], &[('+', 2), ('-', 2), ('-', 1)]), 1);
        // Two parts of one object overlap: it is left for good only once.
        assert_eq!(before(&[], &[('+', 1), ('-', 1), ('-', 1)]), 1);
    }

    #[test]
    fn of_many_the_highest_rank_decides_in_whatever_order_they_are_left() {
        assert_eq!(before(&[], &[('-', 2), ('-', 1)]), 2);
        assert_eq!(before(&[], &[('-', 1), ('-', 2)]), 2);
        assert_eq!(before(&[3, 4], &[]), 4);
        assert_eq!(before(&[4, 3], &[('-', 1)]), 4);
        assert_eq!(before(&[3, 4], &[('-', 5)]), 5);
    }

    #[test]
    fn what_is_entered_can_be_left_in_any_order() {
        let inside = OpenMedia::NOTHING.and(7).and(3).and(5);
        let list = |e: OpenMedia| e.objects[..e.depth].to_vec();
        assert_eq!(list(inside.without(3)), [7, 5]);
        assert_eq!(list(inside.without(5).without(9)), [7, 3]);
        let nothing = inside.without(5).without(3).without(7);
        assert_eq!(nothing, OpenMedia::NOTHING);
        let deep = (0..100).fold(OpenMedia::NOTHING, OpenMedia::and);
        assert_eq!((0..100).fold(deep, OpenMedia::without), OpenMedia::NOTHING);
    }
}
