//! Traversal pane: the current ray's steps through the acceleration structure.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Style, Stylize as _};
use ratatui::text::{Line, Span};

use super::text::{arrows, write};
use super::theme;
use crate::debug::steps::visited_and_tested;
use crate::debug::{Session, StepKind, StepText};
use crate::tui::model::state::first_step;

/// Its title.
pub fn title(session: &Session) -> Line<'static> {
    let steps = session.steps();
    let here = session.cursor().position();
    let kind = session.settings.accel.name();
    if steps.contains(&here) {
        let (n, of) = (here - steps.start + 1, steps.len());
        return Line::raw(format!(" {kind} step {n} of {of} "));
    }
    if steps.is_empty() {
        return Line::raw(format!(" {kind} "));
    }
    let all = session.world.accel.stats().nodes;
    let shapes = session.world.scene.shapes.len();
    let (visited, tested) = visited_and_tested(session);
    Line::raw(format!(
        " {kind}: {visited} of {all} nodes, {tested} of {shapes} shapes "
    ))
}

/// Draws the steps around the current one.
pub fn draw(session: &Session, area: Rect, buffer: &mut Buffer) {
    let steps = session.steps();
    if steps.is_empty() {
        let text = "this ray was not searched for anything";
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
    let shown = first_step(session, area.height)..steps.end;
    let (above, below) = (
        shown.start > steps.start,
        shown.len() > usize::from(area.height),
    );
    arrows(buffer, area, above, below);
    for (y, index) in (area.y..area.bottom()).zip(shown) {
        let current = index == here;
        let mut line = Line::from(Span::raw(if current { theme::POINTER } else { " " }).bold());
        if let Some(step) = StepText::new(session, index) {
            line.extend(spans(step));
        }
        write(buffer, area.x, y, &line, area.width);
        if current {
            let row = Rect::new(area.x + 1, y, area.width.saturating_sub(1), 1);
            buffer.set_style(row.intersection(buffer.area), theme::current());
        }
    }
}

/// A step: skipped nodes and shapes that are not hit step back.
fn spans(step: StepText) -> Vec<Span<'static>> {
    let (name, result) = match step.kind {
        StepKind::Visited => (Style::new().bold(), Style::new()),
        StepKind::Skipped => (theme::dim().bold(), theme::dim()),
        StepKind::Hit => (Style::new(), Style::new().bold()),
        StepKind::NoHit => (Style::new(), theme::dim()),
    };
    vec![
        Span::styled(step.name, name),
        Span::styled(step.result, result),
        Span::styled(step.interval, theme::dim()),
    ]
}
