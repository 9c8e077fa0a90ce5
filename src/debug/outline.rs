//! Outlines of the scene's objects for a line drawing.

use crate::geometry::{Body, Quadric, Shape, Solid, SurfacePatch, Torus};
use crate::math::DVec3;
use crate::scene::Scene;

/// Objects that are drawn at most.
const MAX_OBJECTS: usize = 400;

/// Corners that are drawn of a mesh at most.
const MAX_CORNERS: usize = 600;

/// And at least, however many meshes there are.
const FEW_CORNERS: usize = 30;

/// Objects of at most so many triangles are drawn edge by edge.
const FEW_TRIANGLES: usize = 64;

/// Points of a circle.
const CIRCLE: usize = 72;

/// An object as the drawing shows it.
#[derive(Clone, Debug)]
pub enum ObjectOutline {
    /// Edges.
    Edges(Vec<[DVec3; 2]>),
    /// Points of its surface.
    Points(Vec<DVec3>),
    /// A sphere: a circle from every side.
    Sphere(DVec3, f64),
    /// An unbounded plane n.p = d: a line if it is seen from its edge, else nothing.
    Plane(DVec3, f64),
}

/// The outlines of a scene's objects.
pub fn outlines(scene: &Scene) -> Vec<ObjectOutline> {
    let starts = scene.objects.iter().map(|o| o.first_primitive as usize);
    let ends = starts.clone().skip(1).chain([scene.shapes.len()]);
    let uses = scene.shapes.iter().filter(|s| s.mesh().is_some()).count();
    // Many uses of meshes share the corners of ten.
    let corners = (10 * MAX_CORNERS / uses.max(10)).max(FEW_CORNERS);
    starts
        .zip(ends)
        .take(MAX_OBJECTS)
        .filter_map(|(start, end)| scene.shapes.get(start..end))
        .flat_map(|shapes| of_object(shapes, corners))
        .collect()
}

/// The outlines of an object; of a mesh that is kept once at most so many corners.
fn of_object(shapes: &[Shape], corners: usize) -> Vec<ObjectOutline> {
    let triangles = || {
        shapes.iter().filter_map(|shape| match shape.plain() {
            Shape::Triangle(triangle) => Some(triangle.corners),
            _ => None,
        })
    };
    if let [shape] = shapes
        && shape.mesh().is_some()
    {
        return vec![of_mesh(shape, corners)];
    }
    let count = triangles().count();
    let mut outlines: Vec<_> = shapes
        .iter()
        .take(MAX_OBJECTS)
        .filter_map(of_shape)
        .collect();
    if count > FEW_TRIANGLES {
        let step = (3 * count).div_ceil(MAX_CORNERS);
        outlines.push(ObjectOutline::Points(
            triangles().flatten().step_by(step).collect(),
        ));
    } else if count > 0 {
        let edges = triangles().flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
        outlines.push(ObjectOutline::Edges(edges.collect()));
    }
    outlines
}

/// Points of a mesh that is kept once.
fn of_mesh(shape: &Shape, most: usize) -> ObjectOutline {
    let corners = 3 * shape.triangle_count();
    let step = (corners as usize).div_ceil(most).max(1);
    let corner = |i: u32| Some(shape.triangle(i / 3)?.corners[i as usize % 3]);
    ObjectOutline::Points((0..corners).step_by(step).filter_map(corner).collect())
}

/// The outline of a single shape, a triangle included.
pub fn of_one(shape: &Shape) -> Option<ObjectOutline> {
    match shape.plain() {
        Shape::Triangle(triangle) => {
            let [a, b, c] = triangle.corners;
            Some(ObjectOutline::Edges(vec![[a, b], [b, c], [c, a]]))
        }
        _ if shape.mesh().is_some() => Some(of_mesh(shape, MAX_CORNERS)),
        _ => of_shape(shape),
    }
}

fn of_shape(shape: &Shape) -> Option<ObjectOutline> {
    match shape {
        Shape::Triangle(_) | Shape::Mesh(_) => None,
        Shape::Naive(naive) => of_shape(&naive.shape),
        Shape::Sphere(sphere) => Some(ObjectOutline::Sphere(sphere.center, sphere.radius)),
        Shape::Plane(plane) => Some(ObjectOutline::Plane(
            plane.normal(),
            plane.normal().dot(plane.origin()),
        )),
        Shape::Cuboid(cuboid) => Some(ObjectOutline::Edges(edges(cuboid.bounds.corners()))),
        Shape::Patch(patch) => Some(ObjectOutline::Edges(of_patch(patch))),
        Shape::Body(body) => Some(ObjectOutline::Edges(of_body(body))),
        Shape::Polygon(polygon) => Some(ObjectOutline::Edges(polygon.edges().collect())),
        Shape::Disc(disc) => {
            let rim = |[c, s]: [f64; 2]| {
                disc.center + disc.radius * (c * disc.frame.u + s * disc.frame.v)
            };
            let points: Vec<_> = turns().map(rim).collect();
            let next = points.iter().cycle().skip(1);
            Some(ObjectOutline::Edges(
                points.iter().zip(next).map(|(a, b)| [*a, *b]).collect(),
            ))
        }
        Shape::Transformed(transformed) => {
            let to_world = |p: &DVec3| transformed.transform.point(*p);
            match of_shape(&transformed.shape)? {
                ObjectOutline::Edges(edges) => {
                    let edges = edges.iter().map(|[a, b]| [to_world(a), to_world(b)]);
                    Some(ObjectOutline::Edges(edges.collect()))
                }
                ObjectOutline::Sphere(center, radius) => {
                    // Three great circles tell how a sphere was stretched.
                    let circles = [
                        [DVec3::X, DVec3::Y],
                        [DVec3::Y, DVec3::Z],
                        [DVec3::Z, DVec3::X],
                    ];
                    let points = circles.into_iter().flat_map(|[u, v]| {
                        turns().map(move |[c, s]| center + radius * (u * c + v * s))
                    });
                    let points: Vec<_> = points.collect();
                    Some(ObjectOutline::Points(points.iter().map(to_world).collect()))
                }
                _ => Some(ObjectOutline::Edges(edges(shape.bounds()?.corners()))),
            }
        }
    }
}

