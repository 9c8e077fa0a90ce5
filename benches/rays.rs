//! Rays a second: the list, the trees, and a well-kept BVH crate next to them, on the same rays in the same run.
//!
//! `obvhs` computes in single precision and answers nearly the same; raytree computes in double precision and answers
//! exactly. The ratios at the end are taken in turns, so that a slow minute of the machine hits all alike.

#[path = "rays/bundles.rs"]
mod bundles;

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, Throughput};
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::ray::RayHit;
use raytree::accel::{Accel, AccelKind};
use raytree::geometry::{Aabb, Shape, Triangle};
use raytree::math::{DVec3, Interval, Ray};
use raytree::probe::Silent;

/// The list is only asked where it ends within reason.
const LIST_LIMIT: usize = 10_000;

/// A ball with bumps of 4 rings^2 triangles.
fn bumpy_ball(rings: usize) -> Vec<Triangle> {
    let at = |i: usize, j: usize| {
        let theta = std::f64::consts::PI * i as f64 / rings as f64;
        let phi = std::f64::consts::PI * (j % (2 * rings)) as f64 / rings as f64;
        let bump = 1.0 + 0.1 * libm::sin(9.0 * theta) * libm::sin(7.0 * phi);
        let (sin, cos) = (libm::sin(theta), libm::cos(theta));
        bump * DVec3::new(sin * libm::cos(phi), cos, sin * libm::sin(phi))
    };
    (0..rings)
        .flat_map(|i| (0..2 * rings).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            [[a, b, c], [a, c, d]].map(|corners| Triangle { corners })
        })
        .collect()
}

/// The triangles of a box, turned about the y axis.
fn turned_box(center: DVec3, half: DVec3, angle: f64) -> Vec<Triangle> {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let place = |s: [f64; 3]| {
        let p = DVec3::from(s) * half;
        center + DVec3::new(cos * p.x + sin * p.z, p.y, cos * p.z - sin * p.x)
    };
    (0..3)
        .flat_map(|axis| [-1.0, 1.0].map(|side| (axis, side)))
        .flat_map(|(axis, side)| {
            let at = |u: f64, v: f64| {
                let mut s = [side; 3];
                (s[(axis + 1) % 3], s[(axis + 2) % 3]) = (u, v);
                place(s)
            };
            let (a, b, c, d) = (at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0));
            [[a, b, c], [a, c, d]].map(|corners| Triangle { corners })
        })
        .collect()
}

/// A few large polygons: what a tree of the polygons' own planes is best at.
fn room() -> Vec<Triangle> {
    [
        turned_box(DVec3::ZERO, DVec3::splat(4.0), 0.0),
        turned_box(DVec3::new(-0.5, -0.4, -0.5), DVec3::new(0.3, 0.6, 0.3), 0.3),
        turned_box(DVec3::new(0.5, -0.7, 0.2), DVec3::splat(0.3), -0.4),
    ]
    .concat()
}

/// The built-in bunny of 3,674 triangles, scaled into a box of 2 units around the origin.
fn bunny() -> Vec<Triangle> {
    let scene = raytree::scene::load("bunny").expect("built in");
    let of_bunny = scene
        .shapes
        .iter()
        .enumerate()
        .filter_map(|(id, shape)| match shape {
            Shape::Triangle(triangle) if scene.object_of(id as u32).name == "bunny" => {
                Some(*triangle)
            }
            _ => None,
        });
    let triangles: Vec<Triangle> = of_bunny.collect();
    let bounds = Aabb::around(triangles.iter().flat_map(|t| t.corners));
    let scale = 2.0 / bounds.size().max_element();
    let fit = |p: DVec3| (p - bounds.center()) * scale;
    triangles
        .into_iter()
        .map(|t| Triangle {
            corners: t.corners.map(fit),
        })
        .collect()
}

/// What is measured, seen from about 3 m away.
fn meshes() -> Vec<(&'static str, Vec<Triangle>)> {
    vec![
        ("room-36", room()),
        ("bunny", bunny()),
        ("ball-4k", bumpy_ball(32)),
        ("ball-100k", bumpy_ball(158)),
    ]
}

/// One ray for each of 160 x 120 pixels.
fn primary_rays() -> Vec<(Ray, Interval)> {
    let eye = DVec3::new(0.4, 0.7, 3.0);
    let w = eye.normalize();
    let u = DVec3::Y.cross(w).normalize();
    let v = w.cross(u);
    (0..120)
        .flat_map(|y| (0..160).map(move |x| (x, y)))
        .map(|(x, y)| {
            let (x, y) = ((x as f64 - 79.5) / 160.0, (59.5 - y as f64) / 160.0);
            (
                Ray::new(eye, (x * u + y * v - w).normalize()),
                Interval::FORWARD,
            )
        })
        .collect()
}

/// From each place that a primary ray hits to a light, started a little off the surface.
fn shadow_rays(
    accel: &Accel,
    shapes: &[Shape],
    primary: &[(Ray, Interval)],
) -> Vec<(Ray, Interval)> {
    let light = DVec3::new(4.0, 3.0, 1.0);
    primary
        .iter()
        .filter_map(|(ray, interval)| {
            let hit = accel.closest(shapes, ray, *interval, &mut Silent)?;
            let origin = ray.at(hit.t * (1.0 - 1e-4));
            let way = light - origin;
            Some((
                Ray::new(origin, way.normalize()),
                Interval::before(way.length()),
            ))
        })
        .collect()
}

