//! Tests of solids gone wrong: caps that are forgotten, a root that is given up too early, parts of a csg that are not combined.

use crate::geometry::{Body, Csg, Cut, Intersection};
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
            let roots = roots(body, ray)?;
            let nearer = roots.into_iter().find(|t| interval.contains(*t));
            let is_nearer = |t: f64| {
                let off = |root: f64| (t - root).abs();
                nearer.is_some_and(|near| roots.iter().all(|root| off(near) <= off(*root)))
            };
            first(cuts(body, ray), &|cut| !is_wall(cut) || is_nearer(cut.t))
        }
        (_, Body::Csg(csg)) => first(csg.cuts_of_all_leaves(ray), &|cut| {
            bend == Bend::CsgAllParts || Csg::leaf_of(cut.part) == 0
        }),
        _ => None,
    }
}

/// The cuts of the ray's line with the walls and the faces of a body, by t, whether it is closed or not.
fn cuts(body: &Body, ray: &Ray) -> Vec<Cut> {
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

/// The roots of the endless surface, by t.
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

    fn first(bend: Bend, quadric: Quadric, ray: Ray) -> Option<(f64, u32)> {
        let body = Body::Quadric(quadric);
        assert!(exchanges(bend, &body));
        let cut = first_crossing(bend, &body, &ray, Interval::FORWARD)?;
        Some((cut.t, cut.part))
    }

    /// The line meets the endless wall at t = 3, above the top, goes in by the top at t = 6 and comes out of the wall at t = 7.
    #[test]
    fn caps_and_roots_known_on_paper() {
        let closed = Quadric::cylinder(1.0, 1.0);
        let ray = Ray::new(DVec3::new(-2.5, 7.0, 0.0), DVec3::new(0.5, -1.0, 0.0));
        let top = 2;
        assert_eq!(first(Bend::CapsForgotten, closed, ray), Some((7.0, 0)));
        assert_eq!(first(Bend::FirstRootClipped, closed, ray), Some((6.0, top)));
        assert_eq!(first(Bend::FirstRootClipped, closed.open(), ray), None);
        assert_eq!(
            first(Bend::CapsForgotten, closed.open(), ray),
            Some((7.0, 0))
        );
        assert!(!exchanges(Bend::FarRoot, &Body::Quadric(closed)));
    }

    #[test]
    fn from_inside_the_root_in_front_is_the_nearer_one() {
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let found = first(Bend::FirstRootClipped, Quadric::cylinder(1.0, 1.0), ray);
        assert_eq!(found, Some((1.0, 0)));
    }
}
