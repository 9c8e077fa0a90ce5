//! Worker: jobs on threads of their own. A new job of a kind stops the one before, whose results are dropped.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

use crate::debug::convergence::measure;
use crate::debug::edit::{edited, in_one_line};
use crate::debug::{Session, progressive};
use crate::lab::find::find;
use crate::scene::label as label_of;
use crate::tracer::thread_pool;
use crate::tui::model::{Job, JobOutput, Model};

/// A running job; it stops when it is dropped.
struct Running {
    ticket: u64,
    stop: Arc<AtomicBool>,
}

impl Drop for Running {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// A job's end of the channel to the worker.
struct Channel {
    ticket: u64,
    stop: Arc<AtomicBool>,
    sender: Sender<(u64, JobOutput)>,
}

impl Channel {
    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn send(&self, output: JobOutput) {
        drop(self.sender.send((self.ticket, output)));
    }
}

/// At most one job of each kind.
pub struct Worker {
    threads: usize,
    sender: Sender<(u64, JobOutput)>,
    receiver: Receiver<(u64, JobOutput)>,
    tickets: u64,
    picture: Option<Running>,
    trace: Option<Running>,
    convergence: Option<Running>,
    search: Option<Running>,
    change: Option<Running>,
}

impl Worker {
    /// A worker that renders pictures on `threads` threads (0: one a core).
    pub fn new(threads: usize) -> Self {
        let (sender, receiver) = channel();
        Self {
            threads,
            sender,
            receiver,
            tickets: 0,
            picture: None,
            trace: None,
            convergence: None,
            search: None,
            change: None,
        }
    }

    /// Begins a job, or cancels one.
    pub fn start(&mut self, job: Job, model: &Model) {
        match job {
            Job::Render => self.picture = Some(self.render(model)),
            Job::Trace => self.trace = Some(self.trace(model)),
            Job::CancelTrace => self.trace = None,
            Job::Converge => self.convergence = Some(self.converge(model)),
            Job::CancelConverge => self.convergence = None,
            Job::Search => self.search = self.search(model),
            Job::CancelSearch => self.search = None,
            Job::Change => self.change = self.change(model),
            Job::CancelChange => self.change = None,
        }
    }

    /// Runs a job on a thread.
    fn spawn(&mut self, job: impl FnOnce(&Channel) + Send + 'static) -> Running {
        self.tickets += 1;
        let channel = Channel {
            ticket: self.tickets,
            stop: Arc::new(AtomicBool::new(false)),
            sender: self.sender.clone(),
        };
        let running = Running {
            ticket: channel.ticket,
            stop: Arc::clone(&channel.stop),
        };
        thread::spawn(move || job(&channel));
        running
    }

    /// Renders the missing pixels of the picture.
    fn render(&mut self, model: &Model) -> Running {
        let (world, settings) = (Arc::clone(&model.world), model.settings);
        let (missing, threads) = (model.picture.missing(), self.threads);
        let mode = model.show;
        self.spawn(move |channel| {
            let stopped = || channel.is_stopped();
            let tell = |pixels| channel.send(JobOutput::Pixels(pixels));
            if progressive::render(
                (&world, &settings),
                mode,
                &missing,
                threads,
                &stopped,
                &tell,
            ) {
                channel.send(JobOutput::Rendered);
            }
        })
    }

    /// Ends the rendering of the picture.
    pub fn stop_picture(&mut self) {
        self.picture = None;
    }

    /// Records the pixel under the cursor.
    fn trace(&mut self, model: &Model) -> Running {
        let (world, settings) = (Arc::clone(&model.world), model.settings);
        let at = model.picture.cursor;
        self.spawn(move |channel| {
            let session = Session::new(world, settings, at);
            if !channel.is_stopped() {
                channel.send(JobOutput::Traced(Box::new(session)));
            }
        })
    }

    /// Traces the pixel under the cursor with more and more samples.
    fn converge(&mut self, model: &Model) -> Running {
        let (world, settings) = (Arc::clone(&model.world), model.settings);
        let at = model.picture.cursor;
        self.spawn(move |channel| {
            let stopped = || channel.is_stopped();
            let tell = |pixel| channel.send(JobOutput::Converged(pixel));
            let end = thread_pool::install(1, || measure(&world, &settings, at, &stopped, &tell));
            channel.send(JobOutput::ConvergenceEnd(end));
        })
    }

    /// Searches the picture for the query, if there is one.
    fn search(&mut self, model: &Model) -> Option<Running> {
        let query = model.search.as_ref()?.query.clone();
        let (world, settings) = (Arc::clone(&model.world), model.settings);
        let threads = self.threads;
        let running = self.spawn(move |channel| {
            let watch = |pixels: &[(u32, u32)], searched| {
                channel.send(JobOutput::Found(pixels.to_vec(), searched));
                if channel.is_stopped() {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            if find(&world, &settings, &query, usize::MAX, threads, &watch).complete {
                channel.send(JobOutput::Searched);
            }
        });
        Some(running)
    }

    /// Reads the scene with the changes that are asked for, and builds it.
    fn change(&mut self, model: &Model) -> Option<Running> {
        let edits = model.changing.as_ref()?.edits.clone();
        let source = Arc::clone(&model.options.source);
        let (settings, label) = (model.settings, model.options.scene.clone());
        let threads = self.threads;
        Some(self.spawn(move |channel| {
            let label = label_of(&label);
            let make = || edited(&source, &edits, &settings, label);
            let changed = thread_pool::install(threads, make);
            let changed = changed.map(Box::new).map_err(|e| in_one_line(&e));
            channel.send(JobOutput::Changed(changed));
        }))
    }

    /// True while any job runs.
    pub fn is_working(&self) -> bool {
        [
            &self.picture,
            &self.trace,
            &self.convergence,
            &self.search,
            &self.change,
        ]
        .into_iter()
        .any(Option::is_some)
    }

    /// True while the scene is changed or a pixel is traced, which most often takes no time.
    pub fn is_quick(&self) -> bool {
        self.change.is_some() || self.trace.is_some()
    }

    /// The next result, if there is one by now.
    pub fn output(&mut self) -> Option<JobOutput> {
        loop {
            let (ticket, output) = self.receiver.try_recv().ok()?;
            let (job, is_last) = match output {
                JobOutput::Pixels(_) => (&mut self.picture, false),
                JobOutput::Rendered => (&mut self.picture, true),
                JobOutput::Traced(_) => (&mut self.trace, true),
                JobOutput::Converged(_) => (&mut self.convergence, false),
                JobOutput::ConvergenceEnd(_) => (&mut self.convergence, true),
                JobOutput::Found(..) => (&mut self.search, false),
                JobOutput::Searched => (&mut self.search, true),
                JobOutput::Changed(_) => (&mut self.change, true),
            };
            if job.as_ref().is_some_and(|job| job.ticket == ticket) {
                if is_last {
                    *job = None;
                }
                return Some(output);
            }
        }
    }
}
