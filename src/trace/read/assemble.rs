//! Rays in any order become a tree: each gets its path, parents stand before their children.

use std::collections::HashMap;

use super::limits::{MAX_CHILDREN, MAX_RAY_DEPTH, MAX_RAYS, MAX_STEPS};
use super::notes::Broken;
use super::place::{FieldPlace, RayPlaces};
use super::ray::{LooseParent, LooseRay};
use crate::probe::RayKind;
use crate::scene::printable::excerpt;
use crate::scene::read::error::Problem;
use crate::trace::facts::{RayFacts, Step, TreePath};

/// Rays with the links between them.
struct Links<'a> {
    rays: &'a [LooseRay],
    /// Where they stand in their document, if they stand in one.
    places: Option<&'a RayPlaces>,
    /// The number of each ray's parent.
    parents: Vec<Option<usize>>,
}

/// The rays as a tree. `places` are those of a document; lines of flat rays have none.
pub fn assemble(rays: Vec<LooseRay>, places: Option<&RayPlaces>) -> Result<Vec<RayFacts>, Broken> {
    let mut links = Links {
        rays: &rays,
        places,
        parents: Vec::new(),
    };
    links.parents = links.find_parents()?;
    links.check_kinds()?;
    let order = links.parents_first()?;
    links.check_twins(&order)?;
    let parents = links.parents;
    let mut place_of = vec![0; rays.len()];
    let mut left: Vec<Option<LooseRay>> = rays.into_iter().map(Some).collect();
    let mut tree: Vec<RayFacts> = Vec::with_capacity(order.len());
    for old in order {
        let Some(ray) = left[old].take() else {
            continue;
        };
        let parent = parents[old].map(|parent| place_of[parent]);
        place_of[old] = tree.len();
        let step = Step::new(ray.kind, ray.light.as_deref(), ray.sample);
        let path = match (parent, step) {
            (Some(parent), Some(step)) => tree[parent].path.then(step),
            _ => TreePath::eye(ray.sample),
        };
        tree.push(RayFacts {
            path,
            parent,
            kind: ray.kind,
            facts: ray.facts,
            absent: ray.absent,
        });
    }
    Ok(tree)
}

