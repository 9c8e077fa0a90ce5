//! Comparison of the current ray's steps with those through another structure, or in another order.

use crate::accel::AccelKind;
use crate::debug::Session;
use crate::debug::step_pairs::{StepPair, StepsBeside, far_first, line, through};
use crate::tui::model::list::{LineGoal, PlaceLine, PlaceList};
use crate::tui::panes::text::{padded, shortened};

/// Steps that are listed at most.
const MOST: usize = 2000;

/// The list for what was typed: `accel=KIND` or `order=far-first`; `None` if it is neither.
pub fn list(session: &Session, text: &str, screen: u16) -> Option<Result<PlaceList, String>> {
    let (flag, value) = text.split_once('=')?;
    let beside = match (flag.trim().trim_start_matches('-'), value.trim()) {
        ("accel", name) => {
            let kind = AccelKind::ALL.iter().find(|kind| kind.name() == name)?;
            through(session, *kind)
        }
        ("order", "far-first") => far_first(session),
        ("order", other) => Err(format!("`order` is `{other}`; it can be far-first")),
        _ => return None,
    };
    let width = usize::from(screen.min(124)).saturating_sub(9) / 2;
    Some(beside.map(|beside| made(session, &beside, text, width)))
}

fn made(session: &Session, beside: &StepsBeside, text: &str, width: usize) -> PlaceList {
    let row = |pair: &StepPair| {
        let side = |session: &Session, event: Option<usize>| {
            let words = event.map_or("-".to_owned(), |event| line(session, event));
            padded(&shortened(&words, width), width)
        };
        let other = side(&beside.other, pair.b);
        PlaceLine {
            text: format!(
                "{} {} | {other}",
                if pair.is_same { '=' } else { ' ' },
                side(session, pair.a)
            ),
            place: match pair.a {
                Some(event) => LineGoal::Event(event),
                None => LineGoal::Told(format!("{}: only with {text}", other.trim())),
            },
        }
    };
    let lines = beside.pairs.iter().take(MOST).map(row).collect();
    let mut list = PlaceList::new(format!("steps of this ray | {text}"), lines);
    list.head.clone_from(&beside.told);
    let here = session.cursor().position();
    let chosen = beside
        .pairs
        .iter()
        .take(MOST)
        .position(|pair| pair.a == Some(here));
    list.chosen = chosen.unwrap_or(0);
    list
}
