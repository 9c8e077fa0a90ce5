//! Values of facts in what a user reads, and in JSON. What a student wrote is shown escaped and short.

use serde_json::{Value, json};

use crate::math::Rgb;
use crate::scene::printable::printable;
use crate::trace::facts::Fact;
use crate::trace::format::counted;

/// Characters of a student's text that are shown.
const SHOWN: usize = 200;

/// A text of a student: without control characters, and cut.
pub fn shown(text: &str) -> String {
    let cut: String = text.chars().take(SHOWN).collect();
    printable(&cut).into_owned()
}

/// A value in a line of text.
pub fn text(fact: &Fact) -> String {
    let numbers = |all: &[f64]| {
        let all: Vec<String> = all.iter().map(|x| number(*x)).collect();
        format!("({})", all.join(", "))
    };
    match fact {
        Fact::Number(x) => number(*x),
        Fact::Vector(v) => numbers(v),
        Fact::Pair(p) => numbers(p),
        Fact::Color(c) => numbers(&c.channels()),
        Fact::Word(word) => shown(word),
        Fact::Steps(steps) => counted(steps.len() as u64, "step"),
        Fact::Nothing => "no number".to_owned(),
    }
}

/// A number with five digits behind the point; very small and very large ones with an exponent.
pub fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 || (1e-3..1e6).contains(&size) {
        let text = format!("{x:.5}");
        if text == "-0.00000" {
            "0.00000".to_owned()
        } else {
            text
        }
    } else {
        format!("{x:.4e}")
    }
}

/// A value in JSON; NaN and infinity are null.
pub fn json_value(fact: &Fact) -> Value {
    match fact {
        Fact::Number(x) => json!(x),
        Fact::Vector(v) => json!(v),
        Fact::Pair(p) => json!(p),
        Fact::Color(Rgb { r, g, b }) => json!([r, g, b]),
        Fact::Word(word) => json!(shown(word)),
        Fact::Steps(steps) => json!(steps.iter().map(|step| shown(step)).collect::<Vec<_>>()),
        Fact::Nothing => Value::Null,
    }
}

/// Points as people read them: `2.75`.
pub fn points(thousandths: u64) -> String {
    let text = format!("{}.{:03}", thousandths / 1000, thousandths % 1000);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