impl Links<'_> {
    fn broken(&self, ray: usize, what: impl Into<String>, cure: &str) -> Broken {
        let field = self.places.map_or(String::new(), |places| {
            FieldPlace::Ray(places, ray).to_string()
        });
        Broken {
            field,
            at: self.rays[ray].at,
            problem: Problem::new(what, cure),
        }
    }

    /// The number of each ray's parent, by its id where it is named so.
    fn find_parents(&self) -> Result<Vec<Option<usize>>, Broken> {
        if self.rays.len() > MAX_RAYS {
            let what = format!("is one more than the {MAX_RAYS} rays that a pixel may have");
            return Err(self.broken(MAX_RAYS, what, "stop your tracer at a depth, such as 5"));
        }
        let mut by_id = HashMap::new();
        for (number, ray) in self.rays.iter().enumerate() {
            if let Some(id) = ray.id
                && by_id.insert(id, number).is_some()
            {
                let what = format!("{id} is the `id` of another ray of this pixel, too");
                return Err(self.broken(
                    number,
                    what,
                    "count the rays of a pixel, and give each its number",
                ));
            }
        }
        let parent = |(number, ray): (usize, &LooseRay)| match ray.parent {
            LooseParent::Index(parent) => Ok(Some(parent)),
            // Whatever stands there: nobody sends the eye ray.
            _ if ray.kind == RayKind::Incident => Ok(None),
            LooseParent::None => Ok(None),
            LooseParent::Id(id) => by_id.get(&id).copied().map(Some).ok_or_else(|| {
                let what = format!("`parent` is {id}, and no ray of this pixel has this `id`");
                self.broken(
                    number,
                    what,
                    "write the `id` of the ray that sent it; write a line for that ray, too",
                )
            }),
        };
        self.rays.iter().enumerate().map(parent).collect()
    }

    /// Eye rays, and only these, come from the eye; L rays send none.
    fn check_kinds(&self) -> Result<(), Broken> {
        for (number, ray) in self.rays.iter().enumerate() {
            let letter = ray.kind.letter();
            match self.parents[number] {
                None if ray.kind != RayKind::Incident => {
                    let what = format!("is of kind {letter}, and no ray sent it");
                    let cure = "the first ray has kind I; in flat rays all others have a `parent`";
                    return Err(self.broken(number, what, cure));
                }
                Some(_) if ray.kind == RayKind::Incident => {
                    let what = "is of kind I, and a ray sent it";
                    return Err(self.broken(
                        number,
                        what,
                        "I is the ray from the eye; write R, T or L",
                    ));
                }
                Some(parent) if self.rays[parent].kind == RayKind::Light => {
                    let what = format!("is of kind {letter}, and an L ray sent it");
                    return Err(self.broken(
                        number,
                        what,
                        "L rays end at the light; the hit before sends the others",
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The rays, parents before their children, children in the order of the list.
    fn parents_first(&self) -> Result<Vec<usize>, Broken> {
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); self.rays.len()];
        let mut open = Vec::new();
        for (number, parent) in self.parents.iter().enumerate().rev() {
            match parent {
                Some(parent) => children[*parent].push(number),
                None => open.push((number, 0)),
            }
        }
        let (mut order, mut steps) = (Vec::with_capacity(self.rays.len()), 0);
        while let Some((number, depth)) = open.pop() {
            order.push(number);
            steps += depth;
            let sent = &children[number];
            if sent.len() > MAX_CHILDREN {
                let what = format!("sends {} rays; {MAX_CHILDREN} at most", sent.len());
                return Err(self.broken(number, what, "send fewer samples to a light"));
            }
            if depth > MAX_RAY_DEPTH || steps > MAX_STEPS {
                let what = format!("lies too deep: {depth} rays lead to it from the eye");
                return Err(self.broken(number, what, "stop your tracer at a depth, such as 5"));
            }
            open.extend(sent.iter().map(|child| (*child, depth + 1)));
        }
        if order.len() < self.rays.len() {
            let reached: std::collections::HashSet<usize> = order.iter().copied().collect();
            let lost = (0..self.rays.len())
                .find(|n| !reached.contains(n))
                .unwrap_or(0);
            let what =
                "hangs on itself: its `parent`, the `parent` of that and so on lead back to it";
            return Err(self.broken(lost, what, "write the `id` of the ray that sent it"));
        }
        Ok(order)
    }

    /// A hit sends one R, one T, and one L for each sample of a light: otherwise names are no names.
    fn check_twins(&self, order: &[usize]) -> Result<(), Broken> {
        let name = |n: &usize| {
            let ray = &self.rays[*n];
            (
                self.parents[*n],
                ray.kind,
                ray.light.as_deref(),
                ray.sample_of_name(),
            )
        };
        let mut sorted = order.to_vec();
        sorted.sort_by(|a, b| name(a).cmp(&name(b)));
        let Some(pair) = sorted
            .windows(2)
            .find(|pair| name(&pair[0]) == name(&pair[1]))
        else {
            return Ok(());
        };
        let (number, ray) = (pair[1], &self.rays[pair[1]]);
        let what = match (ray.kind, &ray.light) {
            (RayKind::Incident, _) => format!("is a second eye ray of sample {}", ray.sample),
            (RayKind::Light, Some(light)) => {
                format!(
                    "is a second L ray to `{}`, sample {}, from the same hit",
                    excerpt(light),
                    ray.sample
                )
            }
            _ => format!("is a second {} ray from the same hit", ray.kind.letter()),
        };
        let cure = "a hit sends one R, one T, and one L for each light; L rays to an area light have a `sample`, from 0";
        Err(self.broken(number, what, cure))
    }
}

impl LooseRay {
    /// The number of its sample, where that is a part of its name.
    fn sample_of_name(&self) -> u32 {
        match self.kind {
            RayKind::Incident | RayKind::Light => self.sample,
            RayKind::Reflected | RayKind::Transmitted => 0,
        }
    }
}
