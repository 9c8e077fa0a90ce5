//! Search: a query, what it finds in the picture and in the open tree.

use std::time::Instant;

use super::{history, image};
use crate::debug::QuerySearch;
use crate::debug::ray_search::RaySearch;
use crate::trace::TreeQuery;
use crate::trace::query::unknown_names;
use crate::tui::model::motion::AT_ONCE;
use crate::tui::model::{Job, LongRun, Model};

/// Begins to search for a query; in an open tree also for the next ray that satisfies it.
pub fn start(model: &mut Model, text: &str) -> Result<(), String> {
    let mut search = QuerySearch::new(text, model.picture.size.0)?;
    in_tree(model, &search.query, true);
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
    if in_tree(model, &query, forward) {
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

/// Searches the open tree, if there is one, for the next ray or the one before.
fn in_tree(model: &mut Model, query: &TreeQuery, forward: bool) -> bool {
    let Some(session) = &model.session else {
        return false;
    };
    let search = RaySearch::new(query, session.cursor().position(), forward);
    go_on(model, search, Instant::now() + AT_ONCE);
    true
}

/// Goes on with a search of the open tree.
pub fn go_on(model: &mut Model, mut search: RaySearch, until: Instant) {
    let Some(session) = &mut model.session else {
        return;
    };
    let told = if let Some(found) = search.go_on(session, Some(until)) {
        search.finish(session, found).unwrap_or_else(|none| none)
    } else {
        let (at, all) = (search.looked_at, session.tree().nodes.len());
        model.running = Some(LongRun::ToRay(search));
        format!("searching: {at} of {all} rays; any key stops")
    };
    model.message = Some(told);
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
