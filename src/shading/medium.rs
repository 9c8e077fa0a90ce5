//! Which medium a ray travels in.

use crate::probe::NONE;

/// How many objects may be nested in each other before the outermost is forgotten.
pub const NESTING: usize = 16;

/// The transparent objects that a ray is inside of, outermost first, by object index. Plain data, so that the
/// reflected and the transmitted ray each carry their own copy without allocation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Media {
    objects: [u32; NESTING],
    depth: usize,
}

impl Media {
    /// Inside nothing: the scene's air.
    pub const AIR: Self = Self {
        objects: [NONE; NESTING],
        depth: 0,
    };

    /// The innermost object, or [`NONE`] for air.
    pub fn current(&self) -> u32 {
        self.depth.checked_sub(1).map_or(NONE, |i| self.objects[i])
    }

    /// The media after the ray went into `object`.
    #[must_use]
    #[inline]
    pub fn entered(mut self, object: u32) -> Self {
        if self.depth == NESTING {
            self.objects.rotate_left(1);
            self.depth -= 1;
        }
        self.objects[self.depth] = object;
        self.depth += 1;
        self
    }

    /// The media after the ray came out of `object`: its innermost entry goes, wherever it stands, so that objects
    /// that overlap are left in any order. Nothing changes if the ray was not inside.
    #[must_use]
    #[inline]
    pub fn left(mut self, object: u32) -> Self {
        if let Some(i) = self.objects[..self.depth]
            .iter()
            .rposition(|&o| o == object)
        {
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

    #[test]
    fn what_is_entered_can_be_left_in_any_order() {
        let inside = Media::AIR.entered(7).entered(3).entered(5);
        assert_eq!(inside.current(), 5);
        assert_eq!(inside.left(3).current(), 5);
        assert_eq!(inside.left(3).left(5).current(), 7);
        assert_eq!(inside.left(5).left(3).left(7), Media::AIR);
        assert_eq!(inside.left(9), inside);
    }

    #[test]
    fn nesting_without_end_is_bounded() {
        let deep = (0..100).fold(Media::AIR, Media::entered);
        assert_eq!(deep.current(), 99);
        assert_eq!((0..100).fold(deep, Media::left), Media::AIR);
    }
}
