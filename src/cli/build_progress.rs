//! What one sees while a large scene's accelerator is built.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::accel::AccelKind;
use crate::scene::Scene;
use crate::world::World;

/// What takes no longer than this is not worth a word.
const SHORT: Duration = Duration::from_millis(300);

/// Steps of the bar.
const STEPS: f64 = 1000.0;

/// Builds the accelerator, with a bar on standard error if that is a terminal, it takes its time and the
/// user does not want it `quiet`.
pub fn world(scene: Scene, kind: AccelKind, quiet: bool) -> World {
    let start = Instant::now();
    let bar = ProgressBar::with_draw_target(Some(STEPS as u64), ProgressDrawTarget::hidden());
    let style = ProgressStyle::with_template("{msg}  {wide_bar} {percent:>3} %  {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let count = scene.shapes.len();
    bar.set_message(format!(
        "building `{}` over {count} primitives",
        kind.name()
    ));
    let world = World::watched(scene, kind, &|done| {
        if !quiet && bar.is_hidden() && start.elapsed() > SHORT {
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        bar.set_position((STEPS * done) as u64);
    });
    bar.finish_and_clear();
    world
}
