//! The MTL files that an OBJ file names: where they are, and those of their materials that it uses.

use std::collections::HashSet;

use super::check::Checked;
use super::mtl;
use crate::scene::read::files::Files;
use crate::scene::read::notes::Notes;
use crate::scene::read::text::Decoded;
use crate::scene::warning::{WarningCode, Warnings};
use crate::shading::Material;

/// The materials that the faces of the OBJ file at the path `model` use; each MTL file is read once. One that is missing, or
/// a material that none describes, is only noted: the shape can be seen without.
pub fn read(
    checked: &mut Checked,
    model: &str,
    files: &mut Files,
    warnings: &mut Warnings,
) -> Vec<Material> {
    let used = checked.runs.iter().map(|run| &run.material);
    let used = used.filter(|(name, _)| !name.is_empty());
    let mut missing: HashSet<&str> = used.clone().map(|(name, _)| name.as_str()).collect();
    let (mut materials, mut known) = (Vec::new(), HashSet::new());
    let folder = model.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut search = Search {
        folder,
        files,
        notes: &mut checked.notes,
        line: 0,
    };
    for (library, line) in &checked.libraries {
        if !known.insert(library) {
            continue;
        }
        search.line = *line;
        for (path, text) in search.all(library) {
            let mut own = Notes::default();
            own.encoding(&text);
            materials.extend(mtl::parse(
                &text.text,
                |name| missing.remove(name),
                &mut own,
            ));
            own.warn(&search.files.label(&path), warnings);
        }
    }
    for (name, line) in used {
        if missing.remove(name.as_str()) {
            search.notes.add(WarningCode::MissingMaterial, name, *line);
        }
    }
    materials
}

/// The search for the files of a line `mtllib`.
struct Search<'a> {
    /// Where the model is, and where paths in it start.
    folder: &'a str,
    files: &'a mut Files,
    notes: &'a mut Notes,
    line: usize,
}

impl Search<'_> {
    /// The files that it names: all of it is one name with blanks in it, or each of its words is one.
    fn all(&mut self, library: &str) -> Vec<(String, Decoded)> {
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        let words = library.split_whitespace().filter(|word| *word != library);
        for name in std::iter::once(library).chain(words) {
            match self.one(name) {
                Ok(file) => found.push(file),
                Err(why) => missing.push(why),
            }
            if name == library && !found.is_empty() {
                return found;
            }
        }
        // If nothing is found, it was one name.
        let missing = if found.is_empty() {
            &missing[..1]
        } else {
            &missing[1..]
        };
        for why in missing {
            self.notes.add(WarningCode::MissingLibrary, why, self.line);
        }
        found
    }

    /// Path and text of a file, or why there is none. `\` is `/`. No path leads out of the folder: instead of such a path, or
    /// of one that leads to nothing, the file of its name beside the model is read.
    fn one(&mut self, name: &str) -> Result<(String, Decoded), String> {
        let path = name.trim_matches('"').replace('\\', "/");
        let bare = path.rsplit('/').next().unwrap_or_default();
        let why = match self.open(&path) {
            Ok(found) => return Ok(found),
            Err(why) => format!("`{name}`: {why}"),
        };
        let beside = self.open(bare).map_err(|_| why)?;
        self.notes.add(WarningCode::LibraryPath, name, self.line);
        Ok(beside)
    }

    fn open(&mut self, path: &str) -> Result<(String, Decoded), String> {
        let path = match self.folder {
            "" => path.to_owned(),
            _ if path.starts_with('/') => path.to_owned(),
            folder => format!("{folder}/{path}"),
        };
        match self.files.read_model(&path) {
            Ok(Some(text)) => Ok((path, text)),
            Ok(None) => Err("there is no such file".to_owned()),
            Err(problem) => Err(problem.what),
        }
    }
}
