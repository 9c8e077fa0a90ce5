//! Materials of OBJ files: MTL.
//!
//! Source: the format's description by Alias Wavefront. Only what Whitted's model can show is read: colours,
//! highlight, opacity, index of refraction. The crate `tobj` reads the numbers, which are checked and mended before.

use std::fmt::Write;

use crate::math::Rgb;
use crate::scene::limits::{IOR, MAX_EXPONENT, MAX_RADIANCE};
use crate::scene::read::notes::Notes;
use crate::scene::read::text::{Lines, name, number, words};
use crate::scene::warning::WarningCode;
use crate::shading::Material;

/// What one `newmtl` says.
#[derive(Clone, Debug, Default)]
struct MtlEntry {
    name: String,
    line: usize,
    /// The lines for `tobj`.
    text: String,
    /// `d`, and 1 - `Tr`: it has no `Tr`.
    opacity: [Option<f64>; 2],
    /// `Tf`, which it does not read.
    filter: Option<Rgb>,
}

/// Those materials of an MTL file that are `wanted` by their names, in their order. Of two with one name the first counts.
pub fn parse(text: &str, mut wanted: impl FnMut(&str) -> bool, notes: &mut Notes) -> Vec<Material> {
    let mut materials = Vec::new();
    let (mut entry, mut is_first): (Option<MtlEntry>, bool) = (None, true);
    for (number, line) in Lines::new(text) {
        let mut words = words(&line);
        let Some(key) = words.next() else { continue };
        if key == "newmtl" {
            materials.extend(entry.take().map(|entry| entry.material(notes)));
            let name = name(&line);
            is_first = false;
            entry = wanted(&name).then(|| MtlEntry {
                name,
                line: number,
                text: "newmtl it\n".to_owned(),
                ..MtlEntry::default()
            });
        } else if let Some(entry) = &mut entry {
            let note = |code, about: &str| notes.add(code, about, number);
            entry.read(key, &words.collect::<Vec<_>>(), note);
        } else if is_first {
            notes.add(WarningCode::LeftOut, key, number);
        }
    }
    materials.extend(entry.map(|entry| entry.material(notes)));
    materials
}

/// A material of which nothing is said but its name.
pub fn matt_grey(name: &str) -> Material {
    let entry = MtlEntry {
        name: name.to_owned(),
        ..MtlEntry::default()
    };
    entry.material(&mut Notes::default())
}

impl MtlEntry {
    /// Reads a line; `note` is told what of it is not taken as it stands.
    fn read(&mut self, key: &str, words: &[&str], mut note: impl FnMut(WarningCode, &str)) {
        let (count, [min, max]) = match key {
            "Ka" | "Kd" | "Ks" | "Ke" => (3, [0.0, MAX_RADIANCE]),
            "Tf" => (3, [0.0, 1.0]),
            "d" | "Tr" => (1, [0.0, 1.0]),
            "Ns" => (1, [0.0, MAX_EXPONENT]),
            "Ni" => (1, IOR),
            "illum" => (1, [0.0, 10.0]),
            "bump" | "disp" | "decal" | "refl" | "norm" => return note(WarningCode::Texture, key),
            _ if key.starts_with("map_") => return note(WarningCode::Texture, key),
            _ => return note(WarningCode::LeftOut, key),
        };
        let option = usize::from(words.first() == Some(&"-halo"));
        let read = words.iter().skip(option).take(count);
        let read: Option<Vec<f64>> = read.map(|word| number(word, f64::MAX)).collect();
        let said = match read.as_deref() {
            // Green and blue equal red if they are not said.
            Some([all]) => [*all; 3],
            Some([r, g, b]) => [*r, *g, *b],
            _ => return note(WarningCode::UnreadLine, key),
        };
        let taken = option + read.map_or(0, |read| read.len());
        let values = said.map(|x| x.clamp(min, max));
        match (key, said[0]) {
            // Some exporters write 0 for "not said".
            ("Ni", 0.0) => return,
            ("Ni", ..0.0) => return note(WarningCode::UnreadLine, key),
            ("illum", x) if x != values[0] => return note(WarningCode::UnreadLine, key),
            _ if values != said => note(WarningCode::Clamped, key),
            _ => {}
        }
        if option > 0 || words.len() > taken {
            note(WarningCode::ExtraNumbers, key);
        }
        let [x, y, z] = values;
        // Writing to a string cannot fail.
        let _ = match key {
            "illum" => writeln!(self.text, "illum {}", x as u8),
            _ if count == 3 => writeln!(self.text, "{key} {x} {y} {z}"),
            _ => writeln!(self.text, "{key} {x}"),
        };
        match key {
            "d" => self.opacity[0] = Some(x),
            "Tr" => self.opacity[1] = Some(1.0 - x),
            "Tf" => self.filter = Some(values.into()),
            _ => {}
        }
    }

