//! Pixels in the order of what they show, and those that stand out.

use super::image;
use crate::debug::ranking::{outliers, ranked};
use crate::lab::show::ShowMode;
use crate::trace::Address;
use crate::trace::facts::TreePath;
use crate::trace::format::num;
use crate::tui::model::list::{LineGoal, PlaceLine, PlaceList};
use crate::tui::model::{Model, Overlay};

/// Pixels that are listed at most.
const LISTED: usize = 200;

/// To the pixel with the next smaller number (the next larger one, if not `down`) of what is shown.
pub fn next(model: &mut Model, down: bool) {
    let ranked = ranked(&model.picture);
    let here = ranked
        .iter()
        .position(|(at, _)| *at == model.picture.cursor);
    let next = match (here, down) {
        (None, _) => Some(0),
        (Some(here), true) => Some(here + 1),
        (Some(here), false) => here.checked_sub(1),
    };
    let Some((rank, (at, value))) = next.and_then(|rank| Some((rank, ranked.get(rank)?))) else {
        let end = if down { "the least" } else { "the largest" };
        model.message = Some(format!("this is {end} of {}", what(model)));
        return;
    };
    let told = format!(
        "{} {}: number {} of {}, from the largest down",
        what(model),
        num(*value),
        rank + 1,
        ranked.len()
    );
    model.picture.cursor = *at;
    image::moved(model);
    model.message = Some(told);
}

/// Lists the pixels that stand out from their neighbours; if none does, those with the largest numbers.
pub fn list(model: &mut Model) {
    let line = |at: (u32, u32), text: String| PlaceLine {
        text: format!("{},{}: {text}", at.0, at.1),
        place: LineGoal::Address(Address {
            scene: None,
            pixel: at,
            path: TreePath::default(),
            part: None,
        }),
    };
    let what = what(model);
    let found = outliers(&model.picture);
    let (title, lines): (String, Vec<_>) = if found.is_empty() {
        let all = ranked(&model.picture);
        let lines = all
            .iter()
            .take(LISTED)
            .map(|(at, value)| line(*at, num(*value)));
        (
            format!("no pixel stands out; the largest {what}"),
            lines.collect(),
        )
    } else {
        let lines = found.iter().take(LISTED).map(|o| {
            line(
                o.at,
                format!("{}, around it {}", num(o.value), num(o.around)),
            )
        });
        (
            format!("{} pixels stand out by their {what}", found.len()),
            lines.collect(),
        )
    };
    if lines.is_empty() {
        model.message = Some(format!("no pixel has a {what} yet"));
        return;
    }
    model.overlay = Some(Overlay::Places(PlaceList::new(title, lines)));
}

/// What the pixels are ordered by.
fn what(model: &Model) -> &'static str {
    match model.show {
        Some(ShowMode::Normal | ShowMode::Object | ShowMode::Hit | ShowMode::Direction) | None => {
            "luminance"
        }
        Some(mode) => mode.unit(),
    }
}
