//! The document of a pixel that is written while it is traced, one sample's trees at a time: a pixel of a million rays takes no
//! more memory than one of a thousand.
//!
//! The pixel is traced twice. First it is foreseen: its colour and how much there will be, which stand before the samples. Then its
//! samples are traced, recorded and made into nodes, while the one before is being written.

use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

use serde::Serialize;
use serde::ser::{SerializeSeq as _, Serializer};

use super::make::{samples, with_samples};
use super::{Document, SampleTree};
use crate::probe::{Event, Probe};
use crate::scene::Settings;
use crate::trace::{PixelTrace, RayTree, Recorder, View};
use crate::tracer::{Pixel, pixel, thread_pool};
use crate::world::World;

/// Samples that are traced before they are written.
const AHEAD: usize = 1;

/// What the document of a pixel will hold.
#[derive(Clone, Debug)]
pub struct Foreseen {
    /// The pixel without its trees.
    pub trace: PixelTrace,
    /// Nodes of its trees.
    pub nodes: u64,
    /// Events that do not fit into the logs of their samples.
    pub dropped: u64,
    traversal: bool,
}

/// Traces a pixel to know what its document will hold.
pub fn foresee(
    world: &World,
    settings: &Settings,
    (x, y): (u32, u32),
    traversal: bool,
) -> Foreseen {
    let settings = &settings.with(|s| s.pixel.errors = true);
    let (pixel, counter) = thread_pool::install(1, || {
        let at = (x, y);
        if traversal {
            counted::<true>(world, settings, at)
        } else {
            counted::<false>(world, settings, at)
        }
    });
    let tree = RayTree::new(Recorder::<false>::default());
    Foreseen {
        trace: PixelTrace { x, y, pixel, tree },
        nodes: counter.0,
        dropped: counter.1,
        traversal,
    }
}

fn counted<const TRAVERSAL: bool>(
    world: &World,
    settings: &Settings,
    at: (u32, u32),
) -> (Pixel, (u64, u64)) {
    let mut counter = EventCounter::<TRAVERSAL>::default();
    let pixel = pixel(world, settings, at, &mut counter);
    (pixel, (counter.nodes, counter.dropped))
}

/// The document, whose samples are traced while it is written.
pub fn stream<'a>(
    world: &'a World,
    settings: &'a Settings,
    foreseen: &'a Foreseen,
) -> Document<SampleStream<'a>> {
    let view = View {
        world,
        settings,
        trace: &foreseen.trace,
    };
    let samples = SampleStream {
        view,
        traversal: foreseen.traversal,
    };
    with_samples(view, foreseen.dropped, samples)
}

/// The samples of a pixel: a list when it is written.
#[derive(Clone, Copy, Debug)]
pub struct SampleStream<'a> {
    view: View<'a>,
    traversal: bool,
}

impl Serialize for SampleStream<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(None)?;
        thread::scope(|scope| {
            let (sender, trees) = sync_channel(AHEAD);
            scope.spawn(move || self.record(sender));
            let mut before = 0;
            for tree in trees {
                let count = tree.nodes.len() as u32;
                for sample in self.nodes(tree, before) {
                    list.serialize_element(&sample)?;
                }
                before += count;
            }
            list.end()
        })
    }
}

impl SampleStream<'_> {
    /// Traces the pixel, and sends the tree of each sample as soon as it is whole.
    fn record(&self, trees: SyncSender<RayTree>) {
        let settings = &self.view.settings.with(|s| s.pixel.errors = true);
        let at = (self.view.trace.x, self.view.trace.y);
        thread_pool::install(1, || {
            if self.traversal {
                record::<true>(self.view.world, settings, at, trees);
            } else {
                record::<false>(self.view.world, settings, at, trees);
            }
        });
    }

    /// The nodes of a tree, before which there are so many others.
    fn nodes(&self, tree: RayTree, before: u32) -> Vec<SampleTree> {
        let PixelTrace { x, y, pixel, .. } = self.view.trace.clone();
        let trace = &PixelTrace { x, y, pixel, tree };
        let mut made = samples(View { trace, ..self.view });
        let mut open: Vec<_> = made.iter_mut().filter_map(|s| s.root.as_mut()).collect();
        while let Some(node) = open.pop() {
            node.id += before;
            open.extend(&mut node.children);
        }
        made
    }
}

fn record<const TRAVERSAL: bool>(
    world: &World,
    settings: &Settings,
    at: (u32, u32),
    trees: SyncSender<RayTree>,
) {
    let mut recorder = SampleRecorder {
        log: Recorder::<TRAVERSAL>::default(),
        trees: Some(trees),
    };
    pixel(world, settings, at, &mut recorder);
    recorder.send();
}

/// A recorder that gives its log away whenever the next sample begins.
struct SampleRecorder<const TRAVERSAL: bool> {
    log: Recorder<TRAVERSAL>,
    /// None as soon as nobody reads them any more.
    trees: Option<SyncSender<RayTree>>,
}

impl<const TRAVERSAL: bool> SampleRecorder<TRAVERSAL> {
    fn send(&mut self) {
        let log = std::mem::take(&mut self.log);
        if log.events.is_empty() {
            return;
        }
        self.trees
            .take_if(|trees| trees.send(RayTree::new(log)).is_err());
    }
}

impl<const TRAVERSAL: bool> Probe for SampleRecorder<TRAVERSAL> {
    const TRAVERSAL: bool = TRAVERSAL;

    fn event(&mut self, event: Event) {
        if self.trees.is_none() {
            return;
        }
        if matches!(event, Event::Sample { .. }) {
            self.send();
        }
        self.log.event(event);
    }
}

/// Counts what [`SampleRecorder`] would keep.
struct EventCounter<const TRAVERSAL: bool> {
    nodes: u64,
    dropped: u64,
    /// Room that is left in the log of the sample.
    room: usize,
}

impl<const TRAVERSAL: bool> Default for EventCounter<TRAVERSAL> {
    fn default() -> Self {
        Self {
            nodes: 0,
            dropped: 0,
            room: Recorder::<TRAVERSAL>::default().limit(),
        }
    }
}

impl<const TRAVERSAL: bool> Probe for EventCounter<TRAVERSAL> {
    const TRAVERSAL: bool = TRAVERSAL;

    fn event(&mut self, event: Event) {
        if matches!(event, Event::Sample { .. }) {
            self.room = Recorder::<TRAVERSAL>::default().limit();
        }
        if self.room == 0 {
            self.dropped += 1;
            return;
        }
        self.room -= 1;
        self.nodes += u64::from(matches!(event, Event::Ray(_)));
    }
}
