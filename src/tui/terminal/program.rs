//! Program without a screen: the model, its update, and the worker that does what the update asks for.

use std::time::{Duration, Instant};

use ratatui::layout::Rect;

use super::worker::Worker;
use crate::lab::show::ShownValue;
use crate::scene::Settings;
use crate::tracer::Film;
use crate::tui::model::{Job, Message, Model, Options};
use crate::tui::update::{start, update};
use crate::world::World;

/// How long Enter waits for the tree before the screen is drawn and other keys have their turn: within a frame of 16 ms.
const AT_ONCE: Duration = Duration::from_millis(10);

/// The state and its worker.
pub struct Program {
    /// The state.
    pub model: Model,
    worker: Worker,
}

impl Program {
    /// The picture of a world on a screen of this size; rendering begins at once.
    pub fn new(world: World, settings: Settings, options: Options, screen: Rect) -> Self {
        let mut program = Self {
            worker: Worker::new(options.threads),
            model: Model::new(world, settings, options, screen),
        };
        start(&mut program.model);
        program.start_jobs();
        program
    }

    /// Shows a picture that was drawn otherwise, of the same size, in the place of rendering it.
    pub fn show(&mut self, film: &Film) {
        self.worker.stop_picture();
        for (y, row) in (0..).zip(film.pixels.chunks(film.width.max(1) as usize)) {
            for (x, color) in (0..).zip(row) {
                self.model.picture.set((x, y), ShownValue::Color(*color));
            }
        }
    }

    /// Takes in a message. False if it means nothing.
    pub fn send(&mut self, message: Message) -> bool {
        let known = update(&mut self.model, message);
        self.start_jobs();
        known
    }

    /// Starts what the update asked for. Most pixels are traced at once, and most scenes changed, so that keys typed ahead mean what
    /// they should; for others a spinner turns.
    fn start_jobs(&mut self) {
        let asked = Instant::now();
        let is_quick = |job: &Job| matches!(job, Job::Trace | Job::Change);
        let waits = self.model.jobs.iter().any(is_quick);
        self.launch();
        while waits && self.worker.is_quick() && asked.elapsed() < AT_ONCE {
            if !self.receive() {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }

    fn launch(&mut self) {
        for job in std::mem::take(&mut self.model.jobs) {
            self.worker.start(job, &self.model);
        }
    }

    /// Takes in what the worker has done by now, and starts what that asks for. True if there was anything.
    pub fn receive(&mut self) -> bool {
        let mut any = false;
        while let Some(output) = self.worker.output() {
            any = true;
            update(&mut self.model, Message::Output(output));
            self.launch();
        }
        any
    }

    /// True while the worker works.
    pub fn is_busy(&self) -> bool {
        self.worker.is_working()
    }
}
