//! Break points: set, taken away, run to.

use std::time::{Duration, Instant};

use super::history;
use crate::debug::breaks::{self, BreakPoint};
use crate::tui::model::{LogRun, Model};

/// How long a key waits for a run; it goes on afterwards.
const AT_ONCE: Duration = Duration::from_millis(8);

/// Break points at most.
const MOST: usize = 100;

/// Sets a break point, or takes it away if it is there. In an open tree it tells how many events it stops at.
pub fn toggle(model: &mut Model, text: &str) -> Result<(), String> {
    let point = BreakPoint::new(text)?;
    if let Some(at) = model.breaks.iter().position(|p| *p == point) {
        model.breaks.remove(at);
        model.message = Some(format!("no break at {text} any more"));
        return Ok(());
    }
    if model.breaks.len() >= MOST {
        return Err(format!(
            "there are {MOST} break points; type one again to take it away"
        ));
    }
    let counted = model.session.as_ref().and_then(|s| point.count(s, 0));
    let told = counted.map_or(String::new(), |(_, all)| format!(": {all} in this tree"));
    model.message = Some(format!("break at {text}{told}; x runs to it, X back"));
    model.breaks.push(point);
    Ok(())
}

/// Runs to the next break point, or back to the one before.
pub fn run(model: &mut Model, forward: bool) {
    let Some(session) = &model.session else {
        return;
    };
    if model.breaks.is_empty() {
        model.message = Some("there are no break points: b sets one".to_owned());
        return;
    }
    let from = session.cursor().position();
    model.running = Some(LogRun { forward, from });
    go_on(model);
}

/// Goes on with a run for some milliseconds.
pub fn go_on(model: &mut Model) {
    let (Some(running), Some(session)) = (model.running.take(), &model.session) else {
        return;
    };
    let until = Instant::now() + AT_ONCE;
    let LogRun { forward, from } = running;
    match breaks::run(session, &model.breaks, from, forward, until) {
        breaks::Run::Paused(from) => {
            model.running = Some(LogRun { forward, from });
            let all = session.tree().events.len();
            model.message = Some(format!("running: event {from} of {all}; any key stops"));
        }
        breaks::Run::Ended => {
            let end = if forward { "the end" } else { "the start" };
            model.message = Some(format!("no break point on the way to {end}"));
        }
        breaks::Run::Stopped(event, by) => {
            history::leave(model);
            stop(model, event, by);
        }
    }
}

/// A break point stopped the run at an event.
fn stop(model: &mut Model, event: usize, by: usize) {
    let (Some(session), Some(point)) = (&mut model.session, model.breaks.get(by)) else {
        return;
    };
    session.go_to_event(event);
    let counted = point.count(session, event);
    let told = counted.map_or(String::new(), |(n, all)| format!(": {n} of {all}"));
    model.message = Some(format!("{}{told}", point.text));
}
