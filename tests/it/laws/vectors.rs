//! Vectors and numbers of a document.

use serde_json::Value;

pub type V = [f64; 3];

pub const TOLERANCE: f64 = 1e-12;

pub fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("a number, not {value}"))
}

pub fn vector(value: &Value) -> V {
    [0, 1, 2].map(|i| number(&value[i]))
}

pub fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V, b: V) -> V {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

pub fn combine(a: V, b: V, f: impl Fn(f64, f64) -> f64) -> V {
    [0, 1, 2].map(|i| f(a[i], b[i]))
}

pub fn close(a: V, b: V, tolerance: f64) -> bool {
    length(combine(a, b, |x, y| x - y)) <= tolerance
}
