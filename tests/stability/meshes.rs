//! Closed meshes: rays from inside at edges and corners leave through them an odd number of times, in every accelerator.

use proptest::prelude::*;
use raytree::math::{DVec3, Interval};

use super::common;
use super::support::{Mesh, Random, all, count, towards};

/// Where rays are aimed.
#[derive(Clone, Copy, Debug)]
enum Aim {
    Edges,
    Corners,
    Both,
}

/// Sends rays from near the middle of a mesh (`map` of the origin) at its edges and corners, through every accelerator.
/// Each must cross an odd number of faces: once, if the mesh is `convex`. The error tells the first that does not.
fn leaks(
    mesh: &Mesh,
    map: impl Fn(DVec3) -> DVec3,
    (aim, convex): (Aim, bool),
    (rays, seed): (usize, u64),
) -> Result<(), String> {
    let mut random = Random(seed);
    let shapes = mesh.shapes();
    let aimed: Vec<_> = (0..rays)
        .filter_map(|i| {
            let face = mesh.faces[random.below(mesh.faces.len())];
            let side = random.below(3);
            let [a, b] = [face[side], face[(side + 1) % 3]].map(|i| mesh.points[i]);
            let corner = match aim {
                Aim::Edges => false,
                Aim::Corners => true,
                Aim::Both => i % 2 == 0,
            };
            let target = if corner {
                a
            } else {
                a + random.share() * (b - a)
            };
            towards(map(0.2 * random.point()), target)
        })
        .collect();
    let mut crossed = Vec::new();
    for (kind, accel) in all(&shapes) {
        for (i, ray) in aimed.iter().enumerate() {
            accel.all_hits_into(&mut crossed, &shapes, ray, Interval::FORWARD);
            let (n, odd) = (crossed.len(), crossed.len() % 2 == 1);
            if !odd || convex && n != 1 {
                return Err(format!("{kind:?}: {n} crossings of {ray:?}: {crossed:?}"));
            }
            // The same walk that ends at the first: a fourth of the rays a tree, each ray in some, corners and edges by turns.
            if i / 2 % 4 != kind as usize % 4 {
                continue;
            }
            let mut silent = raytree::probe::Silent;
            let closest = accel.closest(&shapes, ray, Interval::FORWARD, &mut silent);
            if closest != crossed.first().copied() {
                return Err(format!("{kind:?}: {closest:?}, not {crossed:?}, {ray:?}"));
            }
        }
    }
    Ok(())
}

/// Globes of 30 to 208 triangles, round and bumpy by turns: rings, triangles around, how bumpy, and their share of the rays. Smaller
/// ones have larger shares: they have every kind of edge and corner as well, and a ray through them costs less.
const GLOBES: [(usize, usize, f64, f64); 6] = [
    (3, 5, 0.0, 0.22),
    (3, 7, 0.3, 0.22),
    (4, 6, 0.0, 0.22),
    (5, 8, 0.2, 0.22),
    (7, 12, 0.0, 0.06),
    (8, 13, 0.3, 0.06),
];

/// Sends so many rays at what `aim` says of all globes, moved by `offset` and so far from the origin.
fn no_globe_leaks(offset: f64, aim: Aim, rays: usize, seed: u64) {
    let map = |p: DVec3| p + offset * DVec3::new(1.0, -0.7, 0.3);
    for ((rings, around, bump, share), seed) in GLOBES.into_iter().zip(seed..) {
        let mesh = Mesh::globe(rings, around, bump).moved(map);
        // Far off corners are rounded to places that are not quite convex.
        let convex = bump == 0.0 && offset == 0.0;
        let rays = (share * rays as f64).round() as usize;
        let found = leaks(&mesh, map, (aim, convex), (rays, seed));
        assert_eq!(found, Ok(()), "offset {offset}, {rings} rings, bump {bump}");
    }
}

#[test]
fn case_01_rays_at_edges_leave_a_closed_mesh() {
    no_globe_leaks(0.0, Aim::Edges, count(500_000, 4000), 100);
}

