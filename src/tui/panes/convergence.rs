//! Convergence panel: the last point in words, and a chart of luminance and standard error over the number of samples.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Style, Stylize as _};
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Axis, Block, Chart, Clear, Dataset, GraphType, Widget};

use super::text::{wrap, write};
use super::theme;
use crate::debug::Convergence;
use crate::debug::convergence::curve::{CurvePoint, bound};
use crate::debug::convergence::error_text;
use crate::debug::convergence::measure::LAST_POWER;
use crate::tui::model::{Model, Panes, inside};

/// Where it lies: in the corner that is farthest from the pixel under the cursor; beside an open tree below at the right.
fn area(model: &Model, panes: &Panes) -> Rect {
    let all = if model.session.is_some() {
        let all = [
            panes.tree,
            panes.details,
            panes.steps,
            panes.path,
            panes.picture,
        ];
        let shown = all.into_iter().filter(|pane| !pane.is_empty());
        shown.reduce(Rect::union).unwrap_or_default()
    } else {
        panes.picture
    };
    let width = (all.width * 2 / 5).max(44).min(all.width);
    let height = (all.height * 2 / 5).max(12).min(all.height);
    let (mut right, mut below) = (true, true);
    if model.session.is_none() {
        let (column, row) = model.placement(panes).cell(model.picture.cursor);
        right = column < all.x + all.width / 2;
        below = row < all.y + all.height / 2;
    }
    Rect {
        x: if right { all.right() - width } else { all.x },
        y: if below { all.bottom() - height } else { all.y },
        width,
        height,
    }
}

/// Draws it, if it is asked for.
pub fn draw(model: &Model, panes: &Panes, buffer: &mut Buffer) {
    let Some(convergence) = &model.convergence else {
        return;
    };
    let area = area(model, panes);
    Clear.render(area, buffer);
    let (x, y) = model.picture.cursor;
    let title = format!(" pixel ({x}, {y}), more samples ");
    Block::bordered().title(title.bold()).render(area, buffer);
    let room = inside(area);
    let lines = lines(model, convergence, room.width);
    let rows = (lines.len() as u16).min(room.height);
    for (y, line) in (room.y..room.y + rows).zip(&lines) {
        write(buffer, room.x, y, line, room.width);
    }
    let chart = Rect {
        y: room.y + rows,
        height: room.height - rows,
        ..room
    };
    if chart.height > 3 {
        draw_chart(convergence, chart, buffer);
    }
}

/// The last point in words.
fn lines(model: &Model, convergence: &Convergence, width: u16) -> Vec<Line<'static>> {
    let Some(pixel) = convergence.pixels.last() else {
        return vec![Line::raw(" ...")];
    };
    let shown = pixel.color * model.settings.image.exposure;
    let mut value = Line::from(theme::swatch(shown, model.options.color));
    value.push_span(Span::raw(format!(" luminance {:.5}", pixel.color.luminance())).bold());
    let at_most = bound(&model.settings, pixel.samples);
    value.push_span(format!(" ± {at_most}{}", error_text(pixel)));
    let text = convergence.summary(pixel, &model.settings);
    let rest = wrap(&text, usize::from(width)).into_iter().map(Line::raw);
    std::iter::once(value).chain(rest).collect()
}

/// The points, with the standard error above and below.
fn draw_chart(convergence: &Convergence, area: Rect, buffer: &mut Buffer) {
    let Some([low, high]) = convergence.range() else {
        return;
    };
    let points: Vec<CurvePoint> = convergence.points().collect();
    let values: Vec<(f64, f64)> = points.iter().map(|p| (p.power, p.luminance)).collect();
    let bars: Vec<[(f64, f64); 2]> = points
        .iter()
        .filter(|p| p.error > 0.0)
        .map(|p| [-p.error, p.error].map(|by| (p.power, p.luminance + by)))
        .collect();
    let lines = |data, color| {
        Dataset::default()
            .marker(Marker::Braille)
            .graph_type(GraphType::Line)
            .style(Style::new().fg(color))
            .data(data)
    };
    let mut datasets: Vec<Dataset> = bars.iter().map(|bar| lines(bar, ERROR)).collect();
    datasets.push(lines(&values, VALUE));
    let samples: Vec<String> = (0..=LAST_POWER)
        .step_by(3)
        .map(|power| (1u32 << power).to_string())
        .collect();
    let value = |y: f64| format!("{y:.4}");
    Chart::new(datasets)
        .x_axis(
            Axis::default()
                .bounds([0.0, f64::from(LAST_POWER)])
                .labels(samples)
                .style(theme::dim()),
        )
        .y_axis(
            Axis::default()
                .bounds([low, high])
                .labels([low, f64::midpoint(low, high), high].map(value))
                .style(theme::dim()),
        )
        .legend_position(None)
        .render(area, buffer);
}

/// The line of the values.
const VALUE: Color = Color::Rgb(204, 150, 30);

/// The bars of the standard errors.
const ERROR: Color = Color::Rgb(70, 145, 225);
