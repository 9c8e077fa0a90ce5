//! Trees of bounding volumes: what a ray misses the volume of, it misses all of.
//!
//! One traversal for three trees, which differ only in how they are built and bounded: a binary tree of boxes
//! ([`super::bvh`]), the same tree of spheres, and an octree. Source: Rubin and Whitted 1980, "A 3-dimensional
//! representation for fast rendering of complex scenes"; Kay and Kajiya 1986 (nearest volume first).
//!
//! A hit at t lies within the slack of its shape (see `slack`), and the shape inside the volume: so volumes are grown
//! by the slack before they are asked, and no hit is lost.

use super::sift::{Sifted, bounds_of, sift};
use super::slack::Slack;
use super::{AccelStats, NodeView, Query};
use crate::geometry::{Aabb, Hit, Shape};
use crate::math::{DVec3, Interval, Ray};
use crate::probe::{Choice, Event, NONE, Probe, Visit, tell};

/// How many nodes may wait at most while a ray is followed.
pub const WAITING: usize = 160;

/// A tree of bounding volumes over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Boxes {
    /// The root is 0; the children of a node stand next to each other.
    pub nodes: Vec<Node>,
    /// The primitives of all leaves, those of one leaf next to each other and in order.
    pub references: Vec<u32>,
    /// What is outside the tree and tested first: shapes without an end, and those too large or placed too skew for
    /// a sharp bound.
    pub outside: Vec<u32>,
    /// How much volumes are grown.
    pub slack: Slack,
    /// Nodes on the longest way down.
    pub depth: u32,
}

/// A volume with what is in it.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    pub volume: Volume,
    /// The first child, or a leaf's first reference.
    pub first: u32,
    /// How many of them.
    pub count: u32,
    pub leaf: bool,
}

/// What bounds a node.
#[derive(Clone, Copy, Debug)]
pub enum Volume {
    Box(Aabb),
    Sphere { center: DVec3, radius: f64 },
}

/// A primitive to put into a tree.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub primitive: u32,
    pub bounds: Aabb,
}

impl Boxes {
    /// A tree without nodes, and the items to grow it from.
    pub fn seed(shapes: &[Shape]) -> (Self, Vec<Item>) {
        let Sifted {
            inside,
            outside,
            slack,
            ..
        } = sift(shapes, Slack::MAX_REACH);
        let item = |primitive| Item {
            primitive,
            bounds: bounds_of(shapes, primitive),
        };
        let items: Vec<Item> = inside.into_iter().map(item).collect();
        let tree = Self {
            nodes: Vec::new(),
            references: Vec::with_capacity(items.len()),
            outside,
            slack,
            depth: 0,
        };
        (tree, items)
    }

    /// Makes a node a leaf that holds these items.
    pub fn fill(&mut self, node: usize, items: &[Item]) {
        let first = self.references.len();
        self.references.extend(items.iter().map(|i| i.primitive));
        self.references[first..].sort_unstable();
        let node = &mut self.nodes[node];
        (node.first, node.count, node.leaf) = (first as u32, items.len() as u32, true);
    }

