//! NURBS: spheres, cylinders and rings against what they are; knots; what is refused.

use super::seams::evenly;
use super::*;
use crate::geometry::Sphere;
use crate::geometry::test_rays::many;
use std::f64::consts::FRAC_1_SQRT_2;

/// A circle as nine points with weights, in four quarters. Source: Piegl and Tiller 1997, section 7.5.
const CIRCLE: [[f64; 3]; 9] = {
    const S: f64 = FRAC_1_SQRT_2;
    [
        [1.0, 0.0, 1.0],
        [1.0, 1.0, S],
        [0.0, 1.0, 1.0],
        [-1.0, 1.0, S],
        [-1.0, 0.0, 1.0],
        [-1.0, -1.0, S],
        [0.0, -1.0, 1.0],
        [1.0, -1.0, S],
        [1.0, 0.0, 1.0],
    ]
};

/// The surface of a profile (radius, y, weight) that is turned around the y axis. Its normal points outwards if the profile
/// runs upwards.
fn turned(profile: &[[f64; 3]], degree: usize, knots: Vec<f64>) -> NurbsSurface {
    let circle = vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    let point = |[r, y, _]: [f64; 3]| {
        CIRCLE
            .map(|[x, z, _]| DVec3::new(r * x, y, -r * z))
            .to_vec()
    };
    let weight = |[_, _, w]: [f64; 3]| CIRCLE.map(|[_, _, v]| w * v).to_vec();
    NurbsSurface {
        degree: [2, degree],
        knots: [circle, knots],
        points: profile.iter().map(|p| point(*p)).collect(),
        weights: Some(profile.iter().map(|p| weight(*p)).collect()),
    }
}

pub fn sphere() -> NurbsSurface {
    let s = FRAC_1_SQRT_2;
    let profile = [
        [0.0, -1.0, 1.0],
        [1.0, -1.0, s],
        [1.0, 0.0, 1.0],
        [1.0, 1.0, s],
        [0.0, 1.0, 1.0],
    ];
    turned(&profile, 2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0])
}

fn torus(minor: f64) -> NurbsSurface {
    let profile = CIRCLE.map(|[x, y, w]| [1.0 + minor * x, minor * y, w]);
    turned(
        &profile,
        2,
        vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0],
    )
}

fn leaves(surface: &NurbsSurface) -> Vec<SurfacePatch> {
    surface.leaves().expect("a good surface")
}

/// All crossings by t.
fn sorted(leaves: &[SurfacePatch], ray: &Ray) -> PatchCrossings {
    let mut found = super::seams::all(leaves, ray);
    found.sort_by(|a, b| a.t.total_cmp(&b.t));
    found
}

/// The largest error of t times the cosine, of so many rays.
fn against_the_sphere(rays: usize) -> f64 {
    let patches = leaves(&sphere());
    let unit = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let mut random = PatchRays(9);
    let mut worst = 0.0f64;
    for _ in 0..rays {
        let direction = random.direction();
        let ray = Ray::new(random.point() * 1.2 - 3.0 * direction, direction);
        let found = sorted(&patches, &ray);
        let expected = unit.span(&ray);
        match (expected, found.as_slice()) {
            (None, []) => {}
            (Some(t), [a, b]) => {
                for (t, crossing, enters) in [(t[0], a, true), (t[1], b, false)] {
                    let cos = ray.at(t).normalize().dot(direction).abs();
                    worst = worst.max((crossing.t - t).abs() * cos);
                    assert_eq!(crossing.enters, enters);
                }
            }
            // The patches' outline may differ by rounding.
            (Some(t), []) => assert!(t[1] - t[0] < 1e-6, "{ray:?}"),
            _ => assert!(
                unit.span(&ray).is_none() && found[1].t - found[0].t < 1e-6,
                "{ray:?}"
            ),
        }
    }
    worst
}

