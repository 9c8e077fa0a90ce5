//! Results of the worker.

use crate::tui::model::{JobOutput, Model};

/// Takes in a result.
pub fn take_in(model: &mut Model, output: JobOutput) {
    match output {
        JobOutput::Pixels(pixels) => {
            for (at, pixel) in pixels {
                model.picture.set(at, pixel.color);
                model.picture.cuts.add(at, &pixel);
            }
        }
        JobOutput::Rendered => {}
        JobOutput::Converged(pixel) => {
            if let Some(convergence) = &mut model.convergence {
                convergence.pixels.push(pixel);
            }
        }
        JobOutput::ConvergenceEnd(end) => {
            if let Some(convergence) = &mut model.convergence {
                convergence.end = Some(end);
            }
        }
        JobOutput::Traced(mut session) => {
            if let Some(address) = model.options.at.take() {
                model.message = session.go_to_address(&address).err();
            }
            model.session = Some(session);
            model.layout.scroll = 0;
            model.waiting = None;
        }
    }
}
