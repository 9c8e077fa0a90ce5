//! Drawing: a function of the state that cannot change it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Widget};

use super::app::App;
use super::layout::{Pane, Panes, inside};
use super::{
    bars, details, effects, help, nearing, path_pane, picture_pane, steps_pane, theme, tree_pane,
};

impl Widget for &App {
    fn render(self, screen: Rect, buffer: &mut Buffer) {
        let panes = Panes::new(screen, self.shown());
        bars::title(self, panes.title, buffer);
        bars::status(self, panes.status, buffer);
        picture(self, &panes, buffer);
        if let Some(session) = &self.session {
            let level = self.options.color;
            if let Some(place) = frame(self, Pane::Tree, &panes, tree_pane::title(session), buffer)
            {
                tree_pane::draw(session, level, place, buffer);
            }
            if let Some(place) = frame(self, Pane::Details, &panes, details::title(session), buffer)
            {
                details::draw(session, level, place, buffer);
            }
            if let Some(place) = frame(
                self,
                Pane::Steps,
                &panes,
                steps_pane::title(session),
                buffer,
            ) {
                steps_pane::draw(session, place, buffer);
            }
            let title = path_pane::title(self.axis);
            if let Some(place) = frame(self, Pane::Path, &panes, title, buffer) {
                path_pane::draw(session, &self.outlines, self.axis, place, buffer);
            }
        }
        nearing::draw(self, &panes, buffer);
        effects::draw(self, screen, buffer);
        help::draw(self, screen, buffer);
        bars::hint(self, panes.hint, buffer);
        theme::lower(buffer, self.options.color);
    }
}

fn picture(app: &App, panes: &Panes, buffer: &mut Buffer) {
    if app.session.is_some() {
        let (x, y) = app.picture.cursor;
        frame(
            app,
            Pane::Picture,
            panes,
            Line::raw(format!(" picture, pixel {x},{y} ")),
            buffer,
        );
    }
    picture_pane::draw(app, &picture_pane::placement(app, panes), buffer);
}

/// Draws the frame of a pane and gives its inside; `None` if it is not shown.
fn frame(app: &App, pane: Pane, panes: &Panes, title: Line, buffer: &mut Buffer) -> Option<Rect> {
    let place = panes.place(pane);
    let focused = app.focus == pane;
    let mut block = Block::bordered().border_style(theme::dim());
    let mut title = title;
    if focused {
        block = block
            .border_type(BorderType::Double)
            .border_style(Style::new().bold());
        title.spans.insert(0, Span::raw(theme::POINTER));
        title = title.bold();
    }
    block.title(title).render(place, buffer);
    let inside = inside(place);
    (!inside.is_empty()).then_some(inside)
}

/// Writes a line at a place of the screen, cut at `width`.
pub fn write(buffer: &mut Buffer, x: u16, y: u16, line: &Line, width: u16) {
    if buffer.area.contains((x, y).into()) {
        buffer.set_line(x, y, line, width.min(buffer.area.right() - x));
    }
}
