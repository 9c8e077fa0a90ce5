//! Flat, bilinear, collapsed and weighted patches: answers known on paper.

use super::*;

#[test]
fn a_flat_patch_is_its_plane() {
    // Uneven steps within the plane z = x / 2 + y / 4 - 1.
    let mut random = PatchRays(2);
    let patch = lattice(|i, j| {
        let (x, y) = (i * i / 3.0 - 1.0, j + 0.1 * i - 1.5);
        DVec3::new(x, y, x / 2.0 + y / 4.0 - 1.0)
    });
    let mut met = 0;
    for _ in 0..500 {
        let origin = DVec3::new(random.signed(), random.signed(), 3.0);
        let direction = DVec3::new(0.2 * random.signed(), 0.2 * random.signed(), -1.0);
        let t = (origin.x / 2.0 + origin.y / 4.0 - 1.0 - origin.z)
            / (direction.z - direction.x / 2.0 - direction.y / 4.0);
        if let [c] = crossings(&patch, origin, direction)[..] {
            met += 1;
            assert!((c.t - t).abs() <= 4.0 * f64::EPSILON * t, "{:e}", c.t - t);
            assert!(c.enters);
        }
    }
    assert!(met > 400, "{met}");
    // From behind the normal points away.
    assert!(!crossings(&patch, DVec3::new(0.1, 0.0, -9.0), DVec3::Z)[0].enters);
}

#[test]
fn random_sheets_are_crossed_oddly_from_above_and_each_crossing_is_on_the_ray() {
    let mut random = PatchRays(3);
    for height in [0.1, 1.0, 8.0] {
        for _ in 0..100 {
            let patch = sheet(&mut random, height);
            let origin = DVec3::new(random.signed(), random.signed(), 50.0);
            assert_eq!(crossings(&patch, origin, DVec3::NEG_Z).len(), 1);
            let target = random.point() * DVec3::new(0.9, 0.9, height);
            let direction = random.direction();
            for c in &crossings(&patch, target, direction) {
                let off = patch.surface(c.place).point - (target + c.t * direction);
                assert!(off.length() < 1e-14 * height.max(1.0), "{off}");
            }
        }
    }
}

#[test]
fn a_saddle_is_met_where_its_quadratic_says() {
    // z = x y over the square from -1 to 1. Along o + t d: t^2 dx dy + t (ox dy + oy dx - dz) + ox oy - oz = 0.
    let corner = |x: f64, y: f64| DVec3::new(x, y, x * y);
    let saddle = leaf(
        &[
            vec![corner(-1.0, -1.0), corner(1.0, -1.0)],
            vec![corner(-1.0, 1.0), corner(1.0, 1.0)],
        ],
        None,
    );
    let mut random = PatchRays(8);
    for _ in 0..2000 {
        let (o, d) = (random.point() * 2.0, random.direction());
        let (a, b, c) = (d.x * d.y, o.x * d.y + o.y * d.x - d.z, o.x * o.y - o.z);
        let discriminant = b * b - 4.0 * a * c;
        let mut expected = Vec::new();
        if discriminant > 0.0 {
            let q = -0.5 * (b + discriminant.sqrt().copysign(b));
            expected = [q / a, c / q]
                .into_iter()
                .filter(|t| (o + *t * d).truncate().abs().max_element() < 1.0)
                .collect();
            expected.sort_by(f64::total_cmp);
        }
        let found = crossings(&saddle, o, d);
        assert_eq!(found.len(), expected.len(), "{o} {d}");
        for (c, t) in found.iter().zip(expected) {
            let slope = (2.0 * a * t + b).abs();
            assert!((c.t - t).abs() * slope < 1e-14, "{:e}", c.t - t);
        }
    }
    // Edges and corners are ends: along the straight line x = 1/2 that lies in it, the ray touches.
    assert_eq!(
        crossings(
            &saddle,
            DVec3::new(0.5, -3.0, -1.5),
            DVec3::new(0.0, 1.0, 0.5)
        )
        .len(),
        0
    );
}

#[test]
fn points_lines_and_no_rays_miss() {
    let point = lattice(|_, _| DVec3::new(0.1, 0.2, 0.3));
    let line = lattice(|i, j| DVec3::new(i - j, 2.0 * (i - j), 0.0));
    for patch in [&point, &line] {
        for direction in [
            DVec3::X,
            DVec3::new(1.0, 2.0, 0.0),
            DVec3::new(0.3, 0.5, -0.8),
        ] {
            for target in [
                DVec3::new(0.1, 0.2, 0.3),
                DVec3::ZERO,
                DVec3::new(0.5, 1.0, 0.0),
            ] {
                assert_eq!(crossings(patch, target - direction, direction).len(), 0);
            }
        }
        assert!((patch.surface([0.5, 0.5]).normal.length() - 1.0).abs() < 1e-15);
    }
    let good = sheet(&mut PatchRays(1), 0.5);
    for bad in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
        assert_eq!(crossings(&good, DVec3::Z, bad).len(), 0);
        assert_eq!(crossings(&good, bad * f64::INFINITY, DVec3::NEG_Z).len(), 0);
    }
}

