//! Rays a second: every accelerator, and other crates next to them, on the same rays in the same run.
//!
//! The other crates compute in single precision and answer nearly the same; raytree computes in double precision and
//! answers exactly. What counts are ratios, taken in turns, so that a slow minute of the machine hits all alike.
//!
//! `cargo bench -p raytree-benches --bench rays` runs criterion on each of raytree's accelerators, then prints the matrix;
//! with `-- nomatch` only the matrix; with `RAYTREE_BOOK=1` the matrix goes into the book as well, and
//! `RAYTREE_MESH=ball` takes one mesh, `RAYTREE_WHO=kd,bsp-sah` only the accelerators of such names.

#[path = "common/ball.rs"]
mod ball;
#[path = "rays/matrix.rs"]
mod matrix;
#[path = "rays/mesh.rs"]
mod mesh;
#[path = "rays/peers.rs"]
mod peers;
#[path = "rays/sent.rs"]
mod sent;
#[path = "common/table.rs"]
mod table;

use std::time::Duration;

use criterion::{Criterion, Throughput};
use raytree::accel::{Accel, AccelKind};
use raytree::geometry::Shape;
use raytree::probe::Silent;

/// Criterion runs every so many-th block of 256 rays.
const SHARE: usize = 64;

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    let wanted = std::env::var("RAYTREE_MESH").ok();
    let meshes = mesh::all().into_iter();
    let mut tables = Vec::new();
    for (name, triangles) in meshes.filter(|(name, _)| wanted.as_deref().is_none_or(|w| w == *name))
    {
        let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
        watch(&mut criterion, name, &shapes);
        tables.push(matrix::measure(name, &triangles));
    }
    criterion.final_summary();
    table::publish("rays", &tables.join("\n"));
}

/// Criterion on each accelerator, to see what a change does.
fn watch(criterion: &mut Criterion, mesh: &str, shapes: &[Shape]) {
    let kinds = AccelKind::ALL.into_iter().filter(|k| *k != AccelKind::List);
    let accels: Vec<_> = kinds.map(|k| (k, Accel::build(k, shapes))).collect();
    let Some((_, any)) = accels.first() else {
        return;
    };
    for kind in sent::kinds(any, shapes) {
        let rays: Vec<_> = kind.rays.chunks(256).step_by(SHARE).flatten().collect();
        let find = if kind.any {
            Accel::any_hit
        } else {
            Accel::closest
        };
        let mut group = criterion.benchmark_group(format!("{mesh}/{}", kind.name));
        group.throughput(Throughput::Elements(rays.len() as u64));
        for (name, accel) in &accels {
            group.bench_function(name.name(), |b| {
                b.iter(|| {
                    let hit = |(ray, interval): &&&sent::Sent| {
                        find(accel, shapes, ray, *interval, &mut Silent).is_some()
                    };
                    rays.iter().filter(hit).count()
                });
            });
        }
        group.finish();
    }
}
