//! Laws of terms: the products of their factors, and the means of bundles.

use serde_json::Value;

use super::Met;
use super::vectors::{TOLERANCE, close, combine, dot, length, list, number, vector};

/// Each term is the product of the factors that stand beside it.
pub fn check_term(node: &Value, term: &Value) {
    let value = vector(&term["value"]);
    let product = |colors: [&str; 2], scalar: f64| {
        combine(
            vector(&term[colors[0]]),
            vector(&term[colors[1]]),
            |a, b| a * b * scalar,
        )
    };
    let expected = match term["term"].as_str() {
        _ if term.get("corners").is_some() => blended(node, term),
        Some("ambient") => product(["ka", "ambient_light"], 1.0),
        Some("diffuse") => product(["kd", "intensity"], number(&term["n_dot_l"])),
        Some("specular") => {
            let (r_dot_v, n) = (number(&term["r_dot_v"]), number(&term["shininess"]));
            product(
                ["ks", "intensity"],
                if r_dot_v > 0.0 { r_dot_v.powf(n) } else { 0.0 },
            )
        }
        _ => return,
    };
    assert!(
        close(value, expected, 1e-12 * (1.0 + length(value))),
        "{term}"
    );
    // The cosines are those of the shadow ray to the same light.
    let Some(light) = term.get("light") else {
        return;
    };
    let shadow_ray = list(&node["children"])
        .iter()
        .find(|c| c["kind"] == "L" && &c["light"] == light && c.get("sample") == term.get("sample"))
        .expect("a lit term has its shadow ray");
    assert_eq!(shadow_ray["outcome"], "lit");
    if term.get("corners").is_some() {
        return;
    }
    if let Some(asked) = shadow_ray.get("light_point") {
        check_light_point(node, term, asked);
    }
    let (l, n) = (
        vector(&shadow_ray["direction"]),
        vector(&node["hit"]["normal"]),
    );
    let v = vector(&node["direction"]).map(|x| -x);
    if let Some(n_dot_l) = term["n_dot_l"].as_f64() {
        assert!((n_dot_l - dot(n, l)).abs() <= TOLERANCE);
    }
    if let Some(r_dot_v) = term["r_dot_v"].as_f64() {
        let r = combine(n, l, |n_k, l_k| 2.0 * dot(n, l) * n_k - l_k);
        assert!((r_dot_v - dot(r, v).max(0.0)).abs() <= TOLERANCE);
    }
}

/// The sum of what a term is at the corners of a triangle, each times the weight that the hit has there.
fn blended(node: &Value, term: &Value) -> [f64; 3] {
    let corners = list(&term["corners"]);
    let weights = list(&node["hit"]["barycentric"]);
    assert_eq!((corners.len(), weights.len()), (3, 3));
    let mut sum = [0.0; 3];
    for (corner, weight) in corners.iter().zip(weights) {
        assert_eq!(&corner["weight"], weight);
        let value = vector(&corner["value"]);
        if corner["n_dot_l"]
            .as_f64()
            .is_some_and(|cosine| cosine < 0.0)
        {
            assert_eq!(value, [0.0; 3], "{term}");
        }
        sum = combine(sum, value, |a, b| a + number(weight) * b);
    }
    sum
}

/// A bundle counts the rays to its light, and its mean is the sum of their terms.
pub fn check_bundles(node: &Value, met: &mut Met) {
    for bundle in node["bundles"].as_array().into_iter().flatten() {
        met.one("bundle");
        let rays = |outcome: &str| {
            let rays = list(&node["children"]).iter();
            rays.filter(|c| c["light"] == bundle["light"] && c["outcome"] == outcome)
                .count() as f64
        };
        assert_eq!(number(&bundle["lit"]), rays("lit"));
        assert_eq!(number(&bundle["blocked"]), rays("blocked"));
        assert!(rays("lit") + rays("blocked") <= number(&bundle["samples"]));
        let terms = list(&node["terms"]).iter();
        let sum = terms
            .filter(|t| t["light"] == bundle["light"])
            .fold([0.0; 3], |sum, t| {
                combine(sum, vector(&t["value"]), |a, b| a + b)
            });
        assert!(close(sum, vector(&bundle["mean"]), 1e-12));
        assert!(number(&bundle["standard_error"]) >= 0.0);
    }
}

/// What arrives from a point of an area light: I = Le A cos' / (pi r^2 N), and the point is where the distance says.
fn check_light_point(node: &Value, term: &Value, asked: &Value) {
    let (r, samples) = (number(&asked["distance"]), number(&asked["samples"]));
    let share = number(&asked["area"]) * number(&asked["cosine"])
        / (std::f64::consts::PI * r * r * samples);
    let arrives = vector(&asked["radiance"]).map(|le| le * share);
    let told = vector(&term["intensity"]);
    assert!(
        close(told, arrives, 1e-9 * (1.0 + length(told))),
        "{term} {asked}"
    );
    let way = combine(
        vector(&asked["point"]),
        vector(&node["hit"]["point"]),
        |a, b| a - b,
    );
    assert!((length(way) - r).abs() <= 1e-9 * (1.0 + r), "{asked}");
}
