//! TreeComparison of a student's tree with ours: every quantity, whether it agrees, and if not, whether it is a cause.
//!
//! Rays are aligned by their names; nothing is guessed, so the answer is the same whatever the order. A quantity that disagrees
//! though it follows from the student's own numbers before it ([`super::follow`]) is a consequence. One that does not follow from
//! them is a *cause*: there a law is broken.

use std::collections::{HashMap, HashSet};

use super::follow::{Consequences, PixelReference, yes_or_no};
use super::quantity::{QuantityKind, law_of};
use super::tolerance::Tolerances;
use crate::probe::RayKind;
use crate::scene::{Bends, Law};
use crate::trace::facts::{Fact, FactName, PixelFacts, RayFacts, Step, TreePath};

/// One thing that is compared.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The ray.
    pub path: TreePath,
    /// Index of the ray in our tree.
    pub ray: usize,
    /// Kind of the ray.
    pub kind: RayKind,
    /// The fact.
    pub name: FactName,
    /// What of it is compared.
    pub quantity: QuantityKind,
    /// The law that gives it.
    pub law: Law,
    /// Our value.
    pub ours: Fact,
    /// The student's value.
    pub theirs: Option<Fact>,
    /// What our law makes of the student's own numbers, if that can be computed, by both readings of points that are nearly as
    /// computed.
    pub follows: [Option<Fact>; 2],
    /// What it comes to.
    pub status: Status,
}

/// What a comparison comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Status {
    /// Equal to ours.
    Right,
    /// Not ours, but what the law makes of the student's own numbers before it.
    RightGiven,
    /// A first cause: not what the law makes of the numbers before it.
    Wrong,
    /// Cannot be computed from the student's numbers, and something before it is wrong.
    Follows,
    /// Not told.
    Missing,
}

/// A pixel compared.
#[derive(Clone, Debug, Default)]
pub struct TreeComparison {
    /// All that ours has, in the order in which it depends on each other within a ray, rays parents first.
    pub all: Vec<Compared>,
    /// Rays that ours does not have though their parents' outcomes are right: the path, and the index of the parent in our tree.
    pub extra: Vec<(TreePath, usize)>,
}

impl TreeComparison {
    /// Compares every quantity of our tree.
    pub fn new(of: PixelReference, given: &PixelFacts, tolerances: &Tolerances) -> Self {
        let theirs: HashMap<&TreePath, &RayFacts> =
            given.rays.iter().map(|r| (&r.path, r)).collect();
        let follows = Consequences::new(of, given, Bends::default());
        let mut all = Vec::new();
        for (index, ours) in of.facts.rays.iter().enumerate() {
            let ray = theirs.get(&ours.path).copied();
            for (name, fact) in facts_with_rays(of.facts, index, ours) {
                let quantity = QuantityKind::of(ours.kind, &name);
                let told = told(given, &theirs, ours, ray, &name);
                let computed = follows.find(index, &name).map(Option::<&Fact>::cloned);
                let mut add = |quantity| {
                    all.push(Compared {
                        path: ours.path.clone(),
                        ray: index,
                        kind: ours.kind,
                        name: name.clone(),
                        quantity,
                        law: law(of, ours.kind, &name),
                        ours: fact.clone(),
                        theirs: told.clone(),
                        follows: computed.clone(),
                        status: Status::Missing,
                    });
                };
                add(quantity);
                if matches!(quantity, QuantityKind::Direction | QuantityKind::Normal) {
                    add(QuantityKind::Unit);
                }
            }
        }
        settle(&mut all, tolerances);
        let extra = extra_rays(of.facts, given, &all);
        Self { all, extra }
    }

    /// First causes, in the order in which they are told: nearest to the eye first, then as they depend on each other.
    pub fn causes(&self) -> Vec<&Compared> {
        let mut causes: Vec<&Compared> = self
            .all
            .iter()
            .filter(|c| c.status == Status::Wrong)
            .collect();
        causes.sort_by_key(|c| (level(c), c.law, c.ray));
        causes
    }
}

