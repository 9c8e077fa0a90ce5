//! History: back to the places that were left by a jump, and forward again.

use super::image;
use crate::tui::model::Model;

/// Places that are kept.
const MOST: usize = 1000;

/// The cursor is about to jump: it can come back.
pub fn leave(model: &mut Model) {
    let here = model.address();
    let past = &mut model.history.past;
    if past.last() != Some(&here) {
        if past.len() >= MOST {
            past.remove(0);
        }
        past.push(here);
    }
    model.history.future.clear();
}

/// To the place before the last jump, or forward again.
pub fn go(model: &mut Model, back: bool) {
    let here = model.address();
    let history = &mut model.history;
    let (from, to) = if back {
        (&mut history.past, &mut history.future)
    } else {
        (&mut history.future, &mut history.past)
    };
    let mut found = from.pop();
    while found.as_ref() == Some(&here) {
        found = from.pop();
    }
    let Some(address) = found else {
        let told = if back {
            "no jump leads here"
        } else {
            "no place comes after this"
        };
        model.message = Some(told.to_owned());
        return;
    };
    to.push(here);
    let is_tree = address.part.is_some();
    if !is_tree && model.session.take().is_some() {
        image::refit(model);
    }
    model.message = image::go_to(model, address).err();
}
