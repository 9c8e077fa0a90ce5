//! Tests of solids gone wrong: caps that are forgotten, a root that is given up too early, parts of a csg that are not combined.

use crate::geometry::{Body, Cut, Intersection};
use crate::math::{Interval, Ray};
use crate::scene::Bend;

/// Whether a bend changes what is met of such a body.
pub fn exchanges(bend: Bend, body: &Body) -> bool {
    match bend {
        Bend::CapsForgotten | Bend::FirstRootClipped => {
            matches!(body, Body::Quadric(_) | Body::BoxedQuadric(_))
        }
        Bend::CsgFirstPart | Bend::CsgAllParts => matches!(body, Body::Csg(_)),
        _ => false,
    }
}

/// The crossing that is taken for the first inside the interval.
pub fn first_crossing(bend: Bend, body: &Body, ray: &Ray, interval: Interval) -> Option<Cut> {
    let is_wall = |cut: &Cut| cut.part == 0;
    let first = |mut cuts: Vec<Cut>, is_met: &dyn Fn(&Cut) -> bool| {
        cuts.retain(|cut| interval.contains(cut.t) && is_met(cut));
        cuts.first().copied()
    };
    match (bend, body) {
        (Bend::CapsForgotten, _) => first(cuts(body, ray), &is_wall),
        (Bend::FirstRootClipped, _) => {
            let [t0, t1] = roots(body, ray)?;
            let is_nearer = |t: f64| (t - t0).abs() < (t - t1).abs();
            first(cuts(body, ray), &|cut| !is_wall(cut) || is_nearer(cut.t))
        }
        (_, Body::Csg(csg)) => {
            let all = csg.cuts(ray).cuts.into_iter();
            let met = all.filter(|cut| cut.leaf == 0 || bend == Bend::CsgAllParts);
            let cuts = met.map(|cut| Cut {
                t: cut.t,
                part: cut.part,
            });
            first(cuts.collect(), &|_| true)
        }
        _ => None,
    }
}

/// The cuts of the ray's line with the walls and the faces of a body, by t, whether it is closed or not.
fn cuts(body: &Body, ray: &Ray) -> Vec<Cut> {
    if body.is_solid() {
        return body.spans(ray).cuts().map(|(cut, _)| cut).collect();
    }
    // Of an open wall its own test tells them, one after the other.
    let mut found = Vec::new();
    let mut from = f64::NEG_INFINITY;
    while let Intersection::Hit { t, part, .. } =
        body.intersect(ray, Interval::new(from, f64::INFINITY))
    {
        found.push(Cut { t, part });
        from = t;
    }
    found
}

/// The nearer and the farther root of the endless surface.
fn roots(body: &Body, ray: &Ray) -> Option<[f64; 2]> {
    let [x, y] = match body {
        Body::Quadric(quadric) => quadric.arithmetic(ray).roots,
        Body::BoxedQuadric(quadric) => quadric.arithmetic(ray).roots,
        _ => return None,
    };
    Some([x.min(y), x.max(y)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Quadric;
    use crate::math::DVec3;

    /// A ray that goes in by the top at t = 2 and comes out of the wall at t = 3; the wall's line meets it at t = -1 as well, above the top.
    #[test]
    fn caps_and_roots_known_on_paper() {
        let closed = Quadric::cylinder(1.0, 1.0);
        let ray = Ray::new(DVec3::new(-0.5, 3.0, 0.0), DVec3::new(0.5, -1.0, 0.0));
        let first = |bend, quadric| {
            let body = Body::Quadric(quadric);
            assert!(exchanges(bend, &body));
            let cut = first_crossing(bend, &body, &ray, Interval::FORWARD)?;
            Some((cut.t, cut.part))
        };
        let top = 2;
        assert_eq!(first(Bend::CapsForgotten, closed), Some((3.0, 0)));
        assert_eq!(first(Bend::FirstRootClipped, closed), Some((2.0, top)));
        assert_eq!(first(Bend::FirstRootClipped, closed.open()), None);
        assert_eq!(first(Bend::CapsForgotten, closed.open()), Some((3.0, 0)));
        assert!(!exchanges(Bend::FarRoot, &Body::Quadric(closed)));
    }
}