/// The other crate's tree over the same triangles.
struct Other {
    bvh: Bvh2,
    triangles: Vec<obvhs::triangle::Triangle>,
}

impl Other {
    fn build(triangles: &[Triangle]) -> Self {
        let corner = |p: DVec3| Vec3A::from(p.as_vec3());
        let triangles: Vec<_> = triangles
            .iter()
            .map(|t| obvhs::triangle::Triangle {
                v0: corner(t.corners[0]),
                v1: corner(t.corners[1]),
                v2: corner(t.corners[2]),
            })
            .collect();
        let params = BvhBuildParams::medium_build();
        let bvh = build_bvh2_from_tris(&triangles, params, &mut Duration::default());
        // In the order of the leaves, so that a leaf's triangles lie next to each other.
        let triangles = bvh
            .primitive_indices
            .iter()
            .map(|&i| triangles[i as usize])
            .collect();
        Self { bvh, triangles }
    }

    fn ray(&(ray, interval): &(Ray, Interval)) -> obvhs::ray::Ray {
        obvhs::ray::Ray::new(
            ray.origin.as_vec3().into(),
            ray.direction.as_vec3().into(),
            interval.min as f32,
            interval.max as f32,
        )
    }

    fn closest(&self, ray: obvhs::ray::Ray) -> bool {
        let mut hit = RayHit::none();
        self.bvh
            .ray_traverse(ray, &mut hit, |ray, id| self.triangles[id].intersect(ray));
        hit.t < ray.tmax
    }

    fn any(&self, ray: obvhs::ray::Ray) -> bool {
        !self
            .bvh
            .ray_traverse_miss(ray, |ray, id| self.triangles[id].intersect(ray))
    }
}

/// Something that can be timed: how many of the rays hit.
type Run<'a> = Box<dyn Fn() -> usize + 'a>;

/// All contestants for one mesh and one kind of ray.
fn runs<'a>(
    accels: &'a [(&'static str, Accel)],
    other: &'a Other,
    shapes: &'a [Shape],
    rays: &'a [(Ray, Interval)],
    shadow: bool,
) -> Vec<(&'static str, Run<'a>)> {
    let ours = accels.iter().map(|(name, accel)| {
        let run: Run = Box::new(move || {
            let hits = rays.iter().filter(|(ray, interval)| {
                let find = if shadow { Accel::any } else { Accel::closest };
                find(accel, shapes, ray, *interval, &mut Silent).is_some()
            });
            hits.count()
        });
        (*name, run)
    });
    let single: Vec<_> = rays.iter().map(Other::ray).collect();
    let theirs: Run = Box::new(move || {
        let hits = single.iter().filter(|&&ray| {
            if shadow {
                other.any(ray)
            } else {
                other.closest(ray)
            }
        });
        hits.count()
    });
    ours.chain([("obvhs", theirs)]).collect()
}

/// Builds a structure and says how long that took.
fn timed<T>(name: &str, build: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let built = build();
    println!(
        "  {name:12} built in {:8.1} ms",
        start.elapsed().as_secs_f64() * 1e3
    );
    built
}

/// The least time of several rounds, the contestants taking turns.
fn least_times(runs: &[(&str, Run)]) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; runs.len()];
    for _ in 0..7 {
        for (time, (name, run)) in least.iter_mut().zip(runs) {
            if *name == "list" && time.is_finite() {
                continue;
            }
            let start = Instant::now();
            black_box(run());
            *time = time.min(start.elapsed().as_secs_f64());
        }
    }
    least
}

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    let mut table = Vec::new();
    for (mesh, triangles) in meshes() {
        println!("{mesh}: {} triangles", triangles.len());
        let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
        let kinds = [
            ("list", AccelKind::List),
            ("bsp", AccelKind::Bsp),
            ("bsp-axis", AccelKind::BspAxis),
            ("bsp-polygon", AccelKind::BspPolygon),
            ("wide", AccelKind::Wide),
        ];
        let accels: Vec<_> = kinds
            .into_iter()
            .filter(|(name, _)| *name != "list" || shapes.len() <= LIST_LIMIT)
            .map(|(name, kind)| (name, timed(name, || Accel::build(kind, &shapes))))
            .collect();
        let other = timed("obvhs", || Other::build(&triangles));
        for (name, accel) in &accels {
            println!("  {name:12} {:?}", accel.stats());
        }
        let primary = primary_rays();
        let Some((_, tree)) = accels.last() else {
            continue;
        };
        let shadow = shadow_rays(tree, &shapes, &primary);
        for (kind, rays) in [("primary", &primary), ("shadow", &shadow)] {
            let runs = runs(&accels, &other, &shapes, rays, kind == "shadow");
            let mut group = criterion.benchmark_group(format!("{mesh}/{kind}"));
            group.throughput(Throughput::Elements(rays.len() as u64));
            for (name, run) in runs.iter().filter(|(name, _)| *name != "list") {
                group.bench_function(*name, |b| b.iter(run));
            }
            group.finish();
            let times = least_times(&runs);
            for ((name, run), time) in runs.iter().zip(&times) {
                let ratio = times[times.len() - 1] / time;
                table.push(format!(
                    "{mesh:10} {kind:8} {name:12} {:12.0} rays/s {ratio:8.3} of obvhs  {:6} of {} hit",
                    rays.len() as f64 / time,
                    run(),
                    rays.len(),
                ));
            }
        }
    }
    criterion.final_summary();
    println!("\n{}\n", table.join("\n"));
    bundles::table(&[("bunny", bunny()), ("ball-100k", bumpy_ball(158))]);
}
