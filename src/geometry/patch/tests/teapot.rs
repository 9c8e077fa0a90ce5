//! The Utah teapot from its 32 patches.

use super::seams::evenly;
use super::*;
use crate::geometry::test_rays::many;

const TEXT: &str = include_str!("teapot.txt");

/// The patches, each four rows of four points.
pub fn teapot() -> Vec<Vec<Vec<DVec3>>> {
    let mut points: Vec<DVec3> = Vec::new();
    let mut patches = Vec::new();
    for line in TEXT.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next();
        let numbers: Vec<f64> = words.map_while(|w| w.parse().ok()).collect();
        match kind {
            Some("p") => points.push(DVec3::new(numbers[0], numbers[1], numbers[2])),
            Some("b") => {
                let row = |row: &[f64]| row.iter().map(|i| points[*i as usize]).collect();
                patches.push(numbers.chunks(4).map(row).collect());
            }
            _ => {}
        }
    }
    patches
}

pub fn surface(patches: Vec<Vec<Vec<DVec3>>>) -> BezierSurface {
    BezierSurface {
        degree: [3, 3],
        patches,
        weights: None,
        ranges: None,
    }
}

/// Some patches of the teapot with a fan in each opening, from its edges to a point in its middle, so that the body is closed.
fn closed(patches: &[Vec<Vec<DVec3>>]) -> Vec<SurfacePatch> {
    let reversed = |points: &[DVec3]| points.iter().rev().copied().collect::<Vec<_>>();
    let edges = |patch: &Vec<Vec<DVec3>>| {
        // Each as its own patch runs along it, counter-clockwise.
        let column = |i: usize| patch.iter().map(|row| row[i]).collect::<Vec<_>>();
        [
            patch[0].clone(),
            column(3),
            reversed(&patch[3]),
            reversed(&column(0)),
        ]
    };
    let every: Vec<Vec<DVec3>> = patches.iter().flat_map(edges).collect();
    let mut patches = patches.to_vec();
    for edge in &every {
        let back = reversed(edge);
        let is_point = edge.iter().all(|p| *p == edge[0]);
        if !is_point && !every.contains(&back) {
            let middle = middle_of_opening(edge[0]);
            let toward = |t: f64| back.iter().map(|p| p.lerp(middle, t)).collect();
            patches.push(vec![
                back.clone(),
                toward(1.0 / 3.0),
                toward(2.0 / 3.0),
                vec![middle; 4],
            ]);
        }
    }
    surface(patches).leaves().expect("a good surface")
}

/// The middle of the opening that a point is at the rim of.
fn middle_of_opening(p: DVec3) -> DVec3 {
    let [x, z] = match p.x {
        x if x.abs() < 1.45 => [0.0, 2.4],
        x if x < -1.7 => [-1.95, 0.75],
        x if x < 0.0 => [-1.55, 2.1375],
        x if x > 2.0 => [3.0, 2.4],
        _ => [1.7, 1.0],
    };
    DVec3::new(x, 0.0, z)
}

/// The closed parts of the teapot: body with rim and bottom, handle, spout, lid.
fn parts_of_the_teapot() -> [Vec<SurfacePatch>; 4] {
    let all = teapot();
    let body = [&all[0..12], &all[28..32]].concat();
    [
        closed(&body),
        closed(&all[12..16]),
        closed(&all[16..20]),
        closed(&all[20..28]),
    ]
}

#[test]
fn the_teapot_is_read_and_cut() {
    assert_eq!(teapot().len(), 32);
    let patches = surface(teapot()).leaves().expect("a good surface");
    // The edges of the openings stay open, and no seam that was closed comes apart where patches are cut.
    let open = patches
        .iter()
        .map(SurfacePatch::bounds)
        .filter(|b| b.max.z > 2.39)
        .count();
    assert!(open_edges(&patches) < 16 * 16 && open > 0);
    // Normals are finite everywhere, also where lid and bottom meet the axis in a point each.
    for leaf in &patches {
        for k in 0..9 {
            let surface = leaf.surface([f64::from(k % 3) / 2.0, f64::from(k / 3) / 2.0]);
            assert!((surface.normal.length() - 1.0).abs() < 1e-14);
            let on_axis = surface.point.truncate() == DVec2::ZERO;
            assert!(
                !on_axis || surface.normal.z.abs() > 0.9,
                "{} {}",
                surface.point,
                surface.normal
            );
        }
    }
}

#[test]
fn its_parts_are_crossed_evenly() {
    for (k, part) in parts_of_the_teapot().iter().enumerate() {
        assert!(evenly(part, many(40), k as u64) > many(20));
    }
}
