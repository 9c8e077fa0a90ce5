//! Tests of general quadrics in a box.

use super::{QuadricRays, cuts, kinds, ray};
use crate::geometry::quadric::{BoxedQuadric, QuadricForm};
use crate::geometry::{Aabb, Intersection};
use crate::math::rounding::offset_origin;
use crate::math::{DVec3, Interval, Ray};

fn within(size: f64) -> Aabb {
    Aabb {
        min: DVec3::splat(-size),
        max: DVec3::splat(size),
    }
}

#[test]
fn a_paraboloid_cut_below_its_vertex_does_not_vanish() {
    // POV-Ray issue 128. y >= x^2 + z^2 in a box that goes on below the vertex.
    let form = QuadricForm([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0]);
    let bowl = BoxedQuadric::new(form, within(1.0));
    let through = |o, d| cuts(&bowl.spans(&ray(o, d)));
    assert_eq!(
        through([0.5, -2.0, 0.0], [0.0, 1.0, 0.0]),
        [(2.25, 0), (3.0, 4)]
    );
    assert_eq!(
        through([0.0, -2.0, 0.0], [0.0, 1.0, 0.0]),
        [(2.0, 0), (3.0, 4)]
    );
    assert_eq!(
        through([-2.0, 0.25, 0.0], [1.0, 0.0, 0.0]),
        [(1.5, 0), (2.5, 0)]
    );
    assert_eq!(through([-2.0, -0.5, 0.0], [1.0, 0.0, 0.0]), []);
    assert_eq!(BoxedQuadric::part_name(4), "high y");
}

#[test]
fn quadrics_of_revolution_are_the_same_as_forms() {
    let mut random = QuadricRays(11);
    for quadric in kinds() {
        let h = quadric.half_height;
        let size = DVec3::new(3.0, h, 3.0);
        let bounds = Aabb {
            min: -size,
            max: size,
        };
        let form = BoxedQuadric::new(quadric.form(), bounds);
        // The form has no missing nappe: a cone whose apex is in the box is compared where it has none.
        for _ in 0..500 {
            let (origin, target) = (5.0 * random.vector(), 0.9 * random.vector());
            let ray = Ray::new(origin, target - origin);
            let (a, b) = (quadric.spans(&ray), form.spans(&ray));
            let (a, b) = (cuts(&a), cuts(&b));
            assert_eq!(a.len(), b.len(), "{quadric:?} {ray:?}");
            for (a, b) in a.iter().zip(&b) {
                assert!((a.0 - b.0).abs() < 1e-11, "{quadric:?} {ray:?} {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn a_box_that_the_form_leaves_whole_is_a_box() {
    let everywhere = QuadricForm([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
    let cube = BoxedQuadric::new(everywhere, within(1.0));
    let spans = cube.spans(&ray([-3.0, 0.5, 0.0], [2.0, 0.0, 0.0]));
    assert_eq!(cuts(&spans), [(1.0, 1), (2.0, 2)]);
    let half = QuadricForm([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, -0.5]);
    let cut_off = BoxedQuadric::new(half, within(1.0));
    let spans = cut_off.spans(&ray([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!(cuts(&spans), [(2.0, 1), (3.5, 0)]);
    let surface = cut_off.surface(&ray([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]), 3.5, 0);
    let diagonal = DVec3::new(1.0, 1.0, 0.0).normalize();
    assert!((surface.normal - diagonal).length() < 1e-15);
    assert_eq!(surface.point, DVec3::new(0.5, 0.0, 0.0));
}

#[test]
fn a_needle_of_an_ellipsoid_has_the_normal_of_its_gradient() {
    // Half axes 1e-4, 1, 1e4; a ray along x at (y, z): x = -1e-4 sqrt(1 - y^2 - (z/1e4)^2).
    let form = QuadricForm([1e8, 1.0, 1e-8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
    let needle = BoxedQuadric::new(form, within(2e4));
    for (y, z) in [(0.0, 0.0), (0.6, 0.0), (0.3, 5e3), (0.0, 8e3), (-0.5, -5e3)] {
        let ray = ray([-1.0, y, z], [1.0, 0.0, 0.0]);
        let (cut, _) = needle.spans(&ray).cuts().next().expect("met");
        let surface = needle.surface(&ray, cut.t, cut.part);
        let x = -1e-4 * (1.0 - y * y - z * z * 1e-8f64).sqrt();
        assert!((surface.point - DVec3::new(x, y, z)).length() < 1e-15);
        let n = DVec3::new(1e8 * x, y, 1e-8 * z).normalize();
        for axis in 0..3 {
            let (a, b) = (surface.normal[axis], n[axis]);
            assert!((a - b).abs() <= 4.0 * f64::EPSILON * b.abs(), "{a} {b}");
        }
    }
}

/// A random ellipsoid, hyperboloid or saddle with mixed terms, not about the middle of its box.
fn any(random: &mut QuadricRays) -> BoxedQuadric {
    let mut coefficients = [0.0; 10].map(|_: f64| random.within(-1.0, 1.0));
    coefficients[9] -= 0.5;
    let middle = random.vector();
    let bounds = Aabb {
        min: middle - DVec3::ONE,
        max: middle + DVec3::splat(1.5),
    };
    BoxedQuadric::new(QuadricForm(coefficients), bounds)
}

#[test]
fn no_ray_finds_a_general_quadric_again_where_it_leaves() {
    let mut random = QuadricRays(13);
    let mut left = 0;
    for _ in 0..6000 {
        let quadric = any(&mut random);
        let origin = random.power(0.0, 5.0) * random.vector();
        let ray = Ray::new(origin, random.vector() - origin);
        let spans = quadric.spans(&ray);
        assert!(spans.0.len() <= 2);
        for (cut, _) in spans.cuts() {
            let surface = quadric.surface(&ray, cut.t, cut.part);
            let gradient = quadric.form.gradient(surface.point).length();
            if cut.part == 0 {
                let off = quadric.form.value(surface.point).abs() / gradient;
                assert!(off <= surface.error.x, "{off:e} {:e}", surface.error.x);
            }
            let mut d = random.vector().normalize();
            if d.dot(surface.normal).abs() < 1e-3 {
                continue;
            }
            let at = |d| offset_origin(surface.point, surface.error, surface.normal, d);
            for _ in 0..2 {
                let next = quadric.intersect(&Ray::new(at(d), d), Interval::FORWARD);
                let near = matches!(next, Intersection::Hit { t, .. } if t < 1e-9);
                assert!(!near || gradient < 1e-4, "{quadric:?} {ray:?} {next:?}");
                d = -d;
            }
            left += 1;
        }
    }
    assert!(left > 5000);
}
