//! Laws of single rays: directions, hits and shadows.

use serde_json::Value;

use super::Met;
use super::vectors::{TOLERANCE, V, close, combine, cross, dot, length, number, vector};

/// R mirrors I at N; T obeys Snell's law and stays in the plane of I and N; L starts towards its light's side.
pub fn check_direction(node: &Value, parent: &Value, kind: &str, direction: V, met: &mut Met) {
    let i = vector(&parent["direction"]);
    let n = vector(&parent["hit"]["normal"]);
    match kind {
        "R" => {
            let mirrored = combine(i, n, |i, n| {
                i - 2.0
                    * dot(
                        vector(&parent["direction"]),
                        vector(&parent["hit"]["normal"]),
                    )
                    * n
            });
            assert!(close(direction, mirrored, TOLERANCE), "R = I - 2 (N.I) N");
            assert_eq!(
                node["medium"], parent["medium"],
                "a reflected ray stays in its medium"
            );
        }
        "T" => {
            let boundary = &parent["boundary"];
            let (n1, n2) = (number(&boundary["n1"]), number(&boundary["n2"]));
            assert_eq!((n1, n2), (number(&parent["ior"]), number(&node["ior"])));
            let (sin_i, sin_t) = (length(cross(n, i)), length(cross(n, direction)));
            assert!(
                (n1 * sin_i - n2 * sin_t).abs() <= TOLERANCE,
                "n1 sin I = n2 sin T"
            );
            assert!(
                dot(direction, cross(n, i)).abs() <= TOLERANCE,
                "T in the plane of I and N"
            );
            assert!(dot(direction, n) < 0.0, "T goes through");
            met.one(if n1 < n2 {
                "into the denser"
            } else {
                "into the thinner"
            });
        }
        "L" => assert!(dot(direction, n) > 0.0, "the light is before the surface"),
        _ => panic!("a ray of kind {kind} has no parent"),
    }
}

pub fn check_hit(node: &Value, hit: &Value, direction: V) {
    let t = number(&hit["t"]);
    assert!(t > number(&node["t_min"]));
    let there = combine(vector(&node["origin"]), direction, |o, d| o + t * d);
    assert!(
        close(there, vector(&hit["point"]), 1e-11 * (1.0 + t)),
        "point = o + t d"
    );
    for normal in [&hit["normal"], &hit["geometric_normal"]] {
        assert!((length(vector(normal)) - 1.0).abs() <= TOLERANCE);
        assert!(
            dot(vector(normal), direction) <= 0.0,
            "normals face the ray"
        );
    }
    if let Some(weights) = hit.get("barycentric") {
        assert!((vector(weights).iter().sum::<f64>() - 1.0).abs() <= 1e-12);
    }
}

pub fn check_shadow_ray(node: &Value, met: &mut Met) {
    let outcome = node["outcome"].as_str().expect("an outcome");
    met.one(outcome);
    assert!(node["light"].is_string());
    match outcome {
        "lit" => assert!(node.get("hit").is_none()),
        "blocked" => {
            let before = node["t_max"].as_f64().unwrap_or(f64::INFINITY);
            assert!(
                number(&node["hit"]["t"]) < before,
                "the blocker stands before the light"
            );
        }
        other => panic!("an L ray is lit or blocked, not {other}"),
    }
}
