//! Break points and watched numbers: set, taken away, run to.

use std::time::Instant;

use super::{history, search};
use crate::debug::breaks::{self, BreakPoint};
use crate::debug::log_run::{LogRun, Run};
use crate::debug::watch::Watch;
use crate::tui::model::motion::AT_ONCE;
use crate::tui::model::{LongRun, Model};

/// Break points at most.
const MOST: usize = 100;

/// Watched numbers at most.
const MOST_WATCHES: usize = 6;

/// Sets a break point, or takes it away if it is there. In an open tree it tells how many events it stops at.
pub fn toggle(model: &mut Model, text: &str) -> Result<(), String> {
    let text = text.trim();
    if let Some(at) = model.breaks.iter().position(|p| p.text == text) {
        model.breaks.remove(at);
        model.message = Some(format!("no break at {text} any more"));
        return Ok(());
    }
    let point = BreakPoint::new(text, model.session.as_deref())?;
    if model.breaks.len() >= MOST {
        return Err(format!(
            "there are {MOST} break points; type one again to take it away"
        ));
    }
    let all = model.session.as_ref().and_then(|s| point.all(s));
    let place = model.session.as_ref().map_or("", |s| breaks::place(s));
    let told = match all.map(|all| all.len()) {
        None => String::new(),
        Some(count) if point.is_single() => format!(": {count} {place}"),
        Some(count) => format!(": of {count} {place}"),
    };
    model.message = Some(format!("break at {text}{told}; x runs to it, X back"));
    model.breaks.push(point);
    Ok(())
}

/// Watches a number, or no more if it is watched.
pub fn watch(model: &mut Model, text: &str) -> Result<(), String> {
    let text = text.trim();
    if let Some(at) = model.watches.iter().position(|w| w.text == text) {
        model.watches.remove(at);
        model.message = Some(format!("{text} is not watched any more"));
        return Ok(());
    }
    let Some(session) = &model.session else {
        return Err("open the ray tree of a pixel first".to_owned());
    };
    let watch = Watch::new(text, session)?;
    if model.watches.len() >= MOST_WATCHES {
        return Err(format!(
            "{MOST_WATCHES} numbers are watched; type one again to take it away"
        ));
    }
    model.watches.push(watch);
    model.message = Some(format!(
        "{text} is watched; ) runs to its next change, ( back"
    ));
    Ok(())
}

/// Runs to the next break point, or back to the one before.
pub fn run(model: &mut Model, forward: bool) {
    if model.breaks.is_empty() {
        model.message = Some("there are no break points: b sets one".to_owned());
        return;
    }
    start(model, model.breaks.clone(), forward);
}

/// Runs to where a watched number changes next, or back to where it changed last.
pub fn run_to_change(model: &mut Model, forward: bool) {
    if model.watches.is_empty() {
        model.message = Some("no number is watched: * watches one".to_owned());
        return;
    }
    let points = model.watches.iter().map(BreakPoint::at_changes).collect();
    start(model, points, forward);
}

fn start(model: &mut Model, points: Vec<BreakPoint>, forward: bool) {
    let Some(session) = &model.session else {
        return;
    };
    let run = LogRun::new(&points, session.cursor().position(), forward);
    to_break(model, run, points, Instant::now() + AT_ONCE);
}

/// Goes on with what takes long, for some milliseconds.
pub fn go_on(model: &mut Model) {
    let until = Instant::now() + AT_ONCE;
    match model.running.take() {
        None => {}
        Some(LongRun::ToBreak(run, points)) => to_break(model, run, points, until),
        Some(LongRun::ToRay(ray)) => search::go_on(model, ray, until),
    }
}

fn to_break(model: &mut Model, mut run: LogRun, points: Vec<BreakPoint>, until: Instant) {
    let Some(session) = &model.session else {
        return;
    };
    match run.go_on(session, &points, until) {
        Run::Paused => {
            let (at, all) = (run.at, session.tree().events.len());
            model.running = Some(LongRun::ToBreak(run, points));
            model.message = Some(format!("running: event {at} of {all}; any key stops"));
        }
        Run::Ended => {
            let end = match (run.forward, session.horizon()) {
                (true, Some(_)) => "the question",
                (true, None) => "the end",
                (false, _) => "the start",
            };
            let what = if points.iter().all(BreakPoint::is_change) {
                "no watched number changes"
            } else {
                "no break point"
            };
            model.message = Some(format!("{what} on the way to {end}"));
        }
        Run::Stopped(event, by) => {
            history::leave(model);
            if let Some(point) = points.get(by) {
                stop(model, event, point);
            }
        }
    }
}

/// A break point stopped the run at an event.
fn stop(model: &mut Model, event: usize, point: &BreakPoint) {
    let Some(session) = &mut model.session else {
        return;
    };
    session.go_to_event(event);
    let told = point.all(session).map_or(String::new(), |all| {
        let n = all.partition_point(|at| *at <= event);
        format!(": {n} of {}", all.len())
    });
    model.message = Some(format!("{}{told}", point.text));
}
