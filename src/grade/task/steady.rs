//! Pixels that a task draws: by chance, the same for all, away from edges, and steady: a right tracer in single precision with a
//! fixed offset gets the same tree there.

use std::collections::HashSet;

use super::DrawnPixels;
use super::scene::{MAX_PIXELS, TaskScene, reference};
use crate::geometry::{Arithmetic, Offset, Precision};
use crate::grade::compare::{Compared, Status, TreeComparison};
use crate::grade::follow::PixelReference;
use crate::grade::quantity::QuantityKind;
use crate::grade::tolerance::Tolerances;
use crate::sampling::stream::splitmix64;
use crate::trace::facts::{FactName, PixelFacts, TreePath};
use crate::trace::{TreeQuery, View, trace_pixel_here};
use crate::world::World;

/// Pixels that are tried for each that is wanted, before it is given up.
const TRIES: u64 = 2000;

/// What a usual right tracer computes with.
const USUAL: Arithmetic = Arithmetic {
    offset: Offset::Fixed(1e-4),
    precision: Precision::Single,
    ..Arithmetic::OURS
};

/// Draws the pixels of a rule.
pub fn draw(
    scene: &TaskScene,
    rule: &DrawnPixels,
    depth: Option<u32>,
) -> Result<Vec<(u32, u32)>, String> {
    if rule.count == 0 || rule.count > MAX_PIXELS {
        return Err(format!(
            "`pixels.count` is {}; 1 to {MAX_PIXELS} are possible",
            rule.count
        ));
    }
    let query: Option<TreeQuery> = match &rule.r#where {
        Some(text) => Some(text.parse().map_err(|error| format!("`where`: {error}"))?),
        None => None,
    };
    let (width, height) = scene.settings.size();
    let usual = usual(scene);
    let mut seen = HashSet::new();
    let mut found = Vec::new();
    for index in 0..TRIES * rule.count as u64 {
        let random = splitmix64(rule.seed ^ splitmix64(index));
        let at = ((random >> 32) as u32 % width, random as u32 % height);
        if seen.insert(at) && suits(scene, &usual, query.as_ref(), (at, depth)) {
            found.push(at);
            if found.len() == rule.count {
                return Ok(found);
            }
        }
    }
    Err(format!(
        "only {} steady pixels away from edges were found for `where`, and {} are wanted; ask for fewer, or list them",
        found.len(),
        rule.count
    ))
}

fn suits(
    scene: &TaskScene,
    usual: &TaskScene,
    query: Option<&TreeQuery>,
    (at, depth): ((u32, u32), Option<u32>),
) -> bool {
    let satisfies = |query: &TreeQuery| {
        let trace = trace_pixel_here(&scene.world, &scene.settings, at, false);
        query.holds(View {
            world: &scene.world,
            settings: &scene.settings,
            trace: &trace,
        })
    };
    query.is_none_or(satisfies) && away_from_edges(scene, at) && same_tree(scene, usual, at, depth)
}

/// True if a right tracer in single precision with a fixed offset gets the same tree.
pub fn is_steady(scene: &TaskScene, at: (u32, u32), depth: Option<u32>) -> bool {
    same_tree(scene, &usual(scene), at, depth)
}

/// The scene as a usual right tracer computes it.
pub fn usual(scene: &TaskScene) -> TaskScene {
    let settings = scene.settings.with(|s| s.arithmetic = USUAL);
    let world = World::new(
        scene.world.scene.clone().computed_with(USUAL),
        settings.accel,
    );
    TaskScene {
        world: world.into(),
        settings,
        ..scene.clone()
    }
}

/// Rays below this depth may differ.
fn same_tree(scene: &TaskScene, usual: &TaskScene, at: (u32, u32), depth: Option<u32>) -> bool {
    let counts = |path: &TreePath| depth.is_none_or(|most| path.depth() <= most as usize + 1);
    let ours = reference(scene, &scene.settings, at);
    let theirs = reference(usual, &usual.settings, at);
    let of = PixelReference {
        scene: None,
        pixel: at,
        facts: &ours,
    };
    let comparison = TreeComparison::new(of, &theirs, &Tolerances::default());
    let core = comparison
        .all
        .iter()
        .filter(|c| QuantityKind::CORE.contains(&c.quantity));
    comparison.extra.iter().all(|(path, _)| !counts(path))
        && core
            .filter(|c| counts(&c.path))
            .all(|c| c.status == Status::Right || of_all_below(c, depth))
}

/// True if the trees of all eight neighbours have the same shape: the same rays on the same objects.
fn away_from_edges(scene: &TaskScene, (x, y): (u32, u32)) -> bool {
    let (width, height) = scene.settings.size();
    if x == 0 || y == 0 || x + 1 >= width || y + 1 >= height {
        return false;
    }
    let here = shape(&reference(scene, &scene.settings, (x, y)));
    let around = (y - 1..=y + 1).flat_map(|y| (x - 1..=x + 1).map(move |x| (x, y)));
    around
        .into_iter()
        .all(|at| shape(&reference(scene, &scene.settings, at)) == here)
}

/// Each ray with how it ends.
fn shape(facts: &PixelFacts) -> Vec<(TreePath, Option<String>, Option<String>)> {
    let word = |ray: &crate::trace::facts::RayFacts, name| ray.word(&name).map(str::to_owned);
    let rays = facts.rays.iter();
    rays.map(|ray| {
        (
            ray.path.clone(),
            word(ray, FactName::Outcome),
            word(ray, FactName::Object),
        )
    })
    .collect()
}

/// True for a sum that rays below the depth belong to.
fn of_all_below(compared: &Compared, depth: Option<u32>) -> bool {
    depth.is_some() && compared.quantity == QuantityKind::Radiance
}
