//! Horizon: the event of a log behind which nothing is known until a question is answered, and the moves that would pass it.

use super::cursor::{Cursor, StepCommand, traversal_end};
use crate::probe::Event;
use crate::trace::RayTree;

/// What is said of a move that would pass it.
pub const BEHIND: &str = "that is behind the question; answer it first";

/// True if a command leads past the end of what is known.
pub fn is_behind(cursor: Cursor, command: StepCommand, known: &RayTree) -> bool {
    let here = cursor.position();
    let is_last = here + 1 >= known.events.len();
    match command {
        StepCommand::Forward => is_last,
        StepCommand::Over => match known.events.get(here) {
            Some(Event::Ray(_)) => is_out_behind(here, known),
            Some(Event::Visit(_) | Event::Test { .. }) => {
                traversal_end(known, here) >= known.events.len()
            }
            _ => is_last,
        },
        StepCommand::Out => is_out_behind(here, known),
        StepCommand::End => true,
        // What comes next may come behind it.
        StepCommand::NextRay(_)
        | StepCommand::NextSent
        | StepCommand::NextOfLevel
        | StepCommand::NextAbsent => cursor.after(command, known).is_none(),
        StepCommand::Back
        | StepCommand::PreviousRay(_)
        | StepCommand::PreviousSent
        | StepCommand::PreviousOfLevel
        | StepCommand::PreviousAbsent
        | StepCommand::Start => false,
    }
}

/// True if the return that [`Cursor::out`] leads to is not known.
fn is_out_behind(here: usize, known: &RayTree) -> bool {
    let Some(node) = known.node_of_event(here) else {
        return here + 1 >= known.events.len();
    };
    if known.is_done(node) && known.node(node).last_event as usize == here {
        return match known.node(node).parent {
            Some(parent) => !known.is_done(parent),
            None => here + 1 >= known.events.len(),
        };
    }
    !known.is_done(node)
}
