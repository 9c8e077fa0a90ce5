//! The ray tree: a fold of the log.
//!
//! The nodes stand in the order in which their rays were sent, so a node's descendants follow it without a gap: its
//! subtree is a range, its first child is the next node, and a child's next sibling stands behind the child's
//! subtree. Parent and size are all that has to be stored.

use super::Recorder;
use crate::geometry::Hit;
use crate::math::Rgb;
use crate::probe::{Event, RayRecord};

/// A ray tree for each sample of a pixel, in one arena, with the log that it was made from.
#[derive(Clone, Debug)]
pub struct RayTree {
    /// What happened, in order.
    pub events: Vec<Event>,
    /// The rays, in the order in which they were sent.
    pub nodes: Vec<Node>,
    /// The samples, in order.
    pub samples: Vec<Sample>,
    /// Events that the log had no room for; the rays that they belong to are missing or unfinished.
    pub dropped: u64,
}

/// A sample of the pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Its number.
    pub index: u32,
    /// Its position on the film, in pixels from the top left corner.
    pub film: [f64; 2],
    /// Its weight in the pixel's sum.
    pub weight: f64,
    /// The node of its eye ray; `None` if the log was cut before it.
    pub root: Option<u32>,
}

/// A ray in the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The ray as it was sent.
    pub ray: RayRecord,
    /// The node whose hit sent it; `None` for eye rays.
    pub parent: Option<u32>,
    /// The rays of its subtree, itself included.
    pub size: u32,
    /// Its events in the log: from its `Ray` to its `Return`.
    pub first_event: u32,
    /// The index of its `Return`, or of the last event of a log that was cut.
    pub last_event: u32,
    /// Product of the weights from the eye to here.
    pub throughput: Rgb,
    /// Sum of its own terms, in the order of the shading equation.
    pub own: Rgb,
    /// What it brings back.
    pub radiance: Rgb,
    /// How it ended; `None` if the log was cut before.
    pub outcome: Option<Outcome>,
}

/// How a ray ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// On a surface.
    Hit(Hit),
    /// Nowhere.
    Miss,
    /// An L ray at its light.
    Lit,
    /// An L ray at something before its light.
    Blocked(Hit),
}

impl Node {
    /// What its own terms add to the pixel's sample: throughput x their sum. Over a tree these add up to the root's
    /// radiance.
    pub fn contribution(&self) -> Rgb {
        self.throughput * self.own
    }

    /// What its whole subtree adds to the pixel's sample: throughput x radiance.
    pub fn total(&self) -> Rgb {
        self.throughput * self.radiance
    }
}

impl RayTree {
    /// Folds a log into its tree, with a stack of the rays that are under way.
    pub fn new<const TRAVERSAL: bool>(recorder: Recorder<TRAVERSAL>) -> Self {
        Self::fold(recorder.events, recorder.dropped)
    }

    /// The tree of the events before one: what is known by then.
    #[must_use]
    pub fn until(&self, end: usize) -> Self {
        let known = self.events.get(..end).unwrap_or(&self.events);
        Self::fold(known.to_vec(), 0)
    }

    fn fold(events: Vec<Event>, dropped: u64) -> Self {
        let mut tree = Self {
            events,
            nodes: Vec::new(),
            samples: Vec::new(),
            dropped,
        };
        let mut open: Vec<u32> = Vec::new();
        for (index, event) in (0..).zip(&tree.events) {
            if let Event::Ray(ray) = *event {
                let id = tree.nodes.len() as u32;
                let parent = open.last().copied();
                let throughput = parent.map_or(Rgb::WHITE, |p| tree.nodes[p as usize].throughput);
                if parent.is_none()
                    && let Some(sample) = tree.samples.last_mut()
                {
                    sample.root = Some(id);
                }
                tree.nodes.push(Node {
                    ray,
                    parent,
                    size: 1,
                    first_event: index,
                    last_event: index,
                    throughput: throughput * ray.weight,
                    own: Rgb::BLACK,
                    radiance: Rgb::BLACK,
                    outcome: None,
                });
                open.push(id);
                continue;
            }
            if let Event::Sample {
                index,
                film,
                weight,
            } = *event
            {
                tree.samples.push(Sample {
                    index,
                    film,
                    weight,
                    root: None,
                });
                continue;
            }
            let Some(&current) = open.last() else {
                continue;
            };
            let count = tree.nodes.len() as u32;
            let node = &mut tree.nodes[current as usize];
            match *event {
                Event::Hit(hit) => node.outcome = Some(Outcome::Hit(hit)),
                Event::Miss => node.outcome = Some(Outcome::Miss),
                Event::Lit => node.outcome = Some(Outcome::Lit),
                Event::Blocked(hit) => node.outcome = Some(Outcome::Blocked(hit)),
                Event::Term { term, .. } => node.own += term.value(),
                Event::Return { radiance } => {
                    node.radiance = radiance;
                    node.last_event = index;
                    node.size = count - current;
                    open.pop();
                }
                _ => {}
            }
        }
        tree.close(&open);
        tree
    }