    /// The closest hit, or with `ANY` the first that turns up.
    #[inline(never)]
    pub fn search<const ANY: bool, P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        let mut best = None;
        if query.test_all::<ANY, P>(&self.outside, &mut best, probe) || self.nodes.is_empty() {
            return best;
        }
        let slack = self.slack.around(query.ray.origin);
        let Some(inside) = self.nodes[0].volume.clip(query, slack) else {
            if P::TRAVERSAL {
                tell!(
                    probe,
                    step(0, query.interval, Choice::SkippedOutside, [NONE; 2])
                );
            }
            return best;
        };
        // What waits, the nearest on top.
        let mut stack = [(0, inside); WAITING];
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let (id, inside) = stack[waiting];
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            if best.is_some_and(|hit| hit.t < inside.min) {
                if P::TRAVERSAL {
                    tell!(probe, step(id, inside, Choice::SkippedCloserHit, [NONE; 2]));
                }
                continue;
            }
            let node = &self.nodes[id as usize];
            if node.leaf {
                if P::TRAVERSAL {
                    tell!(probe, step(id, inside, Choice::Leaf, [NONE; 2]));
                }
                if query.test_all::<ANY, P>(self.primitives(node), &mut best, probe) {
                    return best;
                }
                continue;
            }
            let (first, mut missed) = (waiting, 0u32);
            for child in node.first..node.first + node.count {
                match self.nodes[child as usize].volume.clip(query, slack) {
                    Some(inside) => {
                        let mut place = waiting;
                        while place > first && stack[place - 1].1.min < inside.min {
                            stack[place] = stack[place - 1];
                            place -= 1;
                        }
                        stack[place] = (child, inside);
                        waiting += 1;
                    }
                    None => missed |= 1 << (child - node.first),
                }
            }
            if P::TRAVERSAL {
                let met = |rank| {
                    stack[first..waiting]
                        .iter()
                        .nth_back(rank)
                        .map_or(NONE, |c| c.0)
                };
                tell!(probe, step(id, inside, Choice::Children, [met(0), met(1)]));
                for child in (0..node.count).filter(|child| missed >> child & 1 == 1) {
                    let choice = Choice::SkippedMissed;
                    tell!(probe, step(node.first + child, inside, choice, [NONE; 2]));
                }
            }
        }
        best
    }

    /// A node as a reader sees it; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let node = self.nodes.get(id as usize)?;
        Some(NodeView {
            plane: None,
            axis: None,
            children: None,
            primitives: if node.leaf {
                self.primitives(node)
            } else {
                &[]
            },
        })
    }

    /// How large the tree is.
    pub fn stats(&self) -> AccelStats {
        AccelStats {
            nodes: self.nodes.len(),
            leaves: self.nodes.iter().filter(|n| n.leaf).count(),
            polygon_planes: 0,
            depth: self.depth,
            references: self.references.len() + self.outside.len(),
            bytes: size_of_val(&self.nodes[..])
                + size_of_val(&self.references[..])
                + size_of_val(&self.outside[..]),
        }
    }

    fn primitives(&self, leaf: &Node) -> &[u32] {
        &self.references[leaf.first as usize..][..leaf.count as usize]
    }
}

impl Volume {
    /// The part of a ray inside the volume grown by `slack`; `None` if it misses that.
    #[inline]
    fn clip(&self, query: &Query, slack: f64) -> Option<Interval> {
        match self {
            Self::Box(bounds) => {
                let grown = bounds.padded(DVec3::splat(slack));
                grown.clip(&query.ray, query.interval)
            }
            Self::Sphere { center, radius } => cut(
                &query.ray,
                *center,
                radius + 2.0 * slack,
                slack,
                query.interval,
            ),
        }
    }
}

/// The part of a ray inside a sphere: where the ray is closest to the center, and half the chord to both sides.
///
/// That distance is wrong by less than the slack e. The radius was grown by 2 e, so for a ray that really passes at
/// p <= r the chord stays long enough: (r + 2 e)^2 - (p + e)^2 >= r^2 - p^2. Numbers that are none keep the sphere in.
fn cut(ray: &Ray, center: DVec3, radius: f64, slack: f64, interval: Interval) -> Option<Interval> {
    let to_center = center - ray.origin;
    let speed = ray.direction.length();
    let t = to_center.dot(ray.direction) / (speed * speed);
    let away = (to_center - t * ray.direction).length();
    if away > radius {
        return None;
    }
    let half = ((radius - away) * (radius + away)).sqrt() + slack;
    // `max` and `min` pass over what is not a number.
    let inside = Interval::new(
        interval.min.max(t - half / speed),
        interval.max.min(t + half / speed),
    );
    (inside.min <= inside.max).then_some(inside)
}

fn step(node: u32, inside: Interval, choice: Choice, [near, far]: [u32; 2]) -> Event {
    Event::Visit(Visit {
        node,
        interval: [inside.min, inside.max],
        t_split: f64::NAN,
        near,
        far,
        choice,
    })
}