#[test]
fn tiny_and_huge_patches_are_met_alike() {
    let patch = sheet(&mut PatchRays(6), 0.5);
    let (origin, direction) = (DVec3::new(0.3, -0.2, 2.0), DVec3::new(0.1, 0.05, -1.0));
    let expected = crossings(&patch, origin, direction)[0];
    for exponent in [-600, -400, -30, 30, 400] {
        let scale = 2f64.powi(exponent);
        let scaled = SurfacePatch {
            control: patch
                .control
                .iter()
                .map(|p| (p.truncate() * scale).extend(1.0))
                .collect(),
            ..patch.clone()
        };
        let found = crossings(&scaled, origin * scale, direction);
        assert_eq!(
            (found[0].t, found[0].place),
            (expected.t * scale, expected.place)
        );
        assert_eq!(
            scaled.surface([0.3, 0.4]).normal,
            patch.surface([0.3, 0.4]).normal
        );
    }
}

#[test]
fn a_raised_degree_and_a_new_knot_change_nothing() {
    let mut random = PatchRays(14);
    for _ in 0..40 {
        let patch = sheet(&mut random, 0.6);
        // Degree 3 to 4 along u: Q_i = i/4 P_(i-1) + (1 - i/4) P_i. A knot at 1/2 is a cut in two halves.
        let p = |i: usize, j: usize| patch.control[j * 4 + i].truncate();
        let raised = |i: usize, j: usize| {
            let a = i as f64 / 4.0;
            a * p(i.saturating_sub(1), j) + (1.0 - a) * p(i.min(3), j)
        };
        let raised = leaf(
            &(0..4)
                .map(|j| (0..5).map(|i| raised(i, j)).collect())
                .collect::<Vec<_>>(),
            None,
        );
        let points = (0..4).map(|j| (0..4).map(|i| p(i, j)).collect()).collect();
        let surface = BezierSurface {
            degree: [3, 3],
            patches: vec![points],
            weights: None,
            ranges: None,
        };
        let cut = surface.leaves().expect("a good surface");
        for _ in 0..20 {
            let (target, direction) = (random.point() * 0.5, random.direction());
            let ray = Ray::new(target - 2.0 * direction, direction);
            let mut in_leaves = super::seams::all(&cut, &ray);
            in_leaves.sort_by(|a, b| a.t.total_cmp(&b.t));
            let whole = crossings(&patch, ray.origin, direction);
            for other in [crossings(&raised, ray.origin, direction), in_leaves] {
                assert_eq!(whole.len(), other.len());
                for (a, b) in whole.iter().zip(&other) {
                    let cos = patch.surface(a.place).normal.dot(direction).abs();
                    assert!((a.t - b.t).abs() * cos < 1e-13 && a.enters == b.enters);
                }
            }
        }
    }
}

#[test]
fn a_weight_of_a_million_pulls_but_does_not_break() {
    let mut random = PatchRays(19);
    for _ in 0..100 {
        let net = sheet(&mut random, 0.6);
        let mut heavy = net.clone();
        let k = (random.unit() * 16.0) as usize;
        heavy.control[k].w = 1e6;
        let origin = DVec3::new(0.9 * random.signed(), 0.9 * random.signed(), 5.0);
        let found = crossings(&heavy, origin, DVec3::NEG_Z);
        // The rim of the square is pulled along itself only, so that it is still run around once.
        assert_eq!(found.len() % 2, 1);
        for c in &found {
            let surface = heavy.surface(c.place);
            let off = surface.point - (origin - c.t * DVec3::Z);
            assert!(
                off.abs().cmple(surface.error).all(),
                "{off} {}",
                surface.error
            );
        }
    }
}

#[test]
fn the_first_crossing_in_an_interval_is_told_with_its_place() {
    let flat = lattice(|i, j| DVec3::new(i, j, 0.0));
    let shear = Shear::new(&Ray::new(DVec3::new(0.75, 1.5, 2.0), DVec3::NEG_Z));
    let test = |min, max| flat.intersect(&shear, Interval::new(min, max));
    let Intersection::Hit { t, place, part } = test(0.0, 3.0) else {
        panic!("inside");
    };
    assert_eq!((t, place, part), (2.0, [0.25, 0.5, 0.0], 0));
    assert_eq!(test(2.0, 3.0), Intersection::Behind(2.0));
    assert_eq!(test(0.0, 2.0), Intersection::TooFar(2.0));
    let surface = flat.surface([0.25, 0.5]);
    assert_eq!(
        (surface.point, surface.normal),
        (DVec3::new(0.75, 1.5, 0.0), DVec3::Z)
    );
    assert_eq!(surface.uv, DVec2::new(0.25, 0.5));
    // What was done for it: one part, which maps one to one, and a step or two to the place.
    let done = flat.arithmetic(&shear);
    assert_eq!(done.crossings.len(), 1);
    assert!(matches!(
        done.steps.last(),
        Some(SearchStep::Part(_, Fate::Solved))
    ));
    let bounds = flat.bounds();
    assert!(
        bounds.min.cmple(DVec3::ZERO).all() && bounds.max.cmpge(DVec3::new(3.0, 3.0, 0.0)).all()
    );
}
