//! Before a question: what lies behind the horizon is not there, and no move passes it.

use super::session;
use crate::debug::asked::asked;
use crate::debug::horizon::BEHIND;
use crate::debug::ray_search::RaySearch;
use crate::debug::running::running_sum;
use crate::debug::samples::samples;
use crate::debug::{Cursor, RowText, Session, StepCommand, TreeRow};
use crate::probe::{Event, RayKind};
use crate::trace::Address;

fn sessions() -> Vec<(&'static str, Session)> {
    [
        ("whitted", (32, 24)),
        ("nested-glass", (30, 24)),
        ("soft-shadow", (24, 36)),
        ("whitted", (0, 0)),
    ]
    .into_iter()
    .map(|(name, at)| (name, session(name, at)))
    .collect()
}

/// Events as text, since NaN is not equal to itself.
fn told(events: &[Event]) -> String {
    format!("{events:?}")
}

fn all_rows(session: &Session) -> Vec<(TreeRow, RowText)> {
    let rows = (0..session.rows.len()).filter_map(|row| session.rows.get(row));
    rows.map(|row| (row, RowText::new(session, row, 0)))
        .collect()
}

#[test]
fn what_is_behind_is_not_there_and_comes_back_to_the_last_bit() {
    for (name, mut session) in sessions() {
        let whole = session.trace.clone();
        let rows = all_rows(&session);
        let count = whole.tree.events.len();
        for end in (1..count).step_by(1 + count / 60) {
            session.set_horizon(Some(end));
            assert_eq!(session.horizon(), Some(end), "{name}");
            assert_eq!(
                told(&session.tree().events),
                told(&whole.tree.events[..end])
            );
            assert_ne!(session.trace.pixel.color, whole.pixel.color, "{name}");
            for (id, node) in session.tree().nodes.iter().enumerate() {
                let known = whole.tree.node(id as u32);
                assert!((known.first_event as usize) < end);
                let is_done = (known.last_event as usize) < end;
                assert_eq!(session.tree().is_done(id as u32), is_done, "{name}: {id}");
                assert!(is_done || node.radiance == crate::math::Rgb::BLACK);
                let told = whole.tree.own_events(id as u32).find(|(_, event)| {
                    matches!(
                        event,
                        Event::Hit(_) | Event::Miss | Event::Lit | Event::Blocked(_)
                    )
                });
                let is_told = told.is_some_and(|(at, _)| at < end);
                assert_eq!(node.outcome.is_some(), is_told, "{name}: ray {id}, {end}");
            }
            for (_, text) in all_rows(&session) {
                assert!(
                    text.columns.is_empty() || text.columns.contains('?'),
                    "{text:?}"
                );
            }
            assert!(samples(&session).head.contains('?'));
        }
        session.set_horizon(None);
        assert_eq!(session.horizon(), None);
        assert_eq!(told(&session.trace.tree.events), told(&whole.tree.events));
        assert_eq!(session.trace.tree.nodes, whole.tree.nodes);
        assert_eq!(session.trace.pixel, whole.pixel);
        for (row, text) in rows {
            assert_eq!(RowText::new(&session, row, 0).columns, text.columns);
        }
    }
}

#[test]
fn no_move_passes_the_horizon() {
    let kinds = [RayKind::Light, RayKind::Reflected, RayKind::Transmitted];
    let next = kinds.into_iter().map(StepCommand::NextRay);
    let commands: Vec<StepCommand> = next
        .chain([
            StepCommand::Forward,
            StepCommand::Over,
            StepCommand::Out,
            StepCommand::NextSent,
            StepCommand::NextOfLevel,
            StepCommand::NextAbsent,
            StepCommand::End,
        ])
        .collect();
    for (name, mut session) in sessions() {
        let whole = session.trace.tree.clone();
        let count = whole.events.len();
        let (mut refused, mut gone) = (0, 0);
        for end in (1..count).step_by(1 + count / 25) {
            session.set_horizon(Some(end));
            for from in (0..end).step_by(1 + end / 25).chain([end - 1]) {
                for command in &commands {
                    session.go_to_event(from);
                    let told = session.step(*command);
                    let to = session.cursor().position();
                    assert!(to < end, "{name}: {command:?} from {from} to {to}");
                    let free = Cursor::at(&whole, from).after(*command, &whole);
                    // What the whole log answers before the horizon is answered alike.
                    match (free, told) {
                        (Some(free), Ok(())) if free.position() < end => {
                            assert_eq!(to, free.position(), "{name}: {command:?}");
                            gone += 1;
                        }
                        (_, Err(told)) => {
                            assert_eq!(told, BEHIND, "{name}: {command:?} from {from}");
                            assert!(to == from || *command == StepCommand::End);
                            refused += 1;
                        }
                        // Rays of a level may lie behind it: the next one that is known.
                        (_, Ok(())) => assert_eq!(*command, StepCommand::NextOfLevel, "{name}"),
                    }
                }
                session.go_to_event(usize::MAX);
                session.go_by_rays(1000);
                session.go_to_row(1000);
                assert!(session.cursor().position() < end);
            }
        }
        assert!(refused > 50 && gone > 20, "{name}: {refused}, {gone}");
    }
}

#[test]
fn places_behind_the_horizon_are_refused_in_one_sentence() {
    let mut session = session("whitted", (32, 24));
    let address = |text: &str| text.parse::<Address>().expect("an address");
    let at = address("32,24/T/T");
    let there = asked(session.view(), &at).expect("it is sent");
    session.set_horizon(Some(there.horizon));
    for text in ["32,24/T/T", "32,24/T/T/R", "32,24#99999"] {
        let told = session.go_to_address(&address(text));
        assert_eq!(told, Err(BEHIND.to_owned()), "{text}");
    }
    assert_eq!(session.go_to_address(&address("32,24/T")), Ok(()));
    let mut search = RaySearch::new(&"depth >= 50".parse().expect("a query"), 0, true);
    let found = search.go_on(&session, None).expect("no clock stops it");
    let told = search.finish(&mut session, found);
    assert!(told.is_err_and(|told| told.contains("before the question")));
    session.set_horizon(None);
    assert_eq!(session.go_to_address(&at), Ok(()));
}

/// The sum of a ray is not told while its end is behind the question; it would be the answer.
#[test]
fn the_running_sum_of_an_open_ray_is_not_told() {
    let mut session = session("whitted", (32, 24));
    let end = session.tree().node(0).last_event as usize;
    let own = session.tree().own_events(0);
    let terms = own.filter(|(_, event)| matches!(event, Event::Term { .. }));
    let last = terms.map(|(at, _)| at).last().expect("a term");
    session.go_to_event(last);
    assert!(running_sum(&session).is_some_and(|sum| sum.added > 0));
    session.set_horizon(Some(end));
    assert_eq!(session.cursor().position(), last);
    assert_eq!(running_sum(&session), None);
}
