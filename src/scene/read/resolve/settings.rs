//! Settings of a scene file.

use super::checks::number;
use crate::scene::Settings;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::SettingsFile;
use crate::scene::settings::knob::{Kind, Value};

/// Settings, with the program's default for each that the file does not give.
pub fn settings(file: &SettingsFile, path: &FieldPath) -> Result<Settings, SceneError> {
    let mut settings = Settings::default();
    for (knob, value) in &file.values {
        let path = path.key(&knob.key());
        if let Some((what, cure)) = knob.problem(value) {
            return Err(path.error(what, cure));
        }
        if let Value::Real(x) = *value {
            number(x, Kind::FILE_RANGE, &path)?;
        }
        (knob.field.set)(&mut settings, value);
    }
    Ok(settings)
}