    /// Ends the rays that a cut log left under way at its end.
    fn close(&mut self, open: &[u32]) {
        let count = self.nodes.len() as u32;
        let last = self.events.len().saturating_sub(1) as u32;
        for &id in open {
            let node = &mut self.nodes[id as usize];
            node.size = count - id;
            node.last_event = last;
        }
    }

    /// A node.
    pub fn node(&self, id: u32) -> &Node {
        &self.nodes[id as usize]
    }

    /// True if its `Return` is in the log.
    pub fn is_done(&self, id: u32) -> bool {
        let last = self.node(id).last_event;
        let is_return = matches!(self.events.get(last as usize), Some(Event::Return { .. }));
        // In a log that was cut the last event may be the return of a ray that it sent.
        is_return
            && !self
                .children(id)
                .any(|child| self.node(child).last_event == last)
    }

    /// The rays that a node's hit sent, in order.
    pub fn children(&self, id: u32) -> impl Iterator<Item = u32> + '_ {
        let end = id + self.node(id).size;
        let mut next = id + 1;
        std::iter::from_fn(move || {
            let child = (next < end).then_some(next)?;
            next += self.node(child).size;
            Some(child)
        })
    }

    /// The events of the node itself, without those of the rays that it sent, with their indices in the log.
    pub fn own_events(&self, id: u32) -> impl Iterator<Item = (usize, &Event)> + '_ {
        let node = self.node(id);
        let mut next = node.first_event as usize;
        let mut children = self.children(id).peekable();
        std::iter::from_fn(move || {
            while let Some(child) = children.next_if(|c| self.node(*c).first_event as usize == next)
            {
                next = self.node(child).last_event as usize + 1;
            }
            let index = (next <= node.last_event as usize).then_some(next)?;
            next += 1;
            Some((index, &self.events[index]))
        })
    }

    /// What an L ray's light adds where the ray was sent. Its terms stand right behind it, so that this takes no longer
    /// where it is one of thousands to a light.
    pub fn lit_by(&self, id: u32) -> Rgb {
        let node = self.node(id);
        let behind = self.events.get(node.last_event as usize + 1..);
        let terms = behind
            .unwrap_or_default()
            .iter()
            .map_while(|event| match *event {
                Event::Term {
                    light,
                    sample,
                    term,
                } if (light, sample) == (node.ray.light, node.ray.sample) => Some(term.value()),
                _ => None,
            });
        terms.fold(Rgb::BLACK, |sum, value| sum + value)
    }

    /// The node that an event of the log belongs to; `None` for events between the samples.
    pub fn node_of_event(&self, event: usize) -> Option<u32> {
        let started = self
            .nodes
            .partition_point(|n| n.first_event as usize <= event);
        let mut id = started.checked_sub(1)? as u32;
        // The ray sent last before the event, or the nearest ray around it that is not done yet.
        while (self.node(id).last_event as usize) < event {
            id = self.node(id).parent?;
        }
        Some(id)
    }

    /// The sample whose tree a node is in.
    pub fn sample_of_node(&self, id: u32) -> Option<&Sample> {
        let after = self
            .samples
            .partition_point(|s| s.root.is_some_and(|r| r <= id));
        self.samples.get(after.checked_sub(1)?)
    }
}
