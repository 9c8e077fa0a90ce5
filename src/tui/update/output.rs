//! Results of the worker.

use super::{ask, compare, edit, search};
use crate::debug::progressive::DrawnPixel;
use crate::lab::show::ShownValue;
use crate::tui::model::{JobOutput, Model};

/// Takes in a result.
pub fn take_in(model: &mut Model, output: JobOutput) {
    match output {
        JobOutput::Pixels(pixels) => {
            for (at, drawn) in pixels {
                match drawn {
                    DrawnPixel::Pixel(pixel) => {
                        model.picture.set(at, ShownValue::Color(pixel.color));
                        model.picture.cuts.add(at, &pixel);
                    }
                    DrawnPixel::Shown(value) => model.picture.set(at, value),
                }
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
        JobOutput::Found(pixels, searched) => search::found(model, &pixels, searched),
        JobOutput::Searched => search::finished(model),
        JobOutput::Changed(changed) => edit::take_in(model, changed),
        JobOutput::Traced(mut session) => {
            let again = model.again.take();
            if let Some(address) = model.options.at.take() {
                if let Err(problem) = session.go_to_address(&address) {
                    model.message = Some(problem);
                }
            } else if let Some(path) = again {
                if !session.go_to_nearest(&path) {
                    let told = format!("there is no ray {path} any more: this is what led to it");
                    model.message.get_or_insert(told);
                }
            } else if let Some(search) = &model.search {
                session.find_first(&search.query);
            }
            ask::opened(model, &mut session);
            model.session = Some(session);
            model.layout.scroll = 0;
            model.waiting = None;
            if let Some(text) = model.options.compare.take()
                && let Err(problem) = compare::typed(model, &text)
            {
                model.message = Some(problem);
            }
        }
    }
}
