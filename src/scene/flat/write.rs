//! A flat scene as JSON: a material, a light and an object a line.

use std::io::{self, Write};

use serde::Serialize;

use super::{head, objects};
use crate::scene::Scene;
use crate::scene::printable::is_printable;

/// Writes a scene in the format `raytree-flat/1`.
pub fn write_json(out: &mut dyn Write, scene: &Scene) -> io::Result<()> {
    let head = head(scene);
    writeln!(out, "{{")?;
    field(out, "format", &head.format)?;
    field(out, "name", &head.name)?;
    field(out, "settings", &head.settings)?;
    field(out, "background", &head.background)?;
    field(out, "ambient", &head.ambient)?;
    field(out, "camera", &head.camera)?;
    list(out, "materials", head.materials)?;
    writeln!(out, ",")?;
    list(out, "lights", head.lights)?;
    writeln!(out, ",")?;
    list(out, "objects", objects(scene))?;
    writeln!(out, "\n}}")
}

fn field(out: &mut dyn Write, name: &str, value: &impl Serialize) -> io::Result<()> {
    writeln!(out, "  \"{name}\": {},", line(value)?)
}

/// An item a line.
fn list<T: Serialize>(
    out: &mut dyn Write,
    name: &str,
    items: impl IntoIterator<Item = T>,
) -> io::Result<()> {
    write!(out, "  \"{name}\": [")?;
    let mut before = "\n";
    for item in items {
        write!(out, "{before}    {}", line(&item)?)?;
        before = ",\n";
    }
    let end = if before == "\n" { "]" } else { "\n  ]" };
    write!(out, "{end}")
}

/// A value on one line. What cannot be seen, which stands in texts only, as `\u....`: harmless on a terminal.
pub fn line(value: &impl Serialize) -> io::Result<String> {
    let json = serde_json::to_string(value)?;
    if json.chars().all(is_printable) {
        return Ok(json);
    }
    let mut shown = String::with_capacity(json.len());
    for c in json.chars() {
        if is_printable(c) {
            shown.push(c);
        } else {
            let units = c.encode_utf16(&mut [0; 2]).to_vec();
            shown.extend(units.iter().map(|unit| format!("\\u{unit:04x}")));
        }
    }
    Ok(shown)
}
