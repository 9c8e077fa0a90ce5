//! What a render counted, and how long it took.

use crate::cli::{Completion, Failure, output};
use crate::scene::{Scene, Settings};
use crate::trace::{Counts, document};

/// The counters and times: for people on standard error, as JSON, with the warnings of the scene, on standard output.
pub fn tell(
    settings: &Settings,
    counts: &Counts,
    seconds: f64,
    json: Option<&Scene>,
) -> Result<Completion, Failure> {
    let Counts {
        incident,
        light,
        reflected,
        transmitted,
        passed,
        nodes,
        tests,
        hits,
    } = *counts;
    if let Some(scene) = json {
        let stats = serde_json::json!({
            "image": { "width": settings.image.width, "height": settings.image.height },
            "accel": settings.accel.name(),
            "rays": { "I": incident, "L": light, "R": reflected, "T": transmitted, "passed": passed },
            "nodes": nodes, "tests": tests, "hits": hits, "seconds": seconds,
            "warnings": document::list(&scene.warnings),
        });
        return output::to_stdout(format!("{stats:#}\n").as_bytes());
    }
    let rays = counts.rays();
    let per_ray = |n: u64| n as f64 / rays.max(1) as f64;
    let straight_on = match passed {
        0 => String::new(),
        n => format!(", {n} straight on"),
    };
    eprintln!(
        "rays    {rays} (I {incident}, L {light}, R {reflected}, T {transmitted}{straight_on})"
    );
    eprintln!("nodes   {nodes} ({:.1} a ray)", per_ray(nodes));
    eprintln!("tests   {tests} ({:.1} a ray, {hits} hits)", per_ray(tests));
    eprintln!(
        "time    {seconds:.3} s ({:.2} million rays/s)",
        rays as f64 / seconds / 1e6
    );
    Ok(Completion::Whole)
}
