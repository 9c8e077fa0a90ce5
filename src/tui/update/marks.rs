//! Marks: made, walked, written.

use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;

use super::{history, image};
use crate::debug::marks::Mark;
use crate::trace::Address;
use crate::tui::model::Model;

/// Marks what is shown, with a note.
pub fn mark(model: &mut Model, note: &str) {
    let mark = Mark {
        address: model.address().to_string(),
        note: note.to_owned(),
        command: model.open_command(),
    };
    model.marks.marks.push(mark);
    model.unsaved = true;
    let last = model.marks.marks.len() - 1;
    model.marked = last;
    model.message = Some(model.marks.told(last));
}

/// Goes to the next mark; behind the last one comes the first.
pub fn next(model: &mut Model) {
    let count = model.marks.marks.len();
    if count == 0 {
        model.message = Some("nothing is marked: M marks what is shown".to_owned());
        return;
    }
    model.marked = (model.marked + 1) % count;
    let told = model.marks.told(model.marked);
    let address = &model.marks.marks[model.marked].address;
    // It was one when it was read.
    let Ok(address) = address.parse::<Address>() else {
        return;
    };
    history::leave(model);
    let gone = image::go_to(model, address).err();
    model.message = Some(gone.unwrap_or(told));
}

/// Writes all marks into a new file.
pub fn write(model: &mut Model, path: &str) -> Result<(), String> {
    if model.marks.marks.is_empty() {
        return Err("nothing is marked: M marks what is shown".to_owned());
    }
    write_new(&model.options.folder.join(path), &model.marks.to_json())?;
    let count = model.marks.marks.len();
    model.unsaved = false;
    model.message = Some(format!(
        "{count} marks are in {path}; raytree view --marks {path} opens them"
    ));
    Ok(())
}

/// Writes a text into a file that is not there yet.
pub fn write_new(path: &Path, text: &str) -> Result<(), String> {
    let file = OpenOptions::new().write(true).create_new(true).open(path);
    let cannot = |error: std::io::Error| format!("cannot be written: {error}");
    let mut file = file.map_err(cannot)?;
    file.write_all(text.as_bytes()).map_err(cannot)
}
