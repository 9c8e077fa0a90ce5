//! How the pixel under the cursor nears its value: luminance and standard error over the number of samples, as more
//! and more of them are taken in the background.
//!
//! Every point is a whole pixel, as `raytree trace --samples N` tells it, and not a part of a larger one: so each can be
//! had again, whichever way samples are chosen. All together cost twice the last.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Style, Stylize as _};
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Axis, Block, Chart, Clear, Dataset, GraphType, Widget};

use super::app::App;
use super::details::wrap;
use super::draw::write;
use super::layout::{Panes, inside};
use super::{picture_pane, theme};
use crate::lab::front::fit;
use crate::math::Sampler;
use crate::scene::{Effect, Sampling, Settings, limits};
use crate::tracer::{Pixel, pixel_unless};
use crate::world::World;

/// Rays that one point may cost.
const MOST_RAYS: u64 = 1 << 20;

/// The numbers of samples: 2 to the power of these.
const POWERS: std::ops::RangeInclusive<u32> = 0..=limits::MAX_SAMPLES.ilog2();

/// Points whose standard errors are those of few samples, and too uncertain to tell a slope.
const UNSURE: usize = 4;

/// What is known of a pixel.
#[derive(Clone, Debug, Default)]
pub struct Nearing {
    /// The pixel with 1, 2, 4 and so on samples.
    pub points: Vec<Pixel>,
    /// Why no more will come.
    pub end: Option<&'static str>,
}

/// Sets that jittered samples are put into.
const SETS: u32 = 8;

/// The settings with so many samples a pixel, such that their differences tell how wrong they are: on a grid there is no
/// chance in them, so Sobol's points take their place; jittered ones come in sets (see [`crate::tracer::spread`]).
pub fn sampled(settings: &Settings, samples: u32) -> Settings {
    settings.with(|s| {
        s.pixel.samples = samples;
        s.pixel.sets = match settings.pixel.sampler {
            Sampler::Stratified if samples >= 2 * SETS => {
                settings.pixel.sets.max(SETS).min(samples)
            }
            _ => settings.pixel.sets.min(samples),
        };
        s.pixel.sampler = match settings.pixel.sampler {
            Sampler::Grid => Sampler::Sobol,
            other => other,
        };
        s.pixel.adaptive = None;
        s.pixel.errors = true;
    })
}

/// True if anything in a pixel is left to chance.
fn has_chance(world: &World, settings: &Settings) -> bool {
    let lights = &world.scene.lights;
    let soft = lights.iter().any(|l| l.kind.is_area());
    settings.pixel.samples > 1
        || settings.pixel.adaptive.is_some()
        || (soft
            && settings.effects.has(Effect::SoftShadows)
            && settings.effects.has(Effect::Shadows))
}

/// Traces a pixel with more and more samples until that becomes too much; the reason why it ended.
pub fn run(
    world: &World,
    settings: &Settings,
    at: (u32, u32),
    stopped: &dyn Fn() -> bool,
    tell: &dyn Fn(Pixel),
) -> &'static str {
    for power in POWERS {
        let settings = sampled(settings, 1 << power);
        let Some(pixel) = pixel_unless(world, &settings, at, stopped) else {
            return "given up";
        };
        if pixel.cut {
            return "the pixel's share of --max-rays ends here";
        }
        tell(pixel);
        if 2 * pixel.rays > MOST_RAYS {
            return "more would take long";
        }
    }
    "that is all"
}

impl App {
    /// Shows how the pixel under the cursor nears its value, or hides it.
    pub fn show_nearing(&mut self) {
        if self.nearing.is_some() {
            return self.hide_nearing();
        }
        self.nearing = Some(Nearing::default());
        self.restart_nearing();
    }

    /// Hides it.
    pub fn hide_nearing(&mut self) {
        self.nearing = None;
        self.renderer.give_up_nearing();
    }

    /// Begins anew if it is shown: the pixel or the settings are others.
    pub fn restart_nearing(&mut self) {
        if self.nearing.is_none() {
            return;
        }
        if !has_chance(&self.world, &self.settings) {
            self.hide_nearing();
            self.message = Some(
                "nothing is left to chance here: one sample a pixel and no area light (try --samples 4)"
                    .to_owned(),
            );
            return;
        }
        self.nearing = Some(Nearing::default());
        let at = self.picture.cursor;
        self.renderer.near(&self.world, self.settings, at);
    }
}

impl Nearing {
    /// Luminance, with what it may be off by, over the power of 2 of the samples.
    fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        self.points.iter().map(|pixel| {
            let error = if pixel.error.is_finite() {
                pixel.error
            } else {
                0.0
            };
            [
                libm::log2(f64::from(pixel.samples)),
                pixel.color.luminance(),
                error,
            ]
        })
    }

    /// The power of n with which the standard error falls, from those that are well known and not 0.
    fn slope(&self) -> Option<f64> {
        let points = self
            .points()
            .skip(UNSURE)
            .filter(|[.., error]| *error > 0.0);
        let points: Vec<[f64; 2]> = points.map(|[x, _, error]| [x, libm::log2(error)]).collect();
        fit(&points).filter(|_| points.len() > 2)
    }
}

