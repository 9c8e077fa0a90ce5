//! Question beside the panes: its keys, what it refuses, the horizon that it sets, what is told when it is answered.

use crossterm::event::{KeyEvent, KeyModifiers};

use super::{compare, image};
use crate::debug::asked::asked;
use crate::debug::horizon::BEHIND;
use crate::debug::{Cursor, Session};
use crate::tui::model::ask::{
    AskKey, AskKind, AskReply, AskRequest, AskState, AskTold, HINTS_BEFORE_DIFFERENCE,
};
use crate::tui::model::bindings::lookup;
use crate::tui::model::list::{LineGoal, PlaceLine, PlaceList};
use crate::tui::model::{Action, Context, Model, Overlay};

/// Takes a key if it belongs to the question.
pub fn press(model: &mut Model, key: KeyEvent) -> bool {
    let special = KeyModifiers::CONTROL | KeyModifiers::ALT;
    if model.overlay.is_some() || key.modifiers.intersects(special) {
        return false;
    }
    let Some(ask) = &mut model.ask else {
        return false;
    };
    let told = match ask.press(key.code) {
        AskKey::Other => {
            return lookup(Context::Question, key).is_some_and(|action| act(model, action));
        }
        AskKey::Taken => None,
        AskKey::Wrong(told) => Some(told),
    };
    (model.play, model.running, model.message) = (None, None, told);
    true
}

/// Does an action of the question. False if it means something else at present.
pub fn act(model: &mut Model, action: Action) -> bool {
    let (in_tree, cursor) = (model.session.is_some(), model.picture.cursor);
    let Some(ask) = &mut model.ask else {
        return false;
    };
    match (action, &ask.kind) {
        (Action::Hint, _) if ask.takes_answers() => {
            if ask.shown.len() < ask.hints {
                ask.request = Some(AskRequest::Hint);
            } else {
                let told = match ask.hints {
                    0 => "there are no hints",
                    _ => "there are no more hints",
                };
                model.message = Some(told.to_owned());
            }
        }
        (Action::Give, _) if !ask.takes_answers() => ask.request = Some(AskRequest::GoOn),
        (Action::Give, AskKind::Pixel) if !in_tree => {
            ask.give(AskReply::Pixel(cursor));
        }
        (Action::Reply(_), AskKind::Word(_)) if ask.is_open() => {}
        (Action::Laws, AskKind::Law { among, .. }) if ask.takes_answers() => {
            let lines = among.iter().enumerate().map(|(number, law)| PlaceLine {
                text: law.clone(),
                place: LineGoal::Law(number),
            });
            let mut list = PlaceList::new("the law that is broken", lines.collect());
            "The answer is a law and the ray under the cursor: the first with a wrong number."
                .clone_into(&mut list.head);
            model.overlay = Some(Overlay::Places(list));
        }
        (Action::WithOurs, AskKind::Law { ours, .. }) if ask.takes_answers() => {
            let ours = ours.clone();
            if ask.shown.len() < HINTS_BEFORE_DIFFERENCE {
                let told = "after two hints d shows where this tracer and ours differ";
                model.message = Some(told.to_owned());
            } else {
                model.message = compare::with_ours(model, &ours).err();
            }
        }
        _ => return false,
    }
    true
}

/// Goes back to where the question was asked, if its own screen is left. (While a pixel is looked for trees are closed first.)
pub fn leaves(model: &mut Model) -> bool {
    let in_tree = model.session.is_some();
    let Some(ask) = &mut model.ask else {
        return false;
    };
    let leaves = !in_tree || ask.kind != AskKind::Pixel;
    if leaves {
        ask.request = Some(AskRequest::Leave);
    }
    leaves
}

/// A law was chosen for the ray under the cursor.
pub fn give_law(model: &mut Model, law: usize) {
    let event = model.session.as_ref().map(|s| s.cursor().position());
    if let (Some(ask), Some(event)) = (&mut model.ask, event) {
        ask.give(AskReply::Law(law, event));
    }
}

