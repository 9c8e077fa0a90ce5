//! The rendering of a whole picture: its tiles, in parallel.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::buffer::Film;
use super::thread_pool;
use super::tile_pass::{RenderedTile, TileMemory};
use crate::probe::{Probe, Silent};
use crate::scene::Settings;
use crate::tracer::tile::tiles;
use crate::world::World;

/// Picture of a scene, on `threads` threads (0: one a core).
pub fn draw(world: &World, settings: &Settings, threads: usize) -> Film {
    let go_on = |_, _| ControlFlow::Continue(());
    render::<Silent>(world, settings, threads, &go_on).0
}

/// Renders the whole picture on `threads` threads (0: one a core). Each pixel depends on nothing but the scene and
/// the settings, so the picture is the same for any number of threads.
///
/// Each tile has a probe of its own; they come back in the order of the tiles. `watch` is called after each tile with
/// the number of its pixels and rays; after [`ControlFlow::Break`] the tiles that have not begun stay black.
pub fn render<P: Probe + Default + Send>(
    world: &World,
    settings: &Settings,
    threads: usize,
    watch: &(dyn Fn(u64, u64) -> ControlFlow<()> + Sync),
) -> (Film, Vec<P>) {
    let stopped = std::sync::atomic::AtomicBool::new(false);
    let order = std::sync::atomic::Ordering::Relaxed;
    let picture = Mutex::new(Film::black(settings.size(), settings));
    let results: Vec<_> = thread_pool::install(threads, || {
        tiles(settings)
            .into_par_iter()
            .map_init(TileMemory::default, |memory, tile| {
                if stopped.load(order) {
                    return RenderedTile::blank();
                }
                let mut done = RenderedTile::render(tile, world, settings, memory);
                if watch(done.film.pixels.len() as u64, done.film.rays) == ControlFlow::Break(()) {
                    stopped.store(true, order);
                }
                let mut picture = picture.lock().unwrap_or_else(PoisonError::into_inner);
                picture.paste(tile, &mut done.film);
                done
            })
            .collect()
    });

    let mut picture = picture.into_inner().unwrap_or_else(PoisonError::into_inner);
    let mut probes = Vec::with_capacity(results.len());
    for done in results {
        picture.add_counts(&done.film);
        probes.push(done.probe);
    }
    (picture, probes)
}
