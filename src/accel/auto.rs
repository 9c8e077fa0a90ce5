//! Which accelerator to take when nobody asks for one.

use super::AccelKind;
use crate::geometry::Shape;

/// Up to so many shapes, testing all of them is quicker than finding out which to leave out. Measured with
/// `cargo bench -p raytree-benches --bench pictures`: on whole pictures of 4 to 9 shapes the list is 1.1 to 1.7 times as fast as `wide`,
/// on 36 shapes `wide` is 4 times as fast as the list.
const FEW: usize = 12;

/// Up to so many shapes, a BSP tree is built before anybody notices.
const MANY: usize = 20_000;

/// The fastest one: a picture of any kind of ray is drawn sooner with it.
pub fn fastest(shapes: &[Shape]) -> AccelKind {
    if shapes.len() <= FEW {
        AccelKind::List
    } else {
        AccelKind::Wide
    }
}

/// The one that is easiest to follow step by step: a BSP tree, unless one would wait for it.
pub fn clearest(shapes: &[Shape]) -> AccelKind {
    if shapes.len() <= MANY {
        AccelKind::Bsp
    } else {
        AccelKind::Wide
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Sphere;
    use crate::math::DVec3;

    #[test]
    fn the_number_of_shapes_decides() {
        let balls = |count| {
            let ball = Sphere {
                center: DVec3::ZERO,
                radius: 1.0,
            };
            vec![Shape::Sphere(ball); count]
        };
        assert_eq!(fastest(&balls(FEW)), AccelKind::List);
        assert_eq!(fastest(&balls(FEW + 1)), AccelKind::Wide);
        assert_eq!(clearest(&balls(MANY)), AccelKind::Bsp);
        assert_eq!(clearest(&balls(MANY + 1)), AccelKind::Wide);
    }
}
