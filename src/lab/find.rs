//! Search of a picture: the pixels whose ray trees satisfy a query.

use std::ops::ControlFlow;

use rayon::prelude::*;

use crate::scene::Settings;
use crate::trace::{TreeQuery, View, trace_pixel_here};
use crate::tracer::thread_pool;
use crate::world::World;

/// Rows that are searched together: enough pixels for all threads, and few enough to stop soon.
const ROWS: u32 = 8;

/// Outcome of a search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundPixels {
    /// The pixels that satisfy the query, row after row.
    pub pixels: Vec<(u32, u32)>,
    /// Pixels that were searched, row after row from the first.
    pub searched: u64,
    /// True if the whole picture was searched.
    pub complete: bool,
}

/// Told of the pixels that were found since the last time, and among how many; it may stop the search.
pub type FindWatch<'a> = &'a (dyn Fn(&[(u32, u32)], u64) -> ControlFlow<()> + Sync);

/// Searches the picture row after row, on `threads` threads (0: one a core), until `most` pixels were found. `watch` may
/// stop it.
pub fn find(
    world: &World,
    settings: &Settings,
    query: &TreeQuery,
    most: usize,
    threads: usize,
    watch: FindWatch,
) -> FoundPixels {
    let (width, height) = settings.size();
    let satisfies = |at: &(u32, u32)| {
        let trace = trace_pixel_here(world, settings, *at, false);
        query.holds(View {
            world,
            settings,
            trace: &trace,
        })
    };
    let mut found = FoundPixels {
        pixels: Vec::new(),
        searched: 0,
        complete: false,
    };
    thread_pool::install(threads, || {
        for first in (0..height).step_by(ROWS as usize) {
            let rows = first..(first + ROWS).min(height);
            let pixels: Vec<(u32, u32)> =
                rows.flat_map(|y| (0..width).map(move |x| (x, y))).collect();
            let searched = pixels.len() as u64;
            let those: Vec<(u32, u32)> = pixels.into_par_iter().filter(satisfies).collect();
            found.searched += searched;
            let told = watch(&those, searched);
            found.pixels.extend(those);
            if told == ControlFlow::Break(()) || found.pixels.len() >= most {
                break;
            }
        }
    });
    found.complete = found.searched == u64::from(width) * u64::from(height);
    if found.pixels.len() > most {
        found.pixels.truncate(most);
        found.complete = false;
    }
    found
}