/// True if a question keeps to its pixel and its settings, and tells that. A broken tracer may be looked at beside its pixel, too.
pub fn refuses(model: &mut Model, action: Action) -> bool {
    let is_neighbour = matches!(action, Action::Neighbour(..)) && model.session.is_some();
    let hides = |ask: &AskState| ask.hides() && !(is_neighbour && ask.is_of_a_bug());
    let refuses = model.ask.as_ref().is_some_and(hides)
        && (is_behind(action) || model.session.is_none() && is_of_pixels(action));
    if refuses {
        model.message = Some(BEHIND.to_owned());
    }
    refuses
}

/// Actions that show or tell what a question hides: other pixels, settings and pictures, and commands that name them.
fn is_behind(action: Action) -> bool {
    match action {
        Action::Switch
        | Action::Convergence
        | Action::Move(..)
        | Action::Open
        | Action::Neighbour(..)
        | Action::Set
        | Action::Compare
        | Action::MoreSamples(..)
        | Action::NextSeed
        | Action::Mark
        | Action::NextMark
        | Action::WriteMarks
        | Action::Undo
        | Action::Flip
        | Action::Difference
        | Action::Changes
        | Action::WritePatch
        | Action::Show(_)
        | Action::NextInOrder(_)
        | Action::Outliers
        | Action::Fan
        | Action::Copy => true,
        Action::Quit
        | Action::Back
        | Action::Help
        | Action::Suspend
        | Action::Mouse
        | Action::Effects
        | Action::Warnings
        | Action::Choose(_)
        | Action::Step(_)
        | Action::Play(_)
        | Action::PlayBy
        | Action::Break
        | Action::Watch
        | Action::Watches
        | Action::RunToChange(_)
        | Action::Breaks
        | Action::Run(_)
        | Action::Origin(_)
        | Action::History(_)
        | Action::GoTo
        | Action::Samples
        | Action::Search
        | Action::FindNext(_)
        | Action::Source
        | Action::Ready(_)
        | Action::GoThere
        | Action::Rows(_)
        | Action::Pages(_)
        | Action::Unfold
        | Action::Fold
        | Action::Toggle
        | Action::NextPane
        | Action::PreviousPane
        | Action::Zoom
        | Action::View
        | Action::Accept
        | Action::Erase(_)
        | Action::Caret(_)
        | Action::Hint
        | Action::Reply(_)
        | Action::Laws
        | Action::WithOurs
        | Action::Give => false,
    }
}

/// Actions that mean pixels while no tree is open.
fn is_of_pixels(action: Action) -> bool {
    matches!(
        action,
        Action::Search | Action::FindNext(_) | Action::GoTo | Action::History(_)
    )
}

/// The tree of the question's pixel is there: what is asked for is hidden.
pub fn opened(model: &mut Model, session: &mut Session) {
    let Some(ask) = model.ask.as_mut().filter(|ask| ask.is_open()) else {
        return;
    };
    let Some(at) = &ask.at else {
        return;
    };
    match asked(session.view(), at) {
        Ok(asked) => {
            session.set_horizon(Some(asked.horizon));
            session.go(Cursor::end(session.tree()));
            ask.asked = Some(asked);
        }
        Err(told) => {
            session.set_horizon(Some(1));
            model.message = Some(told);
        }
    }
}

/// The question is answered: all is known, and the step that tells the answer is shown.
pub fn tell(model: &mut Model, told: AskTold) {
    let Some(ask) = &mut model.ask else {
        return;
    };
    let is_right = told.is_right;
    ask.told = Some(told);
    model.picture.hidden = None;
    let ours = match &ask.kind {
        AskKind::Law { ours, .. } => Some(ours.clone()),
        _ => None,
    };
    if let (Some(asked), Some(session)) = (ask.asked, &mut model.session) {
        session.set_horizon(None);
        session.go_to_event(asked.answer);
    }
    if let (true, Some(ours)) = (is_right, ours) {
        model.message = compare::with_ours(model, &ours).err();
    }
    image::refit(model);
}

/// A further hint is shown.
pub fn hint(model: &mut Model, text: impl Into<String>) {
    if let Some(ask) = &mut model.ask {
        ask.shown.push(text.into());
        image::refit(model);
    }
}
