//! Which rows of a list a pane shows: the current one stands in the middle.

use crate::debug::Session;

/// The first row of the tree that a pane of `height` rows shows.
pub fn first_row(session: &Session, height: u16) -> usize {
    first_shown(session.row(), session.rows.len(), height)
}

/// The first traversal step, as the index of its event, that a pane of `height` rows shows.
pub fn first_step(session: &Session, height: u16) -> usize {
    let steps = session.steps();
    let here = session.cursor().position().saturating_sub(steps.start);
    steps.start + first_shown(here, steps.len(), step_rows(height))
}

/// How many steps a pane of `height` rows shows: where there is room, two rows are for the t axis.
pub fn step_rows(height: u16) -> u16 {
    if height < 8 { height } else { height - 2 }
}

/// The first of `count` rows that is shown in a pane of `height` rows, such that row `current` stands in the middle.
fn first_shown(current: usize, count: usize, height: u16) -> usize {
    let height = usize::from(height);
    let last = count.saturating_sub(height);
    current.saturating_sub(height / 2).min(last)
}
