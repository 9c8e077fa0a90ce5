//! Dispatch of messages.

#[cfg(test)]
use super::action;
use super::{image, keys, mouse, output, play, run};
use crate::scene::printable::printable;
use crate::tui::model::{Message, Model};

/// Fits the picture to the screen and begins to render it.
pub fn start(model: &mut Model) {
    image::fit(model);
    let (width, height) = model.picture.size;
    // From now on it stays: another window shows another part of it, and the same pixels.
    model.options.size = Some((width, height));
    match model.options.marks.take() {
        Some(marks) => {
            model.marked = marks.marks.len().saturating_sub(1);
            let count = marks.marks.len();
            let scene = &model.options.scene;
            let of = if marks.scene == *scene {
                String::new()
            } else {
                format!(" of scene {}, and this is {scene}", printable(&marks.scene))
            };
            model.message = Some(format!("{count} marks{of}: ' goes to the next"));
            model.marks = marks;
        }
        None => model.marks.size = [width, height],
    }
    model.picture.cursor = (width / 2, height / 2);
    let at = model.options.at.as_ref().map(|at| at.pixel);
    let is_inside = |(x, y): &(u32, u32)| *x < width && *y < height;
    if let Some(pixel) = at.filter(is_inside) {
        model.picture.cursor = pixel;
        if model.ask.as_ref().is_some_and(|ask| ask.at.is_some()) {
            model.picture.hidden = Some(pixel);
        }
        image::open(model);
    } else if let Some((x, y)) = at {
        model.options.at = None;
        let what = format!("pixel {x},{y} is outside the picture of {width}x{height} (see --size)");
        model.message = Some(what);
    }
    model.picture.follow();
    image::render(model);
    image::look(model);
}

/// Takes in a message. False if it means nothing.
pub fn update(model: &mut Model, message: Message) -> bool {
    let position = |model: &Model| model.session.as_ref().map(|s| s.cursor().position());
    let before = position(model);
    let mut known = true;
    match message {
        #[cfg(test)]
        Message::Action(action) => action::act(model, action),
        Message::Key(key) => known = keys::press(model, key),
        Message::Paste(text) => keys::paste(model, &text),
        Message::Mouse(mouse, at) => mouse::point(model, mouse, at),
        Message::Resize(screen) => image::resize(model, screen),
        Message::Output(output) => output::take_in(model, output),
        Message::Tick(now) => {
            run::go_on(model);
            play::tick(model, now);
        }
    }
    if position(model) != before {
        model.layout.scroll = 0;
    }
    known
}
