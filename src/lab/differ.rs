//! Pixels whose colour on a screen is another one with other settings.

use crate::scene::Settings;
use crate::tracer::{Film, draw};
use crate::world::World;

/// The pixels, row after row, whose 8-bit colour differs between two pictures; those that only one of two pictures of different
/// sizes has differ. On `threads` threads (0: one a core).
pub fn pixels_that_differ(
    a: (&World, &Settings),
    b: (&World, &Settings),
    threads: usize,
) -> Vec<(u32, u32)> {
    let [drawn, other] = [a, b].map(|(world, settings)| draw(world, settings, threads));
    let (width, height) = (drawn.width.max(other.width), drawn.height.max(other.height));
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let differs = |at: &(u32, u32)| on_screen(&drawn, a.1, *at) != on_screen(&other, b.1, *at);
    pixels.filter(differs).collect()
}

/// The colour of a pixel on a screen; none where the picture ends before it.
fn on_screen(film: &Film, settings: &Settings, (x, y): (u32, u32)) -> Option<[u8; 3]> {
    let is_there = x < film.width && y < film.height;
    is_there.then(|| {
        settings
            .bends
            .srgb8(film.at(x, y) * settings.image.exposure)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Bend, Effect, load};
    use crate::tracer::pixel;

    fn world(name: &str) -> (World, Settings) {
        let scene = load(name).expect("built in");
        let settings = scene
            .settings
            .with(|s| (s.image.width, s.image.height) = (40, 30));
        (World::new(scene, settings.accel), settings)
    }

    #[test]
    fn they_are_those_that_differ_one_by_one() {
        let (world, settings) = world("whitted");
        let bent = |name: &str| {
            let bend = Bend::all().find(|b| b.name() == name);
            settings.with(|s| s.bends = bend.expect("a bend").into())
        };
        // One in the tracer, and one that is only seen in 8 bits.
        let bends = ["shadow-inverted", "truncated"].map(bent);
        let unlit = settings.with(|s| s.effects = s.effects.without(Effect::Ambient));
        let brighter = settings.with(|s| s.image.exposure = 1.5);
        for other in bends.into_iter().chain([unlit, brighter]) {
            let screen = |s: &Settings, at| {
                let color = pixel(&world, s, at, &mut crate::probe::Silent).color;
                s.bends.srgb8(color * s.image.exposure)
            };
            let all = (0..30).flat_map(|y| (0..40).map(move |x| (x, y)));
            let expected: Vec<_> = all
                .filter(|at| screen(&settings, *at) != screen(&other, *at))
                .collect();
            let found = pixels_that_differ((&world, &settings), (&world, &other), 2);
            assert_eq!(found, expected);
            assert!(!found.is_empty());
        }
        assert_eq!(
            pixels_that_differ((&world, &settings), (&world, &settings), 0),
            []
        );
    }

    #[test]
    fn a_pixel_that_one_of_them_does_not_have_differs() {
        let (world, settings) = world("triangle");
        let wider = settings.with(|s| s.image.width += 1);
        let found = pixels_that_differ((&world, &settings), (&world, &wider), 2);
        assert_eq!(found.iter().filter(|(x, _)| *x == 40).count(), 30);
        let found = pixels_that_differ((&world, &wider), (&world, &settings), 2);
        assert_eq!(found.iter().filter(|(x, _)| *x == 40).count(), 30);
    }
}