#[test]
fn a_sphere_of_nurbs_is_a_sphere() {
    assert!(against_the_sphere(many(400)) < 1e-14);
    for leaf in leaves(&sphere()) {
        for place in [[0.0, 0.0], [0.3, 0.7], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0]] {
            let surface = leaf.surface(place);
            assert!((surface.point.length() - 1.0).abs() < 1e-15);
            assert!(
                (surface.normal - surface.point).length() < 1e-13,
                "{} {}",
                surface.normal,
                surface.point
            );
        }
    }
    assert!(evenly(&leaves(&sphere()), many(200), 1) > many(50));
}

#[test]
fn a_ring_is_crossed_four_times_where_known() {
    let patches = leaves(&torus(0.25));
    let found = sorted(&patches, &Ray::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X));
    let t: Vec<f64> = found.iter().map(|c| c.t - 3.0).collect();
    for (t, expected) in t.iter().zip([-1.25, -0.75, 0.75, 1.25]) {
        assert!((t - expected).abs() < 1e-15, "{t}");
    }
    assert_eq!(t.len(), 4);
    // In the plane that touches its top, along its axis, and beside: nothing.
    for (origin, direction) in [
        (DVec3::new(-3.0, 0.25, 0.1), DVec3::X),
        (DVec3::ZERO, DVec3::Y),
    ] {
        assert_eq!(sorted(&patches, &Ray::new(origin, direction)).len(), 0);
    }
    assert!(evenly(&patches, many(200), 2) > many(50));
    assert!(against_the_ring(many(300)) < 4e-15);
}

/// The largest distance of a crossing from the ring's surface, which is |dt| cos; and each ray has as many crossings as the
/// distance from the ring's circle changes to more or less than the radius, where those are not close together.
fn against_the_ring(rays: usize) -> f64 {
    let patches = leaves(&torus(0.25));
    let above = |p: DVec3| libm::hypot(libm::hypot(p.x, p.z) - 1.0, p.y) - 0.25;
    let mut random = PatchRays(4);
    let mut worst = 0.0f64;
    for _ in 0..rays {
        let direction = random.direction();
        let ray = Ray::new(random.point() - 4.0 * direction, direction);
        let found = sorted(&patches, &ray);
        for c in &found {
            worst = worst.max(above(ray.at(c.t)).abs());
        }
        let steps: Vec<bool> = (0..=400)
            .map(|k| above(ray.at(f64::from(k) / 50.0)) > 0.0)
            .collect();
        let changes = steps.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let close = found.windows(2).any(|pair| pair[1].t - pair[0].t < 0.04);
        assert!(changes == found.len() || close, "{ray:?}");
    }
    worst
}

#[test]
fn a_cylinder_is_met_at_its_radius() {
    let wall = leaves(&turned(
        &[[0.5, 0.0, 1.0], [0.5, 2.0, 1.0]],
        1,
        vec![0.0, 0.0, 1.0, 1.0],
    ));
    let found = sorted(&wall, &Ray::new(DVec3::new(-2.0, 1.25, 0.0), DVec3::X));
    assert_eq!(found.len(), 2);
    assert!((found[0].t - 1.5).abs() < 1e-15 && (found[1].t - 2.5).abs() < 1e-15);
    let leaf = wall
        .iter()
        .find(|leaf| leaf.range()[0] == [0.0, 0.0])
        .expect("the first leaf");
    assert!((leaf.surface([0.0, 0.25]).uv.y - 0.25 * leaf.range()[1][1]).abs() < 1e-15);
}

#[test]
fn volumes_are_those_of_the_closed_forms() {
    use std::f64::consts::PI;
    let ball = enclosed_volume(&leaves(&sphere()));
    assert!(
        (ball - 4.0 / 3.0 * PI).abs() < 1e-11,
        "{:e}",
        ball - 4.0 / 3.0 * PI
    );
    let ring = enclosed_volume(&leaves(&torus(0.25)));
    assert!(
        (ring - 2.0 * PI * PI / 16.0).abs() < 1e-11,
        "{:e}",
        ring - PI * PI / 8.0
    );
}
