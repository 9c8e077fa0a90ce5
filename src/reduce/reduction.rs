//! Reduction of a scene, from the task to the file that was read again.

use std::fmt;

use super::error::ReduceError;
use super::search::Search;
use super::task::ReduceTask;
use crate::scene::kept::Kept;
use crate::scene::write::scene_file;
use crate::scene::{Scene, flags, from_json};
use crate::tracer::thread_pool;

/// A reduced scene.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// Its file, which was read again: the tree is the same.
    pub text: String,
    /// The scene in this file.
    pub scene: Scene,
    /// What of the whole scene it has.
    pub kept: Kept,
    /// Flags, with their values, that a scene file cannot stand for: with them the tree is the same.
    pub flags: Vec<(&'static str, String)>,
    /// Objects, shapes and lights that are left, and those of the whole scene.
    pub counts: [[usize; 2]; 3],
    /// What its shapes are called together.
    pub shapes_are: &'static str,
    /// Rays of the tree.
    pub rays: u64,
    /// Column and row of its pixel.
    pub pixel: (u32, u32),
    /// Scenes that were traced.
    pub trials: u64,
    /// False if the search was stopped: then more could be left out.
    pub complete: bool,
}

/// Reduces a scene to what the tree of a pixel needs.
pub fn reduce(task: ReduceTask) -> Result<Reduction, ReduceError> {
    thread_pool::install(task.threads, || reduce_here(task))
}

fn reduce_here(task: ReduceTask) -> Result<Reduction, ReduceError> {
    let mut search = Search::new(task)?;
    let mut kept = search.first()?;
    let complete = search.shrink(&mut kept).is_continue();
    let part = search.trials.part(&kept);
    let (x, y) = task.pixel;
    let note = format!(
        "Part of {}: pixel {x},{y} has the same ray tree.",
        task.scene.name
    );
    let text = scene_file(&part.scene, &note).map_err(ReduceError::NotWritten)?;
    let scene = from_json(&text).map_err(|error| ReduceError::NotWritten(error.to_string()))?;
    if !search.trials.has_tree(scene.clone(), &part.names) {
        return Err(ReduceError::NotSame);
    }
    let whole = task.scene;
    let triangles = whole.shapes.iter().all(|shape| shape.kind() == "triangle");
    let needed = flags(&(task.settings_of)(&scene), &scene);
    Ok(Reduction {
        flags: needed.into_iter().filter(|(f, _)| *f != "accel").collect(),
        counts: [
            [kept.objects(whole), whole.objects.len()],
            [kept.shapes.len(), whole.shapes.len()],
            [kept.lights.len(), whole.lights.len()],
        ],
        shapes_are: if triangles { "triangles" } else { "shapes" },
        rays: search.trials.rays(),
        pixel: task.pixel,
        trials: search.trials.count,
        text,
        scene,
        kept,
        complete,
    })
}

/// In a line what is left: `3 of 7 objects, 12 of 6,320 triangles, 1 of 2 lights; the tree of 160,120 is the same: 8 rays`.
impl fmt::Display for Reduction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = ["objects", self.shapes_are, "lights"];
        for (i, ([left, of], name)) in self.counts.iter().zip(names).enumerate() {
            let before = if i == 0 { "" } else { ", " };
            write!(f, "{before}{} of {} {name}", grouped(*left), grouped(*of))?;
        }
        let (x, y) = self.pixel;
        let rays = match self.rays {
            1 => "1 ray".to_owned(),
            n => format!("{} rays", grouped(n as usize)),
        };
        write!(f, "; the tree of {x},{y} is the same: {rays}")
    }
}

/// A number with a comma before every three digits.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut shown = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            shown.push(',');
        }
        shown.push(digit);
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn large_numbers_have_commas() {
        let shown = [0, 12, 999, 1000, 6320, 123_456, 1_234_567].map(grouped);
        let expected = ["0", "12", "999", "1,000", "6,320", "123,456", "1,234,567"];
        assert_eq!(shown, expected);
    }
}
