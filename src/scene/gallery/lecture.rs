//! The scene `lecture-1000`: the frame of 1,000 objects for which a lecture estimates 109 hours.
//!
//! Balls and boxes float over a floor on a wave, placed like the seeds of a sunflower so that none touch.
//! Source of the spiral: Vogel 1979, "A better way to construct the sunflower head".

use super::builder::{SceneBuilder, matt};
use crate::geometry::{Aabb, Cuboid, Plane, Shape, Sphere};
use crate::math::{DVec3, Rgb};
use crate::scene::{Camera, Scene, Settings};
use crate::shading::{Checker, Material};

/// Its name.
pub const NAME: &str = "lecture-1000";
/// What it shows.
pub const NOTE: &str =
    "1,000 objects, 1280x1024 pixels, 10 rays each: the lecture's frame of 109 hours.";

/// Balls and boxes; with the floor it is 1,000.
const SEEDS: u32 = 999;
/// A seed's distance from the middle is this times the root of its number, in metres.
const SPACING: f64 = 0.3;
/// Colours around the wheel.
const HUES: u32 = 12;

/// The scene; `None` only if its camera had no view direction.
pub fn scene() -> Option<Scene> {
    let eye = DVec3::new(0.0, 5.5, 13.0);
    let look_at = DVec3::new(0.0, 0.2, 0.8);
    let camera = Camera::new(eye, look_at, DVec3::Y, 42_f64.to_radians())?;
    let settings = Settings::default().with(|s| {
        s.image.width = 1280;
        s.image.height = 1024;
        s.pixel.samples = 10;
        s.recursion.depth = 3;
    });
    let mut builder = SceneBuilder::new(NAME, camera, settings);
    builder.sky(Rgb::new(0.45, 0.6, 0.8), Rgb::grey(0.25));
    builder.light(DVec3::new(-8.0, 12.0, 8.0), Rgb::new(0.75, 0.7, 0.6));
    builder.light(DVec3::new(9.0, 7.0, 4.0), Rgb::new(0.2, 0.25, 0.35));

    let floor = builder.material(Material {
        checker: Some(Checker {
            diffuse: Rgb::grey(0.5),
            ambient: Rgb::grey(0.5),
            size: 1.0,
        }),
        mirror: Rgb::grey(0.2),
        ..plain("floor", Rgb::grey(0.35))
    });
    builder.begin("floor", floor);
    let plane = Plane::new(DVec3::ZERO, DVec3::Y);
    builder.put(Shape::Plane(Box::new(plane)));

    let colors: Vec<u32> = (0..HUES)
        .map(|i| builder.material(plain(&format!("color {i}"), hue(i))))
        .collect();
    let mirror = builder.material(Material {
        mirror: Rgb::grey(0.8),
        ..plain("mirror", Rgb::grey(0.1))
    });
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    for (i, &color) in (0..SEEDS).zip(colors.iter().cycle()) {
        let distance = SPACING * (f64::from(i) + 0.5).sqrt();
        let angle = golden * f64::from(i);
        let wave = 0.7 * (1.0 + libm::cos(1.3 * distance)) * libm::exp(-distance / 9.0);
        let center = DVec3::new(
            distance * libm::cos(angle),
            0.25 + wave,
            distance * libm::sin(angle),
        );
        // Every third is a box, every seventh of the rest a mirror.
        if i % 3 == 0 {
            builder.begin(format!("box {i}"), color);
            let bounds = Aabb::around([center - DVec3::splat(0.14), center + DVec3::splat(0.14)]);
            builder.put(Shape::Cuboid(Cuboid { bounds }));
        } else {
            let material = if i % 7 == 0 { mirror } else { color };
            builder.begin(format!("ball {i}"), material);
            let radius = 0.2;
            builder.put(Shape::Sphere(Sphere { center, radius }));
        }
    }
    Some(builder.finish())
}

/// Material with a highlight.
fn plain(name: &str, color: Rgb) -> Material {
    Material {
        specular: Rgb::grey(0.4),
        shininess: 60.0,
        ..matt(name, color)
    }
}

/// Colour `i` of the wheel.
fn hue(i: u32) -> Rgb {
    let channel = |shift: f64| {
        let angle = std::f64::consts::TAU * (f64::from(i) / f64::from(HUES) + shift);
        0.45 + 0.4 * libm::cos(angle)
    };
    Rgb::new(channel(0.0), channel(1.0 / 3.0), channel(2.0 / 3.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_has_a_thousand_objects_of_one_shape_each_that_do_not_touch() {
        let scene = scene().expect("a view");
        assert_eq!((scene.objects.len(), scene.shapes.len()), (1000, 1000));
        let centers: Vec<DVec3> = scene.shapes[1..]
            .iter()
            .filter_map(|s| Some(s.bounds()?.center()))
            .collect();
        for (i, p) in centers.iter().enumerate() {
            for q in &centers[..i] {
                // Within 0.25 m of its middle lies all of a ball (0.2) and of a box (0.14 sqrt 3).
                assert!(p.distance(*q) > 0.45, "{p} {q}");
            }
        }
    }
}
