//! Comparison of the open tree with another one: of another pixel, with another setting or a bent law, or from a file.

use std::fs::{self, File};
use std::io::Read as _;

use crate::debug::Session;
use crate::grade::compare::Compared;
use crate::grade::diff::{Sides, TreeDiff};
use crate::grade::follow::PixelReference;
use crate::grade::quantity::QuantityKind;
use crate::grade::tolerance::Tolerances;
use crate::scene::settings::knobs::set_knob;
use crate::trace::facts::{PixelFacts, pixel_facts};
use crate::trace::read::limits::MAX_TREE_FILE_BYTES;
use crate::trace::read::read_trees;
use crate::trace::{View, document, trace_pixel};
use crate::tui::model::{Model, Overlay};

/// Comparisons to begin with.
pub const READY: [&str; 6] = [
    "bend=eta-inverted",
    "bend=reflect-plus",
    "bend=shadow-none",
    "without=refraction",
    "fresnel=none",
    "depth=1",
];

/// Causes that are told at most.
const MOST_CAUSES: usize = 20;

/// Compares the open tree with what is typed: X,Y, flag=value or a file.
pub fn typed(model: &mut Model, text: &str) -> Result<(), String> {
    let Some(session) = &model.session else {
        return Err("open the ray tree of a pixel first".to_owned());
    };
    let ours = pixel_facts(&document::of(session.view()));
    let (theirs, same_scene) = other(session, text)?;
    let pixel = (session.trace.x, session.trace.y);
    let of = PixelReference {
        scene: same_scene.then_some((&*session.world, &session.settings)),
        pixel,
        facts: &ours,
    };
    let diff = TreeDiff::new(of, &theirs, &Tolerances::default(), &|quantity| {
        quantity != QuantityKind::Order
    });
    let (x, y) = pixel;
    let open = |compared: &Compared| format!(":{x},{y}{}", compared.path);
    let this = format!("{x},{y}");
    let sides = Sides {
        scene: &session.world.scene.name,
        pixel,
        a: &this,
        b: text,
        open: &open,
    };
    let told = if diff.is_empty() {
        format!("All {} quantities agree.\n", diff.asked)
    } else {
        diff.to_text(sides, MOST_CAUSES)
    };
    model.overlay = Some(Overlay::Report("difference", told, 0));
    Ok(())
}

/// The other tree, and whether it is of the same pixel of the same scene.
fn other(session: &Session, text: &str) -> Result<(PixelFacts, bool), String> {
    let here = (session.trace.x, session.trace.y);
    if let Some((flag, value)) = text.split_once('=') {
        let mut settings = session.settings;
        set_knob(
            &mut settings,
            flag.trim().trim_start_matches('-'),
            value.trim(),
        )?;
        if settings.size() != session.settings.size()
            || settings.arithmetic != session.settings.arithmetic
        {
            return Err(format!(
                "`{flag}` cannot be compared here; use raytree diff"
            ));
        }
        let theirs = session.settings.with(|s| *s = settings);
        return Ok((traced(session, &theirs, here), true));
    }
    if let Some(pixel) = pixel_of(text) {
        let (width, height) = session.settings.size();
        if pixel.0 >= width || pixel.1 >= height {
            return Err(format!(
                "pixel {text} is outside the picture of {width}x{height}"
            ));
        }
        return Ok((traced(session, &session.settings, pixel), false));
    }
    from_file(text, here).map(|facts| (facts, true))
}

fn pixel_of(text: &str) -> Option<(u32, u32)> {
    let (x, y) = text.split_once(',')?;
    Some((x.trim().parse().ok()?, y.trim().parse().ok()?))
}

fn traced(session: &Session, settings: &crate::scene::Settings, at: (u32, u32)) -> PixelFacts {
    let trace = trace_pixel(&session.world, settings, at, false);
    pixel_facts(&document::of(View {
        world: &session.world,
        settings,
        trace: &trace,
    }))
}

/// The tree of a pixel in a file of ray trees.
fn from_file(path: &str, pixel: (u32, u32)) -> Result<PixelFacts, String> {
    let cannot = |error: std::io::Error| format!("cannot be read: {error}");
    // A pipe or a device could be read for ever.
    if !fs::metadata(path).map_err(cannot)?.is_file() {
        return Err(format!("{path}: is no regular file"));
    }
    let mut bytes = Vec::new();
    let most = MAX_TREE_FILE_BYTES as u64 + 1;
    let file = File::open(path).map_err(cannot)?;
    file.take(most).read_to_end(&mut bytes).map_err(cannot)?;
    let mut trees = read_trees(&bytes, path);
    let only = trees.len() == 1;
    let is_it = |tree: &PixelFacts| tree.pixel.map_or(only, |at| at == pixel);
    let place = trees.iter().position(|tree| tree.as_ref().is_ok_and(is_it));
    match place.map(|place| trees.swap_remove(place)) {
        Some(Ok(facts)) => Ok(facts),
        _ => match trees.into_iter().find_map(Result::err) {
            Some(error) => Err(error.to_string()),
            None => Err(format!(
                "{path}: has no tree of pixel {},{}",
                pixel.0, pixel.1
            )),
        },
    }
}
