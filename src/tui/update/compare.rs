//! Comparison of the open tree with another one: of another pixel, with another setting or a bent law, of another scene, or from a
//! file.

use std::path::Path;

use super::{compare_scene, compare_steps};
use crate::debug::Session;
use crate::debug::edit::in_one_line;
use crate::grade::compare::Compared;
use crate::grade::diff::{Sides, TreeDiff};
use crate::grade::follow::PixelReference;
use crate::grade::pixel_tree::{self, TreeFileError};
use crate::grade::quantity::QuantityKind;
use crate::grade::side_by_side::{RayPair, side_by_side};
use crate::grade::tolerance::Tolerances;
use crate::scene::Settings;
use crate::scene::printable::printable;
use crate::scene::settings::knobs::set_knob;
use crate::trace::facts::{PixelFacts, pixel_facts};
use crate::trace::{Address, document};
use crate::tui::model::list::{LineGoal, PlaceLine, PlaceList};
use crate::tui::model::{Model, Overlay};
use crate::tui::panes::text::{padded, shortened};

/// Causes that are told at most.
const MOST_CAUSES: usize = 3;

/// Rays that are listed at most.
const MOST_RAYS: usize = 2000;

/// Rays of a tree at most that is compared while the user waits.
const MOST_COMPARED: usize = 50_000;

/// The other tree.
struct OtherTree {
    facts: PixelFacts,
    /// What it is, if not the tree of the same pixel of the same scene: then differences have no causes.
    beside: Option<String>,
}

/// Compares the open tree with what is typed: X,Y, flag=value, a scene or a file. Other structures and orders are compared step by
/// step.
pub fn typed(model: &mut Model, text: &str) -> Result<(), String> {
    let Some(session) = &model.session else {
        return Err("open the ray tree of a pixel first".to_owned());
    };
    if session.tree().nodes.len() > MOST_COMPARED {
        return Err("this tree is too large to be compared here; use raytree diff".to_owned());
    }
    if let Some(list) = compare_steps::list(session, text, model.layout.screen.width) {
        model.overlay = Some(Overlay::Places(list?));
        return Ok(());
    }
    let ours = pixel_facts(&document::of(session.view()));
    let other = other(session, text, &model.options.folder)?;
    let tolerances = Tolerances::default();
    let pairs = side_by_side(&ours, &other.facts, &tolerances);
    let causes = if other.beside.is_none() {
        TreeDiff::new(
            PixelReference {
                scene: Some((&*session.world, &session.settings)),
                pixel: (session.trace.x, session.trace.y),
                facts: &ours,
            },
            &other.facts,
            &tolerances,
            &|quantity| quantity != QuantityKind::Order,
        )
    } else {
        TreeDiff::default()
    };
    let width = usize::from(model.layout.screen.width.min(124)).saturating_sub(26) / 2;
    let first = causes.causes.first().map(|cause| &cause.first.path);
    let pixel = (session.trace.x, session.trace.y);
    let lines = pairs.iter().take(MOST_RAYS);
    let lines = lines.map(|pair| line(pair, first == Some(&pair.path), pixel, width));
    let mut list = PlaceList::new(format!("this tree | {text}"), lines.collect());
    list.head = head(session, text, &causes, &other, &pairs);
    let cause = pairs.iter().position(|pair| first == Some(&pair.path));
    let different = pairs.iter().position(|pair| !pair.is_same());
    list.chosen = cause.or(different).unwrap_or(0);
    model.overlay = Some(Overlay::Places(list));
    Ok(())
}

/// Compares the open tree, which is that of a broken tracer, with the tree by these settings. No law is named.
pub fn with_ours(model: &mut Model, ours: &Settings) -> Result<(), String> {
    let Some(session) = &model.session else {
        return Err("open the ray tree of a pixel first".to_owned());
    };
    if session.tree().nodes.len() > MOST_COMPARED {
        return Err("this tree is too large to be compared here".to_owned());
    }
    let pixel = (session.trace.x, session.trace.y);
    let broken = pixel_facts(&document::of(session.view()));
    let right = pixel_tree::traced(&session.world, ours, pixel);
    let pairs = side_by_side(&broken, &right, &Tolerances::default());
    let width = usize::from(model.layout.screen.width.min(124)).saturating_sub(26) / 2;
    let lines = pairs.iter().take(MOST_RAYS);
    let lines = lines.map(|pair| line(pair, false, pixel, width));
    let mut list = PlaceList::new("the broken tracer | ours", lines.collect());
    "≠ differs, - is not there.".clone_into(&mut list.head);
    list.chosen = pairs.iter().position(|pair| !pair.is_same()).unwrap_or(0);
    model.overlay = Some(Overlay::Places(list));
    Ok(())
}

