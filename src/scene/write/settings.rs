//! Settings in a scene file.

use super::fields::Fields;
use crate::scene::settings::knobs::knobs;
use crate::scene::{Settings, flat};

/// The settings that differ from the program's own, as far as scene files can set them.
pub fn settings(settings: &Settings) -> String {
    let default = Settings::default();
    let mut fields = Fields::default();
    for knob in knobs().filter(|knob| knob.in_files) {
        let value = (knob.field.get)(settings);
        if let Some(value) = value.filter(|v| Some(v) != (knob.field.get)(&default).as_ref()) {
            // Nothing but memory could be missing for that.
            let text = flat::line(&value).unwrap_or_default();
            fields = fields.raw(&knob.key(), &text);
        }
    }
    fields.line()
}
