//! Laws that hold for every ray: even crossings, volumes, and that no ray meets the surface again that it leaves.

use crate::geometry::test_rays::many;
use std::f64::consts::{PI, TAU};

use super::{QuadricRays, kinds, ray, scaled};
use crate::geometry::quadric::{Quadric, Sheets, TOP, WALL};
use crate::geometry::{Intersection, Spans};
use crate::math::rounding::offset_origin;
use crate::math::{DVec3, Frame, Interval, Ray};

fn assert_even(quadric: &Quadric, ray: &Ray) {
    let spans = quadric.spans(ray);
    let cuts: Vec<_> = spans.cuts().map(|(cut, _)| cut.t).collect();
    assert!(
        cuts.iter().all(|t| t.is_finite()) && cuts.is_sorted_by(|a, b| a < b),
        "{ray:?}"
    );
    // A walk from hit to hit finds the same, going in and out by turns.
    let mut interval = Interval::LINE;
    let mut walked = 0;
    while let Intersection::Hit { t, .. } = quadric.intersect(ray, interval) {
        assert_eq!(
            (t, quadric.enters(ray, t)),
            (cuts[walked], Some(walked % 2 == 0))
        );
        interval.min = t;
        walked += 1;
    }
    assert_eq!((walked, walked % 2), (cuts.len(), 0));
}

/// Rays at points of the rims, from 1 to 1e6 sizes away; a fifth of them level.
fn at_rims(count: usize, mut each: impl FnMut(&Quadric, &Ray)) {
    let mut random = QuadricRays(5);
    for _ in 0..count {
        let scale = random.power(-3.0, 3.0);
        for quadric in scaled(scale) {
            let h = quadric.half_height;
            let y = if random.within(0.0, 1.0) < 0.5 { -h } else { h };
            let (sin, cos) = libm::sincos(random.within(0.0, TAU));
            let r = quadric.profile.radius(y);
            let rim = DVec3::new(r * cos, y, r * sin);
            let mut d = random.vector();
            if random.within(0.0, 1.0) < 0.2 {
                d.y = 0.0;
            }
            let origin = rim - scale * random.power(0.0, 6.0) * d;
            each(&quadric, &Ray::new(origin, d));
        }
    }
}

#[test]
fn rays_at_the_rim_cross_evenly() {
    at_rims(many(3000), assert_even);
}

#[test]
fn wall_and_caps_tested_one_by_one_would_cross_oddly() {
    // What the law above is worth: the usual way gives many rays an odd number of crossings.
    let (mut odd, mut all) = (0, 0);
    at_rims(2000, |quadric, ray| {
        if quadric.kind() != "cylinder" {
            return;
        }
        let (h, steps) = (quadric.half_height, quadric.arithmetic(ray));
        let wall = steps.roots.iter().filter(|t| ray.at(**t).y.abs() <= h);
        let wall = if steps.discriminant > 0.0 {
            wall.count()
        } else {
            0
        };
        let r = quadric.profile.radius(0.0);
        let on_cap = |plane: f64| {
            let p = ray.at((plane - ray.origin.y) / ray.direction.y);
            p.x * p.x + p.z * p.z <= r * r
        };
        odd += (wall + usize::from(on_cap(-h)) + usize::from(on_cap(h))) % 2;
        all += 1;
    });
    assert!(odd > all / 10, "{odd} of {all}");
}

/// Area of a pencil of parallel rays times the mean length inside: n by n rays through the middles of a grid.
fn by_spans(spans: impl Fn(&Ray) -> Spans, size: f64, direction: DVec3, n: u32) -> f64 {
    let Frame { u, v, w } = Frame::around(direction);
    let place = |i: u32| size * (2.0 * (f64::from(i) + 0.5) / f64::from(n) - 1.0);
    let rays = (0..n * n).map(|i| Ray::new(place(i % n) * u + place(i / n) * v - 9.0 * w, w));
    let sum: f64 = rays.map(|ray| spans(&ray).length()).sum();
    sum * (2.0 * size / f64::from(n)).powi(2)
}

