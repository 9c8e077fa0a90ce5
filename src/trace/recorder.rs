//! The probe that records every event.

use crate::probe::{Event, Probe};

pub use crate::scene::limits::{MAX_EVENT_BYTES, MAX_EVENTS};

/// A flat log of events, bounded: what comes after its limit is counted, not kept.
#[derive(Clone, Debug)]
pub struct Recorder<const TRAVERSAL: bool> {
    /// What happened, in order.
    pub events: Vec<Event>,
    /// How many events there was no room for.
    pub dropped: u64,
    limit: usize,
}

impl<const TRAVERSAL: bool> Recorder<TRAVERSAL> {
    /// A recorder that keeps the first `limit` events.
    pub fn with_limit(limit: usize) -> Self {
        Self {
            events: Vec::new(),
            dropped: 0,
            limit: limit
                .min(MAX_EVENTS)
                .min(MAX_EVENT_BYTES / size_of::<Event>()),
        }
    }

    /// How many events it keeps.
    pub fn limit(&self) -> usize {
        self.limit
    }
}

impl<const TRAVERSAL: bool> Default for Recorder<TRAVERSAL> {
    fn default() -> Self {
        Self::with_limit(MAX_EVENTS)
    }
}

impl<const TRAVERSAL: bool> Probe for Recorder<TRAVERSAL> {
    const TRAVERSAL: bool = TRAVERSAL;

    fn event(&mut self, event: Event) {
        if self.events.len() < self.limit {
            self.events.push(event);
        } else {
            self.dropped += 1;
        }
    }
}
