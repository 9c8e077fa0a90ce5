//! The rays of a document in the order in which they were sent, with what each adds to the pixel.

use std::collections::HashMap;

use super::{Document, RayNode, SampleTree};
use crate::math::Rgb;
use crate::probe::RayKind;

/// A ray of a sample's tree, and where it stands there.
#[derive(Clone, Copy, Debug)]
pub struct RayInTree<'a> {
    /// The ray.
    pub node: &'a RayNode,
    /// The ray whose hit sent it, counted in this order; `None` for the eye ray.
    pub parent: Option<usize>,
    /// Rays between it and the eye.
    pub level: usize,
    /// True if no ray after it was sent from the same hit.
    pub is_last: bool,
    /// What its subtree adds to the sample: throughput x radiance; for an L ray the light's terms at its parent.
    pub contribution: Rgb,
}

impl SampleTree {
    /// The rays of the sample, parents first. Without recursion: trees may be deep.
    pub fn rays(&self) -> impl Iterator<Item = RayInTree<'_>> {
        let root = self.root.as_ref().map(|node| RayInTree {
            node,
            parent: None,
            level: 0,
            is_last: true,
            contribution: node.total(),
        });
        // The rays still to come, the next one at the end.
        let mut open: Vec<RayInTree> = root.into_iter().collect();
        let mut count = 0;
        std::iter::from_fn(move || {
            let ray = open.pop()?;
            open.extend(children(&ray, count).rev());
            count += 1;
            Some(ray)
        })
    }
}

/// The rays that a hit sent, given its ray and the number of that.
fn children<'a>(
    ray: &RayInTree<'a>,
    number: usize,
) -> impl DoubleEndedIterator<Item = RayInTree<'a>> {
    let (node, level) = (ray.node, ray.level + 1);
    let light = node.light_by_sample();
    let throughput = node.throughput.unwrap_or(Rgb::WHITE);
    node.children.iter().enumerate().map(move |(i, child)| {
        let lit = || light.get(&(child.light.as_deref(), child.sample)).copied();
        RayInTree {
            node: child,
            parent: Some(number),
            level,
            is_last: i + 1 == node.children.len(),
            contribution: match child.kind {
                RayKind::Light => throughput * lit().unwrap_or(Rgb::BLACK),
                _ => child.total(),
            },
        }
    })
}

impl RayNode {
    /// What its subtree adds to the sample: throughput x radiance; black for an L ray.
    fn total(&self) -> Rgb {
        let factors = self.throughput.zip(self.radiance);
        factors.map_or(Rgb::BLACK, |(throughput, radiance)| throughput * radiance)
    }

    /// The sums of the terms of each light, by its name and the number of its sample.
    fn light_by_sample(&self) -> HashMap<(Option<&str>, Option<u32>), Rgb> {
        let mut sums = HashMap::new();
        for term in self.terms.iter().filter(|term| term.light.is_some()) {
            *sums
                .entry((term.light.as_deref(), term.sample))
                .or_insert(Rgb::BLACK) += term.value;
        }
        sums
    }
}

impl Document {
    /// The part of the pixel's brightness that a contribution to a sample makes, 0 to 1: by luminance.
    pub fn fraction(&self, sample: &SampleTree, contribution: Rgb) -> f64 {
        (contribution * sample.weight).fraction_of(self.color.linear)
    }
}
