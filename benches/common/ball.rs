//! A mesh of any number of triangles.

use raytree::geometry::Triangle;
use raytree::math::DVec3;

/// A ball with bumps of 4 rings^2 triangles.
pub fn bumpy_ball(rings: usize) -> Vec<Triangle> {
    triangles(rings).collect()
}

/// The same, one after the other.
pub fn triangles(rings: usize) -> impl Iterator<Item = Triangle> {
    let at = move |i: usize, j: usize| {
        let theta = std::f64::consts::PI * i as f64 / rings as f64;
        let phi = std::f64::consts::PI * (j % (2 * rings)) as f64 / rings as f64;
        let bump = 1.0 + 0.1 * libm::sin(9.0 * theta) * libm::sin(7.0 * phi);
        let (sin, cos) = (libm::sin(theta), libm::cos(theta));
        bump * DVec3::new(sin * libm::cos(phi), cos, sin * libm::sin(phi))
    };
    (0..rings)
        .flat_map(move |i| (0..2 * rings).map(move |j| (i, j)))
        .flat_map(move |(i, j)| {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            [[a, b, c], [a, c, d]].map(|corners| Triangle { corners })
        })
}
