//! Contact of an object with media: what has to be asked at its surface to know the media there, as little as the scene allows.

use super::neighbour::Neighbour;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;
use crate::scene::Scene;
use crate::shading::Material;

/// Contact of an object with media.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// Nothing: it is opaque, and no mirror that touches something transparent.
    None,
    /// It is a transparent solid near nothing else: only its own surface matters.
    Isolated,
    /// It is a transparent sphere that touches others at single points at most: only its own surface matters, but near these.
    Resting,
    /// Other surfaces may be crossed together with its own, or be around it or inside it.
    Touching,
}

/// Boxes that are compared at most; with more, nobody is found to be alone.
const MOST_PAIRS: usize = 1 << 24;

/// Contacts of all objects.
#[derive(Clone, Debug)]
pub struct Contacts {
    /// Of each object.
    pub of: Vec<Contact>,
    /// For each object that is [`Contact::Resting`] what it may touch; empty for all others.
    pub neighbours: Vec<Vec<Neighbour>>,
}

/// Contact of each object. Rather too much than too little: boxes stand for objects, and are grown by far more than
/// rounding could move a surface.
pub fn contacts(scene: &Scene) -> Contacts {
    let count = scene.objects.len();
    let material = |o: usize| &scene.materials[scene.objects[o].material as usize];
    let sends_rays = |o: usize| {
        let mut materials = scene.materials_of(&scene.objects[o]);
        materials.any(Material::sends_rays)
    };
    let media: Vec<usize> = (0..count)
        .filter(|o| material(*o).is_transmissive())
        .collect();
    let asked = (0..count).filter(|o| sends_rays(*o)).count();
    let mut neighbours = vec![Vec::new(); count];
    if media.is_empty() {
        let of = vec![Contact::None; count];
        return Contacts { of, neighbours };
    }
    let in_doubt = asked.saturating_mul(count) > MOST_PAIRS;
    let extents: Vec<Extent> = (0..count as u32)
        .map(|o| Extent::of(scene.shapes_of(o)))
        .collect();
    let of = (0..count)
        .map(|o| {
            let near = |other: &usize| *other != o && extents[o].meets(&extents[*other]);
            let single = scene.shapes_of(o as u32).len() == 1;
            match material(o) {
                _ if !sends_rays(o) => Contact::None,
                _ if in_doubt => Contact::Touching,
                m if m.is_transmissive() => {
                    let solid = single && scene.shapes_of(o as u32)[0].is_solid();
                    if solid && !(0..count).any(|other| near(&other)) {
                        Contact::Isolated
                    } else if let Some(found) = Neighbour::all(scene, o, (0..count).filter(near)) {
                        neighbours[o] = found;
                        Contact::Resting
                    } else {
                        Contact::Touching
                    }
                }
                _ if media.iter().any(near) => Contact::Touching,
                _ => Contact::None,
            }
        })
        .collect();
    Contacts { of, neighbours }
}

/// The part of space that an object is in.
enum Extent {
    Box(Aabb),
    /// All that is near a plane n.p = d.
    Plane(DVec3, f64),
    Everywhere,
}

impl Extent {
    fn of(shapes: &[Shape]) -> Self {
        if let [shape] = shapes
            && let Shape::Plane(plane) = shape.plain()
        {
            let n = plane.normal();
            return Self::Plane(n, n.dot(plane.origin()));
        }
        let boxes: Option<Vec<Aabb>> = shapes.iter().map(grown).collect();
        boxes.map_or(Self::Everywhere, |boxes| {
            Self::Box(boxes.into_iter().fold(Aabb::EMPTY, Aabb::union))
        })
    }

    fn meets(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Box(a), Self::Box(b)) => a.min.cmple(b.max).all() && b.min.cmple(a.max).all(),
            (Self::Box(b), Self::Plane(n, d)) | (Self::Plane(n, d), Self::Box(b)) => {
                let sides = b.corners().map(|corner| n.dot(corner) - d);
                // The boxes are grown; a plane that only just misses one of them is far from what is inside.
                sides.iter().any(|s| *s >= 0.0) && sides.iter().any(|s| *s <= 0.0)
            }
            _ => true,
        }
    }
}

/// The box around a shape, grown by a millionth of its largest coordinate: errors are multiples of 2^-53 of that, for a shape
/// that was stretched many times as much.
fn grown(shape: &Shape) -> Option<Aabb> {
    let bounds = shape.bounds()?;
    let condition = match shape.plain() {
        Shape::Transformed(transformed) => transformed.transform.condition(),
        _ => 1.0,
    };
    let reach = bounds.min.abs().max(bounds.max.abs()).max_element();
    Some(bounds.padded(DVec3::splat(1e-6 * condition * reach)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contact of the objects of a scene of glass (g), mirror (m) and chalk balls of radius 1, along the x axis.
    fn contacts_of(balls: &[(&str, f64)]) -> Vec<Contact> {
        let objects: Vec<String> = balls
            .iter()
            .enumerate()
            .map(|(i, (material, x))| {
                format!(
                    r#"{{"sphere": {{"name": "{i}", "material": "{material}", "center": [{x}, 0, 0], "radius": 1}}}}"#
                )
            })
            .collect();
        let text = format!(
            r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 9], "look_at": [0, 0, 0]}}, "materials": {{
            "glass": {{"transmission": [1, 1, 1]}}, "mirror": {{"mirror": [1, 1, 1]}}, "chalk": {{}}}},
            "objects": [{}]}}"#,
            objects.join(", ")
        );
        contacts(&crate::scene::from_json(&text).expect("a scene")).of
    }

    #[test]
    fn what_touches_a_medium_is_in_contact() {
        use Contact::{Isolated, None, Resting, Touching};
        assert_eq!(contacts_of(&[("chalk", 0.0), ("mirror", 0.0)]), [None; 2]);
        assert_eq!(
            contacts_of(&[("glass", 0.0), ("chalk", 3.0)]),
            [Isolated, None]
        );
        assert_eq!(
            contacts_of(&[("glass", 0.0), ("mirror", 3.0)]),
            [Isolated, None]
        );
        assert_eq!(
            contacts_of(&[("glass", 0.0), ("mirror", 2.0)]),
            [Resting, Touching]
        );
        assert_eq!(
            contacts_of(&[("glass", 0.0), ("chalk", 2.0)]),
            [Resting, None]
        );
        assert_eq!(
            contacts_of(&[("glass", 0.0), ("glass", 0.5)]),
            [Touching; 2]
        );
        assert_eq!(
            contacts_of(&[("glass", 0.0), ("chalk", 1.999_999)]),
            [Touching, None]
        );
    }
}
