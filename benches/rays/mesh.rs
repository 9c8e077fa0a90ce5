//! What is measured: triangles in a box of 2 units around the origin.

use raytree::geometry::{Aabb, Shape, Triangle};
use raytree::math::DVec3;

use crate::ball::bumpy_ball;

/// The names of all meshes, and their triangles.
pub fn all() -> Vec<(&'static str, Vec<Triangle>)> {
    vec![
        ("room", room()),
        ("bunny", built_in("bunny", "bunny")),
        ("slanted", built_in("slanted", "")),
        ("ball", bumpy_ball(158)),
    ]
}

/// The triangles of a box, turned about the y axis.
fn turned_box(center: DVec3, half: DVec3, angle: f64) -> Vec<Triangle> {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let place = |s: [f64; 3]| {
        let p = DVec3::from(s) * half;
        center + DVec3::new(cos * p.x + sin * p.z, p.y, cos * p.z - sin * p.x)
    };
    (0..3)
        .flat_map(|axis| [-1.0, 1.0].map(|side| (axis, side)))
        .flat_map(|(axis, side)| {
            let at = |u: f64, v: f64| {
                let mut s = [side; 3];
                (s[(axis + 1) % 3], s[(axis + 2) % 3]) = (u, v);
                place(s)
            };
            let (a, b, c, d) = (at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0));
            [[a, b, c], [a, c, d]].map(|corners| Triangle { corners })
        })
        .collect()
}

/// 36 triangles, a few large polygons: what a tree of the polygons' own planes is best at.
fn room() -> Vec<Triangle> {
    [
        turned_box(DVec3::ZERO, DVec3::splat(4.0), 0.0),
        turned_box(DVec3::new(-0.5, -0.4, -0.5), DVec3::new(0.3, 0.6, 0.3), 0.3),
        turned_box(DVec3::new(0.5, -0.7, 0.2), DVec3::splat(0.3), -0.4),
    ]
    .concat()
}

/// The triangles of a built-in scene that belong to objects of such names, moved into the box.
fn built_in(scene: &str, objects: &str) -> Vec<Triangle> {
    let scene = raytree::scene::load(scene).expect("built in");
    let shapes = scene.shapes.iter().enumerate();
    let wanted = |id: usize| scene.object_of(id as u32).name.contains(objects);
    let triangles = shapes.filter_map(|(id, shape)| match shape {
        Shape::Triangle(triangle) if wanted(id) => Some(*triangle),
        _ => None,
    });
    let triangles: Vec<Triangle> = triangles.collect();
    let bounds = Aabb::around(triangles.iter().flat_map(|t| t.corners));
    let scale = 2.0 / bounds.size().max_element();
    let fit = |p: DVec3| (p - bounds.center()) * scale;
    let fitted = |t: Triangle| Triangle {
        corners: t.corners.map(fit),
    };
    triangles.into_iter().map(fitted).collect()
}