#[test]
fn volumes_are_mean_span_lengths() {
    let direction = DVec3::new(0.3, 0.8, 0.5).normalize();
    for quadric in kinds() {
        let measured = by_spans(|ray| quadric.spans(ray), 2.0, direction, 150);
        let off = measured / quadric.volume() - 1.0;
        assert!(off.abs() < 2e-3, "{quadric:?}: {off}");
    }
}

#[test]
fn volumes_have_their_closed_forms() {
    let close = |quadric: Quadric, expected: f64| {
        let off = quadric.volume() / expected - 1.0;
        assert!(off.abs() < 1e-14, "{quadric:?}: {off}");
    };
    let (r, h) = (0.7, 1.3);
    close(Quadric::cylinder(r, h), PI * r * r * 2.0 * h);
    close(Quadric::cone(r, 0.0, h), PI * r * r * 2.0 * h / 3.0);
    close(Quadric::cone(0.0, r, h), PI * r * r * 2.0 * h / 3.0);
    close(Quadric::paraboloid(r, h), PI * r * r * 2.0 * h / 2.0);
    // A double cone; a zone of the unit sphere from -0.8 to 0.8: pi (2y - 2y^3/3).
    close(
        Quadric::hyperboloid(0.0, r, h, Sheets::Two),
        2.0 * PI * r * r * h / 3.0,
    );
    close(
        Quadric::hyperboloid(1.0, 0.6, 0.8, Sheets::One),
        PI * (1.6 - 2.0 * 0.512 / 3.0),
    );
}

/// How a ray goes on that left a hit point.
struct Left {
    inward: bool,
    part: u32,
    /// The sine of its angle with the surface.
    lift: f64,
    /// True next to a rim or a vertex, where the step off the surface may lead past the shape.
    at_rim: bool,
    /// The t of the next crossing.
    next: Option<f64>,
}

/// Leaves a hit point in a random direction of one side, steep or very flat.
fn leave(quadric: &Quadric, random: &mut QuadricRays, scale: f64) -> Option<Left> {
    let target = 0.8 * scale * random.vector();
    let origin = target + scale * random.power(0.3, 6.0) * random.vector();
    let ray = Ray::new(origin, target - origin);
    let from_outside = random.within(0.0, 1.0) < 0.5;
    let spans = quadric.spans(&ray);
    let (cut, _) = spans.cuts().find(|(_, enters)| *enters == from_outside)?;
    let surface = quadric.surface(&ray, cut.t, cut.part);
    let (p, n) = (surface.point, surface.normal);
    let step = n.abs().dot(surface.error);
    assert!(
        step < 1e-13 * scale,
        "the step stays far below 1e-9 of the size"
    );
    let side = if random.within(0.0, 1.0) < 0.5 { -n } else { n };
    let lift = random.power(-18.0, 1.0);
    let d = (n.cross(random.vector()).normalize() + lift * side).normalize();
    let next = quadric.intersect(
        &Ray::new(offset_origin(p, surface.error, n, d), d),
        Interval::FORWARD,
    );
    let (h, radius) = (quadric.half_height, libm::hypot(p.x, p.z));
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * scale;
    Some(Left {
        // As rounded, d may point to the other side.
        inward: d.dot(n) < 0.0,
        part: cut.part,
        lift,
        at_rim: near(p.y.abs(), h) && near(radius, quadric.profile.radius(p.y)),
        next: match next {
            Intersection::Hit { t, .. } => Some(t),
            _ => None,
        },
    })
}

/// Needles, dishes and narrow waists, where the wall is very steep or very flat.
fn extremes(s: f64) -> [Quadric; 8] {
    [
        Quadric::cylinder(1e-4 * s, s),
        Quadric::cylinder(s, 1e-4 * s),
        Quadric::cone(s, 0.0, 1e-5 * s),
        Quadric::cone(0.0, 1e-4 * s, s),
        Quadric::paraboloid(s, 1e-5 * s),
        Quadric::hyperboloid(1e-5 * s, s, s, Sheets::One),
        Quadric::hyperboloid(1e-4 * s, s, s, Sheets::Two),
        Quadric::paraboloid(1e-4 * s, s),
    ]
}

