//! The volume that leaves enclose.

use super::SurfacePatch;

/// Nodes and weights of Gauss and Legendre's rule of five points on [0, 1]: exact up to degree 9.
const GAUSS: [[f64; 2]; 5] = [
    [0.046_910_077_030_668_004, 0.118_463_442_528_094_54],
    [0.230_765_344_947_158_45, 0.239_314_335_249_683_23],
    [0.5, 0.284_444_444_444_444_44],
    [0.769_234_655_052_841_5, 0.239_314_335_249_683_23],
    [0.953_089_922_969_332, 0.118_463_442_528_094_54],
];

/// The volume that a closed surface encloses, in cubic metres: below 0 if its normals point inwards.
///
/// By Gauss' theorem it is the integral of S . (S_u x S_v) / 3 over all leaves. That is a polynomial of degree up to 3 p - 1 in u
/// if the degree is p, so the rule is exact up to degree 3 without weights, and close for small leaves else.
pub fn enclosed_volume(leaves: &[SurfacePatch]) -> f64 {
    let places = GAUSS
        .iter()
        .flat_map(|u| GAUSS.iter().map(move |v| ([u[0], v[0]], u[1] * v[1])));
    let of = |leaf: &SurfacePatch| -> f64 {
        let parts = places.clone().map(|(place, weight)| {
            let [s, du, dv] = leaf.derivatives(place);
            weight * s.dot(du.cross(dv)) / 3.0
        });
        parts.sum()
    };
    leaves.iter().map(of).sum()
}
