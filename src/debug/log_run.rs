//! Runs through the log to the next break point, forwards or backwards, a few milliseconds at a time.

#[cfg(test)]
mod tests;

use std::time::Instant;

use super::breaks::BreakPoint;
use super::session::Session;

/// Events between two looks at the clock.
const BETWEEN: usize = 256;

/// Events of a large tree in which the first stop is looked for.
const LOOKED_AT: usize = 1000;

/// A run that is under way.
///
/// A break point at every third event counts from the first event of the log, whichever way the run goes: so a run back stops where a
/// run forward does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LogRun {
    /// Whether forwards, or backwards.
    pub forward: bool,
    /// The event that it came to.
    pub at: usize,
    /// The events before this one have been counted.
    counted: usize,
    /// Where it begins, and the events to be counted before it can: none if no break point counts.
    to_count: usize,
    /// Of each break point the events that fit, before `at` or (forwards) up to it.
    counts: Vec<usize>,
}

/// What a run came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// It stops at this event, because of the break point with this number.
    Stopped(usize, usize),
    /// It came to the end of the log.
    Ended,
    /// The time was over.
    Paused,
}

impl LogRun {
    /// A run from an event on, at which itself it does not stop.
    pub fn new(points: &[BreakPoint], from: usize, forward: bool) -> Self {
        let counts = !points.iter().all(BreakPoint::is_single);
        Self {
            forward,
            at: from,
            counted: 0,
            to_count: if counts {
                from + usize::from(forward)
            } else {
                0
            },
            counts: vec![0; points.len()],
        }
    }

    /// Runs until a break point stops it or the time is over.
    pub fn go_on(&mut self, session: &Session, points: &[BreakPoint], until: Instant) -> Run {
        for step in 1.. {
            if self.counted < self.to_count {
                self.count(session, points);
            } else if let Some(end) = self.step(session, points) {
                return end;
            }
            if step % BETWEEN == 0 && Instant::now() >= until {
                return Run::Paused;
            }
        }
        Run::Ended
    }

    /// Counts at one more of the events that come before the start.
    fn count(&mut self, session: &Session, points: &[BreakPoint]) {
        for (point, count) in points.iter().zip(&mut self.counts) {
            *count += usize::from(!point.is_single() && point.fits(session, self.counted));
        }
        self.counted += 1;
    }

    /// Goes to the next event. Nothing if the run goes on from there.
    fn step(&mut self, session: &Session, points: &[BreakPoint]) -> Option<Run> {
        let last = session.tree().events.len();
        let next = if self.forward {
            Some(self.at + 1).filter(|next| *next < last)
        } else {
            self.at.checked_sub(1)
        };
        let Some(next) = next else {
            return Some(Run::Ended);
        };
        self.at = next;
        let mut stopped = None;
        let numbered = points.iter().zip(&mut self.counts).enumerate();
        for (by, (point, count)) in numbered {
            if !point.fits(session, self.at) {
                continue;
            }
            if self.forward {
                *count += 1;
            }
            if point.is_single() || point.stops_at_nth(*count) {
                stopped = stopped.or(Some(by));
            }
            if !self.forward {
                *count = count.saturating_sub(1);
            }
        }
        stopped.map(|by| Run::Stopped(next, by))
    }
}

/// All break points: how often each stops a run through this tree, and where it does first.
pub fn list(session: &Session, points: &[BreakPoint]) -> Vec<(String, Option<usize>)> {
    let here = session.cursor().position();
    let line = |point: &BreakPoint| {
        if let Some(all) = point.all(session) {
            let counted = point.counted(session, &all, here);
            return (format!("{}: {counted}", point.text), point.first_stop(&all));
        }
        let first = (0..LOOKED_AT).find(|at| point.is_single() && point.fits(session, *at));
        let told = format!("{}: not counted, it would take long", point.text);
        (told, first)
    };
    points.iter().map(line).collect()
}
