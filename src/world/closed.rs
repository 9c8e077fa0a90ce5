//! Which objects bound a part of space, so that every line comes out of them as often as it goes in.

use crate::geometry::patch::{enclosed_volume as enclosed_by, open_edges};
use crate::geometry::{Shape, SurfacePatch};
use crate::math::DVec3;

/// Whether shapes bound a part of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closing {
    /// They are solids, or triangles and polygons that close: each edge is run through as often in one direction as in the other.
    Closed,
    /// Triangles close, but some are turned over: at so many edges.
    Mixed(usize),
    /// Something without an inside, or triangles with so many edges that have no triangle on the other side.
    Open(usize),
}

/// Whether the shapes bound a part of space. What it costs is a sort of the edges.
pub fn closing(shapes: &[Shape]) -> Closing {
    let mut edges: Vec<(Edge, i32)> = Vec::new();
    let mut sheets = false;
    let mut patches = Vec::new();
    for shape in shapes {
        match shape.plain() {
            Shape::Triangle(triangle) => {
                let [a, b, c] = triangle.corners;
                edges.extend([[a, b], [b, c], [c, a]].map(directed));
            }
            Shape::Polygon(polygon) => edges.extend(polygon.edges().map(directed)),
            Shape::Patch(patch) => patches.push((**patch).clone()),
            other => match other.mesh() {
                // A map that can be undone keeps it closed.
                Some((mesh, _)) => edges.extend(mesh.triangles().iter().flat_map(|triangle| {
                    let [a, b, c] = triangle.corners;
                    [[a, b], [b, c], [c, a]].map(directed)
                })),
                None => sheets |= !other.is_solid(),
            },
        }
    }
    edges.sort_unstable();
    let (mut open, mut turned) = (open_edges(&patches), 0);
    for same in edges.chunk_by(|(a, _), (b, _)| a == b) {
        if same.iter().map(|(_, way)| way).sum::<i32>() != 0 {
            let lone = same.len() % 2 == 1;
            *(if lone { &mut open } else { &mut turned }) += 1;
        }
    }
    match (sheets || open > 0, turned) {
        (true, _) => Closing::Open(open),
        (false, 0) => Closing::Closed,
        (false, turned) => Closing::Mixed(turned),
    }
}

/// True if the shapes bound a part of space.
pub fn is_closed(shapes: &[Shape]) -> bool {
    closing(shapes) == Closing::Closed
}

/// The volume inside of shapes that are closed, in cubic metres, as rounded. Of triangles and polygons: the sum of the pyramids that
/// they span with one point (divergence theorem).
pub fn enclosed_volume(shapes: &[Shape]) -> f64 {
    let mut base = None;
    let volume = |shape: &Shape| match shape.plain() {
        Shape::Triangle(triangle) => {
            let base = *base.get_or_insert(triangle.corners[0]);
            let [a, b, c] = triangle.corners.map(|corner| corner - base);
            a.dot(b.cross(c)) / 6.0
        }
        Shape::Polygon(polygon) => {
            let base = *base.get_or_insert(polygon.center());
            polygon.area_vector().dot(polygon.center() - base) / 3.0
        }
        solid => solid.volume(),
    };
    let patches: Vec<SurfacePatch> = shapes
        .iter()
        .filter_map(|shape| match shape.plain() {
            Shape::Patch(patch) => Some((**patch).clone()),
            _ => None,
        })
        .collect();
    let flat = shapes.iter().map(volume).sum::<f64>();
    (flat + enclosed_by(&patches)).abs()
}

/// An edge, and 1 or -1 for the way in which it is run through.
fn directed(ends: [DVec3; 2]) -> (Edge, i32) {
    let [p, q] = ends.map(bits);
    if p < q { ((p, q), 1) } else { ((q, p), -1) }
}

/// Two ends, the smaller one first.
type Edge = ([u64; 3], [u64; 3]);

/// A point that can be compared: -0 is 0.
pub fn bits(point: DVec3) -> [u64; 3] {
    (point + 0.0).to_array().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Plane, Sphere, Triangle};

    fn tetrahedron() -> Vec<Shape> {
        let p = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
            .map(|face| {
                Shape::Triangle(Triangle {
                    corners: face.map(|i| p[i]),
                })
            })
            .to_vec()
    }

    #[test]
    fn a_mesh_without_holes_is_closed_and_one_with_a_hole_is_not() {
        let closed = tetrahedron();
        assert!(is_closed(&closed));
        assert!(!is_closed(&closed[1..]));
        // A face that is turned over, and one that stands twice.
        let mut turned = closed.clone();
        if let Shape::Triangle(t) = &mut turned[0] {
            t.corners.swap(0, 1);
        }
        assert!(!is_closed(&turned));
        let twice = [closed.clone(), closed[..1].to_vec()].concat();
        assert!(!is_closed(&twice));
        assert!(is_closed(&[closed.clone(), closed].concat()));
    }

    #[test]
    fn the_volume_of_a_mesh_is_that_of_its_tetrahedra() {
        assert_eq!(enclosed_volume(&tetrahedron()), 1.0 / 6.0);
        assert_eq!(enclosed_volume(&[]), 0.0);
    }

    #[test]
    fn solids_are_closed_and_planes_are_open() {
        let ball = Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        };
        assert!(is_closed(&[Shape::Sphere(ball)]));
        let floor = Plane::new(DVec3::ZERO, DVec3::Y);
        assert!(!is_closed(&[
            Shape::Sphere(ball),
            Shape::Plane(Box::new(floor))
        ]));
    }
}
