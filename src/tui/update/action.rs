//! Actions of the table of keys.

use super::{
    ask, caret, convergence, edit, effects, flip, history, image, marks, places, play, prompt,
    ranking, rows, run, search, set,
};
use crate::debug::fan::Fan;
use crate::tui::model::{Action, Job, Model, Overlay, Pane, Prompt, Request, inside};

/// Does what a user asks for.
pub fn act(model: &mut Model, action: Action) {
    model.message = None;
    if !matches!(action, Action::Play(_)) {
        model.play = None;
    }
    model.running = None;
    if ask::refuses(model, action) {
        return;
    }
    match action {
        Action::Play(forward) => play::play(model, forward),
        Action::Quit => model.request = Request::Quit,
        Action::Suspend => model.request = Request::Suspend,
        Action::Back => back(model),
        Action::Help => show_or_hide(model, Overlay::Help(0)),
        Action::Warnings => show_or_hide(model, Overlay::Warnings(0)),
        Action::Mouse => catch_mouse(model),
        Action::Rows(by) | Action::Move(_, by) if rows::scroll_text(model, by) => {}
        Action::Pages(by) if rows::scroll_text(model, by * 10) => {}
        // Any other key closes the text, and does no more.
        _ if matches!(
            model.overlay,
            Some(Overlay::Help(_) | Overlay::Warnings(_) | Overlay::Report(..))
        ) =>
        {
            model.overlay = None;
        }
        Action::Effects => effects::show_or_hide(model),
        Action::Choose(by) => choose(model, by),
        Action::GoThere => places::accept(model),
        Action::Switch => effects::switch(model),
        Action::Convergence => convergence::show_or_hide(model),
        Action::Move(dx, dy) => move_by(model, dx, dy),
        Action::Open => {
            history::leave(model);
            image::open(model);
        }
        Action::History(back) => history::go(model, back),
        Action::GoTo => prompt::ask(model, Prompt::GoTo),
        Action::Search => prompt::ask(model, Prompt::Search),
        Action::Set => prompt::ask(model, Prompt::Set),
        Action::Compare => prompt::ask(model, Prompt::Compare),
        Action::MoreSamples(of_lights, more) => set::samples(model, of_lights, more),
        Action::Mark => prompt::ask(model, Prompt::Note),
        Action::NextMark => marks::next(model),
        Action::WriteMarks => prompt::ask(model, Prompt::Write),
        Action::NextSeed => set::next_seed(model),
        Action::Flip => flip::flip(model),
        Action::Difference => flip::difference(model),
        Action::Undo => edit::undo(model),
        Action::Changes => edit::show(model),
        Action::WritePatch => prompt::ask(model, Prompt::WritePatch),
        Action::Ready(next) => prompt::ready(model, next),
        Action::Erase(before) => caret::erase(model, before),
        Action::Caret(by) => caret::move_caret(model, by),
        Action::Accept => prompt::accept(model),
        Action::FindNext(forward) => search::next(model, forward),
        Action::Copy => prompt::copy(model),
        Action::NextInOrder(down) => ranking::next(model, down),
        Action::Outliers => ranking::list(model),
        Action::Show(next) => image::show(model, next),
        Action::Hint | Action::Reply(_) | Action::Laws | Action::WithOurs | Action::Give => {
            ask::act(model, action);
        }
        _ => in_tree(model, action),
    }
}

/// Moves the cursor of the picture.
fn move_by(model: &mut Model, dx: i32, dy: i32) {
    let before = model.picture.cursor;
    model.picture.move_by(dx, dy);
    if model.picture.cursor != before {
        image::moved(model);
    }
}

/// Shows a text, or hides it if it is there, however far it is scrolled.
fn show_or_hide(model: &mut Model, text: Overlay) {
    let there = model.overlay.as_ref().map(std::mem::discriminant);
    let is_there = there == Some(std::mem::discriminant(&text));
    model.overlay = (!is_there).then_some(text);
}

/// Chooses a line further down, or up.
fn choose(model: &mut Model, by: i32) {
    if let Some(Overlay::Places(list)) = &mut model.overlay {
        list.choose(by);
    } else {
        effects::choose(model, by);
    }
}

/// Actions that mean something while a tree is open.
fn in_tree(model: &mut Model, action: Action) {
    let layout = &mut model.layout;
    match action {
        Action::Samples => places::of_pixel(model),
        Action::Source => places::source(model),
        Action::PlayBy => play::by(model),
        Action::Break => prompt::ask(model, Prompt::Break),
        Action::Breaks => places::break_points(model),
        Action::Run(forward) => run::run(model, forward),
        Action::Watch => prompt::ask(model, Prompt::Watch),
        Action::Watches => places::watches(model),
        Action::RunToChange(forward) => run::run_to_change(model, forward),
        Action::Origin(back) => places::origin(model, back),
        Action::Neighbour(dx, dy) => image::neighbour(model, dx, dy),
        Action::View | Action::Fan => of_scene(model, action),
        Action::Zoom => layout.zoom = !layout.zoom,
        Action::NextPane => layout.focus = layout.focus.next(true),
        Action::PreviousPane => layout.focus = layout.focus.next(false),
        Action::Rows(by) => rows::move_by(model, by),
        Action::Pages(by) => {
            let page = inside(model.panes().area(model.layout.focus)).height.max(2) - 1;
            rows::move_by(model, by * i32::from(page));
        }
        _ => in_log(model, action),
    }
}

/// Looks at the scene from the next side, or draws other eye rays in it. Where the screen has no room for its pane, that takes the
/// place of the one that has the keys.
fn of_scene(model: &mut Model, action: Action) {
    let is_hidden = model.panes().path.is_empty();
    let layout = &mut model.layout;
    if is_hidden {
        layout.focus = Pane::Path;
        let told = "the scene: Tab goes on to the next pane";
        model.message = Some(told.to_owned());
    }
    match action {
        Action::Fan => layout.fan = Fan::next(layout.fan),
        // Who did not see the scene before sees it first as it was.
        _ if !is_hidden => layout.axis = layout.axis.next(),
        _ => {}
    }
}

/// Moves the cursor in the log, and opens and closes rows.
fn in_log(model: &mut Model, action: Action) {
    let Some(session) = &mut model.session else {
        return;
    };
    match action {
        Action::Step(command) => model.message = session.step(command).err(),
        Action::Unfold => session.fold(false),
        Action::Fold => session.fold(true),
        Action::Toggle => session.toggle(),
        _ => {}
    }
}

/// Closes what lies on top; at the bottom, leaves.
fn back(model: &mut Model) {
    if model.overlay.take().is_some() {
        return;
    }
    if edit::give_up(model) {
        return;
    }
    if model.waiting.take().is_some() {
        model.jobs.push(Job::CancelTrace);
    } else if model.convergence.is_some() {
        convergence::hide(model);
    } else if model.layout.zoom && model.session.is_some() {
        model.layout.zoom = false;
    } else if ask::leaves(model) {
        // Whoever asked goes on.
    } else if model.session.take().is_some() {
        image::refit(model);
    } else if model.search.is_some() {
        search::end(model);
    } else if std::mem::take(&mut model.unsaved) {
        // Once more ends the program.
        let told = "marks are in no file yet: \" writes them, q quits without";
        model.message = Some(told.to_owned());
    } else {
        model.request = Request::Quit;
    }
}

fn catch_mouse(model: &mut Model) {
    model.mouse = !model.mouse;
    let text = if model.mouse {
        "the mouse picks and scrolls"
    } else {
        "the mouse is the terminal's: select text with it; m takes it back"
    };
    model.message = Some(text.to_owned());
}
