//! The lines around the panes: title, status of the pixel, keys.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::actions::{ACTIONS, Context};
use super::app::{App, Overlay};
use super::draw::write;
use super::theme;
use crate::math::Rgb;
use crate::scene::effects::Finding;
use crate::scene::{Settings, flags};
use crate::trace::format::num;

/// How long a pixel may take before a spinner turns, in milliseconds.
const PATIENCE: u128 = 100;

/// The scene, the pixel, its colour.
pub fn title(app: &App, place: Rect, buffer: &mut Buffer) {
    let Some(session) = &app.session else {
        return;
    };
    let trace = &session.trace;
    let [r, g, b] = (trace.pixel.color * session.settings.image.exposure).to_srgb8();
    let mut line = Line::from(vec![
        Span::raw(format!(" {}  ", session.world.scene.name)).bold(),
        Span::raw(format!("pixel ({}, {})  ", trace.x, trace.y)),
    ]);
    if let Some(told) = deviations(&session.settings, &app.findings) {
        line.push_span(told);
        line.push_span("  ");
    }
    line.push_span(theme::swatch(
        trace.pixel.color * session.settings.image.exposure,
        app.options.color,
    ));
    line.push_span(format!(" sRGB ({r}, {g}, {b})  {} rays", trace.pixel.rays));
    if trace.tree.dropped > 0 {
        let text = format!(
            "  the log is full: {} events were not kept",
            trace.tree.dropped
        );
        line.push_span(Span::raw(text).bold());
    }
    line.push_span(Span::raw(busy(app)));
    write(buffer, place.x, place.y, &line, place.width);
}

/// The pixel under the cursor, and how to trace it again.
pub fn status(app: &App, place: Rect, buffer: &mut Buffer) {
    let (x, y) = app.picture.cursor;
    let mut line = Line::from(Span::raw(format!(" ({x}, {y}) ")).bold());
    if let Some(told) = deviations(&app.settings, &app.findings) {
        line.push_span(told);
        line.push_span("  ");
    }
    match app.picture.exact((x, y)) {
        Some(color) => {
            let shown = color * app.settings.image.exposure;
            let [r, g, b] = shown.to_srgb8();
            line.push_span(theme::swatch(shown, app.options.color));
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
        None => line.push_span("rendering ...  "),
    }
    line.push_span(Span::raw(app.seen.clone()));
    if place.height >= 1 {
        write(buffer, place.x, place.y, &line, place.width);
    }
    if place.height >= 2 {
        let mut again = Line::from(Span::raw(format!(" {}", rerun(app))).style(theme::dim()));
        again.push_span(busy(app));
        write(buffer, place.x, place.y + 1, &again, place.width);
    }
}

fn short(x: f64) -> String {
    let text = format!("{x:.4}");
    if x.abs() < 1000.0 { text } else { num(x) }
}

/// What the background is doing.
fn busy(app: &App) -> String {
    if let Some(since) = app.waiting {
        let waited = since.elapsed().as_millis();
        if waited >= PATIENCE {
            let turn = ["-", "\\", "|", "/"][(waited / 100 % 4) as usize];
            return format!("  {turn} tracing the pixel (Esc gives up)");
        }
    }
    let progress = app.picture.progress();
    if app.session.is_none() && progress < 1.0 {
        return format!("  rendering {:.0} %", (progress * 100.0).floor());
    }
    String::new()
}

/// The command that traces the pixel under the cursor as text.
pub fn rerun(app: &App) -> String {
    let (width, height) = app.settings.size();
    let (x, y) = app.picture.cursor;
    let mut command = format!(
        "raytree trace {} --size {width}x{height} --pixel {x},{y}",
        app.options.scene
    );
    for (flag, value) in flags(&app.settings, &app.world.scene) {
        command.extend([" --", flag, " ", &value]);
    }
    command
}

/// What is not computed as raytree would do it, and what is left out: never to be overlooked.
fn deviations(settings: &Settings, findings: &[Finding]) -> Option<Span<'static>> {
    let list = settings.arithmetic.deviations().into_iter();
    let mut told: Vec<_> = list.map(|d| format!("{} {}", d.choice, d.value)).collect();
    let left_out: Vec<&str> = findings
        .iter()
        .filter(|f| f.on && !settings.effects.has(f.effect))
        .map(|f| f.effect.name())
        .collect();
    if !left_out.is_empty() {
        told.push(format!("without {}", left_out.join(", ")));
    }
    (!told.is_empty()).then(|| Span::styled(format!(" {} ", told.join(", ")), theme::warning()))
}

/// What the keys do here, as many as there is room for.
pub fn hint(app: &App, place: Rect, buffer: &mut Buffer) {
    if place.is_empty() {
        return;
    }
    let mut line = Line::default();
    if let Some(Overlay::GoTo(digits)) = &app.overlay {
        let last = app
            .session
            .as_ref()
            .map_or(0, |s| s.tree().events.len().saturating_sub(1));
        line.push_span(Span::raw(format!(" event (0 to {last}): {digits}▏ ")).bold());
    } else if let Some(message) = &app.message {
        line.push_span(Span::raw(format!(" {message}")).bold());
    }
    let context = app.context();
    let here = |c: Context| c == context || c == Context::Always;
    let mut bindings: Vec<_> = ACTIONS
        .iter()
        .filter(|b| b.hint && here(b.context))
        .collect();
    // The way to the rest and the way out are always in sight.
    bindings.sort_by_key(|b| !matches!(b.name, "help" | "back"));
    for binding in bindings {
        let name = if binding.name == "back" && context == Context::Picture {
            "quit"
        } else {
            binding.name
        };
        let key = Span::styled(format!(" {}", binding.short_label()), theme::keycap());
        let name = Span::raw(format!(" {name} "));
        if line.width() + key.width() + name.width() > usize::from(place.width) {
            break;
        }
        line.push_span(key);
        line.push_span(name);
    }
    write(buffer, place.x, place.y, &line, place.width);
}
