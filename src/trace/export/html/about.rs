//! What the page says of the pixel as a whole, and how to read it.

use std::fmt::{Formatter, Result};

use crate::probe::RayKind;
use crate::trace::document::Document;
use crate::trace::export::tree_layout::hex;
use crate::trace::export::xml::escape;
use crate::trace::format::{counted, num, rgb};

/// The pixel's colour, and what has to be known about it.
pub fn pixel(f: &mut Formatter, document: &Document) -> Result {
    let [r, g, b] = document.color.srgb8;
    writeln!(
        f,
        "<p class=c style=--c:{}>{} = sRGB ({r}, {g}, {b}), {}, depth {}, least weight {}",
        hex(document.color.srgb8),
        rgb(document.color.linear),
        counted(document.rays, "ray"),
        document.settings.depth,
        num(document.settings.min_weight)
    )?;
    for line in remarks(document) {
        writeln!(f, "<p>{}", escape(&line))?;
    }
    Ok(())
}

/// What is special about the pixel, a line each.
fn remarks(document: &Document) -> Vec<String> {
    let mut lines = Vec::new();
    let settings = &document.settings;
    lines.extend(settings.bent.iter().map(|bent| {
        format!(
            "Laws are exchanged for mistakes here ({bent}): this is the tree of a wrong tracer."
        )
    }));
    if !settings.without.is_empty() {
        let without = settings.without.join(", ");
        lines.push(format!("Left out, though the scene needs it: {without}."));
    }
    lines.extend(document.cut.map(|cut| {
        format!(
            "Rays left out: {} by depth, {} by weight, with up to {} % of its light.",
            cut.depth,
            cut.weight,
            num(100.0 * cut.share)
        )
    }));
    lines.extend(document.standard_error.map(|error| {
        format!(
            "Standard error of its luminance, estimated: {}.",
            num(error)
        )
    }));
    if document.spoiled > 0 {
        let spoiled = document.spoiled;
        lines.push(format!(
            "Samples that are no finite numbers and count as black: {spoiled}."
        ));
    }
    lines.extend(
        document
            .warnings
            .iter()
            .map(|warning| format!("Warning: {}; {}.", warning.message, warning.cure)),
    );
    lines
}

/// What the letters and colours mean.
pub fn letters(f: &mut Formatter) -> Result {
    f.write_str("<p class=note>Open a ray to see its numbers and the rays that its hit sent.")?;
    for (kind, what) in
        RayKind::ALL
            .into_iter()
            .zip(["from the eye", "to a light", "reflected", "transmitted"])
    {
        let letter = kind.letter();
        write!(f, " <b class={letter}>{letter}</b>{what}")?;
    }
    f.write_str(". A square is the light that a ray brings back; before it stands its share of the pixel's brightness. ")?;
    f.write_str("\"Along\" alone: from the hit that sent the ray. radiance = terms of the hit + weight × radiance of R and T.\n")
}

/// That the log was full, if it was.
pub fn truncation(f: &mut Formatter, document: &Document) -> Result {
    match document.truncated {
        Some(dropped) => writeln!(
            f,
            "<p>The log is full; events that were not kept: {dropped}."
        ),
        None => Ok(()),
    }
}