    /// In Whitted's terms: highlights from model 2 on, mirror rays by Ks from model 3 on, and what is not opaque lets
    /// rays through.
    fn material(self, notes: &mut Notes) -> Material {
        let read = tobj::load_mtl_buf(&mut self.text.as_bytes());
        let read = read
            .ok()
            .and_then(|(mut all, _)| all.pop())
            .unwrap_or_default();
        let color = |said: Option<[f64; 3]>| said.map(Rgb::from);
        let diffuse = color(read.diffuse).unwrap_or(Rgb::grey(0.6));
        let specular = color(read.specular).unwrap_or(Rgb::BLACK);
        let emission = color(read.emissive).unwrap_or(Rgb::BLACK);
        let illum = read.illumination_model.unwrap_or(2);
        let ior = read.optical_density.unwrap_or(1.0);
        let [opaque, transmission] = self.shares(illum, ior, notes);
        let shaded = if illum == 0 { Rgb::BLACK } else { diffuse };
        Material {
            ambient: color(read.ambient.filter(|_| illum > 0)).unwrap_or(shaded) * opaque,
            diffuse: shaded * opaque,
            specular: if illum >= 2 { specular } else { Rgb::BLACK },
            shininess: read.shininess.unwrap_or(32.0),
            mirror: match illum {
                // The share that a surface mirrors is that which does not enter it (Fresnel), and no other.
                7 if !transmission.is_black() => Rgb::BLACK,
                3..=8 => specular.map(|x| x.min(1.0)),
                _ => Rgb::BLACK,
            },
            transmission,
            ior,
            priority: 0,
            // Model 0 is a constant colour.
            emission: if illum == 0 {
                emission + diffuse * opaque
            } else {
                emission
            },
            checker: None,
            name: self.name,
        }
    }

    /// The share of what meets the surface that is shaded, and that which passes. `Tf` alone says what passes in the models
    /// with refraction, 6 and 7, and in those of glass, 4 and 9, if the index of refraction is one: Maya writes model 4 and
    /// `Tf 1 1 1` for what is opaque.
    fn shares(&self, illum: u8, ior: f64, notes: &mut Notes) -> [Rgb; 2] {
        let filter = self.filter.filter(|filter| !filter.is_black());
        let [d, from_tr] = self.opacity;
        if let (Some(d), Some(from_tr)) = (d, from_tr)
            && (d - from_tr).abs() > 1e-3
        {
            notes.add(WarningCode::OpacityConflict, &self.name, self.line);
        }
        let is_glass = matches!(illum, 4 | 6 | 7 | 9);
        let [opaque, passes] = match (d.or(from_tr), filter) {
            (None, Some(filter)) if is_glass && (ior != 1.0 || matches!(illum, 6 | 7)) => {
                [filter.map(|x| 1.0 - x), filter]
            }
            (said, filter) => {
                let opacity = said.unwrap_or(1.0);
                let filter = filter.unwrap_or(Rgb::WHITE);
                [Rgb::grey(opacity), filter * (1.0 - opacity)]
            }
        };
        if passes.is_black() && filter.is_some_and(|filter| filter != Rgb::WHITE) {
            notes.add(WarningCode::OpaqueFilter, &self.name, self.line);
        }
        if opaque.is_black() && !is_glass {
            notes.add(WarningCode::Invisible, &self.name, self.line);
        }
        [opaque, passes]
    }
}
