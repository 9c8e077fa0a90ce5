//! Search: a query, what it finds in the picture and in the open tree.

use super::{history, image};
use crate::debug::QuerySearch;
use crate::trace::query::unknown_names;
use crate::tui::model::{Job, Model};

/// Begins to search for a query; in an open tree also for the next ray that satisfies it.
pub fn start(model: &mut Model, text: &str) -> Result<(), String> {
    let mut search = QuerySearch::new(text, model.picture.size.0)?;
    if let Some(session) = &mut model.session {
        model.message = Some(
            session
                .find(&search.query, true)
                .unwrap_or_else(|none| none),
        );
    }
    // A name that nothing has is likely a slip.
    if let Some(unknown) = unknown_names(&search.query, &model.world.scene) {
        model.message = Some(unknown);
    }
    search.is_new = model.session.is_none();
    model.search = Some(search);
    // Which pixels satisfy it may tell what is asked.
    if model.picture.hidden.is_none() {
        model.jobs.push(Job::Search);
    }
    Ok(())
}

/// To the next (previous) pixel or ray that satisfies the query.
pub fn next(model: &mut Model, forward: bool) {
    let Some(search) = &model.search else {
        model.message = Some("nothing is searched for: / asks for a query".to_owned());
        return;
    };
    let query = search.query.clone();
    if model.session.is_some() {
        history::leave(model);
    }
    if let Some(session) = &mut model.session {
        model.message = Some(session.find(&query, forward).unwrap_or_else(|none| none));
        return;
    }
    let Some(search) = &model.search else {
        return;
    };
    match search.pixel(model.picture.cursor, forward) {
        Some(pixel) => go(model, pixel),
        None => model.message = Some(search.told(model.picture.cursor)),
    }
}

/// Pixels were found, among the next so many.
pub fn found(model: &mut Model, pixels: &[(u32, u32)], searched: u64) {
    let Some(search) = &mut model.search else {
        return;
    };
    search.add(pixels, searched);
    if let (true, Some(first)) = (search.is_new, pixels.first()) {
        search.is_new = false;
        if model.session.is_none() {
            go(model, *first);
        }
    }
}

/// The whole picture was searched.
pub fn finished(model: &mut Model) {
    if let Some(search) = &mut model.search {
        search.finish();
    }
}

/// Ends the search.
pub fn end(model: &mut Model) {
    model.search = None;
    model.jobs.push(Job::CancelSearch);
}

fn go(model: &mut Model, pixel: (u32, u32)) {
    if pixel != model.picture.cursor {
        model.picture.cursor = pixel;
        image::moved(model);
    }
}
