//! Settings that change while the debugger runs: the picture and an open tree follow, and each change can be undone.
//! What is typed may change the scene as well: see `edit.rs`.

use super::edit;
use super::undo::{check_ready, remember, take};
use crate::scene::Settings;
use crate::scene::settings::knobs::set_knob;
use crate::tui::model::Model;

/// Samples of a pixel or of a light at most, by keys.
const MOST_SAMPLES: u32 = 4096;

/// Takes a setting as `flag=value`, such as `samples=16`, or a number of the scene by its path, such as `material.glass.ior=1.3`.
pub fn typed(model: &mut Model, text: &str) -> Result<(), String> {
    check_ready(model)?;
    let Some((flag, value)) = text.split_once('=') else {
        return Err(format!(
            "`{text}` sets nothing; write flag=value, such as samples=16"
        ));
    };
    if is_path(flag) {
        edit::start(model, text);
        return Ok(());
    }
    let (flag, value) = (flag.trim().trim_start_matches('-'), value.trim());
    if flag == "size" {
        return Err("the size of the picture stays; start again with --size".to_owned());
    }
    let mut settings = model.settings;
    set_knob(&mut settings, flag, value)?;
    if settings.arithmetic != model.settings.arithmetic {
        return Err(format!(
            "`{flag}` is part of the scene's shapes; start again with --{flag} {value}"
        ));
    }
    let told = if settings == model.settings {
        format!("{flag} is {value} already")
    } else {
        format!("{flag}: {value}")
    };
    model.message = Some(told);
    change(model, settings);
    Ok(())
}

/// Twice or half as many samples of each pixel, or of each light with an area.
pub fn samples(model: &mut Model, of_lights: bool, more: bool) {
    let lights = &model.world.scene.lights;
    if of_lights && !lights.iter().any(|light| light.kind.is_area()) {
        let told = "no light of this scene has an area: each takes one sample";
        model.message = Some(told.to_owned());
        return;
    }
    let settings = model.settings.with(|s| {
        let count = if of_lights {
            &mut s.light.samples
        } else {
            &mut s.pixel.samples
        };
        let wanted = if more {
            count.saturating_mul(2)
        } else {
            *count / 2
        };
        *count = wanted.clamp(1, MOST_SAMPLES);
    });
    let (what, count) = if of_lights {
        ("samples a light", settings.light.samples)
    } else {
        ("samples a pixel", settings.pixel.samples)
    };
    model.message = Some(format!("{what}: {count}"));
    change(model, settings);
}

/// Other random numbers.
pub fn next_seed(model: &mut Model) {
    let settings = model.settings.with(|s| s.seed = s.seed.wrapping_add(1));
    model.message = Some(format!("seed: {}", settings.seed));
    change(model, settings);
}

/// Whether it is a path into the scene: flags have neither dots nor brackets.
fn is_path(text: &str) -> bool {
    let word = text.trim_end_matches(['+', '*']).trim();
    word.contains(['.', '[']) || ["background", "ambient"].contains(&word)
}

fn change(model: &mut Model, settings: Settings) {
    if settings == model.settings {
        return;
    }
    if let Err(problem) = check_ready(model) {
        model.message = Some(problem);
        return;
    }
    remember(model);
    take(model, settings);
}
