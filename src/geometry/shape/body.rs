//! Bodies: solids with named parts, and the open walls of some.
//!
//! Their tests are never inlined, so that scenes of triangles and spheres alone pay nothing for them.

use crate::geometry::{
    Aabb, BoxedQuadric, Csg, Intersection, Quadric, Quartic, Spans, SurfacePoint, Torus,
};
use crate::math::{DVec3, Interval, Ray};

/// A solid with parts, in its own space: what decides is the spans of a ray's line in it.
#[derive(Clone, Debug)]
pub enum Body {
    /// A cylinder, cone, paraboloid or hyperboloid, closed or open.
    Quadric(Quadric),
    /// A surface of the second degree inside a box.
    BoxedQuadric(BoxedQuadric),
    /// A torus.
    Torus(Torus),
    /// A surface of the fourth degree inside a box.
    Quartic(Quartic),
    /// A solid that is cut from others.
    Csg(Csg),
}

impl Body {
    /// The first crossing inside the interval. A line that misses the box around it needs no more than that; most miss the ball
    /// around the box, and need no division.
    #[inline(never)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        let bounds = self.bounds();
        if bounds.is_passed_by_far(ray) || bounds.clip(ray, Interval::LINE).is_none() {
            return Intersection::Miss;
        }
        match self {
            Self::Quadric(quadric) => quadric.intersect(ray, interval),
            Self::BoxedQuadric(quadric) => quadric.intersect(ray, interval),
            Self::Torus(torus) => torus.intersect(ray, interval),
            Self::Quartic(quartic) => quartic.intersect(ray, interval),
            Self::Csg(csg) => csg.intersect(ray, interval),
        }
    }

    /// The spans of the ray's line inside; none if it is open.
    pub fn spans(&self, ray: &Ray) -> Spans {
        match self {
            Self::Quadric(quadric) => quadric.spans(ray),
            Self::BoxedQuadric(quadric) => quadric.spans(ray),
            Self::Torus(torus) => torus.spans(ray),
            Self::Quartic(quartic) => quartic.spans(ray),
            Self::Csg(csg) => csg.spans(ray),
        }
    }

    /// Whether the ray goes in at a crossing at `t`; `None` if there is none.
    #[inline(never)]
    pub fn enters(&self, ray: &Ray, t: f64) -> Option<bool> {
        match self {
            Self::Quadric(quadric) => quadric.enters(ray, t),
            other => other.spans(ray).enters(t),
        }
    }

    /// True if it bounds a part of space: all but open quadrics do.
    pub fn is_solid(&self) -> bool {
        match self {
            Self::Quadric(quadric) => quadric.is_solid(),
            _ => true,
        }
    }

    /// The volume, in cubic metres; where there is no formula for it, by the mean length of the spans of 128 x 128 rays along x.
    pub fn volume(&self) -> f64 {
        match self {
            Self::Quadric(quadric) => quadric.volume(),
            Self::Torus(torus) => torus.volume(),
            other => other.mean_volume(),
        }
    }

    fn mean_volume(&self) -> f64 {
        const SIDE: u32 = 128;
        let Aabb { min, max } = self.bounds();
        let size = max - min;
        let place = |i: u32| (f64::from(i) + 0.5) / f64::from(SIDE);
        let rays = (0..SIDE * SIDE).map(|i| {
            let across = DVec3::new(0.0, place(i / SIDE), place(i % SIDE));
            Ray::new(min + size * across, DVec3::X)
        });
        let length: f64 = rays.map(|ray| self.spans(&ray).length()).sum();
        length * size.y * size.z / f64::from(SIDE * SIDE)
    }

    /// The point at which `ray` crosses a part, as found by [`Body::intersect`].
    #[inline(never)]
    pub fn surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        match self {
            Self::Quadric(quadric) => quadric.surface(ray, t, part),
            Self::BoxedQuadric(quadric) => quadric.surface(ray, t, part),
            Self::Torus(torus) => torus.surface(ray, t, part),
            Self::Quartic(quartic) => quartic.surface(ray, t, part),
            Self::Csg(csg) => csg.surface(ray, t, part),
        }
    }

    /// The gradient of its equation F = 0 at a point of a part, outwards; of a csg that of the part. None on flat parts.
    pub fn gradient(&self, point: DVec3, part: u32) -> Option<DVec3> {
        let is_curved = part == 0;
        match self {
            Self::Quadric(quadric) => is_curved.then(|| quadric.gradient(point)),
            Self::BoxedQuadric(quadric) => is_curved.then(|| quadric.form().gradient(point)),
            Self::Torus(torus) => Some(torus.gradient(point)),
            Self::Quartic(quartic) => is_curved.then(|| quartic.gradient(point)),
            Self::Csg(csg) => csg.gradient(point, part),
        }
    }

    /// The box around it.
    pub fn bounds(&self) -> Aabb {
        match self {
            Self::Quadric(quadric) => quadric.bounds(),
            Self::BoxedQuadric(quadric) => quadric.bounds(),
            Self::Torus(torus) => torus.bounds(),
            Self::Quartic(quartic) => quartic.bounds(),
            Self::Csg(csg) => csg.bounds(),
        }
    }

    /// What it is called in scene files and in what a user reads.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Quadric(quadric) => quadric.kind(),
            Self::BoxedQuadric(_) => "quadric",
            Self::Torus(_) => "torus",
            Self::Quartic(_) => "quartic",
            Self::Csg(_) => "csg",
        }
    }

    /// Names of parts, of all shapes whose parts have names.
    pub const PART_NAMES: [&str; 9] = [
        "wall", "base", "top", "low x", "high x", "low y", "high y", "low z", "high z",
    ];

    /// The name of a part; `None` where there is only one, and of a csg, whose parts have the names of the scene.
    pub fn part_name(&self, part: u32) -> Option<&'static str> {
        match self {
            Self::Quadric(_) => Some(Quadric::part_name(part)),
            Self::BoxedQuadric(_) | Self::Quartic(_) => Some(BoxedQuadric::part_name(part)),
            Self::Torus(_) | Self::Csg(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DAffine3, DMat3};

    use super::*;
    use crate::geometry::Shear;
    use crate::geometry::Sheets;
    use crate::geometry::shape::{Shape, Transformed};
    use crate::geometry::test_rays::{TestRays, many};
    use crate::math::Transform;

    /// Rays at rims, apexes and the box itself, from near and from far: what the box turns away has no span.
    #[test]
    fn the_box_turns_no_ray_away_that_meets_the_body() {
        let bodies = [
            Body::Quadric(Quadric::cylinder(0.7, 0.4)),
            Body::Quadric(Quadric::cone(0.8, 0.0, 0.5)),
            Body::Torus(Torus {
                major: 1.0,
                minor: 0.3,
            }),
        ];
        let mut random = TestRays(5);
        let mut met = 0;
        for body in &bodies {
            let Aabb { min, max } = body.bounds();
            for _ in 0..many(20_000u32) {
                let angle = std::f64::consts::TAU * random.unit();
                // A point on the rim of the upper face, moved by some roundings.
                let rim = DVec3::new(max.x * libm::cos(angle), max.y, max.z * libm::sin(angle));
                let corner = DVec3::select(random.in_cube().cmpgt(DVec3::ZERO), max, min);
                let target = if random.unit() < 0.5 { rim } else { corner };
                let target = target * (1.0 + 4e-15 * random.signed());
                let distance = libm::exp10(6.0 * random.unit());
                let direction = random.direction();
                let ray = Ray::new(target - distance * direction, direction);
                let by_spans = body.spans(&ray).first(Interval::LINE);
                assert_eq!(body.intersect(&ray, Interval::LINE), by_spans, "{ray:?}");
                met += u32::from(by_spans != Intersection::Miss);
            }
        }
        assert!(met > 1000, "{met}");
    }

    /// F of a body at a point in its own space.
    fn value(body: &Body, p: DVec3) -> f64 {
        match body {
            Body::Quadric(quadric) => quadric.form().value(p),
            Body::BoxedQuadric(quadric) => quadric.form().value(p),
            Body::Quartic(quartic) => quartic.value(p),
            Body::Torus(torus) => {
                let off = libm::hypot(p.x, p.z) - torus.major;
                off * off + p.y * p.y - torus.minor * torus.minor
            }
            Body::Csg(_) => unreachable!("it has no equation"),
        }
    }

    /// Also where the body is turned, stretched and mirrored: central differences agree, and the normal is its direction.
    #[test]
    fn gradients_in_the_world_are_slopes_of_the_equation() {
        let torus = Torus {
            major: 1.0,
            minor: 0.3,
        };
        let bodies = [
            Body::Quadric(Quadric::cylinder(0.7, 0.4)),
            Body::Quadric(Quadric::cone(0.8, 0.1, 0.5)),
            Body::Quadric(Quadric::paraboloid(0.8, 0.5)),
            Body::Quadric(Quadric::hyperboloid(0.3, 0.8, 0.5, Sheets::One)),
            Body::Torus(torus),
        ];
        let turn = DMat3::from_rotation_y(0.7) * DMat3::from_rotation_x(-1.1);
        let matrix = turn * DMat3::from_diagonal(DVec3::new(2.0, -0.5, 1.5));
        let to_world = DAffine3::from_mat3_translation(matrix, DVec3::new(3.0, -1.0, 2.0));
        let transform = Transform::new(to_world).expect("it can be undone");
        let mut random = TestRays(11);
        let mut met = 0;
        for body in &bodies {
            let shape = Shape::Transformed(Box::new(Transformed {
                shape: Shape::Body(Box::new(body.clone())),
                transform,
            }));
            let f = |p: DVec3| value(body, transform.point_to_object(p));
            for _ in 0..many(2000u32) {
                let target = transform.point(random.in_cube());
                let direction = random.direction();
                let ray = Ray::new(target - 8.0 * direction, direction);
                let found = shape.intersect(&ray, &Shear::new(&ray), Interval::LINE);
                let Intersection::Hit { t, part, .. } = found else {
                    continue;
                };
                let surface = shape.surface(&ray, t, [0.0; 3], part);
                let Some(gradient) = shape.gradient(surface.point, part) else {
                    assert!(part > 0, "{body:?}");
                    continue;
                };
                met += 1;
                let slope = |axis: DVec3| {
                    let h = 1e-6 * axis;
                    (f(surface.point + h) - f(surface.point - h)) / 2e-6
                };
                let slopes = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
                let off = (slopes - gradient).length() / gradient.length();
                assert!(off < 1e-6, "{body:?} {ray:?}: {off}");
                let normal = gradient.normalize();
                assert!((normal - surface.normal).length() < 1e-9, "{body:?}");
            }
        }
        assert!(met > 2500, "{met}");
    }
}
