//! Hit collectors: the closest hit, the first one that turns up (any hit), or all.

use crate::geometry::Hit;

/// Collector of a search's hits.
pub trait Collect {
    /// The closest hit so far, if what lies behind it is of no use.
    fn closest(&self) -> Option<&Hit>;

    /// Takes a hit that is closer than [`Collect::closest`].
    fn add(&mut self, hit: Hit);

    /// Whether the search is over, whatever else there is.
    #[inline(always)]
    fn is_over(&self) -> bool {
        false
    }
}

/// The first hit that turns up: all that a shadow ray asks for.
#[derive(Clone, Copy, Debug, Default)]
pub struct AnyHit(pub Option<Hit>);

/// All hits, in no order, and some of them more than once: a tree may refer to a primitive from many leaves.
pub struct AllHits<'a>(pub &'a mut Vec<Hit>);

/// The closest hit; of equal t the one with the smallest primitive id.
impl Collect for Option<Hit> {
    #[inline(always)]
    fn closest(&self) -> Option<&Hit> {
        self.as_ref()
    }

    #[inline(always)]
    fn add(&mut self, hit: Hit) {
        *self = Some(hit);
    }
}

impl Collect for AnyHit {
    #[inline(always)]
    fn closest(&self) -> Option<&Hit> {
        None
    }

    #[inline(always)]
    fn add(&mut self, hit: Hit) {
        self.0 = Some(hit);
    }

    #[inline(always)]
    fn is_over(&self) -> bool {
        self.0.is_some()
    }
}

impl Collect for AllHits<'_> {
    #[inline(always)]
    fn closest(&self) -> Option<&Hit> {
        None
    }

    #[inline(always)]
    fn add(&mut self, hit: Hit) {
        self.0.push(hit);
    }
}
