//! Lines above and below the panes: title, status of the pixel.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Style, Stylize as _};
use ratatui::text::{Line, Span};

use super::text::{columns, shortened, write};
use super::theme;
use crate::debug::effects::deviations;
use crate::lab::show::{ShownRange, ShownValue, scale};
use crate::scene::{Scene, trace_command};
use crate::trace::explain::UNKNOWN;
use crate::trace::format::{counted, num};
use crate::tui::model::Model;
use crate::tui::model::ask::AskState;

/// How long a pixel may take before a spinner turns, in milliseconds.
const PATIENCE: u128 = 100;

/// The scene, the pixel, its colour.
pub fn title(model: &Model, area: Rect, buffer: &mut Buffer) {
    let Some(session) = &model.session else {
        return;
    };
    let trace = &session.trace;
    let [r, g, b] = (trace.pixel.color * session.settings.image.exposure).to_srgb8();
    let mut line = Line::from(format!("pixel ({}, {})  ", trace.x, trace.y));
    if !trace.pixel.cuts.is_empty() {
        let (count, share) = (trace.pixel.cuts.count(), 100.0 * trace.pixel.cut_share());
        let rays = counted(count, "ray");
        line.push_span(format!("{rays} cut ({share:.1} %)  "));
    }
    let is_bent = model.ask.as_ref().is_some_and(AskState::is_of_a_bug);
    remark(&mut line, is_bent.then(|| "a broken tracer".to_owned()));
    remark(&mut line, changed(&session.world.scene));
    remark(&mut line, left_out(model));
    if trace.is_whole() {
        line.push_span(theme::swatch(
            trace.pixel.color * session.settings.image.exposure,
            model.options.color,
        ));
        let rays = counted(trace.pixel.rays, "ray");
        line.push_span(format!(" sRGB ({r}, {g}, {b})  {rays}"));
    } else {
        line.push_span(format!("{UNKNOWN} sRGB {UNKNOWN}  {UNKNOWN} rays"));
    }
    if trace.tree.dropped > 0 {
        let text = format!(
            "  the log is full: {} events were not kept",
            trace.tree.dropped
        );
        line.push_span(Span::raw(text).bold());
    }
    line.push_span(Span::raw(busy(model)));
    // The name takes what the rest leaves, or an eighth.
    let width = usize::from(area.width);
    let room = width.saturating_sub(line.width() + 3).max(width / 8);
    let name = format!(" {}  ", shortened(&session.world.scene.name, room));
    line.spans.insert(0, Span::raw(name).bold());
    write(buffer, area.x, area.y, &line, area.width);
}

/// The pixel under the cursor, and how to trace it again.
pub fn status(model: &Model, area: Rect, buffer: &mut Buffer) {
    let (x, y) = model.picture.cursor;
    let mut linear = String::new();
    let mut line = Line::from(Span::raw(format!(" ({x}, {y}) ")).bold());
    warned(&mut line, model);
    remark(&mut line, changed(&model.world.scene));
    remark(&mut line, left_out(model));
    if let Some(search) = &model.search {
        line.push_span(Span::raw(format!("{}  ", search.told((x, y)))).bold());
    }
    match model.shown().exact((x, y)) {
        Some(value) if model.unit().is_some() => line.extend(shown(model, value)),
        Some(ShownValue::Color(color)) => {
            let shown = color * model.settings.image.exposure;
            let [r, g, b] = shown.to_srgb8();
            line.push_span(theme::swatch(shown, model.options.color));
            line.push_span(format!(" sRGB ({r}, {g}, {b})  "));
            let [r, g, b] = color.channels().map(short);
            linear = format!("  linear ({r}, {g}, {b})");
        }
        _ if model.picture.hidden == Some((x, y)) => {
            line.push_span(format!("sRGB {UNKNOWN}"));
            write(buffer, area.x, area.y, &line, area.width);
            return;
        }
        _ => line.push_span("rendering ...  "),
    }
    line.push_span(Span::raw(model.picked.clone()));
    if line.width() + columns(&linear) <= usize::from(area.width) {
        line.push_span(linear);
    }
    if area.height >= 1 {
        write(buffer, area.x, area.y, &line, area.width);
    }
    // The command would name what is broken.
    let is_bent = model.ask.as_ref().is_some_and(AskState::is_of_a_bug);
    if area.height >= 2 && !is_bent {
        let mut again = Line::from(Span::raw(format!(" {}", rerun(model))).style(theme::dim()));
        again.push_span(busy(model));
        write(buffer, area.x, area.y + 1, &again, area.width);
    }
}

