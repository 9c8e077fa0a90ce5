//! Whole screen: every pane at its area, and what lies over them.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Widget};

use super::text::shortened;
use super::{
    ask, bars, convergence, details, effects, help, hints, list, paths, picture, report, steps,
    theme, tree, warnings, watches,
};
use crate::debug::Session;
use crate::tui::model::layout::covered;
use crate::tui::model::{Model, Pane, Panes, inside};

/// Draws the model.
pub fn draw(model: &Model, screen: Rect, buffer: &mut Buffer) {
    let panes = model.panes_on(screen);
    bars::title(model, panes.title, buffer);
    bars::status(model, panes.status, buffer);
    if model.session.is_some() {
        let (x, y) = model.picture.cursor;
        let mut title = format!(" picture, pixel {x},{y} ");
        if title.len() + 3 > usize::from(panes.picture.width) {
            title = format!(" {x},{y} ");
        }
        let title = Line::raw(title);
        frame(model, Pane::Picture, &panes, title, buffer);
    }
    picture::draw(model, &model.placement(&panes), buffer);
    if let Some(session) = &model.session {
        for pane in Pane::FOCUS {
            around_tree(model, session, pane, &panes, buffer);
        }
    }
    if let Some(ask) = &model.ask {
        ask::draw(ask, panes.ask, buffer);
    }
    convergence::draw(model, &panes, buffer);
    let over = covered(screen);
    effects::draw(model, over, buffer);
    warnings::draw(model, over, buffer);
    report::draw(model, over, buffer);
    list::draw(model, over, buffer);
    help::draw(model, over, buffer);
    hints::hint(model, panes.hint, buffer);
    hints::message(model, &panes, buffer);
    theme::quantize_colors(buffer, model.options.color);
}

/// A pane of an open tree.
fn around_tree(model: &Model, session: &Session, pane: Pane, panes: &Panes, buffer: &mut Buffer) {
    let (level, layout) = (model.options.color, &model.layout);
    let title = match pane {
        Pane::Picture => return,
        Pane::Tree => tree::title(session),
        Pane::Details => details::title(session),
        Pane::Steps => {
            let taken = if layout.focus == pane { 3 } else { 2 };
            steps::title(session, panes.area(pane).width.saturating_sub(taken))
        }
        Pane::Path => paths::title(layout.axis),
    };
    let Some(area) = frame(model, pane, panes, title, buffer) else {
        return;
    };
    match pane {
        Pane::Picture => {}
        Pane::Tree => tree::draw(session, level, area, buffer),
        Pane::Details => {
            let rest = watches::draw(model, area, buffer);
            details::draw(session, layout.scroll, level, rest, buffer);
        }
        Pane::Steps => steps::draw(session, area, buffer),
        Pane::Path => {
            let seen = (layout.axis, layout.fan);
            paths::draw(session, &model.outlines, seen, area, buffer);
        }
    }
}

/// Draws the frame of a pane and gives its inside; `None` if it is not shown.
fn frame(
    model: &Model,
    pane: Pane,
    panes: &Panes,
    mut title: Line,
    buffer: &mut Buffer,
) -> Option<Rect> {
    let area = panes.area(pane);
    let mut block = Block::bordered().border_style(theme::dim());
    // Titles are cut with a sign as well.
    let room = usize::from(area.width.saturating_sub(3));
    if title.width() > room {
        title = Line::raw(shortened(&title.to_string(), room));
    }
    if model.layout.focus == pane {
        block = block
            .border_type(BorderType::Double)
            .border_style(Style::new().bold());
        title.spans.insert(0, Span::raw(theme::POINTER));
        title = title.bold();
    }
    block.title(title).render(area, buffer);
    let inside = inside(area);
    (!inside.is_empty()).then_some(inside)
}
