//! Fields of a ray by name, as in `160,120/T.t`: what is asked, shown and printed of a recorded pixel.
//!
//! Names are those of the document in JSON ([`crate::trace::document`]), with short ones for what is asked most: `t`, `object`,
//! `point`, `normal` for `hit.t` and so on, `lit` for the outcome of an L ray, `distance` for its end. Behind a name stand parts:
//! `.x .y .z` of vectors, `.r .g .b` of colours, `[0]` of lists.

mod computed;
mod equations;

pub use computed::steps;
use serde_json::Value;

use super::View;
use super::address::{node_at, subtree};
use super::document::{self, RayNode};
use super::facts::TreePath;
use super::format::num;
use crate::scene::printable::excerpt;
use crate::scene::read::did_you_mean::did_you_mean;

/// Names that stand for a field of the hit point.
const OF_HIT: [&str; 13] = [
    "t",
    "point",
    "object",
    "primitive",
    "part",
    "barycentric",
    "uv",
    "gradient",
    "normal",
    "geometric_normal",
    "side",
    "material",
    "shading",
];

/// What a field holds.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
    /// A number.
    Number(f64),
    /// A vector or a colour.
    Numbers(Vec<f64>),
    /// A word, such as a name.
    Word(String),
}

/// A field of the ray at the end of a path; if there is none, in words what there is. Steps (`order`) are known if the pixel was
/// traced with them.
pub fn field(view: View, path: &TreePath, name: &str) -> Result<FieldValue, String> {
    let id = node_at(view, path)?;
    let (whole, parts) = parts(name)?;
    let value = match of_pixel(view, whole) {
        Some(value) => value,
        None => match computed::computed(view, id, whole) {
            Some(value) => value?,
            None => of_node(&node(view, path)?, whole)?,
        },
    };
    taken(value, &parts, name)
}

/// A name without the parts behind it, and these: x, y, z or r, g, b by their number, or indices.
fn parts(name: &str) -> Result<(&str, Vec<usize>), String> {
    let mut parts = Vec::new();
    let mut rest = name;
    loop {
        let letter = rest.rsplit_once('.').and_then(|(before, last)| {
            let index = ["x", "y", "z"].iter().position(|l| *l == last);
            let index = index.or_else(|| ["r", "g", "b"].iter().position(|l| *l == last));
            // b of a quadratic is no blue.
            Some((before, index?)).filter(|_| !equations::EQUATIONS.contains(&before))
        });
        let number = rest.strip_suffix(']').and_then(|rest| {
            let (before, digits) = rest.rsplit_once('[')?;
            Some((before, digits.parse().ok()?))
        });
        match letter.or(number) {
            Some((before, index)) => {
                parts.insert(0, index);
                rest = before;
            }
            None if rest.is_empty() => {
                return Err(format!("`{}` names no field", excerpt(name)));
            }
            None => return Ok((rest, parts)),
        }
    }
}

/// The part of a value that is asked.
fn taken(value: Value, parts: &[usize], name: &str) -> Result<FieldValue, String> {
    let mut value = value;
    for index in parts {
        let count = value.as_array().map(Vec::len);
        let part = value.get_mut(*index).map(Value::take);
        value = part.ok_or_else(|| {
            let name = excerpt(name);
            match count {
                Some(count) => format!("`{name}`: there are {count}, counted from 0"),
                None => format!("`{name}`: it has no parts"),
            }
        })?;
    }
    let not_one = |what: &str| Err(format!("`{}` is {what}; name a part of it", excerpt(name)));
    match value {
        Value::Number(number) => Ok(FieldValue::Number(number.as_f64().unwrap_or(f64::NAN))),
        Value::String(word) => Ok(FieldValue::Word(word)),
        Value::Bool(yes) => Ok(FieldValue::Word(if yes { "yes" } else { "no" }.to_owned())),
        Value::Null => Ok(FieldValue::Word("none".to_owned())),
        Value::Array(list) => {
            let numbers: Option<Vec<f64>> = list.iter().map(Value::as_f64).collect();
            match numbers {
                Some(numbers) => Ok(FieldValue::Numbers(numbers)),
                None => not_one("a list"),
            }
        }
        Value::Object(fields) => {
            let names: Vec<&str> = fields.keys().map(String::as_str).collect();
            not_one(&format!("a group of {}", names.join(", ")))
        }
    }
}

/// A field of the pixel.
fn of_pixel(view: View, name: &str) -> Option<Value> {
    let color = || document::of(view).color;
    match name {
        "color" => serde_json::to_value(color().linear).ok(),
        "srgb8" => serde_json::to_value(color().srgb8).ok(),
        "error" => {
            let error = view.trace.pixel.error;
            Some(if error.is_finite() {
                error.into()
            } else {
                Value::Null
            })
        }
        _ => None,
    }
}

/// The ray in the document.
fn node(view: View, path: &TreePath) -> Result<RayNode, String> {
    let document = subtree(document::of(view), path)?;
    let root = document.samples.into_iter().next().and_then(|s| s.root);
    root.ok_or_else(|| "the log was cut before this ray".to_owned())
}

/// A field of a ray of the document, by the names of its JSON.
fn of_node(node: &RayNode, name: &str) -> Result<Value, String> {
    let first = name.split(['.', ':']).next().unwrap_or(name);
    let long = if OF_HIT.contains(&first) {
        format!("hit.{name}")
    } else {
        name.replace("distance", "t_max")
    };
    let whole = serde_json::to_value(node).map_err(|e| e.to_string())?;
    let mut value = &whole;
    for key in long.split('.') {
        value = value.get(key).ok_or_else(|| no_field(value, key, name))?;
    }
    Ok(value.clone())
}

/// That there is no such field, and which there are.
fn no_field(value: &Value, key: &str, name: &str) -> String {
    let own: Vec<&str> = value.as_object().map_or(Vec::new(), |fields| {
        fields.keys().map(String::as_str).collect()
    });
    if OF_HIT.contains(&key) {
        return format!("what this ray met has no `{key}`");
    }
    let near = did_you_mean(key, own.iter().copied().chain(OF_HIT));
    let cure = match near {
        Some(near) => format!("; did you mean `{near}`?"),
        None if own.is_empty() => String::new(),
        None => format!("; there are {}", own.join(", ")),
    };
    format!("this ray has no field `{}`{cure}", excerpt(name))
}

impl FieldValue {
    /// The value in words, numbers with so many digits behind the point, or as the debugger shows them.
    pub fn text(&self, digits: Option<usize>) -> String {
        let number = |x: &f64| match digits {
            Some(digits) => format!("{x:.digits$}"),
            None => num(*x),
        };
        match self {
            Self::Number(x) => number(x),
            Self::Numbers(list) => {
                let all: Vec<String> = list.iter().map(number).collect();
                format!("({})", all.join(", "))
            }
            Self::Word(word) => word.clone(),
        }
    }

    /// The numbers in it; none of a word.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Number(x) => std::slice::from_ref(x),
            Self::Numbers(list) => list,
            Self::Word(_) => &[],
        }
    }
}

#[cfg(test)]
mod tests;
