//! Error over time on log axes, as an SVG picture.

use std::fmt::Write as _;

use super::measured::Sweep;
use crate::trace::export::xml::escape;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 480.0;
const MARGIN: f64 = 64.0;

/// Colours that stay apart for most eyes. Source: Okabe and Ito 2008, "Color universal design".
const COLORS: [&str; 7] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000",
];

/// Errors below this are drawn at it: they come from rounding, and an axis down to them would put all that matters on one line.
/// It is the rounding of a number of single precision.
pub const FLOOR: f64 = 1e-7;

/// The part of the plane that is shown, in powers of ten: seconds to the right, RMSE upwards.
struct Axes {
    seconds: (f64, f64),
    rmse: (f64, f64),
}

/// A sweep by its letter and name, with log10 of seconds and of RMSE of each step.
pub type Plotted = (char, String, Vec<[f64; 2]>);

/// The sweeps that have an error, with their letters: told apart without colours.
pub fn plotted(sweeps: &[Sweep]) -> Vec<Plotted> {
    let lettered = ('a'..='z').chain('A'..='Z').cycle().zip(sweeps);
    lettered
        .map(|(letter, sweep)| (letter, sweep.parameter.name(), points(sweep)))
        .filter(|(_, _, points)| !points.is_empty())
        .collect()
}

/// What is said of errors that are drawn at the floor; `None` if there are none.
pub fn about_floor(sweeps: &[Sweep]) -> Option<String> {
    let steps = sweeps.iter().flat_map(|sweep| &sweep.steps);
    let mut errors = steps.filter_map(|step| step.errors).map(|e| e.rmse);
    let some = errors.any(|rmse| rmse > 0.0 && rmse < FLOOR);
    some.then(|| format!("errors below {FLOOR:.0e}, which are rounding, are drawn at {FLOOR:.0e}"))
}

/// The sweeps that have an error, each a line: seconds to the right, RMSE upwards, both by powers of ten.
pub fn svg(title: &str, sweeps: &[Sweep]) -> String {
    let lines = plotted(sweeps);
    let axes = Axes::around(&lines);
    let mut out = String::new();
    let mut add = |line: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{line}");
    };
    add(format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">"#
    ));
    add(format!(
        r#"<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>"#
    ));
    add(format!(
        r#"<text x="{MARGIN}" y="24" font-size="16">{}</text>"#,
        escape(title)
    ));
    axes.draw(&mut add);
    for (line, (i, color)) in lines.iter().zip(COLORS.iter().cycle().enumerate()) {
        axes.draw_line(&mut add, line, i, color);
    }
    if let Some(floor) = about_floor(sweeps) {
        add(format!(
            r#"<text x="{MARGIN}" y="{:.1}">{floor}</text>"#,
            HEIGHT - MARGIN + 52.0
        ));
    }
    add("</svg>".to_owned());
    out
}

impl Axes {
    fn around(lines: &[Plotted]) -> Self {
        let all = || lines.iter().flat_map(|(_, _, points)| points);
        let (seconds, rmse) = if lines.is_empty() {
            ((0.0, 1.0), (0.0, 1.0))
        } else {
            (range(all().map(|p| p[0])), range(all().map(|p| p[1])))
        };
        Self { seconds, rmse }
    }

    fn x(&self, v: f64) -> f64 {
        let (low, high) = self.seconds;
        MARGIN + (v - low) / (high - low) * (WIDTH - 2.0 * MARGIN)
    }

    fn y(&self, v: f64) -> f64 {
        let (low, high) = self.rmse;
        HEIGHT - MARGIN - (v - low) / (high - low) * (HEIGHT - 2.0 * MARGIN)
    }

    /// A grid with a line for each power of ten, and its labels.
    fn draw(&self, add: &mut impl FnMut(String)) {
        for power in powers(self.seconds) {
            let at = self.x(power);
            add(format!(
                r##"<path d="M{at:.1} {MARGIN}V{:.1}" stroke="#dddddd"/>"##,
                HEIGHT - MARGIN
            ));
            add(format!(
                r#"<text x="{at:.1}" y="{:.1}" text-anchor="middle">1e{power} s</text>"#,
                HEIGHT - MARGIN + 18.0
            ));
        }
        for power in powers(self.rmse) {
            let at = self.y(power);
            add(format!(
                r##"<path d="M{MARGIN} {at:.1}H{:.1}" stroke="#dddddd"/>"##,
                WIDTH - MARGIN
            ));
            add(format!(
                r#"<text x="{:.1}" y="{:.1}" text-anchor="end">1e{power}</text>"#,
                MARGIN - 6.0,
                at + 4.0
            ));
        }
        add(format!(
            r#"<text x="{MARGIN}" y="{:.1}">RMSE</text>"#,
            MARGIN - 8.0
        ));
        add(format!(
            r#"<text x="{:.1}" y="{:.1}" text-anchor="middle">seconds a picture</text>"#,
            WIDTH / 2.0,
            HEIGHT - MARGIN + 36.0
        ));
    }

    /// Sweep number `i`: a line with a dot for each step, which has its letter, and its name. A colour that comes again is dashed.
    fn draw_line(
        &self,
        add: &mut impl FnMut(String),
        (letter, name, points): &Plotted,
        i: usize,
        color: &str,
    ) {
        let path: Vec<String> = points
            .iter()
            .map(|[px, py]| format!("{:.1} {:.1}", self.x(*px), self.y(*py)))
            .collect();
        let dashes = match i / COLORS.len() {
            0 => "",
            1 => r#" stroke-dasharray="6 3""#,
            _ => r#" stroke-dasharray="2 3""#,
        };
        add(format!(
            r#"<path d="M{}" fill="none" stroke="{color}" stroke-width="2"{dashes}/>"#,
            path.join("L")
        ));
        for [px, py] in points {
            let (x, y) = (self.x(*px), self.y(*py));
            add(format!(
                r#"<circle cx="{x:.1}" cy="{y:.1}" r="6" fill="{color}"/>"#
            ));
            add(format!(
                r#"<text x="{x:.1}" y="{:.1}" text-anchor="middle" font-size="10" fill="white">{letter}</text>"#,
                y + 3.0
            ));
        }
        let line = MARGIN + 14.0 + 16.0 * i as f64;
        add(format!(
            r#"<text x="{:.1}" y="{line:.1}" text-anchor="end" fill="{color}">{letter}  {}</text>"#,
            WIDTH - MARGIN - 6.0,
            escape(name)
        ));
    }
}

/// log10 of seconds and of RMSE, where there is an error.
fn points(sweep: &Sweep) -> Vec<[f64; 2]> {
    let steps = sweep.steps.iter();
    steps
        .filter_map(|s| {
            let rmse = s.errors?.rmse;
            (rmse > 0.0).then(|| [s.seconds, rmse.max(FLOOR)].map(libm::log10))
        })
        .collect()
}

/// The powers of ten around values.
pub fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    (low.floor(), high.ceil().max(low.floor() + 1.0))
}

fn powers((low, high): (f64, f64)) -> impl Iterator<Item = f64> {
    (low as i32..=high as i32).map(f64::from)
}
