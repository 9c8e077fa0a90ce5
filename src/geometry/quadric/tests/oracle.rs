//! Near-tangent rays against exact integers.
//!
//! Shapes, origins and directions have whole coordinates, so a `f64` holds them and 128 bits hold D. Each ray passes through a
//! point of whole coordinates next to the wall, along a whole direction next to a tangent, from 1e5 radii away.

use super::QuadricRays;
use crate::geometry::quadric::{Quadric, Sheets};
use crate::math::{DVec3, Ray};

/// A unit of length that leaves the digits for near misses: the shapes are 4 to 10 of these.
const K: i64 = 2_000_000;

/// A quadric as q (x^2 + z^2) = a y^2 + b y + c between y = -h and h.
struct Whole {
    quadric: Quadric,
    h: i64,
    /// q, a, b and c.
    form: [i64; 4],
}

fn shapes() -> [Whole; 5] {
    let k = K as f64;
    let shape = |quadric, h, form| Whole { quadric, h, form };
    [
        shape(
            Quadric::cylinder(4.0 * k, 3.0 * k),
            3 * K,
            [1, 0, 0, 16 * K * K],
        ),
        // R = 4k + y/2.
        shape(
            Quadric::cone(3.0 * k, 5.0 * k, 2.0 * k),
            2 * K,
            [4, 1, 16 * K, 64 * K * K],
        ),
        // R^2 = 6k (y + 3k).
        shape(
            Quadric::paraboloid(6.0 * k, 3.0 * k),
            3 * K,
            [1, 0, 6 * K, 18 * K * K],
        ),
        shape(
            Quadric::hyperboloid(4.0 * k, 5.0 * k, 3.0 * k, Sheets::One),
            3 * K,
            [1, 1, 0, 16 * K * K],
        ),
        shape(
            Quadric::hyperboloid(3.0 * k, 4.0 * k, 5.0 * k, Sheets::Two),
            5 * K,
            [1, 1, 0, -9 * K * K],
        ),
    ]
}

impl Whole {
    /// The truth, if the line is nearest to the wall between the planes and turns away from it there (A > 0): D > 0.
    fn is_hit(&self, o: [i64; 3], d: [i64; 3]) -> Option<bool> {
        let [q, a, b, c] = self.form.map(i128::from);
        let ([x, y, z], [dx, dy, dz]) = (o.map(i128::from), d.map(i128::from));
        let first = q * (dx * dx + dz * dz) - a * dy * dy;
        // Twice B.
        let second = 2 * q * (x * dx + z * dz) - (2 * a * y + b) * dy;
        let third = q * (x * x + z * z) - (a * y + b) * y - c;
        let height = 2 * first * y - second * dy;
        let between = height.abs() < 2 * first * i128::from(self.h);
        (first > 0 && between).then_some(second * second > 4 * first * third)
    }

    /// A ray near to touching, in whole numbers.
    fn near_tangent(&self, random: &mut QuadricRays) -> ([i64; 3], [i64; 3]) {
        let h = self.h as f64;
        let y = random.within(-0.9 * h, 0.9 * h);
        let (sin, cos) = libm::sincos(random.within(0.0, std::f64::consts::TAU));
        let r = self.quadric.profile.radius(y);
        let p = DVec3::new(r * cos, y, r * sin);
        let tangent = self.quadric.gradient(p).cross(random.vector()).normalize();
        let whole = |v: DVec3| v.to_array().map(|x| x.round() as i64);
        let (p, d) = (whole(p), whole(1e4 * tangent));
        let o = [0, 1, 2].map(|i| p[i] - 100_000_000 * d[i]);
        (o, d)
    }
}

#[test]
fn near_tangent_rays_are_told_as_whole_numbers_tell_them() {
    let mut random = QuadricRays(17);
    for shape in shapes() {
        let (mut asked, mut hits, mut school_wrong) = (0, 0, 0);
        for _ in 0..2000 {
            let (o, d) = shape.near_tangent(&mut random);
            let Some(expected) = shape.is_hit(o, d) else {
                continue;
            };
            let float = |v: [i64; 3]| DVec3::from_array(v.map(|x| x as f64));
            let ray = Ray::new(float(o), float(d));
            let found = !shape.quadric.spans(&ray).0.is_empty();
            assert_eq!(found, expected, "{} {o:?} {d:?}", shape.quadric.kind());
            let school = !shape.quadric.school_spans(&ray).0.is_empty();
            asked += 1;
            hits += u32::from(expected);
            school_wrong += u32::from(school != expected);
        }
        let kind = shape.quadric.kind();
        assert!(
            asked > 500 && hits > 100 && asked - hits > 50,
            "{kind} {asked} {hits}"
        );
        assert!(
            school_wrong * 10 > asked,
            "{kind} {school_wrong} of {asked}"
        );
    }
}

#[test]
fn a_cylinder_four_thousand_million_radii_away_is_told_as_whole_numbers_tell_it() {
    // Touching is |p x e| = r |e| exactly. Here u |o| is half a unit, about as far as these rays pass from the wall: only an o' that
    // is rounded once, at its own size, can tell.
    const R: i64 = 1_000_000;
    let tower = Quadric::cylinder(R as f64, R as f64);
    let mut random = QuadricRays(19);
    let (mut hits, mut count) = (0, 0);
    for _ in 0..2000 {
        let (sin, cos) = libm::sincos(random.within(0.0, std::f64::consts::TAU));
        let whole = |size: f64, x: f64| (size * x).round() as i64;
        let p = [whole(R as f64, cos), whole(R as f64, sin)];
        let d = [whole(-1e3, sin), whole(1e3, cos)];
        let o = [0, 1].map(|i| p[i] - 4_000_000_000_000 * d[i]);
        let ([x, z], [dx, dz]) = (o.map(i128::from), d.map(i128::from));
        let moment = x * dz - z * dx;
        let at_touch = i128::from(R * R) * (dx * dx + dz * dz);
        // A line that touches to the last digit is told neither way.
        if moment * moment == at_touch {
            continue;
        }
        let expected = moment * moment < at_touch;
        let float = |[x, z]: [i64; 2]| DVec3::new(x as f64, 0.0, z as f64);
        let ray = Ray::new(float(o), float(d));
        // Spans this short may have no two different t: D is asked for.
        let found = tower.arithmetic(&ray).discriminant > 0.0;
        assert_eq!(found, expected, "{o:?} {d:?}");
        hits += i32::from(expected);
        count += 1;
    }
    assert!(hits > 100 && count - hits > 100, "{hits}");
}
