//! The recorded pixel, as a log, as a ray tree, as an owned document, as numbers to read.
//!
//! The log is the truth. The tree ([`RayTree`]) is a fold of it; stepping ([`crate::debug::Cursor`]) is an index into it; what is
//! shown beside it is computed again from it with the tracer's own functions ([`mod@explain`]). The [`Document`] is made
//! from both, with names instead of ids; whatever is written ([`export`]) is made from the document alone.

pub mod address;
pub mod corner_terms;
pub mod counts;
pub mod document;
pub mod explain;
pub mod export;
pub mod facts;
pub mod field;
pub mod format;
pub mod ledger;
pub mod light_estimate;
pub mod lighting;
pub mod query;
pub mod read;
pub mod recorder;
pub mod surface_hit;
pub mod tree;
pub mod view;

pub use address::Address;
pub use counts::Counts;
pub use document::Document;
pub use explain::{Explanation, explain};
pub use light_estimate::LightEstimate;

pub use query::TreeQuery;
pub use recorder::Recorder;
pub use surface_hit::SurfaceHit;
pub use tree::{Node, Outcome, RayTree};
pub use view::View;

use crate::scene::Settings;
use crate::tracer::{Pixel, pixel, thread_pool};
use crate::world::World;

/// A recorded pixel.
#[derive(Clone, Debug)]
pub struct PixelTrace {
    /// Its column, from 0 at the left.
    pub x: u32,
    /// Its row, from 0 at the top.
    pub y: u32,
    /// Its colour: that of the rendered picture, bit for bit.
    pub pixel: Pixel,
    /// Its log and its ray trees.
    pub tree: RayTree,
}

impl PixelTrace {
    /// What is known of it before an event: the tree up to there, and a pixel without samples.
    #[must_use]
    pub fn until(&self, end: usize) -> Self {
        Self {
            pixel: Pixel::default(),
            tree: self.tree.until(end),
            ..*self
        }
    }

    /// False if only its beginning is known: the pixel has no samples yet, and no colour.
    pub fn is_whole(&self) -> bool {
        self.pixel.samples > 0
    }
}

/// Traces pixel (x, y) again, as [`crate::tracer::render()`] does, and writes down what happens; with every step
/// through the acceleration structure if `traversal`.
pub fn trace_pixel(
    world: &World,
    settings: &Settings,
    (x, y): (u32, u32),
    traversal: bool,
) -> PixelTrace {
    thread_pool::install(1, || trace_pixel_here(world, settings, (x, y), traversal))
}

/// [`trace_pixel`] on the calling thread, whose stack must be deep enough: one of [`thread_pool::install`].
pub fn trace_pixel_here(
    world: &World,
    settings: &Settings,
    (x, y): (u32, u32),
    traversal: bool,
) -> PixelTrace {
    let settings = settings.with(|s| s.pixel.errors = true);
    let (pixel, tree) = if traversal {
        record(Recorder::<true>::default(), world, &settings, (x, y))
    } else {
        record(Recorder::<false>::default(), world, &settings, (x, y))
    };
    PixelTrace { x, y, pixel, tree }
}

fn record<const TRAVERSAL: bool>(
    mut recorder: Recorder<TRAVERSAL>,
    world: &World,
    settings: &Settings,
    at: (u32, u32),
) -> (Pixel, RayTree) {
    let pixel = pixel(world, settings, at, &mut recorder);
    (pixel, RayTree::new(recorder))
}
