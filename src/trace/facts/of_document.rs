//! The facts of a document.

use super::{Fact, FactName, PixelFacts, RayFacts, Step, TreePath};
use crate::math::Rgb;
use crate::probe::TermKind;
use crate::shading::Side;
use crate::trace::Document;
use crate::trace::document::{HitPoint, RayNode, RayOutcome, TermValue, TraversalStep};

/// The facts of a traced pixel.
pub fn pixel_facts(document: &Document) -> PixelFacts {
    let mut rays: Vec<RayFacts> = Vec::new();
    for sample in &document.samples {
        let first = rays.len();
        for ray in sample.rays() {
            let parent = ray.parent.map(|index| first + index);
            let step = Step::new(
                ray.node.kind,
                ray.node.light.as_deref(),
                ray.node.sample.unwrap_or(0),
            );
            let path = match (parent, step) {
                (Some(parent), Some(step)) => rays[parent].path.then(step),
                _ => TreePath::eye(sample.index),
            };
            rays.push(ray_facts(ray.node, path, parent));
        }
    }
    PixelFacts {
        scene: Some(document.scene.name.clone()),
        pixel: Some((document.pixel.x, document.pixel.y)),
        color: Some(Fact::Color(document.color.linear)),
        srgb8: Some(Fact::Vector(document.color.srgb8.map(f64::from))),
        rays,
        ..PixelFacts::default()
    }
}

fn ray_facts(node: &RayNode, path: TreePath, parent: Option<usize>) -> RayFacts {
    use FactName as Name;
    let is_light = node.light.is_some();
    let mut facts = vec![
        (Name::Origin, Fact::Vector(node.origin)),
        (Name::Direction, Fact::Vector(node.direction)),
        (Name::Medium, Fact::Word(node.medium.clone())),
        (Name::Ior, Fact::Number(node.ior)),
    ];
    if let Some(outcome) = node.outcome {
        facts.push((Name::Outcome, Fact::Word(word(outcome).to_owned())));
    }
    if let Some(distance) = node.t_max.filter(|_| is_light) {
        facts.push((Name::Distance, Fact::Number(distance)));
    }
    if let Some(hit) = node.hit.as_ref().filter(|_| !is_light) {
        add_hit(&mut facts, hit);
    }
    if let Some(boundary) = &node.boundary {
        facts.push((Name::N1, Fact::Number(boundary.n1)));
        facts.push((Name::N2, Fact::Number(boundary.n2)));
        facts.push((Name::Reflectance, Fact::Number(boundary.reflectance)));
    }
    node.terms
        .iter()
        .for_each(|term| add_term(&mut facts, term));
    let colors = [(Name::Weight, node.weight), (Name::Radiance, node.radiance)];
    let colors = colors.into_iter().filter(|_| !is_light);
    facts.extend(colors.filter_map(|(name, color)| Some((name, Fact::Color(color?)))));
    if !node.traversal.is_empty() {
        let steps = node.traversal.iter().map(step_text).collect();
        facts.push((Name::Order, Fact::Steps(steps)));
    }
    let absent = node.absent.iter();
    RayFacts {
        path,
        parent,
        kind: node.kind,
        facts: sorted(facts),
        absent: absent
            .map(|a| (a.kind, a.light.clone(), <&str>::from(a.reason).to_owned()))
            .collect(),
    }
}

fn add_hit(facts: &mut Vec<(FactName, Fact)>, hit: &HitPoint) {
    use FactName as Name;
    let side = match hit.side {
        Side::Front => "front",
        Side::Back => "back",
    };
    facts.extend([
        (Name::Object, Fact::Word(hit.object.clone())),
        (Name::Primitive, Fact::Number(f64::from(hit.primitive))),
        (Name::T, Fact::Number(hit.t)),
        (Name::Uv, Fact::Pair(hit.uv)),
        (Name::Point, Fact::Vector(hit.point)),
        (Name::GeometricNormal, Fact::Vector(hit.geometric_normal)),
        (Name::Normal, Fact::Vector(hit.normal)),
        (Name::Side, Fact::Word(side.to_owned())),
    ]);
    facts.extend(
        hit.barycentric
            .map(|b| (Name::Barycentric, Fact::Vector(b))),
    );
}

fn add_term(facts: &mut Vec<(FactName, Fact)>, term: &TermValue) {
    let sample = term.sample.unwrap_or(0);
    let name = FactName::Term(term.term, term.light.clone(), sample);
    facts.push((name, Fact::Color(term.value)));
    let light = || term.light.clone().unwrap_or_default();
    let factors = &term.factors;
    let n_dot_l = factors
        .n_dot_l
        .map(|x| (FactName::NDotL(light(), sample), x));
    let r_dot_v = factors
        .r_dot_v
        .map(|x| (FactName::RDotV(light(), sample), x));
    let factors = n_dot_l.into_iter().chain(r_dot_v);
    facts.extend(factors.map(|(name, x)| (name, Fact::Number(x))));
    for (corner, i) in term.corners.iter().flat_map(|all| all.iter()).zip(0..) {
        let name = FactName::CornerValue(term.term, term.light.clone(), sample, i);
        facts.push((name, Fact::Color(corner.value)));
    }
}

/// An outcome as the format names it.
fn word(outcome: RayOutcome) -> &'static str {
    match outcome {
        RayOutcome::Hit | RayOutcome::Light => "hit",
        RayOutcome::Miss => "miss",
        RayOutcome::Lit => "lit",
        RayOutcome::Blocked => "blocked",
    }
}

/// A step through the accelerator in a word: which node, or which primitive.
fn step_text(step: &TraversalStep) -> String {
    match step {
        TraversalStep::Visit { node, .. } => format!("node {node}"),
        TraversalStep::Test { test, .. } => format!("test {} {}", test.object, test.primitive),
    }
}

/// The facts by name. Terms of the same name are added up, as the equation does.
pub fn sorted(mut facts: Vec<(FactName, Fact)>) -> Vec<(FactName, Fact)> {
    facts.sort_by(|(a, _), (b, _)| a.cmp(b));
    facts.dedup_by(|(name, fact), (kept_name, kept)| {
        if name != kept_name {
            return false;
        }
        if let FactName::Term(..) = name {
            match (&*fact, kept) {
                (Fact::Color(more), Fact::Color(sum)) => *sum += *more,
                // A sum is no number if a summand is none.
                (Fact::Nothing, kept) => *kept = Fact::Nothing,
                _ => {}
            }
        }
        true
    });
    facts
}

impl FactName {
    /// The name of the term that a surface or the background adds by itself.
    pub fn own_term(kind: TermKind) -> Self {
        Self::Term(kind, None, 0)
    }
}

impl Fact {
    /// Black.
    pub const BLACK: Self = Self::Color(Rgb::BLACK);
}