/// What differs, in words.
fn head(
    session: &Session,
    text: &str,
    causes: &TreeDiff,
    other: &OtherTree,
    pairs: &[RayPair],
) -> String {
    let (x, y) = (session.trace.x, session.trace.y);
    let different = pairs.iter().filter(|pair| !pair.is_same()).count();
    if different == 0 && causes.is_empty() {
        return format!(
            "All {} rays agree.",
            pairs.iter().map(|p| 1 + p.folded).sum::<usize>()
        );
    }
    if let Some(other) = &other.beside {
        return format!("Pixel {x},{y} beside {other}; ≠ differs, - is not there.");
    }
    let open = |compared: &Compared| format!("opens by :{x},{y}{}", compared.path);
    let this = format!("{x},{y}");
    let sides = Sides {
        scene: &session.world.scene.name,
        pixel: (x, y),
        a: &this,
        b: text,
        open: &open,
    };
    causes.to_text(sides, MOST_CAUSES)
}

/// A ray in both trees, `width` columns each.
fn line(pair: &RayPair, is_cause: bool, pixel: (u32, u32), width: usize) -> PlaceLine {
    let level = pair.path.depth().min(width / 4);
    let letter = pair
        .path
        .steps
        .last()
        .map_or("I".to_owned(), ToString::to_string);
    let side = |words: &Option<String>| {
        let words = words.as_deref().unwrap_or("-");
        padded(&shortened(words, width), width)
    };
    let name = format!("{}{letter} ", " ".repeat(level));
    let a = side(&pair.a.as_ref().map(|words| format!("{name}{words}")));
    let b = side(&pair.b);
    let sign = if pair.is_same() { "=" } else { "≠" };
    let note = match (is_cause, pair.folded) {
        (true, _) => " < first cause".to_owned(),
        (false, 0) => String::new(),
        (false, folded) => format!(" +{folded} below agree"),
    };
    let address = Address {
        scene: None,
        pixel,
        path: pair.path.clone(),
        part: None,
    };
    let place = match pair.a {
        Some(_) => LineGoal::Address(address),
        None => LineGoal::Told(format!(
            "{}: this ray is in the other tree only",
            name.trim()
        )),
    };
    PlaceLine {
        text: format!("{sign} {a} | {b}{note}"),
        place,
    }
}

/// The other tree.
fn other(session: &Session, text: &str, folder: &Path) -> Result<OtherTree, String> {
    let here = (session.trace.x, session.trace.y);
    if let Some((flag, value)) = text.split_once('=') {
        let mut settings = session.settings;
        let flag = flag.trim().trim_start_matches('-');
        set_knob(&mut settings, flag, value.trim())?;
        if settings.size() != session.settings.size()
            || settings.arithmetic != session.settings.arithmetic
        {
            return Err(format!(
                "`{flag}` cannot be compared here; use raytree diff"
            ));
        }
        return Ok(OtherTree {
            facts: pixel_tree::traced(&session.world, &settings, here),
            beside: None,
        });
    }
    if let Some(pixel) = pixel_of(text) {
        let (width, height) = session.settings.size();
        if pixel.0 >= width || pixel.1 >= height {
            return Err(format!(
                "pixel {text} is outside the picture of {width}x{height}"
            ));
        }
        return Ok(OtherTree {
            facts: pixel_tree::traced(&session.world, &session.settings, pixel),
            beside: (pixel != here).then(|| format!("pixel {text}")),
        });
    }
    if let Some(facts) = compare_scene::tree(session, text, folder) {
        return Ok(OtherTree {
            facts: facts?,
            beside: Some(format!("the same pixel of scene {}", printable(text))),
        });
    }
    if text == "-" {
        return Err("the keys are read from standard input; name a file".to_owned());
    }
    let facts = pixel_tree::in_file(text, Some(here)).map_err(|error| match error {
        TreeFileError::Unread(error) => format!("{text}: {}", in_one_line(&error)),
        TreeFileError::Content(what) => what,
    })?;
    Ok(OtherTree {
        facts,
        beside: None,
    })
}

fn pixel_of(text: &str) -> Option<(u32, u32)> {
    let (x, y) = text.split_once(',')?;
    Some((x.trim().parse().ok()?, y.trim().parse().ok()?))
}
