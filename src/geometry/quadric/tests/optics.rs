//! Foci of lenses and mirrors, as Descartes found them: all rays along the axis meet in one point.

use super::ray;
use crate::geometry::quadric::{BoxedQuadric, Quadric, QuadricForm, Sheets, WALL};
use crate::geometry::{Aabb, SurfacePoint};
use crate::math::{DVec3, Ray};

const INDEX: f64 = 1.5;

/// Snell's law for a unit direction; `ratio` is the index before over the index behind.
fn refracted(d: DVec3, surface: &SurfacePoint, ratio: f64) -> DVec3 {
    let facing = d.dot(surface.normal) < 0.0;
    let n = if facing {
        surface.normal
    } else {
        -surface.normal
    };
    let cos = -d.dot(n);
    let behind = (1.0 - ratio * ratio * (1.0 - cos * cos)).sqrt();
    ratio * d + (ratio * cos - behind) * n
}

/// The height at which a ray in the plane z = 0 crosses the axis.
fn on_axis(from: DVec3, d: DVec3) -> f64 {
    from.y - from.x / d.x * d.y
}

/// Heights above the axis, from near it to 0.98 of `rim`.
fn heights(rim: f64) -> impl Iterator<Item = f64> {
    (1..=98).map(move |i| rim * f64::from(i) / 100.0)
}

#[test]
fn an_ellipsoid_of_glass_collects_at_its_far_focus() {
    // Half axes 1 along y and sqrt(5)/3 across: the eccentricity is 2/3, one over the index. The foci are at +-2/3.
    let form = QuadricForm([1.8, 1.0, 1.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
    let bounds = Aabb {
        min: DVec3::splat(-2.0),
        max: DVec3::splat(2.0),
    };
    let lens = BoxedQuadric::new(form, bounds);
    for x in heights(5.0f64.sqrt() / 3.0) {
        let down = ray([x, 3.0, 0.0], [0.0, -1.0, 0.0]);
        let (cut, _) = lens.spans(&down).cuts().next().expect("met");
        let surface = lens.surface(&down, cut.t, cut.part);
        let inside = refracted(down.direction, &surface, 1.0 / INDEX);
        let focus = on_axis(surface.point, inside);
        assert!((focus + 2.0 / 3.0).abs() < 1e-13, "{x} {focus}");
    }
}

#[test]
fn glass_that_ends_in_a_hyperboloid_collects_at_its_far_focus() {
    // x^2 + z^2 = 1.25 (y^2 - 1): the eccentricity is sqrt(2.25), the index. The foci are at +-1.5.
    let h = 2.0;
    let radius = (1.25f64 * 3.0).sqrt();
    let lens = Quadric::hyperboloid(1.0, radius, h, Sheets::Two);
    for x in heights(radius) {
        let up = ray([x, -3.0, 0.0], [0.0, 1.0, 0.0]);
        let spans = lens.spans(&up);
        let (cut, _) = spans.cuts().nth(1).expect("met");
        let surface = lens.surface(&up, cut.t, cut.part);
        let behind = refracted(up.direction, &surface, INDEX);
        let focus = on_axis(surface.point, behind);
        assert!((focus - 1.5).abs() < 1e-13, "{x} {focus}");
    }
}

#[test]
fn a_parabolic_mirror_collects_at_its_focus() {
    let (r, h) = (2.0, 0.4);
    let mirror = Quadric::paraboloid(r, h).open();
    for x in heights(r) {
        let down = Ray::new(DVec3::new(x, 5.0, 0.0), DVec3::NEG_Y);
        let (cut, _) = mirror.spans_if_closed(&down).cuts().nth(1).expect("met");
        let surface = mirror.surface(&down, cut.t, WALL);
        let n = surface.normal;
        let back = down.direction - 2.0 * down.direction.dot(n) * n;
        // r^2 / 4H above the vertex, with H = 2h.
        let focus = on_axis(surface.point, back) + h;
        assert!((focus - r * r / (8.0 * h)).abs() < 1e-13, "{x} {focus}");
    }
}
