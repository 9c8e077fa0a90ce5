//! Bounding box of the rays and objects that a drawing of the ray paths shows.

use crate::geometry::Aabb;
use crate::math::{DVec3, Ray};
use crate::probe::RayKind;
use crate::scene::Scene;
use crate::trace::{Node, Outcome, View};

/// Rays that the drawing shows at most.
pub const MAX_DRAWN: usize = 2000;

/// The least share of the pixel of a ray that the drawing makes room for.
pub const VISIBLE_SHARE: f64 = 0.01;

/// A box around the paths that matter to the pixel, and around what they hit if that is not much larger. Lights may
/// be far away: rays to them leave the drawing.
pub fn extent(view: View) -> Aabb {
    let tree = &view.trace.tree;
    let nodes = (0..tree.nodes.len().min(MAX_DRAWN) as u32).filter(|id| {
        let node = tree.node(*id);
        node.ray.kind != RayKind::Light
            && (node.parent.is_none() || view.fraction(*id) >= VISIBLE_SHARE)
    });
    if !view.trace.is_whole() {
        return before_a_question(view);
    }
    let (mut points, mut met) = (Aabb::EMPTY, Vec::new());
    for id in nodes {
        let node = tree.node(id);
        points = points.union(Aabb::around([node.ray.origin]));
        if let Some(Outcome::Hit(hit)) = node.outcome {
            let ray = Ray::new(node.ray.origin, node.ray.direction);
            points = points.union(Aabb::around([ray.at(hit.t)]));
            met.push(view.world.scene.owners[hit.primitive as usize]);
        }
    }
    fitted(&view.world.scene, points, met)
}

/// A box around all that has an end and the starts of the rays: where they end is asked for.
fn before_a_question(view: View) -> Aabb {
    let scene = &view.world.scene;
    let objects = (0..scene.objects.len() as u32).filter_map(|object| bounds(scene, object));
    let nodes = view.trace.tree.nodes.iter().take(MAX_DRAWN);
    let starts = nodes.map(|node| node.ray.origin).chain([scene.camera.eye]);
    fitted(
        scene,
        objects.fold(Aabb::around(starts), Aabb::union),
        Vec::new(),
    )
}

/// A box around points, and around the objects that were met there if those are not much larger.
pub fn fitted(scene: &Scene, points: Aabb, mut met: Vec<u32>) -> Aabb {
    met.sort_unstable();
    met.dedup();
    let objects = met.into_iter().filter_map(|object| bounds(scene, object));
    let near = objects.filter(|bounds| bounds.size().length() < points.size().length());
    let all = near.fold(points, Aabb::union);
    let margin = 0.05 * all.size().length().max(0.1);
    all.padded(DVec3::splat(margin))
}

/// An extent with a ray, whatever it contributes; but without the light that an L ray goes to.
pub fn with_ray(extent: Aabb, node: &Node) -> Aabb {
    let ray = Ray::new(node.ray.origin, node.ray.direction);
    let end = match node.outcome {
        Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => ray.at(hit.t),
        _ => ray.origin,
    };
    extent.union(Aabb::around([ray.origin, end]))
}

/// A box around an object; `None` if a part of it is unbounded.
fn bounds(scene: &Scene, object: u32) -> Option<Aabb> {
    let first = scene.objects.get(object as usize)?.first_primitive as usize;
    let count = scene
        .owners
        .get(first..)?
        .iter()
        .take_while(|o| **o == object)
        .count();
    let mut shapes = scene.shapes.get(first..first + count)?.iter();
    shapes.try_fold(Aabb::EMPTY, |all, shape| Some(all.union(shape.bounds()?)))
}