/// Where it lies: in the corner that is farthest from the pixel under the cursor; beside an open tree below at the right.
fn place(app: &App, panes: &Panes) -> Rect {
    let area = if app.session.is_some() {
        let all = [
            panes.tree,
            panes.details,
            panes.steps,
            panes.path,
            panes.picture,
        ];
        all.into_iter().fold(Rect::default(), |all, pane| {
            if all.is_empty() {
                pane
            } else if pane.is_empty() {
                all
            } else {
                all.union(pane)
            }
        })
    } else {
        panes.picture
    };
    let width = (area.width * 2 / 5).max(44).min(area.width);
    let height = (area.height * 2 / 5).max(12).min(area.height);
    let (mut right, mut below) = (true, true);
    if app.session.is_none() {
        let (column, row) = picture_pane::placement(app, panes).cell(app.picture.cursor);
        right = column < area.x + area.width / 2;
        below = row < area.y + area.height / 2;
    }
    Rect {
        x: if right { area.right() - width } else { area.x },
        y: if below {
            area.bottom() - height
        } else {
            area.y
        },
        width,
        height,
    }
}

/// Draws it, if it is asked for.
pub fn draw(app: &App, panes: &Panes, buffer: &mut Buffer) {
    let Some(nearing) = &app.nearing else {
        return;
    };
    let place = place(app, panes);
    Clear.render(place, buffer);
    let (x, y) = app.picture.cursor;
    let title = format!(" pixel ({x}, {y}), more samples ");
    Block::bordered().title(title.bold()).render(place, buffer);
    let room = inside(place);
    let lines = lines(app, nearing, room.width);
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
        draw_chart(nearing, chart, buffer);
    }
}

/// A standard error with five digits behind the point, or two if it is smaller than that.
pub fn error(pixel: &Pixel) -> String {
    match pixel.error {
        x if !x.is_finite() => "?".to_owned(),
        x if x == 0.0 || x >= 1e-4 => format!("{x:.5}"),
        x => format!("{x:.1e}"),
    }
}

/// The last point in words.
fn lines(app: &App, nearing: &Nearing, width: u16) -> Vec<Line<'static>> {
    let Some(pixel) = nearing.points.last() else {
        return vec![Line::raw(" ...")];
    };
    let shown = pixel.color * app.settings.image.exposure;
    let mut value = Line::from(theme::swatch(shown, app.options.color));
    value.push_span(Span::raw(format!(" luminance {:.5}", pixel.color.luminance())).bold());
    let settings = sampled(&app.settings, pixel.samples);
    let at_most = match settings.pixel.sampler {
        Sampler::Sobol => "at most ",
        _ => "",
    };
    value.push_span(format!(" ± {at_most}{}", error(pixel)));
    let sets = match settings.pixel.sets {
        1 => String::new(),
        n => format!(" in {n} sets"),
    };
    let slope = nearing.slope();
    let slope = slope.map_or(String::new(), |slope| format!("± falls as n^{slope:.2}; "));
    let text = format!(
        "{} {} samples{sets}, {} rays; {slope}{}",
        pixel.samples,
        Sampling::of(settings.pixel.sampler).name(),
        pixel.rays,
        nearing.end.unwrap_or("more are coming")
    );
    let rest = wrap(&text, usize::from(width)).into_iter().map(Line::raw);
    std::iter::once(value).chain(rest).collect()
}

/// The points, with the standard error above and below.
fn draw_chart(nearing: &Nearing, place: Rect, buffer: &mut Buffer) {
    let points: Vec<[f64; 3]> = nearing.points().collect();
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for [_, value, error] in &points {
        low = low.min(value - error);
        high = high.max(value + error);
    }
    if !(low.is_finite() && high.is_finite()) {
        return;
    }
    // Equal values stand in the middle.
    let least = 1e-6 * (1.0 + high.abs());
    let margin = if high - low < least {
        least
    } else {
        0.05 * (high - low)
    };
    let (low, high) = (low - margin, high + margin);
    let values: Vec<(f64, f64)> = points.iter().map(|[x, y, _]| (*x, *y)).collect();
    let bars: Vec<[(f64, f64); 2]> = points
        .iter()
        .filter(|[.., error]| *error > 0.0)
        .map(|[x, y, error]| [(*x, y - error), (*x, y + error)])
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
    let last = *POWERS.end();
    let samples: Vec<String> = (0..=last)
        .step_by(3)
        .map(|power| (1u32 << power).to_string())
        .collect();
    let value = |y: f64| format!("{y:.4}");
    Chart::new(datasets)
        .x_axis(
            Axis::default()
                .bounds([0.0, f64::from(last)])
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
        .render(place, buffer);
}

/// The line of the values.
const VALUE: Color = Color::Rgb(204, 150, 30);

/// The bars of the standard errors.
const ERROR: Color = Color::Rgb(70, 145, 225);
