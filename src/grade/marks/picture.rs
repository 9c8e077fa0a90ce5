//! The mark of a check of a picture: the share of its pixels that agree.

use std::collections::HashMap;

use super::{CheckMark, Given};
use crate::grade::picture::read_picture;
use crate::grade::quantity::QuantityKind;
use crate::grade::task::{Check, PictureFile, Task};
use crate::math::Rgb;
use crate::trace::facts::Fact;
use crate::tracer::Film;

/// Marks a picture.
pub fn mark(
    task: &Task,
    check: &Check,
    asked: &PictureFile,
    ours: &Film,
    given: &Given,
) -> CheckMark {
    let Some((name, bytes)) = given.picture(&asked.file) else {
        return CheckMark {
            most: check.points,
            note: format!("no picture `{}` was handed in", asked.file),
            ..CheckMark::default()
        };
    };
    let exposure = task.scenes[check.scene].settings.image.exposure;
    let theirs = match read_picture(bytes, (ours.width, ours.height), exposure) {
        Ok(picture) => picture,
        Err(problem) => return CheckMark::broken(check, format!("{name}: {problem}")),
    };
    let right = agreeing(task, asked, (ours, exposure), &theirs);
    let total = ours.pixels.len() as u64;
    let none = match asked.none {
        Some(share) => (share * total as f64).round() as u64,
        None => of_one_color(task, asked, (ours, exposure)),
    };
    let wanted = ((asked.share * total as f64).round() as u64).max(none + 1);
    let mark = CheckMark::of_share(check, right.saturating_sub(none), wanted - none);
    let percent = |n: u64| format!("{:.1} %", (n as f64 / total as f64 * 1000.0).floor() / 10.0);
    CheckMark {
        note: format!(
            "{name}: {} of the pixels agree; {} wanted, {} earn nothing",
            percent(right),
            percent(wanted),
            percent(none)
        ),
        ..mark
    }
}

/// How many pixels agree.
fn agreeing(
    task: &Task,
    asked: &PictureFile,
    (ours, exposure): (&Film, f64),
    theirs: &Film,
) -> u64 {
    let pairs = ours.pixels.iter().zip(&theirs.pixels);
    pairs
        .filter(|(ours, theirs)| agree(task, asked, exposure, (**ours, **theirs)))
        .count() as u64
}

/// True if two pixels agree.
pub fn agree(task: &Task, asked: &PictureFile, exposure: f64, (ours, theirs): (Rgb, Rgb)) -> bool {
    if asked.ask == "linear" {
        return task.tolerances.agree(
            QuantityKind::Color,
            &Fact::Color(ours),
            &Fact::Color(theirs),
        );
    }
    let shown = |color: Rgb| Fact::Vector((color * exposure).to_srgb8().map(f64::from));
    task.tolerances
        .agree(QuantityKind::Srgb8, &shown(ours), &shown(theirs))
}

/// How many pixels of a picture of the commonest colour would agree.
fn of_one_color(task: &Task, asked: &PictureFile, (ours, exposure): (&Film, f64)) -> u64 {
    let mut counts: HashMap<[u8; 3], (u64, usize)> = HashMap::new();
    for (index, color) in ours.pixels.iter().enumerate() {
        let entry = counts
            .entry((*color * exposure).to_srgb8())
            .or_insert((0, index));
        entry.0 += 1;
    }
    let commonest = counts
        .values()
        .max_by_key(|(count, first)| (*count, usize::MAX - first));
    let Some((_, first)) = commonest else {
        return 0;
    };
    let plain = Film {
        pixels: vec![ours.pixels[*first]; ours.pixels.len()],
        ..Film::default()
    };
    agreeing(task, asked, (ours, exposure), &plain)
}
