//! The ray at the end of a path.

use crate::probe::NONE;
use crate::scene::printable::{excerpt, printable};
use crate::trace::View;
use crate::trace::document::{Document, RayNode};
use crate::trace::facts::{Step, TreePath};

/// Steps that a message lists.
const LISTED: usize = 12;

/// The node of a recorded pixel; if there is none, in words what is there.
pub fn node_at(view: View, path: &TreePath) -> Result<u32, String> {
    let tree = &view.trace.tree;
    let sample = tree
        .samples
        .iter()
        .find(|sample| sample.index == path.sample);
    let root = sample
        .and_then(|sample| sample.root)
        .ok_or_else(|| no_sample(path, tree.samples.len()))?;
    let children = |parent: u32| {
        let end = parent + tree.node(parent).size;
        let mut next = parent + 1;
        std::iter::from_fn(move || {
            let child = (next < end).then_some(next)?;
            next += tree.node(child).size;
            let ray = &tree.node(child).ray;
            let light = (ray.light != NONE).then(|| view.light_name(ray.light));
            Some((Step::new(ray.kind, light, u32::from(ray.sample))?, child))
        })
    };
    follow(root, path, children)
}

/// The path to a node of a recorded pixel.
pub fn path_of(view: View, node: u32) -> TreePath {
    let tree = &view.trace.tree;
    let mut steps = Vec::new();
    let mut at = node;
    while let Some(parent) = tree.node(at).parent {
        let ray = &tree.node(at).ray;
        let light = (ray.light != NONE).then(|| view.light_name(ray.light));
        steps.extend(Step::new(ray.kind, light, u32::from(ray.sample)));
        at = parent;
    }
    steps.reverse();
    let sample = tree.samples.iter().find(|sample| sample.root == Some(at));
    TreePath {
        sample: sample.map_or(0, |sample| sample.index),
        steps,
    }
}

/// The document with nothing but the ray at the end of the path and what hangs on it; if there is none, in words what is there.
pub fn subtree(mut document: Document, path: &TreePath) -> Result<Document, String> {
    let count = document.samples.len();
    document
        .samples
        .retain(|sample| sample.index == path.sample);
    let root = document
        .samples
        .first_mut()
        .and_then(|sample| sample.root.as_mut());
    let root = root.ok_or_else(|| no_sample(path, count))?;
    let node = follow(&*root, path, children)?.clone();
    *root = node;
    Ok(document)
}

fn children(node: &RayNode) -> impl Iterator<Item = (Step, &RayNode)> {
    node.children.iter().filter_map(|child| {
        let sample = child.sample.unwrap_or(0);
        Some((
            Step::new(child.kind, child.light.as_deref(), sample)?,
            child,
        ))
    })
}

/// Goes the steps of a path from a root.
fn follow<N: Copy, C: Iterator<Item = (Step, N)>>(
    root: N,
    path: &TreePath,
    children: impl Fn(N) -> C,
) -> Result<N, String> {
    let (mut node, mut gone) = (root, TreePath::eye(path.sample));
    for step in &path.steps {
        let Some((_, child)) = children(node).find(|(sent, _)| is_same(sent, step)) else {
            return Err(no_ray(&gone, step, children(node).map(|(sent, _)| sent)));
        };
        node = child;
        gone = gone.then(step.clone());
    }
    Ok(node)
}

/// Names of lights may have been made printable.
fn is_same(sent: &Step, wanted: &Step) -> bool {
    match (sent, wanted) {
        (Step::Light(sent, a), Step::Light(wanted, b)) => {
            a == b && (sent == wanted || *sent == printable(wanted))
        }
        _ => sent == wanted,
    }
}

fn no_ray(gone: &TreePath, step: &Step, sent: impl Iterator<Item = Step>) -> String {
    let sent: Vec<String> = sent.map(|step| excerpt(&step.to_string())).collect();
    let more = if sent.len() > LISTED { ", ..." } else { "" };
    let list = match &sent[..sent.len().min(LISTED)] {
        [] => "nothing".to_owned(),
        list => list.join(", ") + more,
    };
    let from = match gone.to_string() {
        eye if gone.depth() == 0 => format!("the eye ray{eye}"),
        path => path,
    };
    let step = excerpt(&step.to_string());
    format!(
        "there is no step {step} from {}, which sends {list}",
        excerpt(&from)
    )
}

fn no_sample(path: &TreePath, count: usize) -> String {
    format!(
        "there is no sample {} of this pixel; it has {count}, counted from 0",
        path.sample
    )
}
