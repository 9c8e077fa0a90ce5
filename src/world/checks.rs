//! Checks of a scene in space: bodies that are none, an eye or a lamp in the dark, lights and cameras that miss everything.
//!
//! Each warns only where it is sure. What a scene says by itself is checked in [`crate::scene::check`].

mod bodies;
mod inside;
mod overlap;
mod reach;
mod view;

use super::World;
use crate::geometry::{Aabb, Shape};
use crate::scene::error::FieldPath;
use crate::scene::warning::Warnings;
use crate::scene::{Effect, Settings, Warning};

/// A world with what it is looked at with, and where its scene comes from.
struct Checked<'a> {
    world: &'a World,
    settings: &'a Settings,
    path: FieldPath<'a>,
}

/// Warnings about a world that is rendered with `settings`. `label` is what the user calls the scene.
pub fn warnings(world: &World, settings: &Settings, label: &str) -> Vec<Warning> {
    let checked = Checked {
        world,
        settings,
        path: FieldPath::root(label),
    };
    let mut found = Warnings::default();
    bodies::check(&checked, &mut found);
    overlap::check(&checked, &mut found);
    view::check(&checked, &mut found);
    inside::eye(&checked, &mut found);
    // Without shadows nothing is in the way of light.
    if settings.effects.has(Effect::Shadows) {
        inside::lamps(&checked, &mut found);
        reach::behind_planes(&checked, &mut found);
    }
    reach::cones(&checked, &mut found);
    found.into_list(label)
}

/// A box around shapes; `None` if one has no end.
fn bounds(shapes: &[Shape]) -> Option<Aabb> {
    let mut boxes = shapes.iter().map(Shape::bounds);
    boxes.try_fold(Aabb::EMPTY, |all, next| Some(all.union(next?)))
}
