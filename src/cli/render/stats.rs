//! What a render counted, and how long it took.

use crate::cli::{Completion, Failure, output};
use crate::scene::{Settings, Warning};
use crate::trace::{Counts, document};
use crate::tracer::Film;

/// The counters and times: for people on standard error, as JSON, with the warnings of the scene, on standard output.
pub fn tell(
    settings: &Settings,
    (counts, film): (&Counts, &Film),
    seconds: f64,
    json: Option<&[Warning]>,
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
    if let Some(warnings) = json {
        let stats = serde_json::json!({
            "image": { "width": settings.image.width, "height": settings.image.height },
            "accel": settings.accel.name(),
            "rays": { "I": incident, "L": light, "R": reflected, "T": transmitted, "passed": passed },
            "cut": cut(film), "nodes": nodes, "tests": tests, "hits": hits, "seconds": seconds,
            "warnings": document::list(warnings),
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
    if !film.cuts.rays.is_empty() {
        eprintln!("cut     {}", film.cuts);
    }
    eprintln!("nodes   {nodes} ({:.1} a ray)", per_ray(nodes));
    eprintln!("tests   {tests} ({:.1} a ray, {hits} hits)", per_ray(tests));
    eprintln!(
        "time    {seconds:.3} s ({:.2} million rays/s)",
        rays as f64 / seconds / 1e6
    );
    Ok(Completion::Whole)
}

/// What the limits of recursion left out.
fn cut(film: &Film) -> serde_json::Value {
    let cuts = &film.cuts;
    serde_json::json!({
        "depth": cuts.rays.by_depth, "weight": cuts.rays.by_weight, "share": cuts.share(),
        "dark_pixels": cuts.dark,
        "most": cuts.worst.map(|((x, y), share)| serde_json::json!({ "x": x, "y": y, "share": share })),
    })
}