fn self_hits(count: usize, shapes: fn(f64) -> [Quadric; 8], convex: [bool; 8]) {
    let mut random = QuadricRays(7);
    let (mut outwards, mut inwards) = (0, 0);
    for _ in 0..count {
        let scale = random.power(-3.0, 3.0);
        for (quadric, convex) in shapes(scale).into_iter().zip(convex) {
            let Some(left) = leave(&quadric, &mut random, scale) else {
                continue;
            };
            if left.inward {
                let met = left.next.is_some();
                assert!(
                    met || left.at_rim,
                    "{quadric:?} {} {}",
                    left.part,
                    left.lift
                );
                inwards += 1;
            } else {
                // Outside of convex shapes, and beyond a cap, there is nothing to be met. A saddle may truly be met again, farther
                // on, and one sheet from the other.
                let alone = convex || left.part != WALL;
                let near = |t| t < 1e-9 * scale && left.lift > 1e-6;
                let wrong = left.next.is_some_and(|t| alone || near(t));
                assert!(
                    !wrong,
                    "{quadric:?} {} {} {:?}",
                    left.part, left.lift, left.next
                );
                outwards += 1;
            }
        }
    }
    assert!(outwards > count / 2 && inwards > count / 2);
}

/// Twice `count` rays at each of eight shapes.
fn all_self_hits(count: usize) {
    self_hits(
        count,
        scaled,
        [true, true, true, true, true, false, false, false],
    );
    self_hits(
        count,
        extremes,
        [true, true, true, true, true, false, false, true],
    );
}

#[test]
fn no_ray_finds_the_surface_again_that_it_leaves() {
    all_self_hits(many(4000));
}

#[test]
fn points_lie_on_the_surface_and_in_the_box() {
    let mut random = QuadricRays(9);
    for _ in 0..4000 {
        for quadric in kinds() {
            let (origin, target) = (random.power(0.5, 7.0) * random.vector(), random.vector());
            let ray = Ray::new(origin, (target - origin).normalize());
            for (cut, enters) in quadric.spans(&ray).cuts() {
                let surface = quadric.surface(&ray, cut.t, cut.part);
                let bounds = quadric.bounds();
                let p = surface.point;
                assert!(p.cmpge(bounds.min).all() && p.cmple(bounds.max).all());
                assert!((surface.normal.length() - 1.0).abs() < 4e-16);
                assert!(
                    surface.uv.cmpge(crate::math::DVec2::ZERO).all()
                        && surface.uv.x <= 1.0
                        && surface.uv.y <= 1.0
                );
                if cut.part == WALL {
                    let distance = quadric.form().value(p).abs() / quadric.gradient(p).length();
                    assert!(distance < surface.error.x, "{quadric:?} {p} {distance:e}");
                } else {
                    assert_eq!(p.y.abs(), quadric.half_height);
                }
                // The normal tells the same as the spans, but for flat angles.
                let cos = surface.normal.dot(ray.direction);
                assert!(cos.abs() < 1e-6 || (cos < 0.0) == enters);
            }
        }
    }
}

#[test]
fn u_runs_once_around_and_v_up_the_wall() {
    let cylinder = Quadric::cylinder(1.0, 2.0);
    for (origin, direction, part, uv) in [
        ([3.0, -1.0, 0.0], [-1.0, 0.0, 0.0], WALL, [0.5, 0.25]),
        ([0.0, 1.0, 3.0], [0.0, 0.0, -1.0], WALL, [0.25, 0.75]),
        ([0.5, 3.0, 0.0], [0.0, -1.0, 0.0], TOP, [0.5, 0.5]),
    ] {
        let surface = cylinder.surface(
            &ray(origin, direction),
            if part == WALL { 2.0 } else { 1.0 },
            part,
        );
        assert_eq!(surface.uv.to_array(), uv);
    }
}
