//! The kinds of acceleration structure, and which one to take if none is asked for.

use crate::geometry::Shape;

/// Which accelerator to build.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum AccelKind {
    /// Test every shape.
    List,
    /// A BSP tree; which planes split is decided by the scene.
    #[default]
    Bsp,
    /// A BSP tree split along the axes by the surface area heuristic.
    BspAxis,
    /// A BSP tree split by the planes of the scene's own polygons, as in the lectures.
    BspPolygon,
    /// A BSP tree split by planes along the axes or at any angle, by the surface area heuristic.
    BspSah,
    /// A kd-tree: the best planes along the axes that there are.
    Kd,
    /// A grid of cells.
    Grid,
    /// An octree.
    Octree,
    /// A binary tree of boxes.
    Bvh,
    /// A binary tree of spheres.
    BvhSpheres,
    /// A tree of boxes, eight to a node: the fast one.
    Wide,
}

impl AccelKind {
    /// Every kind.
    pub const ALL: [Self; 11] = [
        Self::List,
        Self::Bsp,
        Self::BspAxis,
        Self::BspPolygon,
        Self::BspSah,
        Self::Kd,
        Self::Grid,
        Self::Octree,
        Self::Bvh,
        Self::BvhSpheres,
        Self::Wide,
    ];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// What it does, in a line.
    pub fn note(self) -> &'static str {
        match self {
            Self::List => "Test every shape",
            Self::Bsp => "A BSP tree; the scene decides which planes split",
            Self::BspAxis => "A BSP tree split along the axes",
            Self::BspPolygon => "A BSP tree split by the scene's own polygons",
            Self::BspSah => "A BSP tree: the best planes at any angle",
            Self::Kd => "A kd-tree: the best planes along the axes",
            Self::Grid => "A uniform grid of cells",
            Self::Octree => "An octree: cubes halved along all axes",
            Self::Bvh => "A binary tree of boxes",
            Self::BvhSpheres => "The same tree of spheres, to see why boxes win",
            Self::Wide => "A tree of boxes, eight to a node: the fast one",
        }
    }
}

/// Up to so many shapes, testing all of them is quicker than finding out which to leave out. Measured with
/// `cargo bench -p raytree-benches --bench pictures`: on whole pictures of 4 to 9 shapes the list is 1.1 to 1.7 times as fast as `wide`,
/// on 36 shapes `wide` is 4 times as fast as the list.
const FEW: usize = 12;

/// Up to so many shapes, a BSP tree is built at once.
const MANY: usize = 20_000;

/// The fastest one: a picture of any kind of ray is drawn sooner with it.
pub fn fastest(shapes: &[Shape]) -> AccelKind {
    if shapes.len() <= FEW {
        AccelKind::List
    } else {
        AccelKind::Wide
    }
}

/// The one that is easiest to follow step by step: a BSP tree, unless building one takes long.
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
