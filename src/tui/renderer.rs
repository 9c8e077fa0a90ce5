//! Work in the background: the picture, coarse blocks first, and the trace of a pixel. What is done comes as [`News`].

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

use rayon::prelude::*;

use super::nearing;
use super::picture::Window;
use super::session::Session;
use crate::math::Rgb;
use crate::probe::Silent;
use crate::scene::Settings;
use crate::tracer::{Pixel, on_threads, pixel};
use crate::world::World;

/// The sides of the blocks of the picture's passes.
pub const BLOCKS: [u32; 5] = [16, 8, 4, 2, 1];

/// Pixels that are told of at once.
const BATCH: usize = 32;

/// What the background has to tell.
pub enum News {
    /// Pixels of the picture.
    Pixels(u64, Vec<((u32, u32), Rgb)>),
    /// The last pixel is done.
    Rendered(u64),
    /// A pixel was traced.
    Traced(u64, Box<Session>),
    /// A pixel with more samples than before.
    Nearer(u64, Pixel),
    /// No more samples of it will come, and why.
    Near(u64, &'static str),
}

/// A job that stops when nobody holds it any more.
struct Job {
    ticket: u64,
    stop: Arc<AtomicBool>,
}

impl Drop for Job {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// The one who sends out work and hears of its results. News of work that was given up are dropped.
pub struct Renderer {
    threads: usize,
    sender: Sender<News>,
    receiver: Receiver<News>,
    tickets: u64,
    picture: Option<Job>,
    trace: Option<Job>,
    nearing: Option<Job>,
}

impl Renderer {
    /// Work on `threads` threads (0: one a core).
    pub fn new(threads: usize) -> Self {
        let (sender, receiver) = channel();
        Self {
            threads,
            sender,
            receiver,
            tickets: 0,
            picture: None,
            trace: None,
            nearing: None,
        }
    }

    /// A new job, and what its thread needs of it.
    fn job(&mut self) -> (Job, Arc<AtomicBool>, Sender<News>) {
        self.tickets += 1;
        let stop = Arc::new(AtomicBool::new(false));
        let job = Job {
            ticket: self.tickets,
            stop: Arc::clone(&stop),
        };
        (job, stop, self.sender.clone())
    }

    /// Renders the pixels of `window` that are not `known`, instead of what was rendered before.
    pub fn render(
        &mut self,
        world: &Arc<World>,
        settings: Settings,
        window: Window,
        known: Vec<bool>,
    ) {
        let (job, stop, sender) = self.job();
        let (ticket, world, threads) = (job.ticket, Arc::clone(world), self.threads);
        self.picture = Some(job);
        thread::spawn(move || {
            let tell = |news| drop(sender.send(news));
            let stopped = || stop.load(Ordering::Relaxed);
            for (pass, block) in BLOCKS.into_iter().enumerate() {
                let places: Vec<(u32, u32)> = places(window, pass, block)
                    .filter(|at| known.get(window.index(*at)) == Some(&false))
                    .collect();
                on_threads(threads, || {
                    places.par_chunks(BATCH).for_each(|chunk| {
                        let mut done = Vec::with_capacity(chunk.len());
                        for at in chunk {
                            if stopped() {
                                return;
                            }
                            done.push((*at, pixel(&world, &settings, *at, &mut Silent).color));
                        }
                        tell(News::Pixels(ticket, done));
                    });
                });
                if stopped() {
                    return;
                }
            }
            tell(News::Rendered(ticket));
        });
    }

    /// Traces a pixel, instead of one that was asked for before.
    pub fn trace(&mut self, world: &Arc<World>, settings: Settings, at: (u32, u32)) {
        let (job, stop, sender) = self.job();
        let (ticket, world) = (job.ticket, Arc::clone(world));
        self.trace = Some(job);
        thread::spawn(move || {
            let session = Session::new(world, settings, at);
            if !stop.load(Ordering::Relaxed) {
                drop(sender.send(News::Traced(ticket, Box::new(session))));
            }
        });
    }

    /// Forgets the pixel that is being traced.
    pub fn give_up_trace(&mut self) {
        self.trace = None;
    }

    /// Traces a pixel with more and more samples, instead of one that was asked for before.
    pub fn near(&mut self, world: &Arc<World>, settings: Settings, at: (u32, u32)) {
        let (job, stop, sender) = self.job();
        let (ticket, world) = (job.ticket, Arc::clone(world));
        self.nearing = Some(job);
        thread::spawn(move || {
            let stopped = || stop.load(Ordering::Relaxed);
            let tell = |pixel| drop(sender.send(News::Nearer(ticket, pixel)));
            let end = on_threads(1, || nearing::run(&world, &settings, at, &stopped, &tell));
            drop(sender.send(News::Near(ticket, end)));
        });
    }

    /// Takes no more samples of it.
    pub fn give_up_nearing(&mut self) {
        self.nearing = None;
    }

    /// True while anything is not done.
    pub fn is_working(&self) -> bool {
        [&self.picture, &self.trace, &self.nearing]
            .into_iter()
            .any(Option::is_some)
    }

    /// True while a pixel is traced.
    pub fn is_tracing(&self) -> bool {
        self.trace.is_some()
    }

    /// The next piece of news, if there is one by now.
    pub fn news(&mut self) -> Option<News> {
        let is = |job: &Option<Job>, ticket| job.as_ref().is_some_and(|job| job.ticket == ticket);
        loop {
            let news = self.receiver.try_recv().ok()?;
            match news {
                News::Pixels(ticket, _) if is(&self.picture, ticket) => return Some(news),
                News::Rendered(ticket) if is(&self.picture, ticket) => {
                    self.picture = None;
                    return Some(news);
                }
                News::Traced(ticket, _) if is(&self.trace, ticket) => {
                    self.trace = None;
                    return Some(news);
                }
                News::Nearer(ticket, _) if is(&self.nearing, ticket) => return Some(news),
                News::Near(ticket, _) if is(&self.nearing, ticket) => {
                    self.nearing = None;
                    return Some(news);
                }
                _ => {}
            }
        }
    }
}

/// The pixels of a pass: the first corners of all blocks that were not first corners of larger ones.
fn places(window: Window, pass: usize, block: u32) -> impl Iterator<Item = (u32, u32)> {
    let step = block as usize;
    let rows = (0..window.height).step_by(step);
    rows.flat_map(move |y| {
        (0..window.width)
            .step_by(step)
            .filter(move |x| pass == 0 || x % (2 * block) != 0 || y % (2 * block) != 0)
            .map(move |x| (window.x + x, window.y + y))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_passes_cover_every_pixel_once() {
        let window = Window {
            x: 3,
            y: 5,
            width: 37,
            height: 21,
        };
        let mut all: Vec<_> = BLOCKS
            .into_iter()
            .enumerate()
            .flat_map(|(pass, block)| places(window, pass, block))
            .collect();
        assert_eq!(all.len(), 37 * 21);
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), 37 * 21);
    }
}
