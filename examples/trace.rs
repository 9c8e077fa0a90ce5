//! Writes the ray tree of a pixel as JSON: `cargo run --release --example trace -- whitted 160 120`.

use std::error::Error;

use raytree::scene;
use raytree::trace::export::json;
use raytree::trace::{View, document, trace_pixel};
use raytree::world::World;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let name = args.next().unwrap_or("whitted".to_owned());
    let mut number = |default| args.next().map_or(Ok(default), |text| text.parse::<u32>());
    let pixel = (number(160)?, number(120)?);
    let scene = scene::load(&name)?;
    let settings = scene.settings;
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(&world, &settings, pixel, false);
    let view = View {
        world: &world,
        settings: &settings,
        trace: &trace,
    };
    json::write(std::io::stdout().lock(), &document::of(view))?;
    Ok(())
}