/// The law of a fact. Of the terms of a light with an area it is how the light is sampled.
fn law(of: PixelReference, kind: RayKind, name: &FactName) -> Law {
    let is_area = |light: &String| {
        let lights = of.scene.map_or(&[][..], |(world, _)| &world.scene.lights);
        lights.iter().any(|l| l.name == *light && l.kind.is_area())
    };
    match name {
        FactName::Term(_, Some(light), _) | FactName::CornerValue(_, Some(light), ..)
            if is_area(light) =>
        {
            Law::LightSamples
        }
        FactName::NDotL(light, _) | FactName::RDotV(light, _) if is_area(light) => {
            Law::LightSamples
        }
        _ => law_of(kind, name),
    }
}

/// The level of the hit that a quantity is decided at: of a secondary ray's origin and direction that of the hit that sent it.
fn level(compared: &Compared) -> usize {
    let depth = compared.path.depth();
    let of_parent = compared.kind == RayKind::Light
        || matches!(
            compared.name,
            FactName::Origin | FactName::Direction | FactName::Distance | FactName::Weight
        );
    depth - usize::from(of_parent && depth > 0)
}

/// The facts of a ray of ours, and whether its hit sends R and T.
fn facts_with_rays(all: &PixelFacts, index: usize, ours: &RayFacts) -> Vec<(FactName, Fact)> {
    let mut facts: Vec<(FactName, Fact)> = ours
        .facts
        .iter()
        .filter(|(name, _)| ours.kind != RayKind::Light || is_of_shadow_ray(name))
        .cloned()
        .collect();
    if ours.kind != RayKind::Light && ours.word(&FactName::Outcome) == Some("hit") {
        for kind in [RayKind::Reflected, RayKind::Transmitted] {
            let sent = all.children(index).any(|(_, child)| child.kind == kind);
            facts.push((FactName::Sends(kind), yes_or_no(sent)));
        }
        let dark = ours
            .absent
            .iter()
            .filter(|(kind, _, why)| *kind == RayKind::Light && why == "facing-away");
        let dark = dark.filter_map(|(_, light, _)| light.clone());
        facts.extend(dark.map(|light| (FactName::Shines(light), yes_or_no(false))));
    }
    facts.sort_by(|(a, _), (b, _)| a.cmp(b));
    facts
}

/// Of an L ray what blocks it is not compared: any of the things in the way will do.
fn is_of_shadow_ray(name: &FactName) -> bool {
    matches!(
        name,
        FactName::Origin | FactName::Direction | FactName::Distance | FactName::Outcome
    )
}

/// What the student tells of a fact; for what is not told where nothing has to be told, that.
fn told(
    given: &PixelFacts,
    theirs: &HashMap<&TreePath, &RayFacts>,
    ours: &RayFacts,
    ray: Option<&RayFacts>,
    name: &FactName,
) -> Option<Fact> {
    if let FactName::Sends(kind) = name {
        let step = Step::new(*kind, None, 0)?;
        let sends_rays = given.rays.len() > 1;
        let sent = theirs.contains_key(&ours.path.then(step));
        return (ray.is_some() && sends_rays).then(|| yes_or_no(sent));
    }
    if let FactName::Shines(light) = name {
        let step = Step::Light(light.clone(), 0);
        let shadow_ray = theirs.get(&ours.path.then(step));
        let lit = shadow_ray.is_some_and(|ray| ray.word(&FactName::Outcome) == Some("lit"));
        return ray.is_some().then(|| yes_or_no(lit));
    }
    let fact = ray.and_then(|ray| {
        ray.get(name)
            .or_else(|| ray.get(&other_normal(ours, name)?))
    });
    if let Some(fact) = fact {
        return Some(fact.clone());
    }
    match name {
        // A term of nothing need not be told, nor a light that adds nothing.
        FactName::Term(..)
            if ray.is_some_and(|ray| ray.word(&FactName::Outcome) != Some("miss")) =>
        {
            let is_black = ours.get(name) == Some(&Fact::BLACK);
            is_black.then_some(Fact::BLACK)
        }
        FactName::Outcome if ours.kind == RayKind::Light => {
            let parent_is_there = ours.path.steps.split_last().is_some_and(|(_, steps)| {
                theirs.values().any(|parent| {
                    let path = &parent.path;
                    let is_it = path.sample == ours.path.sample && path.steps == steps;
                    is_it && parent.word(name) != Some("miss")
                })
            });
            // One who tells of other shadow rays, and not of this one, has sent none.
            let is_blocked = ours.word(name) == Some("blocked");
            let tells_others = given.rays.iter().any(|ray| {
                let is_absent = ray.absent.iter().any(|(kind, ..)| *kind == RayKind::Light);
                ray.kind == RayKind::Light || is_absent
            });
            let tells_none = parent_is_there && (is_blocked || tells_others);
            tells_none.then(|| Fact::Word("blocked".to_owned()))
        }
        _ => None,
    }
}

