//! Image: follows the screen and the cursor, and is rendered anew when the settings change.

use std::time::Instant;

use ratatui::layout::Rect;
use strum::VariantArray as _;

use super::convergence;
use crate::debug::horizon::BEHIND;
use crate::debug::pick::description;
use crate::lab::show::ShowMode;
use crate::trace::Address;
use crate::trace::facts::TreePath;
use crate::tui::model::ask::AskState;
use crate::tui::model::layout::Shown;
use crate::tui::model::{Job, Model};

/// The screen has another size.
pub fn resize(model: &mut Model, screen: Rect) {
    if screen != model.layout.screen {
        model.layout.screen = screen;
        refit(model);
    }
}

/// Fits the image to the screen again and renders it. An open tree keeps the image that it belongs to.
pub fn refit(model: &mut Model) {
    if model.session.is_none() && fit(model) {
        render(model);
        search_again(model);
        look(model);
    }
}

/// Gives the image the size of its pane, unless the command line chose one; the cursor stays at the corresponding
/// pixel. True if anything changed.
pub fn fit(model: &mut Model) -> bool {
    let pane = model.panes_for(model.layout.screen, Shown::Picture).picture;
    let visible = (
        u32::from(pane.width).max(1),
        2 * u32::from(pane.height).max(1),
    );
    let size = model.options.size.unwrap_or(visible);
    let Some(resized) = model.picture.resized(size, visible) else {
        return false;
    };
    model.picture = resized;
    (model.settings.image.width, model.settings.image.height) = model.picture.size;
    true
}

/// Renders what is not known of the image.
pub fn render(model: &mut Model) {
    model.jobs.push(Job::Render);
}

/// The cursor is on another pixel.
pub fn moved(model: &mut Model) {
    if model.waiting.take().is_some() {
        model.jobs.push(Job::CancelTrace);
    }
    if model.picture.follow() {
        render(model);
    }
    look(model);
}

/// Renders everything anew: the settings are others. An open tree is traced again, at the same ray.
pub fn redo(model: &mut Model) {
    model.picture.forget();
    render(model);
    search_again(model);
    look(model);
    if let Some(session) = &model.session {
        let (x, y) = (session.trace.x, session.trace.y);
        let is_here = model.picture.cursor == (x, y);
        model.again = is_here.then(|| model.address().path);
    }
    if model.session.is_some() || model.waiting.is_some() {
        open(model);
    }
}

/// Goes to an address: to its pixel, and into its tree if it names a ray or if a tree is open.
pub fn go_to(model: &mut Model, address: Address) -> Result<(), String> {
    let (width, height) = model.picture.size;
    let (x, y) = address.pixel;
    if x >= width || y >= height {
        return Err(format!(
            "pixel {x},{y} is outside the picture of {width}x{height}"
        ));
    }
    if let Some(session) = &mut model.session
        && address.pixel == (session.trace.x, session.trace.y)
    {
        return session.go_to_address(&address);
    }
    if model.ask.as_ref().is_some_and(AskState::hides) {
        return Err(BEHIND.to_owned());
    }
    show_at(model, address);
    Ok(())
}

/// Goes to an address in another pixel.
fn show_at(model: &mut Model, address: Address) {
    model.picture.cursor = address.pixel;
    moved(model);
    let is_ray = address.path != TreePath::default() || address.part.is_some();
    if is_ray || model.session.is_some() {
        model.options.at = Some(address);
        open(model);
    }
}

/// Opens the tree of the pixel beside this one, at the same ray. (A question that does not allow it has refused the key.)
pub fn neighbour(model: &mut Model, dx: i32, dy: i32) {
    let mut address = model.address();
    let (x, y) = address.pixel;
    let (width, height) = model.picture.size;
    let next = x.checked_add_signed(dx).zip(y.checked_add_signed(dy));
    let Some(pixel) = next.filter(|(x, y)| *x < width && *y < height) else {
        model.message = Some("this is the edge of the picture".to_owned());
        return;
    };
    address.pixel = pixel;
    address.part = None;
    show_at(model, address);
}

/// Searches the picture anew: it is another one.
fn search_again(model: &mut Model) {
    if let Some(search) = &model.search {
        model.search = Some(search.again(model.picture.size.0));
        model.jobs.push(Job::Search);
    }
}

/// Shows the next (previous) thing in the place of colours; before the first and behind the last come the colours.
pub fn show(model: &mut Model, next: bool) {
    let modes = ShowMode::VARIANTS;
    let at = model
        .show
        .and_then(|mode| modes.iter().position(|m| *m == mode));
    let at = match (at, next) {
        (None, true) => Some(0),
        (None, false) => modes.len().checked_sub(1),
        (Some(at), true) => Some(at + 1),
        (Some(at), false) => at.checked_sub(1),
    };
    model.show = at.and_then(|at| modes.get(at)).copied();
    if model.show == Some(ShowMode::Error) && model.settings.pixel.samples < 2 {
        let told = "one sample tells no standard error: } takes twice as many";
        model.message = Some(told.to_owned());
    }
    model.picture.forget();
    render(model);
}

/// Picks the object behind the pixel under the cursor, and begins its convergence anew if that is shown.
pub fn look(model: &mut Model) {
    convergence::restart(model);
    model.picked = description(&model.world, &model.settings, model.picture.cursor);
}

/// Traces the pixel under the cursor.
pub fn open(model: &mut Model) {
    model.waiting = Some(Instant::now());
    model.jobs.push(Job::Trace);
}
