//! A difference as text for the terminal, and as JSON.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{Cause, TreeDiff};
use crate::grade::compare::Compared;
use crate::grade::quantity::{QuantityKind, field};
use crate::grade::value::{json_value, shown, text};
use crate::math::DVec3;
use crate::scene::Bend;
use crate::trace::facts::Fact;

/// Places of a cause, and consequences, that are named.
const NAMED: usize = 5;

/// What the two sides are called, and how they are opened.
#[derive(Clone, Copy)]
pub struct Sides<'a> {
    /// The name of the scene.
    pub scene: &'a str,
    /// The pixel.
    pub pixel: (u32, u32),
    /// How A is named.
    pub a: &'a str,
    /// How B is named.
    pub b: &'a str,
    /// The command that opens our tree at a ray.
    pub open: &'a dyn Fn(&Compared) -> String,
}

impl TreeDiff {
    /// For the terminal, with at most so many causes.
    pub fn to_text(&self, sides: Sides, most: usize) -> String {
        let (x, y) = sides.pixel;
        let mut out = format!("{}, pixel ({x}, {y}): ", sides.scene);
        let consequences: usize = self
            .causes
            .iter()
            .map(|cause| cause.consequences.len())
            .sum();
        let mut parts = Vec::new();
        if !self.causes.is_empty() {
            parts.push(count(self.causes.len(), "cause"));
        }
        let counts = [
            (consequences, "consequence"),
            (self.missing.len(), "quantity not told"),
            (self.extra.len(), "ray too many"),
        ];
        parts.extend(
            counts
                .iter()
                .filter(|(n, _)| *n > 0)
                .map(|(n, what)| count(*n, what)),
        );
        let before = if parts.is_empty() {
            String::new()
        } else {
            parts.join(", ") + "; "
        };
        let _ = writeln!(out, "{before}{} of {} agree", self.agree, self.asked);
        for (index, cause) in self.causes.iter().take(most).enumerate() {
            cause_text(&mut out, index + 1, cause, sides);
        }
        if self.causes.len() > most {
            let _ = writeln!(out, "{} more", count(self.causes.len() - most, "cause"));
        }
        list(
            &mut out,
            "not told",
            self.missing
                .iter()
                .map(|(path, name)| format!("{path}.{}", field(name))),
        );
        list(
            &mut out,
            "too many",
            self.extra.iter().map(|path| shown(&path.to_string())),
        );
        out
    }

    /// As JSON, `raytree-diff/1`.
    pub fn to_json(&self, sides: Sides) -> Value {
        let (x, y) = sides.pixel;
        let causes: Vec<Value> = self
            .causes
            .iter()
            .map(|cause| cause_json(cause, sides))
            .collect();
        let missing = self
            .missing
            .iter()
            .map(|(path, name)| format!("{x},{y}{path}.{}", field(name)));
        let extra = self
            .extra
            .iter()
            .map(|path| shown(&format!("{x},{y}{path}")));
        json!({
            "format": "raytree-diff/1",
            "a": sides.a,
            "b": sides.b,
            "agree": self.agree,
            "asked": self.asked,
            "causes": causes,
            "missing": missing.collect::<Vec<_>>(),
            "extra": extra.collect::<Vec<_>>(),
        })
    }
}

