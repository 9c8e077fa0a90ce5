//! Notes about a file: what is left out, guessed or clamped, once for each kind, with a count.

use std::borrow::Cow;

use super::error::Problem;
use super::text::{Decoded, Lines};
use crate::scene::limits::MAX_WARNINGS;
use crate::scene::warning::{WarningCode, Warnings};

/// Notes as they are made: what each is about, the line of the first, and their number.
#[derive(Debug, Default)]
pub struct Notes(Vec<(WarningCode, String, usize, u64)>);

impl Notes {
    /// Notes something about `about`, which stands on a line.
    pub fn add(&mut self, code: WarningCode, about: &str, line: usize) {
        let same =
            |note: &&mut (WarningCode, String, usize, u64)| note.0 == code && note.1 == about;
        if let Some(note) = self.0.iter_mut().find(same) {
            note.3 += 1;
        } else if self.0.len() < 2 * MAX_WARNINGS || about == "..." {
            self.0.push((code, about.to_owned(), line, 1));
        } else {
            // More kinds than are kept: one for all others.
            self.add(code, "...", line);
        }
    }

    /// Notes bytes of a file that are no text.
    pub fn encoding(&mut self, file: &Decoded) {
        let odd = |(number, line): (usize, Cow<str>)| {
            line.contains(char::REPLACEMENT_CHARACTER).then_some(number)
        };
        if file.replaced > 0 {
            let line = Lines::new(&file.text).find_map(odd).unwrap_or(1);
            let code = WarningCode::NotUtf8;
            self.0
                .push((code, "\u{fffd}".to_owned(), line, file.replaced));
        }
    }

    /// Makes warnings about the file of them.
    pub fn warn(self, file: &str, warnings: &mut Warnings) {
        for (code, about, line, count) in self.0 {
            let (what, cure) = text(code);
            let problem = Problem::new(what.replace("{}", &about), cure);
            warnings.add_many(code, problem.in_line(file, line), count);
        }
    }
}

/// What a note says, where `{}` is what it is about, and the cure.
fn text(code: WarningCode) -> (&'static str, &'static str) {
    use WarningCode as C;
    let text = match code {
        C::NotUtf8 => {
            "a byte is no UTF-8 text: it is shown as {}|save the file with the encoding UTF-8"
        }
        C::FewCorners => {
            "a face has fewer than three corners: it is left out|give each face at least three corners"
        }
        C::GuessedFace => {
            "a face {}: its triangles are a guess|cut it into triangles in the program that made it"
        }
        C::DanglingIndex => {
            "a corner names a `{}` that is not there: it has none|export the model again, with all lines `vt` and `vn`"
        }
        C::BadVertexData => {
            "`{}` has no usable numbers: it counts as missing|write finite numbers, and a direction that is not zero"
        }
        C::VertexColors => {
            "`{}` has a colour, which is not drawn|give the faces a material: `usemtl`, and `Kd` in an MTL file"
        }
        C::SmoothingGroup => {
            "`{}` asks for smooth faces, which need normals: they stay flat|export the model with normals (`vn`)"
        }
        C::LeftOut => {
            "`{}` is left out|describe by faces what should be seen, and materials by Ka, Kd, Ks, Ke, Ns, Ni, d and Tf"
        }
        C::NoMaterialName => {
            "`{}` names no material: the faces after it are grey|write `usemtl name`, or take the line away"
        }
        C::LibraryPath => {
            "`{}` leads elsewhere: the file of this name beside the model is read|write the name of the file alone"
        }
        C::MissingLibrary => {
            "{}: what it describes is grey|copy the file of materials into the folder of the model"
        }
        C::MissingMaterial => {
            "no MTL file describes the material `{}`: it is grey|describe it: `newmtl` and its name, then `Kd 0.8 0.2 0.1`"
        }
        C::UnreadLine => {
            "`{}` cannot be read: the line is left out|write three numbers for a colour and one for all else, such as 0.5"
        }
        C::Clamped => {
            "`{}` is out of its range: the nearest number is taken|write 0 to 1 for `d` and `Tr`, 0.01 to 100 for `Ni`, else 0 or more"
        }
        C::Texture => {
            "`{}` names a picture, which is not drawn|write as `Kd` the colour that should be seen"
        }
        C::OpacityConflict => {
            "`d` and `Tr` of the material `{}` contradict each other: `d` counts|take `Tr` away, or write 1 - d"
        }
        C::Invisible => {
            "the material `{}` is wholly transparent|write `d 1` if it should be seen: some programs write `Tr 1` for opaque"
        }
        C::OpaqueFilter => {
            "the material `{}` is opaque: its `Tf` is left out|write `d 0` if light should pass, and its index of refraction as `Ni`"
        }
        C::ExtraNumbers => {
            "beside the numbers of `{}` stands what is not read: it is left out|take it away"
        }
        // Those of other parts say it where they are found.
        _ => "{}|mend it",
    };
    text.split_once('|').unwrap_or((text, ""))
}
