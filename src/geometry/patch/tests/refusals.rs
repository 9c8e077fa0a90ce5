//! What is refused, in words that say why; and knots that are allowed.

use super::*;

fn nurbs() -> NurbsSurface {
    super::geomdl::surface()
}

fn refused(change: impl Fn(&mut NurbsSurface), words: &str) {
    let mut surface = nurbs();
    change(&mut surface);
    let error = surface.leaves().err().unwrap_or_default();
    assert!(error.contains(words), "{error:?} does not say {words:?}");
}

#[test]
fn what_is_wrong_is_told() {
    refused(|s| s.degree = [6, 2], "each must be 1 to 5");
    refused(|s| s.degree = [0, 2], "each must be 1 to 5");
    refused(|s| s.knots[0][5] = 0.1, "fall from 0.3 to 0.1: sort them");
    refused(|s| s.knots[0][5] = f64::NAN, "not a finite number");
    refused(
        |s| _ = s.knots[1].pop(),
        "5 points of degree 2 take 5 + 2 + 1 = 8",
    );
    refused(|s| s.knots[1] = vec![1.0; 8], "leave nothing between");
    let torn = [0.0, 0.0, 0.5, 0.5, 1.0, 1.5, 1.5];
    refused(
        |s| (s.degree, s.knots[1]) = ([3, 1], torn.to_vec()),
        "knot 0.5 along v repeats more than 1 times, which tears",
    );
    refused(
        |s| _ = s.points[2].pop(),
        "row 2 has 5 points and row 0 has 6",
    );
    refused(|s| s.points.clear(), "there are no points");
    refused(|s| s.points.truncate(2), "give 2 rows of 6 weights");
    refused(|s| s.points[1][1].x = f64::INFINITY, "not finite");
    refused(
        |s| s.weights.as_mut().expect("it has some")[0][0] = 0.0,
        "the weight 0 must be a finite number above 0",
    );
    refused(
        |s| s.weights.as_mut().expect("it has some")[0][0] = -1.0,
        "above 0",
    );
    refused(
        |s| (s.weights, s.degree) = (None, [3, 5]),
        "degree 5 along v takes at least 6 points",
    );
    let bezier = BezierSurface {
        degree: [3, 2],
        patches: vec![nurbs().points],
        weights: None,
        ranges: None,
    };
    assert!(
        bezier
            .leaves()
            .expect_err("wrong size")
            .contains("patch 0: it has 5 rows of 6 points; degree [3, 2] takes 3 rows of 4")
    );
}

#[test]
fn a_surface_whose_knots_go_on_beyond_its_ends_closes_to_the_bit() {
    // A periodic cubic B-spline around the y axis: 7 points and the first three again, knots 0 to 13, which live from 3 to 10.
    let ring = |y: f64, r: f64| -> Vec<DVec3> {
        (0..10)
            .map(|i| {
                let (s, c) = libm::sincos(std::f64::consts::TAU * f64::from(i % 7) / 7.0);
                DVec3::new(r * c, y, -r * s)
            })
            .collect()
    };
    let surface = NurbsSurface {
        degree: [3, 1],
        knots: [
            (0..14).map(f64::from).collect(),
            vec![0.0, 0.0, 1.0, 2.0, 3.0, 3.0],
        ],
        points: vec![
            ring(-1.0, 0.0),
            ring(-1.0, 1.0),
            ring(1.0, 1.0),
            ring(1.0, 0.0),
        ],
        weights: None,
    };
    let leaves = surface.leaves().expect("a good surface");
    assert_eq!(open_edges(&leaves), 0);
    assert!(super::seams::evenly(&leaves, 300, 5) > 100);
    let ranges = leaves.iter().map(SurfacePatch::range);
    let area: f64 = ranges
        .map(|[low, high]| (high[0] - low[0]) * (high[1] - low[1]))
        .sum();
    assert!((area - 1.0).abs() < 1e-12);
}
