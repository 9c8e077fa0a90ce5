//! Traversal pane: the current ray's steps through the acceleration structure as a tree, and the t axis of the current one.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Style, Stylize as _};
use ratatui::text::{Line, Span};

use super::text::{arrows, write};
use super::theme;
use crate::debug::steps::{is_cut, totals};
use crate::debug::t_axis::TAxis;
use crate::debug::{Session, StepKind, StepText};
use crate::tui::model::first::{first_step, step_rows};

/// Its title, in at most so many columns.
pub fn title(session: &Session, width: u16) -> Line<'static> {
    let room = usize::from(width).saturating_sub(2);
    Line::raw(format!(" {} ", totals(session, room)))
}

/// Draws the steps around the current one, and the t axis of that below them.
pub fn draw(session: &Session, area: Rect, buffer: &mut Buffer) {
    let steps = session.steps();
    if steps.is_empty() {
        let text = if is_cut(session) && session.node().is_some() {
            "the search is behind the question"
        } else {
            "this ray was not searched for anything"
        };
        write(
            buffer,
            area.x,
            area.y,
            &Line::from(text).style(theme::dim()),
            area.width,
        );
        return;
    }
    let here = session.cursor().position();
    let bottom = area.y + step_rows(area.height);
    let shown = first_step(session, area.height)..steps.end;
    let (above, below) = (
        shown.start > steps.start,
        shown.len() > usize::from(bottom - area.y),
    );
    arrows(buffer, area, above, below);
    let rows = (area.y..bottom).zip(shown);
    // Deep in the tree the outer lines give way to words: all rows move to the left together.
    let deepest = rows
        .clone()
        .filter_map(|(_, index)| session.step_number(index))
        .map(|step| session.step_tree.depth(step))
        .max();
    let hidden = deepest
        .unwrap_or(0)
        .saturating_sub(usize::from(area.width) / 3);
    for (y, index) in rows {
        let current = index == here;
        let mut line = Line::from(Span::raw(if current { theme::POINTER } else { " " }).bold());
        if let Some(step) = StepText::new(session, index) {
            line.extend(spans(step, hidden));
        }
        write(buffer, area.x, y, &line, area.width);
        if current {
            let row = Rect::new(area.x + 1, y, area.width.saturating_sub(1), 1);
            buffer.set_style(row.intersection(buffer.area), theme::current());
        }
    }
    if let Some(axis) = TAxis::new(session).filter(|_| bottom < area.bottom()) {
        let room = area.width.saturating_sub(1);
        let line = Line::raw(axis.line(usize::from(room)));
        write(buffer, area.x + 1, bottom, &line, room);
        let legend = Line::raw(axis.legend(usize::from(room))).style(theme::dim());
        write(buffer, area.x + 1, bottom + 1, &legend, room);
    }
}

/// A step: skipped nodes and shapes that are not hit step back.
fn spans(step: StepText, hidden: usize) -> Vec<Span<'static>> {
    let (name, result) = match step.kind {
        StepKind::Visited => (Style::new().bold(), Style::new()),
        StepKind::Skipped => (theme::dim().bold(), theme::dim()),
        StepKind::Hit => (Style::new(), Style::new().bold()),
        StepKind::NoHit => (Style::new(), theme::dim()),
    };
    let mut guides: String = step.guides.chars().skip(hidden).collect();
    if hidden > 0 && !step.guides.is_empty() {
        guides.insert(0, '‹');
    }
    vec![
        Span::styled(guides, theme::dim()),
        Span::styled(step.name, name),
        Span::styled(step.result, result),
        Span::styled(step.interval, theme::dim()),
    ]
}
