//! Frames: the coordinates in which the objects of a group were described.

use crate::math::{Ray, Transform};

/// Frame of a group, or of a part where it is used.
#[derive(Clone, Debug)]
pub struct ObjectFrame {
    /// The name of the group, with those that it stands in: `car/left`.
    pub name: String,
    /// How the group is placed in the frame around it, in words.
    pub placed: String,
    /// From the frame to the world; `None` if they are the same.
    pub to_world: Option<Transform>,
    /// Index of the frame around it; `None` for the world.
    pub outer: Option<u32>,
}

impl ObjectFrame {
    /// A ray in this frame: its t are those of the ray in the world.
    pub fn ray(&self, ray: &Ray) -> Ray {
        self.to_world.map_or(*ray, |map| map.ray_to_object(ray))
    }

    /// Three rows of four numbers, of which the last are a translation.
    pub fn matrix(&self) -> [[f64; 4]; 3] {
        let map = self
            .to_world
            .map_or_else(Default::default, |map| map.to_world());
        std::array::from_fn(|row| {
            let [x, y, z] = map.matrix3.row(row).to_array();
            [x, y, z, map.translation[row]]
        })
    }
}
