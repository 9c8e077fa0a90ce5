//! Tests of quadrics of revolution: answers known on paper, and the cases that break formulas.

mod general;
mod laws;
mod optics;
mod oracle;
mod placed;

use super::{BASE, Quadric, Sheets, TOP, WALL};
use crate::geometry::{Intersection, Spans, Sphere};
use crate::math::{DVec3, Interval, Ray};

/// A small generator: xorshift64*. Source: Vigna 2016, "An experimental exploration of Marsaglia's xorshift generators".
pub(super) struct QuadricRays(pub u64);

impl QuadricRays {
    /// Uniform in [a, b).
    pub fn within(&mut self, a: f64, b: f64) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11;
        a + (b - a) * (bits as f64 / (1u64 << 53) as f64)
    }

    /// Uniform in the cube from -1 to 1.
    pub fn vector(&mut self) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.within(-1.0, 1.0)))
    }

    /// A power of ten, evenly between two exponents.
    pub fn power(&mut self, a: f64, b: f64) -> f64 {
        libm::pow(10.0, self.within(a, b))
    }
}

/// One of each kind, about as large as `s`; the fifth is a barrel, the last a double cone. The first five are convex.
pub(super) fn scaled(s: f64) -> [Quadric; 8] {
    [
        Quadric::cylinder(0.7 * s, 1.3 * s),
        Quadric::cone(1.1 * s, 0.0, 0.9 * s),
        Quadric::cone(0.3 * s, 1.2 * s, 0.4 * s),
        Quadric::paraboloid(0.9 * s, 1.1 * s),
        Quadric::hyperboloid(1.0 * s, 0.6 * s, 0.8 * s, Sheets::One),
        Quadric::hyperboloid(0.5 * s, 1.2 * s, 1.1 * s, Sheets::One),
        Quadric::hyperboloid(0.3 * s, 1.2 * s, 1.1 * s, Sheets::Two),
        Quadric::hyperboloid(0.0, 1.2 * s, 1.1 * s, Sheets::Two),
    ]
}

/// Shapes about as large as 1.
pub(super) fn kinds() -> [Quadric; 8] {
    scaled(1.0)
}

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray::new(origin.into(), direction.into())
}

/// The crossings as pairs of t and part.
fn cuts(spans: &Spans) -> Vec<(f64, u32)> {
    spans.cuts().map(|(cut, _)| (cut.t, cut.part)).collect()
}

fn spans(quadric: Quadric, origin: [f64; 3], direction: [f64; 3]) -> Vec<(f64, u32)> {
    cuts(&quadric.spans(&ray(origin, direction)))
}

