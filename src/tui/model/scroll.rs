//! Scrolling of lists that keep the current row in the middle.

/// The first of `count` rows that is shown in a pane of `height` rows, such that row `current` stands in the middle.
pub fn first_shown(current: usize, count: usize, height: u16) -> usize {
    let height = usize::from(height);
    let last = count.saturating_sub(height);
    current.saturating_sub(height / 2).min(last)
}