/// Bars of a histogram, from a few to all.
const BARS: [&str; 8] = ["▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"];

/// What the pixel shows in the place of its colour, and a legend: the range of the picture, with a bar for each tenth of it in its
/// colour, as high as there are many such pixels.
fn shown(model: &Model, value: ShownValue) -> Vec<Span<'static>> {
    let mode = model.unit().unwrap_or_default();
    let (ShownValue::Number(x), Some((range, bins))) = (value, model.shown().tenths()) else {
        return vec![Span::raw(format!("{mode}  ")).bold()];
    };
    let most = bins.iter().copied().max().unwrap_or(0).max(1);
    let bar = |(tenth, count): (usize, &usize)| {
        let bar = if *count == 0 {
            " "
        } else {
            BARS[(count * 8).div_ceil(most).clamp(1, 8) - 1]
        };
        let color = theme::screen(scale((tenth as f64 + 0.5) / 10.0));
        Span::styled(bar, Style::new().fg(color))
    };
    let ShownRange(least, largest) = range;
    let mut spans = vec![
        Span::raw(format!("{mode}: {}  ", num(x))).bold(),
        Span::raw(format!("{} ", num(least))),
    ];
    spans.extend(bins.iter().enumerate().map(bar));
    spans.push(Span::raw(format!(" {}  ", num(largest))));
    spans
}

/// How many warnings there are, and how to see them.
fn warned(line: &mut Line, model: &Model) {
    let told = match model.warnings().len() {
        0 => return,
        1 => " 1 warning: press w ".to_owned(),
        n => format!(" {n} warnings: press w "),
    };
    line.push_span(Span::styled(told, theme::warning()));
    line.push_span("  ");
}

/// What is not computed as usual: never to be overlooked.
fn remark(line: &mut Line, deviations: Option<String>) {
    if let Some(told) = deviations {
        line.push_span(Span::styled(format!(" {told} "), theme::warning()));
        line.push_span("  ");
    }
}

/// What is not computed as usual; before a question that stands beside it.
fn left_out(model: &Model) -> Option<String> {
    let is_told = model.ask.as_ref().is_some_and(|ask| !ask.remark.is_empty());
    let settings = model
        .session
        .as_ref()
        .map_or(&model.settings, |s| &s.settings);
    (!is_told).then(|| deviations(settings, &model.findings))?
}

/// How many numbers of the scene are changed, and how to see them.
fn changed(scene: &Scene) -> Option<String> {
    match scene.changes.len() {
        0 => None,
        1 => Some("1 change: press C".to_owned()),
        n => Some(format!("{n} changes: press C")),
    }
}

fn short(x: f64) -> String {
    let text = format!("{x:.4}");
    if x.abs() < 1000.0 { text } else { num(x) }
}

/// What the background is doing.
fn busy(model: &Model) -> String {
    let changing = model.changing.as_ref().map(|change| change.since);
    let jobs = [
        (changing, "changing the scene"),
        (model.waiting, "tracing the pixel"),
    ];
    for (since, what) in jobs {
        let waited = since.map_or(0, |since| since.elapsed().as_millis());
        if waited >= PATIENCE {
            let turn = ["-", "\\", "|", "/"][(waited / 100 % 4) as usize];
            return format!("  {turn} {what} (Esc gives up)");
        }
    }
    let progress = model.picture.progress();
    if model.session.is_none() && progress < 1.0 {
        return format!("  rendering {:.0} %", (progress * 100.0).floor());
    }
    String::new()
}

/// The command that traces the pixel under the cursor as text.
pub fn rerun(model: &Model) -> String {
    trace_command(
        &model.options.scene,
        &model.world.scene,
        &model.settings,
        model.picture.cursor,
    )
}