#[test]
fn a_cylinder_is_met_at_wall_and_caps() {
    let c = Quadric::cylinder(0.5, 1.0);
    let across = spans(c, [-2.0, 0.25, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(across, [(1.5, WALL), (2.5, WALL)]);
    // Along the axis inside: caps only, t exact, whatever the length of the direction.
    let along = spans(c, [0.25, -3.0, 0.1], [0.0, 2.0, 0.0]);
    assert_eq!(along, [(1.0, BASE), (2.0, TOP)]);
    // Along the wall, and in the plane of a cap: they only touch.
    assert_eq!(spans(c, [0.5, -3.0, 0.0], [0.0, 1.0, 0.0]), []);
    assert_eq!(spans(c, [0.3, -3.0, 0.4], [0.0, 1.0, 0.0]), []);
    assert_eq!(spans(c, [-2.0, 1.0, 0.0], [1.0, 0.0, 0.0]), []);
    let names = [WALL, BASE, TOP].map(Quadric::part_name);
    assert_eq!(names, ["wall", "base", "top"]);
}

#[test]
fn a_thin_wire_far_away_is_hit_where_it_is() {
    // Case 19 of the list of hard cases: the school formula tells half of these wrong.
    let wire = Quadric::cylinder(1e-4, 1.0);
    for (x, count) in [(0.999e-4, 2), (1.001e-4, 0)] {
        assert_eq!(spans(wire, [x, 0.0, 1e5], [0.0, 0.0, -1.0]).len(), count);
        // Aslant: the distance from the axis stays x.
        assert_eq!(spans(wire, [x, 1e5, 2e5], [0.0, -1.0, -2.0]).len(), count);
    }
}

#[test]
fn a_large_cylinder_is_met_from_just_above() {
    // (1e6 + 1e-3 - t/sqrt(17))^2 + (4t/sqrt(17))^2 = 1e12 by mpmath to 40 digits, with the floats as they are.
    let c = Quadric::cylinder(1e6, 1.0);
    let x = 1e6 + 1e-3;
    let down = spans(c, [x, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    assert_eq!(down[0], (x - 1e6, WALL));
    let aslant = spans(c, [x, 0.0, 0.0], [-1.0, 0.0, 1.0]);
    assert!(
        (aslant[0].0 - EXPECTED_ASLANT).abs() <= 2.0 * 1.2e-10,
        "{}",
        aslant[0].0
    );
}

/// By mpmath: the smaller root of 2 t^2 - 2 x t + x^2 - 1e12 = 0 with x = fl(1e6 + 1e-3).
const EXPECTED_ASLANT: f64 = 0.001_000_000_047_497_451_3;

#[test]
fn a_ray_through_the_apex_of_a_cone_is_inside_down_to_the_base() {
    let cone = Quadric::cone(1.0, 0.0, 0.5);
    for (origin, direction) in [
        ([0.0, 2.5, 0.0], [0.0, -1.0, 0.0]),
        ([0.5, 2.5, 0.0], [-0.25, -1.0, 0.0]),
        ([0.5, 2.5, 1.0], [-0.25, -1.0, -0.5]),
    ] {
        let ray = ray(origin, direction);
        let found = cone.spans(&ray);
        let [enter, leave] = cuts(&found)[..] else {
            panic!("{found:?}")
        };
        assert!(
            (enter.0 - 2.0).abs() < 1e-15 && leave == (3.0, BASE),
            "{found:?}"
        );
        let apex = cone.surface(&ray, enter.0, enter.1);
        assert!((apex.point - 0.5 * DVec3::Y).length() < 1e-15);
        assert!((apex.normal.length() - 1.0).abs() < 1e-15);
    }
    // At the apex itself the axis stands for the gradient, which vanishes there.
    assert_eq!(cone.gradient(0.5 * DVec3::Y), DVec3::ZERO);
    let axis = cone.surface(&ray([0.0, 2.5, 0.0], [0.0, -1.0, 0.0]), 2.0, WALL);
    assert_eq!(axis.normal, DVec3::Y);
}

#[test]
fn a_ray_that_only_touches_a_cone_misses() {
    let cone = Quadric::cone(1.0, 0.0, 0.5);
    // The apex; then a generator, where A = B = C = D = 0.
    assert_eq!(spans(cone, [-2.0, 0.5, 0.0], [1.0, 0.0, 0.0]), []);
    assert_eq!(spans(cone, [-2.0, 0.5, 0.0], [1.0, 0.0, 0.25]), []);
    assert_eq!(spans(cone, [-1.0, 1.5, 0.0], [1.0, -1.0, 0.0]), []);
    assert_eq!(spans(cone, [2.0, -1.5, 0.0], [-1.0, 1.0, 0.0]), []);
    // Parallel to a generator, 0.5 inside along x: A = 0, and the one root is the wall's.
    let inside = spans(cone, [1.5, -1.5, 0.0], [-1.0, 1.0, 0.0]);
    assert_eq!(inside, [(1.0, BASE), (1.75, WALL)]);
}

#[test]
fn the_missing_nappe_of_a_cone_is_never_met() {
    let mut random = QuadricRays(1);
    // Rays close by the apex: at the end of the first cone, 1 below the end of the second.
    for (cone, apex) in [
        (Quadric::cone(1.0, 0.0, 0.5), 0.5),
        (Quadric::cone(0.5, 1.0, 0.5), -1.5),
    ] {
        let mut met = 0;
        for _ in 0..20_000 {
            let at = DVec3::Y * apex + random.power(-16.0, 0.0) * random.vector();
            let d = random.vector();
            let ray = Ray::new(at - random.power(-16.0, 3.0) * d, d);
            for (t, part) in cuts(&cone.spans(&ray)) {
                met += 1;
                let y = ray.at(t).y;
                assert!(y.abs() <= 0.5 + 1e-12, "{ray:?} {t} {part} {y}");
            }
            assert!(cone.spans(&ray).0.len() <= 1);
        }
        assert!(met > 1000);
    }
}

#[test]
fn a_ray_along_the_axis_of_a_paraboloid_meets_the_wall_once() {
    let (r, h) = (0.75, 2.0);
    let p = Quadric::paraboloid(r, h);
    for (x, z) in [
        (0.0, 0.0),
        (1e-9, 0.0),
        (0.1, 0.2),
        (-0.3, 0.6),
        (0.74, -0.01),
    ] {
        let y = -h + (x * x + z * z) * 2.0 * h / (r * r);
        let up = spans(p, [x, -3.0, z], [0.0, 1.0, 0.0]);
        assert_eq!((up.len(), up[0].1, up[1]), (2, WALL, (5.0, TOP)));
        assert!((up[0].0 - 3.0 - y).abs() <= 2.0 * f64::EPSILON * h);
        let surface = p.surface(&ray([x, -3.0, z], [0.0, 1.0, 0.0]), up[0].0, WALL);
        assert!((surface.point - DVec3::new(x, y, z)).length() <= 2.0 * f64::EPSILON * h);
    }
    // Across through the vertex: only touches.
    assert_eq!(spans(p, [-2.0, -h, 0.0], [1.0, 0.0, 0.0]), []);
}

#[test]
fn asymptotes_and_rulings_of_hyperboloids() {
    // x^2 + z^2 - y^2 = 1, exactly.
    let one = Quadric::hyperboloid(1.0, 1.25, 0.75, Sheets::One);
    assert_eq!(one.form().0[1], -1.0);
    let asymptote = spans(one, [-2.0, -2.0, 0.0], [1.0, 1.0, 0.0]);
    assert_eq!(asymptote, [(1.25, BASE), (2.75, TOP)]);
    assert_eq!(spans(one, [1.0, -2.0, -2.0], [0.0, 1.0, 1.0]), []);
    // Steeper than the asymptotes: inside with no crossing of the wall (A < 0, D < 0).
    assert_eq!(
        spans(one, [0.0, -1.75, 0.0], [0.0, 1.0, 0.0]),
        [(1.0, BASE), (2.5, TOP)]
    );
    // x^2 + z^2 - y^2 = -9/16: two spans; none through the gap.
    let two = Quadric::hyperboloid(0.75, 1.0, 1.25, Sheets::Two);
    let along = spans(two, [0.0, -2.25, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(along, [(1.0, BASE), (1.5, WALL), (3.0, WALL), (3.5, TOP)]);
    assert_eq!(spans(two, [-2.0, 0.5, 0.0], [1.0, 0.0, 0.0]), []);
    // With no gap: through the common vertex of the two cones it is one span.
    let double = Quadric::hyperboloid(0.0, 1.0, 1.0, Sheets::Two);
    let through = spans(double, [0.0, -2.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(through, [(1.0, BASE), (3.0, TOP)]);
}

#[test]
fn a_barrel_is_a_zone_of_a_sphere() {
    let barrel = Quadric::hyperboloid(1.0, 0.6, 0.8, Sheets::One);
    let center = DVec3::ZERO;
    let ball = Sphere {
        center,
        radius: 1.0,
    };
    let mut random = QuadricRays(3);
    let mut compared = 0;
    for _ in 0..2000 {
        let (origin, target) = (4.0 * random.vector(), random.vector());
        let ray = Ray::new(origin, target - origin);
        let Some(both) = ball.span(&ray) else {
            continue;
        };
        for (t, _) in cuts(&barrel.spans(&ray))
            .iter()
            .filter(|(_, part)| *part == WALL)
        {
            assert!(both.iter().any(|other| (t - other).abs() < 1e-12));
            let (a, b) = (barrel.surface(&ray, *t, WALL), ball.surface(&ray, *t));
            assert!((a.point - b.point).length() < 1e-14 && (a.normal - b.normal).length() < 1e-13);
            compared += 1;
        }
    }
    assert!(compared > 500);
}

#[test]
fn without_caps_only_the_wall_is_met() {
    let tube = Quadric::cylinder(1.0, 1.0).open();
    let meet = |o, d| tube.intersect(&ray(o, d), Interval::FORWARD);
    assert!(!tube.is_solid() && tube.volume() == 0.0);
    assert!(matches!(
        meet([0.0, 3.0, 0.0], [0.0, -1.0, 0.0]),
        Intersection::Miss
    ));
    // In through the open end, then the wall from inside.
    let through = ray([0.0, 2.0, 0.0], [1.0, -2.0, 0.0]);
    let found = tube.intersect(&through, Interval::FORWARD);
    assert!(matches!(
        found,
        Intersection::Hit {
            t: 1.0,
            part: WALL,
            ..
        }
    ));
    assert_eq!(tube.enters(&through, 1.0), Some(false));
    assert_eq!(tube.enters(&through, 0.5), None);
    assert_eq!(tube.spans(&through), Spans::none());
    // On its way out the ray has left both crossings behind.
    assert!(matches!(
        meet([2.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        Intersection::Behind(_)
    ));
}

#[test]
fn of_two_tubes_on_one_another_just_one_is_met_at_their_rim() {
    let tube = Quadric::cylinder(1.0, 1.0).open();
    let count = |o, d| {
        let spans = tube.spans_if_closed(&ray(o, d));
        spans.cuts().filter(|(cut, _)| cut.part == WALL).count()
    };
    // The rim that they share is at y = 1; the upper one's middle is at y = 2.
    for d in [
        [1.0, 1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 0.5, 0.0],
        [1.0, -0.5, 0.0],
    ] {
        let start = [-2.0, 1.0 - d[1], 0.0];
        let raised = [-2.0, start[1] - 2.0, 0.0];
        assert_eq!(count(start, d) + count(raised, d), 2, "{d:?}");
    }
}

#[test]
fn rays_of_nothing_miss() {
    let steep = Quadric::cone(0.0, 5.0, 0.5);
    for quadric in kinds().into_iter().chain([steep, steep.open()]) {
        for number in [f64::NAN, f64::INFINITY, 1e300, 0.0] {
            for axis in 0..3 {
                let mut direction = DVec3::ZERO;
                direction[axis] = number;
                let mut origin = DVec3::splat(0.1);
                let found = quadric.spans(&Ray::new(origin, direction));
                assert!(found.cuts().all(|(cut, _)| cut.t.is_finite()), "{found:?}");
                assert!(number.is_finite() && number != 0.0 || found.0.is_empty());
                origin[axis] = number;
                let found = quadric.spans(&Ray::new(origin, DVec3::ONE));
                assert!(number == 0.0 || found.0.is_empty());
            }
        }
    }
}

#[test]
fn nonsense_ends_without_a_panic() {
    for (r, h) in [
        (-1.0, 1.0),
        (1.0, -1.0),
        (0.0, 0.0),
        (1e300, 1e-300),
        (f64::NAN, 1.0),
    ] {
        for quadric in [
            Quadric::cylinder(r, h),
            Quadric::cone(0.0, r, h),
            Quadric::paraboloid(r, h),
            Quadric::hyperboloid(2.0, r, h, Sheets::One),
            Quadric::hyperboloid(2.0, r, h, Sheets::Two),
        ] {
            let ray = ray([0.1, 0.2, 3.0], [0.0, 0.1, -1.0]);
            for (t, part) in [(3.0, WALL), (1e300, BASE), (f64::NAN, TOP)] {
                let _ = quadric.surface(&ray, t, part);
            }
            let _ = (quadric.spans(&ray), quadric.bounds(), quadric.volume());
        }
    }
}

#[test]
fn the_steps_of_the_arithmetic_lead_to_the_hit() {
    let cone = Quadric::cone(1.0, 0.5, 1.0);
    let ray = ray([-3.0, 0.25, 0.1], [1.0, 0.1, 0.0]);
    let steps = cone.arithmetic(&ray);
    let cut = cuts(&cone.spans(&ray))[0].0;
    assert!(steps.roots.contains(&cut) && steps.discriminant > 0.0);
    assert!((steps.discriminant - (steps.b * steps.b - steps.a * steps.c)).abs() < 1e-15);
    assert!((steps.form.value(steps.origin) - steps.c).abs() < 1e-15);
    let clip = steps.clip.expect("between the planes");
    assert!(clip.contains(cut));
    let school = cuts(&cone.school_spans(&ray));
    assert!((school[0].0 - cut).abs() < 1e-14);
}
