//! Numbers of a change: set, or computed from what is there; and how they are written.

use serde_json::{Map, Number, Value};

use crate::scene::read::error::Problem;

/// How a value is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    Set,
    Add,
    Multiply,
}

impl Operation {
    /// The new value. `+=` and `*=` take a number and a number, or a list of numbers and a number or a list of as many.
    pub fn apply(self, now: Option<&Value>, by: &Value) -> Result<Value, Problem> {
        match (self, now, by) {
            (Self::Set, ..) => Ok(by.clone()),
            (_, Some(Value::Number(now)), Value::Number(by)) => self.computed(now, by),
            (_, Some(Value::Array(list)), Value::Number(_)) => {
                let each = list.iter().map(|now| self.apply(Some(now), by));
                each.collect::<Result<_, _>>().map(Value::Array)
            }
            (_, Some(Value::Array(list)), Value::Array(by)) if list.len() == by.len() => {
                let pairs = list.iter().zip(by);
                let each = pairs.map(|(now, by)| self.apply(Some(now), by));
                each.collect::<Result<_, _>>().map(Value::Array)
            }
            _ => Err(Problem::new(
                "there is no number here that += and *= could change",
                "write = and the new value, or check the spelling",
            )),
        }
    }

    fn computed(self, now: &Number, by: &Number) -> Result<Value, Problem> {
        let (Some(now), Some(by)) = (now.as_f64(), by.as_f64()) else {
            return Err(too_large());
        };
        let sum = match self {
            Self::Set => by,
            Self::Add => now + by,
            Self::Multiply => now * by,
        };
        Number::from_f64(sum)
            .map(Value::Number)
            .ok_or_else(too_large)
    }
}

fn too_large() -> Problem {
    Problem::new("the number becomes too large", "write = and the new value")
}

/// A value on one line, its numbers as people write them: whole ones without a point.
pub fn written(value: &Value) -> String {
    match value {
        Value::Number(number) => match number.as_f64() {
            Some(x) if x.fract() == 0.0 && x.abs() < 1e15 => format!("{x:.0}"),
            _ => number.to_string(),
        },
        Value::Array(list) => {
            let items: Vec<String> = list.iter().map(written).collect();
            format!("[{}]", items.join(","))
        }
        Value::Object(fields) => {
            let field = |(name, value): (&String, &Value)| {
                format!("{}:{}", Value::from(name.as_str()), written(value))
            };
            let fields: Vec<String> = fields.iter().map(field).collect();
            format!("{{{}}}", fields.join(","))
        }
        other => other.to_string(),
    }
}

/// An object with a field a line, each value on one line.
pub fn lines(fields: &Map<String, Value>, depth: usize) -> String {
    if fields.is_empty() {
        return "{}".to_owned();
    }
    let indent = "  ".repeat(depth + 1);
    let line = |(name, value): (&String, &Value)| {
        let value = match value {
            Value::Object(inner) => lines(inner, depth + 1),
            other => written(other),
        };
        format!("{indent}{}: {value}", Value::from(name.as_str()))
    };
    let all: Vec<String> = fields.iter().map(line).collect();
    format!("{{\n{}\n{}}}", all.join(",\n"), "  ".repeat(depth))
}
