//! Lines around the panes: title, status of the pixel, key hints.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Clear, Widget};

use super::text::{columns, padded, shortened, wrap, write};
use super::theme;
use crate::debug::effects::deviations;
use crate::lab::show::{ShowMode, ShownRange, ShownValue};
use crate::math::Rgb;
use crate::scene::{Scene, trace_command};
use crate::trace::format::{counted, num};
use crate::tui::model::bindings::ACTIONS;
use crate::tui::model::{Context, Model, Overlay, Prompt};

/// What stands at the end of the hints if there are more.
const MORE: &str = " ... ?";

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
        line.push_span(format!("{count} cut ({share:.1} %)  "));
    }
    remark(&mut line, changed(&session.world.scene));
    remark(&mut line, deviations(&session.settings, &model.findings));
    line.push_span(theme::swatch(
        trace.pixel.color * session.settings.image.exposure,
        model.options.color,
    ));
    let rays = counted(trace.pixel.rays, "ray");
    line.push_span(format!(" sRGB ({r}, {g}, {b})  {rays}"));
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
    let mut line = Line::from(Span::raw(format!(" ({x}, {y}) ")).bold());
    warned(&mut line, model);
    remark(&mut line, changed(&model.world.scene));
    remark(&mut line, deviations(&model.settings, &model.findings));
    match model.picture.exact((x, y)) {
        Some(value) if model.show.is_some() => {
            line.push_span(Span::raw(shown(model, value)).bold());
        }
        Some(ShownValue::Color(color)) => {
            let shown = color * model.settings.image.exposure;
            let [r, g, b] = shown.to_srgb8();
            line.push_span(theme::swatch(shown, model.options.color));
            let Rgb {
                r: lr,
                g: lg,
                b: lb,
            } = color;
            let (lr, lg, lb) = (short(lr), short(lg), short(lb));
            line.push_span(format!(
                " sRGB ({r}, {g}, {b})  linear ({lr}, {lg}, {lb})  "
            ));
        }
        _ => line.push_span("rendering ...  "),
    }
    line.push_span(Span::raw(model.picked.clone()));
    if let Some(search) = &model.search {
        line.push_span("  ");
        line.push_span(Span::raw(search.told((x, y))).bold());
    }
    if area.height >= 1 {
        write(buffer, area.x, area.y, &line, area.width);
    }
    if area.height >= 2 {
        let mut again = Line::from(Span::raw(format!(" {}", rerun(model))).style(theme::dim()));
        again.push_span(busy(model));
        write(buffer, area.x, area.y + 1, &again, area.width);
    }
}

/// What the pixel shows in the place of its colour, and the range of the picture.
fn shown(model: &Model, value: ShownValue) -> String {
    let mode = model.show.map_or("", ShowMode::unit);
    match (value, model.picture.range()) {
        (ShownValue::Number(x), Some(ShownRange(least, most))) => {
            format!("{mode}: {} of {} to {}  ", num(x), num(least), num(most))
        }
        _ => format!("{mode}  "),
    }
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

/// A prompt with what was typed; where something is told about it, in few words.
fn asked(model: &Model, prompt: Prompt, text: &str) -> String {
    let is_short = model.message.is_some();
    let label = match (prompt, &model.session) {
        (Prompt::Search, _) => "find".to_owned(),
        (Prompt::GoTo, _) if is_short => "go to".to_owned(),
        (Prompt::GoTo, Some(session)) => {
            let last = session.tree().events.len().saturating_sub(1);
            format!("event (0 to {last}) or address")
        }
        (Prompt::GoTo, None) => "pixel or address".to_owned(),
        (Prompt::Set, _) if is_short => "set".to_owned(),
        (Prompt::Set, _) => "set (flag=value or kind.name.field=value)".to_owned(),
        (Prompt::Note, _) => "note".to_owned(),
        (Prompt::Write, _) => "new file for the marks".to_owned(),
        (Prompt::WritePatch, _) => "new file for the patch".to_owned(),
        (Prompt::Compare, _) if is_short => "compare".to_owned(),
        (Prompt::Compare, _) => "compare with X,Y, flag=value or a file".to_owned(),
    };
    format!(" {label}: {text}▏ ")
}

/// Writes a message for which there is no room beside what is typed on the lines above.
fn above(message: &str, area: Rect, buffer: &mut Buffer) {
    let lines = wrap(message, usize::from(area.width).saturating_sub(2));
    let count = (lines.len() as u16).min(area.y);
    let box_above = Rect {
        y: area.y - count,
        height: count,
        ..area
    };
    Clear.render(box_above, buffer);
    for (y, text) in (box_above.y..area.y).zip(lines) {
        let text = padded(&format!(" {text}"), area.width.into());
        let line = Line::from(Span::raw(text).bold().reversed());
        write(buffer, area.x, y, &line, area.width);
    }
}

/// What the keys do here, as many as there is room for.
pub fn hint(model: &Model, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let mut line = Line::default();
    if let Some(Overlay::Prompt(prompt, text)) = &model.overlay {
        line.push_span(Span::raw(asked(model, *prompt, text)).bold());
    }
    if let Some(message) = &model.message {
        let is_asked = line.width() > 0;
        if is_asked && line.width() + columns(message) + 2 > usize::from(area.width) {
            above(message, area, buffer);
        } else {
            line.push_span(Span::raw(format!(" {message} ")).bold());
        }
    }
    let context = model.context();
    let here = |c: Context| c == context || c == Context::Always;
    let mut bindings: Vec<_> = ACTIONS
        .iter()
        .filter(|b| b.hint && here(b.context))
        .collect();
    // Help and back are always in sight.
    bindings.sort_by_key(|b| !matches!(b.name, "help" | "back"));
    for binding in bindings {
        let name = if binding.name == "back" && context == Context::Picture {
            "quit"
        } else {
            binding.name
        };
        let key = Span::styled(format!(" {}", binding.short_label()), theme::keycap());
        let name = Span::raw(format!(" {name} "));
        // Where keys are left out, that is said.
        let room = usize::from(area.width).saturating_sub(columns(MORE));
        if line.width() + key.width() + name.width() > room {
            line.push_span(Span::raw(MORE).style(theme::dim()));
            break;
        }
        line.push_span(key);
        line.push_span(name);
    }
    write(buffer, area.x, area.y, &line, area.width);
}