fn cause_text(out: &mut String, number: usize, cause: &Cause, sides: Sides) {
    let first = &cause.first;
    let at = if first.path.steps.is_empty() {
        "eye ray".to_owned()
    } else {
        first.path.to_string()
    };
    let _ = writeln!(
        out,
        "{number}. {at} {}: {}",
        field(&first.name),
        broken(first)
    );
    let _ = writeln!(out, "     ours      {}", side(first.quantity, &first.ours));
    if let Some(theirs) = &first.theirs {
        let off = first.off().map_or(String::new(), |(off, unit)| match unit {
            "degree" => format!("    {off:.2} degrees off"),
            "metre" => format!("    {} m off", crate::grade::value::number(off)),
            _ => String::new(),
        });
        let _ = writeln!(out, "     theirs    {}{off}", side(first.quantity, theirs));
    }
    if let Some(bend) = cause.as_if.first() {
        let entry = bend.entry();
        let others: Vec<&str> = cause.as_if[1..].iter().map(|bend| bend.name()).collect();
        let or = if others.is_empty() {
            String::new()
        } else {
            format!(" (or {})", others.join(", "))
        };
        let _ = writeln!(
            out,
            "     as if     {}: {} [{}]{or}",
            bend.name(),
            entry.note,
            entry.formula
        );
    }
    if !cause.also.is_empty() {
        let places: Vec<String> = cause.also.iter().take(NAMED).map(place).collect();
        let more = cause.also.len().saturating_sub(NAMED);
        let more = if more > 0 {
            format!(" and {more} more")
        } else {
            String::new()
        };
        let _ = writeln!(out, "     also at   {}{more}", places.join(", "));
    }
    if !cause.consequences.is_empty() {
        let named = cause
            .consequences
            .iter()
            .take(NAMED)
            .map(|c| match &c.theirs {
                Some(theirs) if matches!(theirs, Fact::Number(_)) => {
                    format!("{} {} -> {}", place(c), text(&c.ours), text(theirs))
                }
                _ => place(c),
            });
        let named: Vec<String> = named.collect();
        let more = if cause.consequences.len() > NAMED {
            ", ..."
        } else {
            ""
        };
        let what = count(cause.consequences.len(), "consequence");
        let _ = writeln!(out, "     {what}: {}{more}", named.join(", "));
    }
    let _ = writeln!(out, "     {}", (sides.open)(first));
}

/// A value, or of a length that.
fn side(quantity: QuantityKind, fact: &Fact) -> String {
    match (quantity, fact) {
        (QuantityKind::Unit, Fact::Vector(v)) => {
            format!(
                "{}    length {:.5}",
                text(fact),
                DVec3::from_array(*v).length()
            )
        }
        _ => text(fact),
    }
}

/// Which law is broken, in words.
fn broken(compared: &Compared) -> String {
    if compared.quantity == QuantityKind::Unit {
        return "not unit".to_owned();
    }
    format!(
        "does not follow from what is before it (law {})",
        compared.law
    )
}

fn place(compared: &Compared) -> String {
    shown(&format!("{} {}", compared.path, field(&compared.name)))
        .trim_start()
        .to_owned()
}

fn list(out: &mut String, what: &str, items: impl ExactSizeIterator<Item = String>) {
    let total = items.len();
    if total > 0 {
        let named: Vec<String> = items.take(NAMED).map(|item| shown(&item)).collect();
        let more = if total > NAMED { ", ..." } else { "" };
        let _ = writeln!(out, "{total} {what}: {}{more}", named.join(", "));
    }
}

fn cause_json(cause: &Cause, sides: Sides) -> Value {
    let address = |compared: &Compared| shown(&compared.address(sides.pixel));
    let first = &cause.first;
    let (off, unit) = first.off().unzip();
    json!({
        "address": address(first),
        "quantity": first.quantity.name(),
        "a": json_value(&first.ours),
        "b": first.theirs.as_ref().map_or(Value::Null, json_value),
        "off": off,
        "unit": unit.filter(|unit| !unit.is_empty()),
        "law": first.law.name(),
        "as_if": cause.as_if.iter().map(|bend: &Bend| bend.name()).collect::<Vec<_>>(),
        "also_at": cause.also.iter().map(address).collect::<Vec<_>>(),
        "consequences": cause.consequences.iter().map(address).collect::<Vec<_>>(),
    })
}

/// "1 cause", "2 causes".
fn count(n: usize, what: &str) -> String {
    match (n, what) {
        (1, what) => format!("1 {what}"),
        (n, "quantity not told") => format!("{n} quantities not told"),
        (n, "ray too many") => format!("{n} rays too many"),
        (n, what) => format!("{n} {what}s"),
    }
}
