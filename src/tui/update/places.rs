//! Lists of places: where numbers come from and go, the samples of the pixel, the break points.

use super::{ask, history, image};
use crate::debug::log_run;
use crate::debug::origin::{OriginPlace, origins, uses};
use crate::debug::samples::samples;
use crate::debug::watch::Watch;
use crate::trace::explain::source_text;
use crate::trace::facts::TreePath;
use crate::trace::{Address, explain};
use crate::tui::model::list::{LineGoal, PlaceLine, PlaceList};
use crate::tui::model::{Model, Overlay};

/// Shows where the numbers of the current event come from, or where they go.
pub fn origin(model: &mut Model, back: bool) {
    let Some(session) = &model.session else {
        return;
    };
    let (view, here) = (session.view(), session.cursor().position());
    let to = |at: usize, what: &str| PlaceLine {
        text: format!("{what}: event {at}, {}", explain(view, at).title),
        place: LineGoal::Event(at),
    };
    let list = if back {
        let lines = origins(view, here)
            .into_iter()
            .map(|origin| match origin.place {
                OriginPlace::Event(at) => to(at, origin.what),
                OriginPlace::Input(words) => PlaceLine {
                    text: format!("{}: {words}", origin.what),
                    place: LineGoal::Told(format!(
                        "{}: {words}; no step comes before that",
                        origin.what
                    )),
                },
            });
        PlaceList::new("where the numbers come from", lines.collect())
    } else {
        let lines = uses(view, here).into_iter().map(|(at, what)| to(at, what));
        PlaceList::new("where the numbers go", lines.collect())
    };
    if list.lines.is_empty() {
        let pixel = "the numbers of this event go into no other one of this tree";
        model.message = Some(pixel.to_owned());
        return;
    }
    model.overlay = Some(Overlay::Places(list));
}

/// Shows the function that does what the current event tells.
pub fn source(model: &mut Model) {
    let Some(session) = &model.session else {
        return;
    };
    let place = explain(session.view(), session.cursor().position()).source;
    match source_text(place) {
        Some(text) => {
            let text = format!("{}\n\n{text}", place.file);
            model.overlay = Some(Overlay::Report("the code of this event", text, 0));
        }
        None => model.message = Some("this event has no function of its own".to_owned()),
    }
}

/// Shows the samples of the pixel.
pub fn of_pixel(model: &mut Model) {
    let Some(session) = &model.session else {
        return;
    };
    let table = samples(session);
    let pixel = (session.trace.x, session.trace.y);
    let line = |(index, text): (u32, String)| PlaceLine {
        text,
        place: LineGoal::Address(Address {
            scene: None,
            pixel,
            path: TreePath {
                sample: index,
                ..TreePath::default()
            },
            part: None,
        }),
    };
    let mut list = PlaceList::new(
        "samples of the pixel",
        table.lines.into_iter().map(line).collect(),
    );
    list.head = table.head;
    model.overlay = Some(Overlay::Places(list));
}

/// Shows the break points; each leads to the first event that it stops at.
pub fn break_points(model: &mut Model) {
    let Some(session) = &model.session else {
        return;
    };
    let line = |(text, first): (String, Option<usize>)| PlaceLine {
        place: match first {
            Some(event) => LineGoal::Event(event),
            None => LineGoal::Told("none stands near the start: x runs to the next".to_owned()),
        },
        text,
    };
    let lines: Vec<_> = log_run::list(session, &model.breaks)
        .into_iter()
        .map(line)
        .collect();
    if lines.is_empty() {
        model.message = Some("there are no break points: b sets one".to_owned());
        return;
    }
    model.overlay = Some(Overlay::Places(PlaceList::new("break points", lines)));
}

/// Shows the watched numbers; each leads to the step that told it.
pub fn watches(model: &mut Model) {
    let Some(session) = &model.session else {
        return;
    };
    if model.watches.is_empty() {
        model.message = Some("no number is watched: * watches one".to_owned());
        return;
    }
    let here = session.cursor().position();
    let line = |watch: &Watch| {
        let state = watch.state(session, here);
        PlaceLine {
            text: state.told(&watch.text),
            place: match state.now {
                Some(now) => LineGoal::Event(now.event),
                None => LineGoal::Told(format!("no step near before this tells {}", watch.text)),
            },
        }
    };
    let lines = model.watches.iter().map(line).collect();
    let mut list = PlaceList::new("watched numbers", lines);
    "≠ changes at this step; ) runs to the next change, ( back".clone_into(&mut list.head);
    model.overlay = Some(Overlay::Places(list));
}

/// Goes to the chosen place of a list.
pub fn accept(model: &mut Model) {
    let Some(Overlay::Places(list)) = model.overlay.take() else {
        return;
    };
    let Some(line) = list.lines.into_iter().nth(list.chosen) else {
        return;
    };
    history::leave(model);
    match line.place {
        LineGoal::Event(at) => {
            if let Some(session) = &mut model.session {
                session.go_to_event(at);
            }
        }
        LineGoal::Address(address) => model.message = image::go_to(model, address).err(),
        LineGoal::Law(law) => ask::give_law(model, law),
        LineGoal::Told(text) => model.message = Some(text),
    }
}
