//! Renders a scene to a PNG file: `cargo run --release --example render -- whitted whitted.png`.

use std::error::Error;

use raytree::scene;
use raytree::tracer::{draw, image::png};
use raytree::world::World;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let name = args.next().unwrap_or("whitted".to_owned());
    let file = args.next().unwrap_or("whitted.png".to_owned());
    let scene = scene::load(&name)?;
    let settings = scene.settings;
    let world = World::new(scene, settings.accel);
    let film = draw(&world, &settings, 0);
    std::fs::write(&file, png::encode(&film, settings.image.exposure)?)?;
    println!("{file}: {} rays", film.rays);
    Ok(())
}
