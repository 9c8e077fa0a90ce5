//! The picture of a case: its panels side by side, as text or in a PNG file.

use std::fmt::Write as _;

use crate::cli::Failure;
use crate::cli::output::{self, Destination};
use crate::lab::contact_sheet;
use crate::lab::stability::{Panel, Picture};
use crate::math::Rgb;
use crate::scene::printable::printable;
use crate::tracer::image::{ColorLevel, terminal};

/// Columns of text that the panels share.
const COLUMNS: u32 = 80;

/// Columns of a panel at most, so that a table and its picture fit 24 lines.
const WIDEST: u32 = 24;

/// Pixels along an edge of a panel in a file, and how many times larger they are shown.
const EDGE: u32 = 64;
const ZOOM: u32 = 6;

/// The panels side by side, each under its name, and what they show. Without colours a wrong pixel is an x.
pub fn as_text(picture: &Picture, panels: usize, level: ColorLevel) -> String {
    let share = (COLUMNS + 1) / (panels.max(1) as u32) - 1;
    let (width, column) = (share.min(WIDEST), share.min(WIDEST + 4));
    let lines = width / 2;
    let (height, lines_of, mark): (_, fn(&Panel, ColorLevel) -> Vec<String>, _) = match level {
        ColorLevel::Never => (lines, characters, "x"),
        _ => (2 * lines, half_blocks, "red"),
    };
    let panels = (picture.draw)((width, height));
    let column = column as usize;
    let names = panels.iter().map(|p| format!("{:column$}", p.arithmetic));
    let names: Vec<String> = names.collect();
    let drawn: Vec<Vec<String>> = panels.iter().map(|p| lines_of(p, level)).collect();
    let gap = " ".repeat(column + 1 - width as usize);
    // Writing to a string cannot fail.
    let mut out = String::new();
    let _ = writeln!(out, "\n{}", names.join(" ").trim_end());
    for row in 0..lines as usize {
        let parts = drawn.iter().filter_map(|lines| lines.get(row));
        let parts: Vec<&str> = parts.map(String::as_str).collect();
        let _ = writeln!(out, "{}", parts.join(&gap));
    }
    let _ = writeln!(out, "{}", legend(picture, mark));
    out
}

fn legend(picture: &Picture, mark: &str) -> String {
    format!("{}; {mark}: {}", picture.shows, picture.wrong)
}

/// Two pixels a character.
fn half_blocks(panel: &Panel, level: ColorLevel) -> Vec<String> {
    let text = terminal::lines(&panel.film, 1.0, level);
    text.lines().map(str::to_owned).collect()
}

/// A pixel a character.
fn characters(panel: &Panel, _: ColorLevel) -> Vec<String> {
    let marked = |(color, wrong): (&Rgb, &bool)| if *wrong { 'x' } else { terminal::ramp(*color) };
    let all: Vec<char> = panel
        .film
        .pixels
        .iter()
        .zip(&panel.wrong)
        .map(marked)
        .collect();
    let rows = all.chunks(panel.film.width.max(1) as usize);
    rows.map(|row| row.iter().collect()).collect()
}

/// Writes the panels to a PNG file; tells which is which.
pub fn to_file(picture: &Picture, to: Destination) -> Result<String, Failure> {
    let path = to.path().to_owned();
    let panels: Vec<Panel> = (picture.draw)((EDGE, EDGE));
    let names: Vec<String> = panels.iter().map(|p| p.arithmetic.clone()).collect();
    let films = panels.into_iter().map(|p| p.film).collect();
    output::write_png(to, &contact_sheet(&[films], ZOOM), 1.0)?;
    Ok(format!(
        "\n{}, from left to right:\n  {}\n{}\n",
        printable(&path.to_string_lossy()),
        names.join(", "),
        legend(picture, "red")
    ))
}
