//! Hit collectors: the closest hit, the first one that turns up (any hit), or all.

use crate::geometry::Hit;

/// Collector of a search's hits.
pub trait Collect {
    /// Whether the first hit ends the search.
    const ANY: bool;

    /// The closest hit so far, if what lies behind it is of no use.
    fn closest(&self) -> Option<&Hit>;

    /// Takes a hit that is closer than [`Collect::closest`].
    fn add(&mut self, hit: Hit);
}

/// The first hit that turns up: all that a shadow ray asks for.
#[derive(Clone, Copy, Debug, Default)]
pub struct AnyHit(pub Option<Hit>);

/// All hits, in no order, and some of them more than once: a tree may refer to a primitive from many leaves.
pub struct AllHits<'a>(pub &'a mut Vec<Hit>);

/// The closest hit; of equal t the one with the smallest primitive id.
impl Collect for Option<Hit> {
    const ANY: bool = false;

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
    const ANY: bool = true;

    #[inline(always)]
    fn closest(&self) -> Option<&Hit> {
        self.0.as_ref()
    }

    #[inline(always)]
    fn add(&mut self, hit: Hit) {
        self.0 = Some(hit);
    }
}

impl Collect for AllHits<'_> {
    const ANY: bool = false;

    #[inline(always)]
    fn closest(&self) -> Option<&Hit> {
        None
    }

    #[inline(always)]
    fn add(&mut self, hit: Hit) {
        self.0.push(hit);
    }
}