#[test]
fn case_02_rays_at_corners_leave_a_closed_mesh() {
    no_globe_leaks(0.0, Aim::Corners, count(500_000, 4000), 200);
}

/// A thousand triangles meet in each pole.
#[test]
fn case_02_rays_at_the_pole_of_a_fan_of_a_thousand() {
    let mut fan = Mesh::globe(1, 1000, 0.0);
    // Aim at the poles alone: they are the first corner of every face.
    let shapes = fan.shapes();
    let mut random = Random(5);
    for (kind, accel) in all(&shapes) {
        for _ in 0..count(10_000, 60) {
            let pole = fan.points[random.below(2)];
            let ray = towards(0.2 * random.point(), pole).expect("a direction");
            let crossed = accel.all_hits(&shapes, &ray, Interval::FORWARD);
            assert_eq!(crossed.len(), 1, "{kind:?}: {ray:?}");
        }
    }
    fan = fan.moved(|p| p + DVec3::splat(1e6));
    let map = |p: DVec3| p + DVec3::splat(1e6);
    let rays = count(5000, 30);
    assert_eq!(leaks(&fan, map, (Aim::Both, false), (rays, 6)), Ok(()));
}

#[test]
fn case_03_a_thousand_from_the_origin() {
    no_globe_leaks(1e3, Aim::Both, count(1_000_000, 3000), 300);
}

#[test]
fn case_03_a_million_from_the_origin() {
    no_globe_leaks(1e6, Aim::Both, count(1_000_000, 3000), 400);
}

#[test]
fn case_03_a_billion_from_the_origin() {
    no_globe_leaks(1e9, Aim::Both, count(1_000_000, 3000), 500);
}

/// A globe drawn out and pressed flat: triangles a hundred million times as long as wide.
#[test]
fn case_04_needles() {
    let stretches = [
        DVec3::new(1e4, 1.0, 1e-4),
        DVec3::new(1.0, 1.0, 1e-8),
        DVec3::new(1e8, 1.0, 1.0),
    ];
    for (i, stretch) in stretches.into_iter().enumerate() {
        let mesh = Mesh::globe(6, 12, 0.0).moved(|p| p * stretch);
        let map = |p: DVec3| p * stretch;
        let rays = count(60_000, 800);
        let found = leaks(&mesh, map, (Aim::Both, false), (rays, 10 + i as u64));
        assert_eq!(found, Ok(()), "{stretch}");
    }
}

/// Source: Embree, `verify.cpp`, watertight test: a sphere of radius 2 with this centre. It allows 2e-5 misses.
#[test]
fn case_05_embree_sphere_far_off() {
    let map = |p: DVec3| DVec3::new(148_376.0, 1234.0, -223_423.0) + 2.0 * p;
    let mesh = Mesh::globe(9, 18, 0.0).moved(map);
    let rays = count(100_000, 1000);
    assert_eq!(leaks(&mesh, map, (Aim::Both, false), (rays, 20)), Ok(()));
}

proptest! {
    #![proptest_config(common::config(60))]

    /// Any globe, of any size, anywhere.
    #[test]
    fn case_03_any_closed_mesh_anywhere(
        seed: u64,
        rings in 1usize..8,
        around in 3usize..12,
        bump in 0.0..0.4f64,
        power in -6i32..7,
        distance in prop::sample::select(&[0.0, 1.0, 1e3, 1e6][..]),
    ) {
        let size = libm::pow(10.0, f64::from(power));
        let at = distance * size * Random(seed).point();
        let map = |p: DVec3| at + size * p;
        let mesh = Mesh::globe(rings, around, bump).moved(map);
        // A pyramid of three sides does not hold all of the points that the rays start from.
        prop_assume!(rings > 2 && around > 4);
        prop_assert_eq!(leaks(&mesh, map, (Aim::Both, false), (30, seed)), Ok(()));
    }
}