/// The four edges of a leaf, each by a few points.
fn of_patch(patch: &SurfacePatch) -> Vec<[DVec3; 2]> {
    const STEPS: u32 = 4;
    let at = |x: u32| f64::from(x) / f64::from(STEPS);
    let edges: [fn(f64) -> [f64; 2]; 4] = [|x| [x, 0.0], |x| [x, 1.0], |x| [0.0, x], |x| [1.0, x]];
    let points = edges.into_iter().flat_map(|edge| {
        let point = move |i: u32| patch.surface(edge(at(i))).point;
        (0..STEPS).map(move |i| [point(i), point(i + 1)])
    });
    points.collect()
}

/// Edges of a body in its own space.
fn of_body(body: &Body) -> Vec<[DVec3; 2]> {
    match body {
        Body::Quadric(quadric) => of_quadric(quadric),
        Body::Torus(torus) => of_torus(torus),
        Body::Csg(csg) => {
            let leaves = csg.leaves().filter_map(|solid| match solid {
                Solid::Shape(shape) => of_shape(shape),
                Solid::HalfSpace(_) => None,
                Solid::Polyhedron(polyhedron) => {
                    let (points, triangles) = polyhedron.mesh();
                    let corners = triangles.iter().map(|t| t.map(|i| points[i as usize]));
                    let sides = corners.flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
                    Some(ObjectOutline::Edges(sides.collect()))
                }
            });
            leaves.flat_map(as_edges).collect()
        }
        other => edges(other.bounds().corners()),
    }
}

/// The lines of an outline that has some.
fn as_edges(outline: ObjectOutline) -> Vec<[DVec3; 2]> {
    match outline {
        ObjectOutline::Edges(edges) => edges,
        ObjectOutline::Sphere(center, radius) => [[DVec3::X, DVec3::Y], [DVec3::X, DVec3::Z]]
            .into_iter()
            .flat_map(|[u, v]| loop_of(move |[c, s]| center + radius * (c * u + s * v)))
            .collect(),
        ObjectOutline::Points(points) => points.windows(2).map(|p| [p[0], p[1]]).collect(),
        ObjectOutline::Plane(..) => Vec::new(),
    }
}

/// A closed line of [`CIRCLE`] points.
fn loop_of(point: impl Fn([f64; 2]) -> DVec3) -> Vec<[DVec3; 2]> {
    let points: Vec<DVec3> = turns().map(point).collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| [*a, *b]).collect()
}

/// Both rims, the circle midway, and four profiles from end to end.
fn of_quadric(quadric: &Quadric) -> Vec<[DVec3; 2]> {
    const STEPS: u32 = 16;
    let h = quadric.half_height();
    let point = |y: f64, [c, s]: [f64; 2]| {
        let r = quadric.radius_at(y);
        DVec3::new(r * c, y, r * s)
    };
    let circles = [-h, 0.0, h].map(|y| loop_of(|turn| point(y, turn)));
    let sides = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    let profiles = sides.into_iter().flat_map(|side| {
        let at = move |i: u32| point(h * (2.0 * f64::from(i) / f64::from(STEPS) - 1.0), side);
        (0..STEPS).map(move |i| [at(i), at(i + 1)])
    });
    circles.into_iter().flatten().chain(profiles).collect()
}

/// Four circles around the axis and eight around the tube.
fn of_torus(torus: &Torus) -> Vec<[DVec3; 2]> {
    let point = |[c, s]: [f64; 2], [across, up]: [f64; 2]| {
        let rho = torus.major + torus.minor * across;
        DVec3::new(rho * c, torus.minor * up, rho * s)
    };
    let around = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    let rings = around
        .into_iter()
        .flat_map(|side| loop_of(|turn| point(turn, side)));
    let tubes = turns()
        .step_by(CIRCLE / 8)
        .flat_map(|turn| loop_of(move |side| point(turn, side)));
    rings.chain(tubes).collect()
}

/// Cosine and sine, once around.
pub fn turns() -> impl Iterator<Item = [f64; 2]> {
    (0..CIRCLE).map(|i| {
        let angle = std::f64::consts::TAU * i as f64 / CIRCLE as f64;
        [libm::cos(angle), libm::sin(angle)]
    })
}

/// The twelve edges of a box: corners whose numbers differ in one bit.
fn edges(corners: [DVec3; 8]) -> Vec<[DVec3; 2]> {
    let pairs = (0..8usize).flat_map(|i| [1, 2, 4].map(|bit| (i, i | bit)));
    pairs
        .filter(|(a, b)| a != b)
        .map(|(a, b)| [corners[a], corners[b]])
        .collect()
}
