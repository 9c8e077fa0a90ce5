//! Scenes and rays by chance, of the kinds that trees find hard: what lies in planes, on grids, on top of each other.

use glam::{DAffine3, DQuat};
use raytree::geometry::{
    Aabb, BezierSurface, Body, Csg, CsgOp, CsgTree, Cuboid, Disc, Plane, Polygon, Quadric, Shape,
    Sheets, Solid, Sphere, Torus, Transformed, Triangle,
};
use raytree::math::{DVec3, Interval, Ray, Transform};

use crate::random::Random;

pub fn triangle(corners: [DVec3; 3]) -> Shape {
    Shape::Triangle(Triangle { corners })
}

/// A point on a coarse grid, so that coordinates, edges and planes coincide.
pub fn grid_point(random: &mut Random) -> DVec3 {
    (random.point() * 3.0).round() / 2.0
}

/// The kinds of scene that the property ranges over.
#[derive(Clone, Copy, Debug)]
pub enum Style {
    Soup,
    Grid,
    Slivers,
    Strip,
    Stack,
    Duplicates,
    Mixed,
    Bodies,
}

pub const STYLES: [Style; 8] = [
    Style::Soup,
    Style::Grid,
    Style::Slivers,
    Style::Strip,
    Style::Stack,
    Style::Duplicates,
    Style::Mixed,
    Style::Bodies,
];

/// Where a scene's points go in the world.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub scale: f64,
    pub offset: DVec3,
}

impl Frame {
    pub fn place(&self, p: DVec3) -> DVec3 {
        self.offset + self.scale * p
    }

    pub fn triangle(&self, corners: [DVec3; 3]) -> Shape {
        triangle(corners.map(|p| self.place(p)))
    }
}

pub fn scene(style: Style, count: usize, frame: Frame, random: &mut Random) -> Vec<Shape> {
    let mut strip = [random.point(), random.point()];
    let normal = random.direction();
    (0..count)
        .map(|i| match style {
            Style::Soup => frame.triangle([random.point(), random.point(), random.point()]),
            Style::Grid => {
                frame.triangle([grid_point(random), grid_point(random), grid_point(random)])
            }
            Style::Slivers => {
                let (a, along) = (random.point(), random.point());
                let thin = random.point() * [1e-3, 1e-9, 1e-15, 0.0][random.below(4)];
                frame.triangle([a, a + along, a + 0.5 * along + thin])
            }
            Style::Strip => {
                let [a, b] = strip;
                let c = (0.5 * (a + b) + 0.3 * random.point()).clamp(-DVec3::ONE, DVec3::ONE);
                strip = [b, c];
                frame.triangle([a, b, c])
            }
            Style::Stack => {
                // A few parallel planes, turned anyhow, with many triangles on each.
                let (u, v) = normal.any_orthonormal_pair();
                let height = random.below(3) as f64 * 0.25;
                let mut on = || height * normal + random.unit() * u + random.unit() * v;
                frame.triangle([on(), on(), on()])
            }
            Style::Duplicates => {
                let turn = i % 3;
                let corners = [DVec3::X, DVec3::Y, DVec3::new(0.1, 0.2, (i / 3 % 2) as f64)];
                frame.triangle([0, 1, 2].map(|k| corners[(k + turn) % 3]))
            }
            Style::Mixed => mixed(i, frame, random),
            Style::Bodies => solid(i, frame, random),
        })
        .collect()
}

/// A sphere, a box, either of them turned and stretched, a disc, a plane or a triangle.
pub fn mixed(i: usize, frame: Frame, random: &mut Random) -> Shape {
    let center = frame.place(grid_point(random));
    let size = frame.scale * (0.05 + 0.4 * random.unit().abs());
    let stretch = DVec3::new(1.0, 1.0 + random.unit().abs() * 4.0, 0.5);
    let local = if random.below(2) == 0 {
        Shape::Sphere(Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        })
    } else {
        Shape::Cuboid(Cuboid {
            bounds: Aabb::around([-DVec3::ONE, DVec3::ONE]),
        })
    };
    match i % 6 {
        5 => Shape::Disc(Box::new(Disc::new(center, random.direction(), size))),
        0 => Shape::Sphere(Sphere {
            center,
            radius: size,
        }),
        1 => Shape::Cuboid(Cuboid {
            bounds: Aabb::around([center, center + size * stretch]),
        }),
        2 => {
            let turn = DQuat::from_axis_angle(random.direction(), 3.0 * random.unit());
            let to_world = DAffine3::from_scale_rotation_translation(size * stretch, turn, center);
            let transform = Transform::new(to_world).expect("it can be undone");
            Shape::Transformed(Box::new(Transformed {
                shape: local,
                transform,
            }))
        }
        3 if i == 3 => Shape::Plane(Box::new(Plane::new(center, random.direction()))),
        _ => frame.triangle([random.point(), random.point(), grid_point(random)]),
    }
}

