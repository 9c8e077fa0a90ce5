//! What it cost to come near enough.

use crate::cli::command_line;
use crate::lab::converge::{Convergence, StopReason};
use crate::scene::Scene;

/// The tries, and the command lines that give the last of them again.
pub fn passes(found: &Convergence, wanted: f64, scene: (&str, &Scene)) -> String {
    let mut text = "samples     error          rays   seconds\n".to_owned();
    for t in &found.passes {
        let line = format!(
            "{:>7}  {:>8.6}  {:>12}  {:>8.3}\n",
            t.samples, t.error, t.rays, t.seconds
        );
        text += &line;
    }
    let rays: u64 = found.passes.iter().map(|t| t.rays).sum();
    let seconds: f64 = found.passes.iter().map(|t| t.seconds).sum();
    let error = found.passes.last().map_or(f64::INFINITY, |t| t.error);
    let (relation, why) = match found.stop {
        StopReason::Reached => ("at most", ""),
        StopReason::Rays => ("not yet", ": the next try would take more than --max-rays"),
        StopReason::Samples => ("not yet", ": the next try would take too many samples"),
        StopReason::Cut => ("not yet", ": a limit cut it short"),
    };
    let words = command_line::words(scene.0, &found.settings, scene.1);
    text + &format!(
        "estimated error {error:.6}, {relation} {wanted}{why}; in all {rays} rays, {seconds:.3} s\n\
again: raytree render {words}\n\
a pixel of it: raytree trace {words} --pixel X,Y\n"
    )
}
