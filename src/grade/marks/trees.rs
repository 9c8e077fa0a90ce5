//! The mark of a check of ray trees.

use super::{CausingTree, CheckMark, Given, QuantityCounts};
use crate::grade::compare::{Compared, Status, TreeComparison};
use crate::grade::diff::{Cause, TreeDiff};
use crate::grade::follow::PixelReference;
use crate::grade::quantity::QuantityKind;
use crate::grade::task::{Ask, Check, Task};
use crate::probe::RayKind;
use crate::trace::facts::{Fact, FactName, PixelFacts, TreePath};

/// Causes that a mark keeps.
const KEPT: usize = 3;

/// What is counted over the pixels of a check.
#[derive(Default)]
struct Sum {
    earned: u64,
    asked: u64,
    counts: QuantityCounts,
    causes: Vec<((u32, u32), Cause)>,
    tree: Option<CausingTree>,
    note: String,
}

/// Marks the trees of all pixels of a check.
pub fn mark(
    task: &Task,
    check: &Check,
    (pixels, ask, depth): (&[PixelFacts], &Ask, Option<usize>),
    given: &Given,
) -> CheckMark {
    let mut sum = Sum::default();
    for ours in pixels {
        pixel(task, check, (ours, ask, depth), given, &mut sum);
    }
    CheckMark {
        counts: sum.counts,
        causes: sum.causes,
        tree: sum.tree,
        note: sum.note,
        ..CheckMark::of_share(check, sum.earned, sum.asked)
    }
}

/// Adds a pixel.
fn pixel(
    task: &Task,
    check: &Check,
    (ours, ask, depth): (&PixelFacts, &Ask, Option<usize>),
    given: &Given,
    sum: &mut Sum,
) {
    let at = ours.pixel.unwrap_or_default();
    let nothing = PixelFacts::default();
    let theirs = given.tree(check.scene, at).unwrap_or_else(|problem| {
        problem.clone_into(&mut sum.note);
        None
    });
    let theirs = theirs.unwrap_or(&nothing);
    let scene = &task.scenes[check.scene];
    let of = PixelReference {
        scene: Some((&scene.world, &scene.settings)),
        pixel: at,
        facts: ours,
    };
    let comparison = TreeComparison::new(of, theirs, &task.tolerances);
    let counts = |path: &TreePath, kind| depth.is_none_or(|most| level(path, kind) <= most);
    for compared in comparison.all.iter().filter(|c| counts(&c.path, c.kind)) {
        sum.add(task, compared.status, ask.weight(compared));
    }
    for (quantity, ours, theirs) in colors(ours, theirs) {
        let status = match (ours, &theirs) {
            (Some(ours), Some(theirs)) if task.tolerances.agree(quantity, ours, theirs) => {
                Status::Right
            }
            (_, Some(_)) => Status::Wrong,
            _ => Status::Missing,
        };
        sum.add(task, status, ask.color_weight(quantity));
    }
    // A ray that should not be is one more quantity, and wrong.
    let extra = comparison
        .extra
        .iter()
        .filter(|(path, _)| depth.is_none_or(|most| path.depth() <= most));
    let extra = extra.count() as u64;
    sum.counts.extra += extra;
    sum.asked += extra;
    let has_causes = comparison.all.iter().any(|c| c.status == Status::Wrong);
    if has_causes && sum.causes.len() < KEPT {
        let causes = TreeDiff::new(of, theirs, &task.tolerances, &|_| true).causes;
        let ray = causes.first().map(|cause| cause.first.ray);
        let is_kept = |c: &Compared| c.status != Status::Right || Some(c.ray) == ray;
        sum.tree
            .get_or_insert_with(|| CausingTree::new(at, comparison, &is_kept));
        let room = KEPT - sum.causes.len();
        sum.causes
            .extend(causes.into_iter().take(room).map(|cause| (at, cause)));
    }
}

impl Sum {
    /// Adds a quantity of this weight; nothing if it is not asked.
    fn add(&mut self, task: &Task, status: Status, weight: u64) {
        if weight == 0 {
            return;
        }
        let slot = match status {
            Status::Right => &mut self.counts.right,
            Status::RightGiven => &mut self.counts.right_given,
            Status::Wrong => &mut self.counts.wrong,
            Status::Follows => &mut self.counts.follows,
            Status::Missing => &mut self.counts.missing,
        };
        *slot += 1;
        let is_right = status == Status::Right || status == Status::RightGiven && task.follow;
        self.asked += weight;
        self.earned += if is_right { weight } else { 0 };
    }
}

/// The depth that a ray counts at: a shadow ray that of the hit that sent it.
fn level(path: &TreePath, kind: RayKind) -> usize {
    path.depth() - usize::from(kind == RayKind::Light)
}

/// The colours of a pixel, ours and theirs.
fn colors<'a>(
    ours: &'a PixelFacts,
    theirs: &PixelFacts,
) -> [(QuantityKind, Option<&'a Fact>, Option<Fact>); 2] {
    // One sample's radiance is the pixel's colour.
    let root = match &theirs.rays[..] {
        [root, ..]
            if theirs
                .rays
                .iter()
                .filter(|ray| ray.parent.is_none())
                .count()
                == 1 =>
        {
            root.get(&FactName::Radiance).cloned()
        }
        _ => None,
    };
    let color = theirs.color.clone().or(root);
    [
        (QuantityKind::Color, ours.color.as_ref(), color),
        (
            QuantityKind::Srgb8,
            ours.srgb8.as_ref(),
            theirs.srgb8.clone(),
        ),
    ]
}
