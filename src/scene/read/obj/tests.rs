//! Cutting polygons into triangles.

use crate::math::DVec3;
use crate::scene::read::cut::triangulate;

fn area(corners: &[DVec3], triangles: &[[usize; 3]]) -> f64 {
    let double = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|i| corners[i]);
        (b - a).cross(c - a).length()
    };
    triangles.iter().map(double).sum::<f64>() / 2.0
}

#[test]
fn a_square_becomes_a_fan() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::ONE, DVec3::Y + DVec3::Z];
    assert_eq!(triangulate(&square), (vec![[0, 1, 2], [0, 2, 3]], None));
}

#[test]
fn a_concave_polygon_is_covered_once() {
    // An arrow head that points left, from each of its corners: a fan covers too much from some of them.
    let arrow =
        [[0.0, 0.0], [2.0, -1.0], [1.0, 0.0], [2.0, 1.0]].map(|[x, y]| DVec3::new(x, 5.0, -y));
    for turn in 0..4 {
        let mut corners = arrow;
        corners.rotate_left(turn);
        let (triangles, guess) = triangulate(&corners);
        assert_eq!(guess, None);
        assert_eq!(triangles.len(), 2);
        assert!(
            (area(&corners, &triangles) - 1.0).abs() < 1e-12,
            "{turn}: {triangles:?}"
        );
    }
}

#[test]
fn triangles_run_as_the_polygon_does() {
    // A spiral of 1000 corners that is one wide, both ways around.
    let corner = |i: i32| {
        let (k, wide) = if i < 500 { (i, 1.0) } else { (999 - i, 0.9) };
        let angle = f64::from(k) * 0.2;
        wide * (1.0 + angle) * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle))
    };
    let mut corners: Vec<DVec3> = (0..1000).map(corner).collect();
    for _ in 0..2 {
        let (triangles, guess) = triangulate(&corners);
        assert_eq!((triangles.len(), guess), (998, None));
        let cross =
            |[a, b, c]: &[usize; 3]| (corners[*b] - corners[*a]).cross(corners[*c] - corners[*a]);
        let whole: DVec3 = (2..1000).map(|i| cross(&[0, i - 1, i])).sum();
        assert!(triangles.iter().all(|t| cross(t).y * whole.y > 0.0));
        corners.reverse();
    }
}

#[test]
fn what_is_no_polygon_ends_all_the_same() {
    assert!(triangulate(&[]).0.is_empty());
    assert!(triangulate(&[DVec3::ZERO, DVec3::X]).0.is_empty());
    assert_eq!(triangulate(&[DVec3::ONE; 5]).0.len(), 3);
    let bow = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y];
    assert_eq!(triangulate(&bow).1, Some("crosses itself"));
}

#[test]
fn a_twisted_face_keeps_all_its_triangles() {
    // Two corners up and two down. Seen from above, its first side and its third cross.
    let twisted = [
        [0.0, 0.0, 0.0],
        [2.0, 0.5, 1.0],
        [1.0, 0.0, 0.0],
        [2.2, 0.5, 3.0],
    ];
    let mut corners = twisted.map(DVec3::from_array);
    for _ in 0..4 {
        let (triangles, guess) = triangulate(&corners);
        assert_eq!((triangles.len(), guess), (2, Some("is twisted")));
        assert!(
            (0..4).all(|i| triangles.iter().any(|t| t.contains(&i))),
            "{triangles:?}"
        );
        // Of the two diagonals, that where the triangles bend less.
        let normal = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| corners[i]);
            (b - a).cross(c - a).normalize()
        };
        let cosine = |s: &[usize; 3], t: &[usize; 3]| normal(s).dot(normal(t));
        let taken = cosine(&triangles[0], &triangles[1]);
        let others = [
            cosine(&[0, 1, 2], &[0, 2, 3]),
            cosine(&[1, 2, 3], &[1, 3, 0]),
        ];
        assert_eq!(taken, others[0].max(others[1]));
        assert_ne!(others[0], others[1]);
        corners.rotate_left(1);
    }
}

#[test]
fn a_flat_face_comes_from_earcut_although_it_is_turned_and_rounded() {
    // Letters as exporters write them: turned, and with six digits.
    let (u, v) = (DVec3::new(0.6, 0.48, 0.64), DVec3::new(0.0, 0.8, -0.6));
    let rounded = |[x, y]: [f64; 2]| ((x * u + y * v) * 1e6).round() / 1e6;
    // An L with a corner in the middle of its foot, and one twice.
    let l = [
        [1.0, 3.0],
        [0.0, 3.0],
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [2.0, 1.0],
        [1.0, 1.0],
    ];
    let l = l.map(rounded);
    let (triangles, guess) = triangulate(&l);
    assert_eq!(guess, None);
    assert!((area(&l, &triangles) - 4.0).abs() < 1e-5, "{triangles:?}");
    // A bow: its larger half alone, not a fan that covers both.
    let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 1.0]].map(rounded);
    let (triangles, guess) = triangulate(&bow);
    assert_eq!(guess, Some("crosses itself"));
    assert_eq!(triangles.len(), 1, "{triangles:?}");
}