/// A solid with parts, a polygon or a leaf of a patch, turned and stretched anyhow.
pub fn solid(i: usize, frame: Frame, random: &mut Random) -> Shape {
    let size = frame.scale * (0.1 + 0.4 * random.unit().abs());
    let center = frame.place(grid_point(random));
    let corner = |x: f64, y: f64| center + size * DVec3::new(x, y, 0.3 * x);
    if i % 8 == 6 {
        let rim = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [0.0, 2.0],
        ];
        let polygon = Polygon::new(&[rim.map(|[x, y]| corner(x, y)).to_vec()]);
        return Shape::Polygon(Box::new(polygon.expect("an area")));
    }
    if i % 8 == 7 {
        let mut point = |i: usize, j: usize| {
            corner(i as f64 / 3.0, j as f64 / 3.0) + 0.3 * size * random.point()
        };
        let rows = (0..4)
            .map(|j| (0..4).map(|i| point(i, j)).collect())
            .collect();
        let surface = BezierSurface {
            degree: [3, 3],
            patches: vec![rows],
            weights: None,
            ranges: None,
        };
        let leaf = surface.leaves().expect("a patch").swap_remove(0);
        return Shape::Patch(Box::new(leaf));
    }
    let turn = DQuat::from_axis_angle(random.direction(), 3.0 * random.unit());
    let stretch = DVec3::new(1.0, 1.0 + random.unit().abs(), 0.7);
    let to_world = DAffine3::from_scale_rotation_translation(size * stretch, turn, center);
    Shape::Transformed(Box::new(Transformed {
        shape: Shape::Body(Box::new(body(i))),
        transform: Transform::new(to_world).expect("it can be undone"),
    }))
}

/// A body of about the size of 1, by its number.
pub fn body(i: usize) -> Body {
    match i % 6 {
        0 => Body::Quadric(Quadric::cylinder(0.5, 1.0)),
        1 => Body::Quadric(Quadric::cone(0.8, 0.0, 0.7)),
        2 => Body::Quadric(Quadric::hyperboloid(0.2, 0.8, 1.0, Sheets::Two)),
        3 => Body::Torus(Torus {
            major: 0.8,
            minor: 0.25,
        }),
        4 => Body::Quadric(Quadric::paraboloid(0.8, 0.5)),
        _ => {
            let ball = Shape::Sphere(Sphere {
                center: DVec3::ZERO,
                radius: 1.2,
            });
            let cube = Shape::Cuboid(Cuboid {
                bounds: Aabb::around([-DVec3::ONE, DVec3::ONE]),
            });
            let leaves = [cube, ball].map(|shape| CsgTree::Leaf(Solid::Shape(shape)));
            let tree = CsgTree::Op(CsgOp::Difference, leaves.to_vec());
            Body::Csg(Csg::new(tree).expect("a solid"))
        }
    }
}

/// A ray that is likely to meet a special case of the scene: its corners, edges, surfaces and planes.
pub fn ray(shapes: &[Shape], frame: Frame, random: &mut Random) -> (Ray, Interval) {
    let on = |random: &mut Random| {
        let shape = &shapes[random.below(shapes.len())];
        let Shape::Triangle(Triangle { corners: [a, b, c] }) = *shape else {
            return frame.place(grid_point(random));
        };
        let (u, v) = (random.unit().abs(), random.unit().abs());
        match random.below(4) {
            0 => a,
            1 => a + u * (b - a),
            2 => a + 0.5 * (b - a),
            _ => a + u * (b - a) + v * (1.0 - u) * (c - a),
        }
    };
    let origin = match random.below(4) {
        0 => frame.place(3.0 * random.point()),
        1 => on(random),
        2 => frame.place(grid_point(random)),
        _ => frame.place(random.point()),
    };
    let axis = DVec3::AXES[random.below(3)];
    let direction = match random.below(6) {
        0 => random.direction(),
        1 => axis,
        2 => -axis,
        // Nearly along an axis.
        3 => (axis + 1e-16 * random.point()).normalize(),
        _ => (on(random) - origin).normalize_or(axis),
    };
    let interval = match random.below(4) {
        0 => Interval::before(frame.scale * random.unit().abs()),
        1 => Interval::new(0.3 * frame.scale, 1.5 * frame.scale),
        _ => Interval::FORWARD,
    };
    (Ray::new(origin, direction), interval)
}

/// Sixteen rays from one place to others close to each other: along edges and planes of the scene, as one bundle.
pub fn fan(shapes: &[Shape], frame: Frame, random: &mut Random) -> Vec<(Ray, Interval)> {
    let (middle, interval) = ray(shapes, frame, random);
    let size = [0.1, 1e-3, 1e-9][random.below(3)];
    let (u, v) = middle.direction.any_orthonormal_pair();
    (0..16)
        .map(|i| {
            let aside = size * (f64::from(i % 4) * u + f64::from(i / 4) * v);
            let direction = (middle.direction + aside).normalize();
            (Ray::new(middle.origin, direction), interval)
        })
        .collect()
}
