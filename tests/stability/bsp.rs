//! Trees: whatever they are made of, they say what the list says, which has no tree to go wrong.

use raytree::geometry::{Shape, Sphere};
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::Silent;

use super::support::{Random, all, bits, count, triangle};

/// Shapes that trees find hard: points on a coarse grid, so that corners, edges and planes coincide; the same triangle
/// many times; needles; all of it far off.
fn adversarial(random: &mut Random) -> (Vec<Shape>, DVec3, f64) {
    let size = libm::pow(10.0, [-3.0, 0.0, 3.0][random.below(3)]);
    let offset = size * [0.0, 1.0, 1e3, 1e6][random.below(4)] * random.point();
    let steps = [2.0, 4.0, 1e6][random.below(3)];
    let needle = [1.0, 1e-8][random.below(2)];
    let mut shapes = Vec::new();
    for _ in 0..=random.below(60) {
        let mut corner = || {
            let p = (steps * random.point()).round() / steps;
            offset + size * DVec3::new(p.x, p.y * needle, p.z)
        };
        let shape = triangle([corner(), corner(), corner()]);
        for _ in 0..[1, 1, 1, 9][random.below(4)] {
            shapes.push(shape.clone());
        }
    }
    for _ in 0..random.below(8) {
        shapes.push(Shape::Sphere(Sphere {
            center: offset + size * (2.0 * random.point()).round() / 2.0,
            radius: size * (0.01 + 0.5 * random.share()),
        }));
    }
    (shapes, offset, size)
}

/// Along an axis, in planes where trees split, or anyhow.
fn any_ray(random: &mut Random, offset: DVec3, size: f64) -> Ray {
    let on_grid = random.below(2) == 0;
    let place = |v: DVec3| if on_grid { (2.0 * v).round() / 2.0 } else { v };
    let origin = offset + size * place(2.0 * random.point());
    let direction = match random.below(3) {
        0 => DVec3::AXES[random.below(3)] * [1.0, -1.0][random.below(2)],
        1 => place(random.point()).normalize_or(DVec3::Z),
        _ => random.direction(),
    };
    Ray::new(origin, direction)
}

#[test]
fn case_17_every_tree_finds_what_the_list_finds() {
    let mut random = Random(17);
    let (scenes, rays) = (count(200, 40), count(500, 100));
    let mut met = 0;
    for scene in 0..scenes {
        let (shapes, offset, size) = adversarial(&mut random);
        let accels = all(&shapes);
        for _ in 0..rays {
            let ray = any_ray(&mut random, offset, size);
            let answers = accels.iter().map(|(kind, accel)| {
                let closest = accel.closest(&shapes, &ray, Interval::FORWARD, &mut Silent);
                let crossings = accel.crossings(&shapes, &ray, Interval::FORWARD);
                let crossings: Vec<_> = crossings.iter().map(bits).collect();
                (kind, closest.as_ref().map(bits), crossings)
            });
            let answers: Vec<_> = answers.collect();
            let (_, closest, crossings) = &answers[0];
            assert_eq!(
                closest.as_ref(),
                crossings.first(),
                "scene {scene}: {ray:?}"
            );
            for (kind, other, others) in &answers {
                assert_eq!(other, closest, "{kind:?}, scene {scene}: {ray:?}");
                assert_eq!(others, crossings, "{kind:?}, scene {scene}: {ray:?}");
            }
            met += usize::from(closest.is_some());
        }
    }
    println!("{scenes} scenes, {} rays, {met} hits", scenes * rays);
    assert!(met > scenes * rays / 20, "{met}");
}
