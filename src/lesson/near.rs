//! How near a student's answer must be to the tracer's.

use crate::trace::field::FieldValue;

/// A student uses a calculator: within one percent, and no better than this.
const RELATIVE: f64 = 0.01;
const ABSOLUTE: f64 = 0.0005;

/// Whether an answer is near enough.
pub fn is_near(given: &FieldValue, answer: &FieldValue, tolerance: Option<f64>) -> bool {
    if let (FieldValue::Word(a), FieldValue::Word(b)) = (given, answer) {
        return a.eq_ignore_ascii_case(b);
    }
    let (a, b) = (given.numbers(), answer.numbers());
    let length = b.iter().map(|x| x * x).sum::<f64>().sqrt();
    let allowed = tolerance.unwrap_or((RELATIVE * length).max(ABSOLUTE));
    !b.is_empty() && a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= allowed)
}
