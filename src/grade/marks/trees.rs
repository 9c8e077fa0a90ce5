//! The mark of a check of ray trees.

use super::{CheckMark, Counted, Given, status};
use crate::grade::compare::{Status, TreeComparison};
use crate::grade::diff::TreeDiff;
use crate::grade::follow::PixelReference;
use crate::grade::quantity::QuantityKind;
use crate::grade::task::{Ask, Check, Task};
use crate::probe::RayKind;
use crate::trace::facts::{Fact, FactName, PixelFacts, TreePath};

/// Causes that a mark keeps.
const KEPT: usize = 3;

/// Marks the trees of all pixels of a check.
pub fn mark(
    task: &Task,
    check: &Check,
    (pixels, ask, depth): (&[PixelFacts], &Ask, Option<usize>),
    given: &Given,
) -> CheckMark {
    let scene = &task.scenes[check.scene];
    let (mut earned, mut asked) = (0, 0);
    let mut counts = Counted::default();
    let mut causes = Vec::new();
    let mut notes: Vec<&str> = Vec::new();
    for ours in pixels {
        let at = ours.pixel.unwrap_or_default();
        let nothing = PixelFacts::default();
        let theirs = match given.tree(task, check.scene, at) {
            Ok(tree) => tree.unwrap_or(&nothing),
            Err(problem) => {
                notes.push(problem);
                &nothing
            }
        };
        let of = PixelReference {
            scene: Some((&scene.world, &scene.settings)),
            pixel: at,
            facts: ours,
        };
        let comparison = TreeComparison::new(of, theirs, &task.tolerances);
        let is_asked = |path: &TreePath, kind| depth.is_none_or(|most| level(path, kind) <= most);
        let mut count = |status: Status, weight: u64| {
            asked += weight;
            let slot = match status {
                Status::Right => &mut counts.right,
                Status::RightGiven => &mut counts.right_given,
                Status::Wrong => &mut counts.wrong,
                Status::Follows => &mut counts.follows,
                Status::Missing => &mut counts.missing,
            };
            *slot += 1;
            let is_right = status == Status::Right || status == Status::RightGiven && task.follow;
            earned += if is_right { weight } else { 0 };
        };
        for compared in comparison.all.iter().filter(|c| is_asked(&c.path, c.kind)) {
            let weight = ask.weight(compared);
            if weight > 0 {
                count(compared.status, weight);
            }
        }
        for (quantity, ours, theirs) in colors(ours, theirs) {
            let weight = ask.color_weight(quantity);
            if weight > 0 {
                let agrees =
                    |(ours, theirs): (&Fact, &Fact)| task.tolerances.agree(quantity, ours, theirs);
                let status = match (ours, &theirs) {
                    (Some(ours), Some(theirs)) if agrees((ours, theirs)) => Status::Right,
                    (_, Some(_)) => Status::Wrong,
                    _ => Status::Missing,
                };
                count(status, weight);
            }
        }
        // A ray that should not be is one more quantity, and wrong.
        let extra = comparison
            .extra
            .iter()
            .filter(|(path, _)| depth.is_none_or(|most| path.depth() <= most));
        let extra = extra.count() as u64;
        counts.extra += extra;
        asked += extra;
        let has_causes = comparison.all.iter().any(|c| c.status == Status::Wrong);
        if has_causes && causes.len() < KEPT {
            let diff = TreeDiff::new(of, theirs, &task.tolerances, &|_| true);
            causes.extend(
                diff.causes
                    .into_iter()
                    .take(KEPT - causes.len())
                    .map(|cause| (at, cause)),
            );
        }
    }
    let mark = CheckMark::of_share(check, earned, asked);
    CheckMark {
        status: status(mark.score, mark.most),
        counts,
        causes,
        note: notes
            .first()
            .map_or(String::new(), |note| (*note).to_owned()),
        ..mark
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
