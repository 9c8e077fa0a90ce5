//! Material in a scene file.

use super::fields::Fields;
use crate::scene::file::MaterialFile;
use crate::shading::Material;

/// The fields of a material that are not what a file without them means.
pub fn material(m: &Material) -> String {
    let default = MaterialFile::default();
    let mut fields = Fields::default().color("diffuse", m.diffuse);
    if m.ambient != m.diffuse {
        fields = fields.row("ambient", &m.ambient.channels());
    }
    fields = fields.color("specular", m.specular);
    if m.shininess != default.shininess {
        fields = fields.number("shininess", m.shininess);
    }
    fields = fields
        .color("mirror", m.mirror)
        .color("transmission", m.transmission);
    if m.ior != default.ior {
        fields = fields.number("ior", m.ior);
    }
    if m.priority != default.priority {
        fields = fields.number("priority", m.priority.into());
    }
    fields = fields.color("emission", m.emission);
    if let Some(checker) = &m.checker {
        let mut squares = Fields::default().row("diffuse", &checker.diffuse.channels());
        if checker.ambient != checker.diffuse {
            squares = squares.row("ambient", &checker.ambient.channels());
        }
        let squares = squares.number("size", checker.size).line();
        fields = fields.raw("checker", &squares);
    }
    fields.line()
}
