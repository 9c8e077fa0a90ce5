//! Essence of a ray tree: what of a document must stay when its scene is reduced.

use std::collections::BTreeMap;
use std::io::BufWriter;

use crate::trace::Document;
use crate::trace::document::{RayNode, SceneId};
use crate::trace::export::json;

/// BLAKE3 hash of all that a document tells of a pixel, to the last bit.
///
/// Left out is what tells of the scene as a whole and not of these rays: its name, hash, lights and warnings, the effects that were
/// left out of it, the accelerator and the way through it, the numbers of primitives, which are others where some are gone, and the
/// frames of groups, which are not written.
/// Objects in `names` have the name that is given there.
pub fn essence(mut document: Document, names: &BTreeMap<String, String>) -> blake3::Hash {
    document.scene = SceneId {
        name: String::new(),
        hash: String::new(),
        lights: Vec::new(),
    };
    document.warnings.clear();
    document.settings.accel.clear();
    document.settings.without.clear();
    // Without recursion: trees may be deep.
    let roots = document.samples.iter_mut();
    let mut open: Vec<&mut RayNode> = roots.filter_map(|s| s.root.as_mut()).collect();
    while let Some(node) = open.pop() {
        let children = without_numbers(node, names);
        open.extend(children);
    }
    let mut hash = blake3::Hasher::new();
    // A hash takes everything.
    let _ = json::write(BufWriter::new(&mut hash), &document);
    hash.finalize()
}

/// Takes the numbers of primitives out of a ray, and gives objects their names; gives the rays that it sent.
fn without_numbers<'n>(
    node: &'n mut RayNode,
    names: &BTreeMap<String, String>,
) -> impl Iterator<Item = &'n mut RayNode> {
    let rename = |name: &mut String| {
        if let Some(original) = names.get(name) {
            name.clone_from(original);
        }
    };
    node.traversal.clear();
    for passed in &mut node.passed {
        passed.primitive = 0;
        rename(&mut passed.object);
    }
    if let Some(hit) = &mut node.hit {
        hit.primitive = 0;
        hit.frames.clear();
        rename(&mut hit.object);
    }
    if let Some(boundary) = node.boundary.as_mut().filter(|_| !names.is_empty()) {
        boundary.touching.iter_mut().for_each(rename);
        // Parts of one object touch as one.
        let own = node.hit.as_ref().map(|hit| hit.object.as_str());
        let mut told: Vec<String> = Vec::new();
        for name in std::mem::take(&mut boundary.touching) {
            if own != Some(&name) && !told.contains(&name) {
                told.push(name);
            }
        }
        boundary.touching = told;
    }
    node.children.iter_mut()
}
