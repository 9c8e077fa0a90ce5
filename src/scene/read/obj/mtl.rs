//! Materials of OBJ files: MTL.
//!
//! Source: the format's description by Alias Wavefront. Only what Whitted's model can show is read: colours,
//! highlight, opacity, index of refraction. Textures and other extensions are passed over.

use crate::math::Rgb;
use crate::scene::limits::{IOR, MAX_EXPONENT, MAX_RADIANCE};
use crate::scene::read::error::Problem;
use crate::shading::Material;

/// What one `newmtl` says.
#[derive(Clone, Debug)]
struct MtlEntry {
    name: String,
    ambient: Option<Rgb>,
    diffuse: Rgb,
    specular: Rgb,
    emission: Rgb,
    shininess: f64,
    ior: f64,
    opacity: f64,
    illum: u8,
}

/// Those materials of an MTL file that are `wanted` by their names, in their order, or the line of the first mistake,
/// from 1. Of two with one name the first counts.
pub fn parse<'a>(
    text: &'a str,
    mut wanted: impl FnMut(&str) -> bool,
) -> Result<Vec<Material>, (usize, Problem)> {
    let mut materials = Vec::new();
    let mut entry: Option<MtlEntry> = None;
    let mut finish = |entry: Option<MtlEntry>| {
        let wanted = entry.filter(|entry| wanted(&entry.name));
        materials.extend(wanted.map(MtlEntry::material));
    };
    for (line, mut words) in (1..).zip(text.lines().map(str::split_whitespace)) {
        let Some(key) = words.next() else { continue };
        let rest: Vec<&'a str> = words.collect();
        if key == "newmtl" {
            finish(entry.replace(MtlEntry::new(rest.join(" "))));
        } else {
            read_line(key, &rest, entry.as_mut()).map_err(|problem| (line, problem))?;
        }
    }
    finish(entry);
    Ok(materials)
}

/// A material of which nothing is said but its name.
pub fn matt_grey(name: &str) -> Material {
    MtlEntry::new(name.to_string()).material()
}

fn read_line(key: &str, rest: &[&str], entry: Option<&mut MtlEntry>) -> Result<(), Problem> {
    if !["Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "illum"].contains(&key) {
        return Ok(());
    }
    let Some(entry) = entry else {
        return Err(Problem::new(
            format!("`{key}` stands before any `newmtl`"),
            "begin each material with a line `newmtl name`",
        ));
    };
    match key {
        "Ka" => entry.ambient = Some(color(key, rest, MAX_RADIANCE)?),
        "Kd" => entry.diffuse = color(key, rest, MAX_RADIANCE)?,
        "Ks" => entry.specular = color(key, rest, MAX_RADIANCE)?,
        "Ke" => entry.emission = color(key, rest, MAX_RADIANCE)?,
        "Ns" => entry.shininess = number(key, rest, [0.0, MAX_EXPONENT])?,
        // Some exporters write 0 for "not said".
        "Ni" if rest.first() == Some(&"0") => {}
        "Ni" => entry.ior = number(key, rest, IOR)?,
        "d" => entry.opacity = number(key, rest, [0.0, 1.0])?,
        "Tr" => entry.opacity = 1.0 - number(key, rest, [0.0, 1.0])?,
        _ => entry.illum = number(key, rest, [0.0, 10.0])? as u8,
    }
    Ok(())
}

/// The three numbers of a colour.
fn color(key: &str, words: &[&str], max: f64) -> Result<Rgb, Problem> {
    if let Some(kind @ ("spectral" | "xyz")) = words.first().copied() {
        return Err(Problem::new(
            format!("`{key} {kind}` is not supported"),
            format!("write three numbers: `{key} red green blue`"),
        ));
    }
    let [r, g, b] = words else {
        return Err(Problem::new(
            format!("`{key}` needs three numbers and has {}", words.len()),
            format!("write `{key} red green blue`, such as `{key} 0.8 0.2 0.1`"),
        ));
    };
    let channel = |word: &str| number(key, &[word], [0.0, max]);
    Ok(Rgb::new(channel(r)?, channel(g)?, channel(b)?))
}

/// One number between two bounds.
fn number(key: &str, words: &[&str], [min, max]: [f64; 2]) -> Result<f64, Problem> {
    let Some(word) = words.first() else {
        return Err(Problem::new(
            format!("`{key}` has no number"),
            format!("write a number after `{key}`, or take the line away"),
        ));
    };
    match word.parse::<f64>() {
        Ok(value) if (min..=max).contains(&value) => Ok(value),
        Ok(_) => Err(Problem::new(
            format!("`{key}` is {word}"),
            format!("write a number from {min} to {max}"),
        )),
        Err(_) => Err(Problem::new(
            format!("`{key}` has `{word}`, which is not a number"),
            format!("write a number from {min} to {max}, with a decimal point"),
        )),
    }
}

impl MtlEntry {
    fn new(name: String) -> Self {
        Self {
            name,
            ambient: None,
            diffuse: Rgb::grey(0.6),
            specular: Rgb::BLACK,
            emission: Rgb::BLACK,
            shininess: 32.0,
            ior: 1.0,
            opacity: 1.0,
            illum: 2,
        }
    }

    /// In Whitted's terms: highlights from model 2 on, mirror rays by Ks from model 3 on, and what is not opaque lets
    /// rays through.
    fn material(self) -> Material {
        let mirrors = matches!(self.illum, 3..=8);
        let capped = |c: Rgb, max: f64| c.map(|x| x.min(max));
        Material {
            name: self.name,
            ambient: self.ambient.unwrap_or(self.diffuse) * self.opacity,
            diffuse: self.diffuse * self.opacity,
            specular: if self.illum >= 2 {
                self.specular
            } else {
                Rgb::BLACK
            },
            shininess: self.shininess,
            mirror: if mirrors {
                capped(self.specular, 1.0)
            } else {
                Rgb::BLACK
            },
            transmission: Rgb::grey(1.0 - self.opacity),
            ior: self.ior,
            priority: 0,
            emission: self.emission,
            checker: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_material_is_read_and_unknown_lines_are_passed_over() {
        let text = "# a comment\r\nnewmtl red glass\r\nKd 1 0 0\r\nKs 2 0.5 0\nd 0.25\nNi 1.5\nillum 4\nmap_Kd x.png\n";
        let materials = parse(text, |_| true).expect("a good file");
        let [glass] = &materials[..] else {
            panic!("one material")
        };
        assert_eq!(glass.name, "red glass");
        assert_eq!(glass.diffuse, Rgb::new(0.25, 0.0, 0.0));
        assert_eq!(glass.transmission, Rgb::grey(0.75));
        assert_eq!(glass.mirror, Rgb::new(1.0, 0.5, 0.0));
        assert_eq!(glass.ior, 1.5);
    }

    #[test]
    fn each_mistake_names_its_line() {
        for (text, line) in [
            ("newmtl a\nKd", 2),
            ("newmtl a\nKd 1", 2),
            ("newmtl a\n\nKd 1 2", 3),
            ("newmtl a\nKd 1 2 x", 2),
            ("newmtl a\nKs nan 0 0", 2),
            ("newmtl a\nd 7", 2),
            ("newmtl a\nNs", 2),
            ("newmtl a\nNi -1", 2),
            ("Kd 1 1 1", 1),
        ] {
            assert_eq!(
                parse(text, |_| true).err().map(|e| e.0),
                Some(line),
                "{text:?}"
            );
        }
        assert_eq!(parse("", |_| true).map(|m| m.len()), Ok(0));
    }
}
