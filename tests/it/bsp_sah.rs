//! What planes at any angle are worth where nothing runs along an axis: steps and tests, which are the same in every
//! run.

use raytree::accel::{Accel, AccelKind, AccelStats};
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::{Event, Probe};
use raytree::sampling::stream::{splitmix64, to_unit_f64};
use raytree::scene::Scene;

/// Counts steps in the tree and tests of shapes.
#[derive(Default)]
struct Counts {
    steps: usize,
    tests: usize,
}

impl Probe for Counts {
    const TRAVERSAL: bool = true;

    fn event(&mut self, event: Event) {
        match event {
            Event::Visit(_) => self.steps += 1,
            Event::Test { .. } => self.tests += 1,
            _ => {}
        }
    }
}

/// What a ray takes on the average.
fn mean(accel: &Accel, scene: &Scene, rays: &[Ray]) -> f64 {
    let mut counts = Counts::default();
    for ray in rays {
        accel.closest(&scene.shapes, ray, Interval::FORWARD, &mut counts);
    }
    let each = |n: usize| n as f64 / rays.len() as f64;
    let (steps, tests) = (each(counts.steps), each(counts.tests));
    println!("{steps:.2} steps + {tests:.2} tests");
    steps + tests
}

/// The rays through a film of 96 x 72 pixels.
fn from_the_eye(scene: &Scene) -> Vec<Ray> {
    let through = |i: u32| {
        let film = [f64::from(i % 96) + 0.5, f64::from(i / 96) + 0.5];
        scene.camera.ray(film, (96, 72))
    };
    (0..96 * 72).map(through).collect()
}

/// Rays from anywhere to anywhere, as bounces are.
fn from_anywhere() -> Vec<Ray> {
    let point =
        |i: u64| DVec3::from([0, 1, 2].map(|k| 3.0 * to_unit_f64(splitmix64(3 * i + k)) - 1.5));
    let ray = |i: u64| Ray::new(point(2 * i), (point(2 * i + 1) - point(2 * i)).normalize());
    (0..5000).map(ray).collect()
}

fn trees(name: &str) -> (Scene, [Accel; 2], AccelStats) {
    let scene = raytree::scene::load(name).expect("built in");
    let trees = [AccelKind::Kd, AccelKind::BspSah].map(|k| Accel::build(k, &scene.shapes));
    let stats = trees[1].stats();
    println!("{name}: {:?}\n{stats:?}", trees[0].stats());
    (scene, trees, stats)
}

#[test]
fn planes_at_any_angle_take_fewer_steps_and_tests() {
    // How much of what kd takes may be left. Measured: 0.49 and 0.60 of it, and 0.90 and 0.88 on an even mesh.
    for (name, most) in [("slanted", 0.65), ("bunny", 0.95)] {
        let (scene, [kd, bsp], stats) = trees(name);
        assert!(stats.polygon_planes > 0);
        for rays in [from_the_eye(&scene), from_anywhere()] {
            let (bsp, kd) = (mean(&bsp, &scene, &rays), mean(&kd, &scene, &rays));
            println!("{:.3}", bsp / kd);
            assert!(bsp < most * kd, "{name}: {bsp:.2}, kd {kd:.2}");
        }
    }
}