/// Where a surface has one normal, the shading normal is the geometric one: who tells one tells both.
fn other_normal(ours: &RayFacts, name: &FactName) -> Option<FactName> {
    let other = match name {
        FactName::Normal => FactName::GeometricNormal,
        FactName::GeometricNormal => FactName::Normal,
        _ => return None,
    };
    (ours.get(name) == ours.get(&other)).then_some(other)
}

/// Decides what each comparison comes to.
fn settle(all: &mut [Compared], tolerances: &Tolerances) {
    // Rays of which something is wrong, and those below them.
    let mut spoiled: HashSet<TreePath> = HashSet::new();
    for compared in all.iter_mut() {
        let agrees = |fact: Option<&Fact>| {
            let (theirs, fact) = (compared.theirs.as_ref()?, fact?);
            Some(tolerances.agree(compared.quantity, fact, theirs))
        };
        let status = if compared.theirs.is_none() {
            Status::Missing
        } else if agrees(Some(&compared.ours)) == Some(true) {
            Status::Right
        } else {
            let follows = compared.follows.each_ref();
            match follows.map(|fact| agrees(fact.as_ref())) {
                [Some(true), _] | [_, Some(true)] => Status::RightGiven,
                [None, _] | [_, None] if is_below(&compared.path, &spoiled) => Status::Follows,
                _ => Status::Wrong,
            }
        };
        compared.status = status;
        if matches!(status, Status::Wrong | Status::Follows | Status::RightGiven) {
            spoiled.insert(compared.path.clone());
        }
    }
}

fn is_below(path: &TreePath, spoiled: &HashSet<TreePath>) -> bool {
    (0..=path.steps.len()).any(|count| {
        spoiled.contains(&TreePath {
            sample: path.sample,
            steps: path.steps[..count].to_vec(),
        })
    })
}

/// The rays that only the student has, whose parents' outcomes are right. A shadow ray that is blocked adds nothing.
fn extra_rays(ours: &PixelFacts, given: &PixelFacts, all: &[Compared]) -> Vec<(TreePath, usize)> {
    let known: HashMap<&TreePath, usize> = ours
        .rays
        .iter()
        .zip(0..)
        .map(|(r, i)| (&r.path, i))
        .collect();
    let right: HashSet<usize> = all
        .iter()
        .filter(|c| c.name == FactName::Outcome && c.status == Status::Right)
        .map(|c| c.ray)
        .collect();
    let extra = given.rays.iter().filter_map(|ray| {
        let parent = known.get(&given.rays.get(ray.parent?)?.path).copied()?;
        let is_known = known.contains_key(&ray.path);
        let adds_nothing =
            ray.kind == RayKind::Light && ray.word(&FactName::Outcome) != Some("lit");
        (!is_known && !adds_nothing && right.contains(&parent)).then(|| (ray.path.clone(), parent))
    });
    extra.collect()
}
