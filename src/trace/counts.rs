//! The probe that counts events. Unlike times, its numbers are the same on every machine.

use crate::probe::{Event, Probe, RayKind, Verdict};

/// How often each thing happened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// I rays.
    pub incident: u64,
    /// L rays.
    pub light: u64,
    /// R rays.
    pub reflected: u64,
    /// T rays.
    pub transmitted: u64,
    /// Surfaces that a ray went straight through: each is one more search.
    pub passed: u64,
    /// Nodes of the acceleration structure that were visited or skipped.
    pub nodes: u64,
    /// Primitives that were tested.
    pub tests: u64,
    /// Tests that found the closest hit so far.
    pub hits: u64,
}

impl Counts {
    /// All rays.
    pub fn rays(&self) -> u64 {
        self.incident + self.light + self.reflected + self.transmitted + self.passed
    }

    /// The sums of two counts.
    #[must_use]
    pub fn plus(self, other: &Self) -> Self {
        Self {
            incident: self.incident + other.incident,
            light: self.light + other.light,
            reflected: self.reflected + other.reflected,
            transmitted: self.transmitted + other.transmitted,
            passed: self.passed + other.passed,
            nodes: self.nodes + other.nodes,
            tests: self.tests + other.tests,
            hits: self.hits + other.hits,
        }
    }
}

impl Probe for Counts {
    const TRAVERSAL: bool = true;

    fn event(&mut self, event: Event) {
        match event {
            Event::Ray(sent) => match sent.kind {
                RayKind::Incident => self.incident += 1,
                RayKind::Light => self.light += 1,
                RayKind::Reflected => self.reflected += 1,
                RayKind::Transmitted => self.transmitted += 1,
            },
            Event::Passed { .. } => self.passed += 1,
            Event::Visit(_) => self.nodes += 1,
            Event::Test { verdict, .. } => {
                self.tests += 1;
                self.hits += u64::from(verdict == Verdict::Hit);
            }
            _ => {}
        }
    }
}
