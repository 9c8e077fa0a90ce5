//! Difference of a tree and ours: the causes, what follows from each, and the mistakes that would give the same.

mod write;

use std::collections::BTreeMap;

use super::compare::{Compared, Status, TreeComparison};
use super::follow::{Consequences, PixelReference};
use super::quantity::{QuantityKind, field};
use super::tolerance::Tolerances;
use crate::scene::{Bend, Bends, Law};
use crate::trace::facts::{Fact, FactName, PixelFacts, TreePath};

pub use write::Sides;

/// What is wrong with a tree.
#[derive(Clone, Debug, Default)]
pub struct TreeDiff {
    /// How many quantities are compared.
    pub asked: usize,
    /// How many of them agree with ours.
    pub agree: usize,
    /// The causes, those that the same mistakes explain together, the first one nearest to the eye.
    pub causes: Vec<Cause>,
    /// Quantities that are not told, by ray and name.
    pub missing: Vec<(TreePath, FactName)>,
    /// Rays that ours does not have.
    pub extra: Vec<TreePath>,
}

/// A broken law, at the first place where it shows.
#[derive(Clone, Debug)]
pub struct Cause {
    /// The quantity.
    pub first: Compared,
    /// Mistakes that give just what the student has, here and at all places in `also`.
    pub as_if: Vec<Bend>,
    /// Further quantities that the same mistakes explain.
    pub also: Vec<Compared>,
    /// Quantities that are wrong because this one is.
    pub consequences: Vec<Compared>,
}

impl TreeDiff {
    /// Compares a tree with ours.
    pub fn new(
        of: PixelReference,
        given: &PixelFacts,
        tolerances: &Tolerances,
        asks: &dyn Fn(QuantityKind) -> bool,
    ) -> Self {
        let mut comparison = TreeComparison::new(of, given, tolerances);
        comparison.all.retain(|compared| asks(compared.quantity));
        let asked: Vec<&Compared> = comparison
            .all
            .iter()
            .filter(|c| is_told_by_itself(c))
            .collect();
        let of_status = |status: Status| asked.iter().filter(move |c| c.status == status);
        let mut diff = Self {
            asked: asked.len(),
            agree: of_status(Status::Right).count(),
            causes: Vec::new(),
            missing: of_status(Status::Missing)
                .map(|c| (c.path.clone(), c.name.clone()))
                .collect(),
            extra: comparison
                .extra
                .iter()
                .map(|(path, _)| path.clone())
                .collect(),
        };
        diff.causes = causes(of, given, tolerances, &comparison);
        let wrong = comparison.all.iter();
        for compared in wrong.filter(|c| matches!(c.status, Status::RightGiven | Status::Follows)) {
            if let Some(cause) = cause_of(&mut diff.causes, compared) {
                cause.consequences.push(compared.clone());
            }
        }
        diff
    }

    /// True if nothing differs that is told.
    pub fn is_empty(&self) -> bool {
        self.agree == self.asked && self.extra.is_empty()
    }
}

/// Whether R and T are sent is told with these rays; it counts only as a cause.
fn is_told_by_itself(compared: &Compared) -> bool {
    compared.quantity != QuantityKind::Sent
}

/// The causes, grouped by the mistakes that explain them.
fn causes(
    of: PixelReference,
    given: &PixelFacts,
    tolerances: &Tolerances,
    comparison: &TreeComparison,
) -> Vec<Cause> {
    let first = comparison.causes();
    if first.is_empty() {
        return Vec::new();
    }
    let bent: Vec<(Bend, Consequences)> = Bend::all()
        .map(|bend| (bend, Consequences::new(of, given, Bends::from(bend))))
        .collect();
    // By law and mistakes; the first of each group is the nearest to the eye.
    let mut groups: BTreeMap<(Vec<Bend>, Option<Law>), usize> = BTreeMap::new();
    let mut causes: Vec<Cause> = Vec::new();
    for compared in first {
        let explains = |(bend, facts): &(Bend, Consequences)| {
            let told = compared.theirs.as_ref()?;
            let made = facts.find(compared.ray, &compared.name);
            let agrees = |made: &Fact| tolerances.agree(compared.quantity, made, told);
            made.into_iter().flatten().any(agrees).then_some(*bend)
        };
        let as_if: Vec<Bend> = bent.iter().filter_map(explains).collect();
        let alone = as_if.is_empty().then_some(compared.law);
        let index = *groups.entry((as_if.clone(), alone)).or_insert(causes.len());
        match causes.get_mut(index) {
            Some(cause) => cause.also.push(compared.clone()),
            None => causes.push(Cause {
                first: compared.clone(),
                as_if,
                also: Vec::new(),
                consequences: Vec::new(),
            }),
        }
    }
    causes
}

/// The cause that a consequence belongs to: the last one on its way to the eye, else the first of all.
fn cause_of<'a>(causes: &'a mut [Cause], compared: &Compared) -> Option<&'a mut Cause> {
    let above = |cause: &Compared| {
        let (above, below) = (&cause.path, &compared.path);
        let is_above = above.sample == below.sample && below.steps.starts_with(&above.steps);
        is_above.then_some(above.steps.len())
    };
    let nearest = |cause: &Cause| {
        let places = std::iter::once(&cause.first).chain(&cause.also);
        places.filter_map(above).max()
    };
    let index = (0..causes.len()).max_by_key(|i| (nearest(&causes[*i]), usize::MAX - i))?;
    causes.get_mut(index)
}

impl Compared {
    /// The quantity by ray and field, as in `70,150/T/T.direction`.
    pub fn address(&self, (x, y): (u32, u32)) -> String {
        format!("{x},{y}{}.{}", self.path, field(&self.name))
    }

    /// How far the student's value is from ours, and in which unit.
    pub fn off(&self) -> Option<(f64, &'static str)> {
        use super::tolerance::angle;
        let theirs = self.theirs.as_ref()?;
        match (&self.ours, theirs) {
            (Fact::Vector(_), Fact::Vector(_)) if self.quantity == QuantityKind::Unit => None,
            (Fact::Vector(_), Fact::Vector(_)) if is_angle(self.quantity) => {
                angle(&self.ours, theirs).map(|degrees| (degrees, "degree"))
            }
            (Fact::Vector(a), Fact::Vector(b)) => {
                let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
                Some((squares.sum::<f64>().sqrt(), "metre"))
            }
            (Fact::Number(a), Fact::Number(b)) => Some(((a - b).abs(), "")),
            (Fact::Color(a), Fact::Color(b)) => {
                let channels = a.channels().into_iter().zip(b.channels());
                let off = channels.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                Some((off, ""))
            }
            _ => None,
        }
    }
}

/// True if values are compared by the angle between them.
fn is_angle(quantity: QuantityKind) -> bool {
    use QuantityKind::{Direction, GeometricNormal, Normal};
    matches!(quantity, Direction | Normal | GeometricNormal)
}
