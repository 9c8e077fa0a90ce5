//! Error over time on log axes, as lines of text.

use std::fmt::Write as _;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::symbols::Marker;
use ratatui::text::Line;
use ratatui::widgets::{Axis, Chart, Dataset, GraphType, Widget};

use crate::lab::{Sweep, plot};

const WIDTH: u16 = 78;
const HEIGHT: u16 = 18;

/// A sweep in the chart: its letter, its name and its points.
type ChartLine = (char, String, Vec<(f64, f64)>);

/// The sweeps that have an error: seconds to the right, RMSE upwards. Empty if there are none.
pub fn lines(sweeps: &[Sweep]) -> String {
    let plotted = plot::plotted(sweeps).into_iter();
    let lines: Vec<ChartLine> = plotted
        .map(|(letter, name, points)| {
            let points = points.into_iter().map(|[x, y]| (x, y));
            (letter, name, points.collect())
        })
        .collect();
    if lines.is_empty() {
        return String::new();
    }
    let all = || lines.iter().flat_map(|(_, _, points)| points);
    let x = plot::range(all().map(|p| p.0));
    let y = plot::range(all().map(|p| p.1));
    let datasets: Vec<Dataset> = lines
        .iter()
        .map(|(letter, _, points)| {
            Dataset::default()
                .marker(Marker::Custom(*letter))
                .graph_type(GraphType::Scatter)
                .data(points)
        })
        .collect();
    let axis = |(low, high): (f64, f64), unit: &str| {
        let powers = (low as i32..=high as i32).map(|power| Line::raw(format!("1e{power}{unit}")));
        Axis::default()
            .bounds([low, high])
            .labels(powers.collect::<Vec<_>>())
    };
    let area = Rect::new(0, 0, WIDTH, HEIGHT);
    let mut buffer = Buffer::empty(area);
    Chart::new(datasets)
        .x_axis(axis(x, " s").title("seconds a picture".bold()))
        .y_axis(axis(y, "").title("RMSE".bold()))
        .legend_position(None)
        .render(area, &mut buffer);

    let mut out = String::new();
    for row in buffer.content.chunks(usize::from(WIDTH)) {
        let line: String = row.iter().map(ratatui::buffer::Cell::symbol).collect();
        out.push_str(line.trim_end());
        out.push('\n');
    }
    for (letter, name, _) in &lines {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "  {letter}  {name}");
    }
    if let Some(floor) = plot::about_floor(sweeps) {
        let _ = writeln!(out, "  {floor}");
    }
    out
}
