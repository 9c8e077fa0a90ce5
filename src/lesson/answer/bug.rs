//! A broken law, and the first ray that shows it.

use super::AnswerVerdict;
use crate::grade::diff::TreeDiff;
use crate::grade::follow::PixelReference;
use crate::grade::pixel_tree::traced;
use crate::grade::quantity::field;
use crate::grade::tolerance::Tolerances;
use crate::lesson::directive::BlockDirective;
use crate::lesson::stage::Stage;
use crate::scene::Bend;
use crate::scene::printable::excerpt;
use crate::trace::Address;
use crate::trace::facts::{Step, TreePath};

/// Judges a mistake by name and the ray where it first shows.
pub fn judge(
    stage: &Stage,
    bend: Bend,
    at: (u32, u32),
    law: &str,
    path: &TreePath,
) -> Result<AnswerVerdict, String> {
    let named: Bend = law
        .parse()
        .map_err(|_| format!("`{}` is no mistake that is offered", excerpt(law)))?;
    let (first, what) = first_wrong(stage, bend, at)?;
    let (is_law, is_ray) = (
        named == bend,
        *path == first || is_sample_of(path, &first, bend),
    );
    if !(is_law && is_ray) {
        return Ok(match (is_law, is_ray) {
            (true, false) => AnswerVerdict::wrong(
                "the mistake is right, the ray is not: look for the first number that is wrong on the way from the eye",
            ),
            (false, true) => AnswerVerdict::wrong("the ray is right, the mistake is another one"),
            _ => AnswerVerdict::wrong("neither the mistake nor the ray is right"),
        });
    }
    let mut verdict = AnswerVerdict::right(format!("right: {}", bend.entry().note));
    verdict
        .lines
        .push(format!("it computes {}", bend.entry().formula));
    let ray = if first.steps.is_empty() {
        "the eye ray".to_owned()
    } else {
        format!("ray {first}")
    };
    verdict
        .lines
        .push(format!("its first trace is {what} of {ray}"));
    let address = Address {
        scene: None,
        pixel: at,
        path: TreePath::default(),
        part: None,
    };
    let told = BlockDirective::Diff(address)
        .text(stage, &[("bend".to_owned(), bend.name().to_owned())])?;
    verdict.lines.extend(told.lines().map(str::to_owned));
    Ok(verdict)
}

/// True if a ray goes to one of the wrong points of a light. Where points are thrown anew no single one of them can be told to be
/// wrong, so what shows it first is the sum at their hit; whoever looks at one of them has found it, too.
fn is_sample_of(path: &TreePath, first: &TreePath, bend: Bend) -> bool {
    let is_sample = matches!(path.steps.last(), Some(Step::Light(..)));
    bend == Bend::SamePoints && is_sample && path.steps.starts_with(&first.steps)
}

/// The ray, and its quantity, that is the first to be wrong with a bend.
pub fn first_wrong(
    stage: &Stage,
    bend: Bend,
    at: (u32, u32),
) -> Result<(TreePath, String), String> {
    stage.traced(at)?;
    let bent = stage.with(&[("bend".to_owned(), bend.name().to_owned())])?;
    let ours = traced(&stage.world, &stage.settings, at);
    let theirs = traced(&bent.world, &bent.settings, at);
    let of = PixelReference {
        scene: Some((&stage.world, &stage.settings)),
        pixel: at,
        facts: &ours,
    };
    let found = TreeDiff::new(of, &theirs, &Tolerances::default(), &|_| true);
    let cause = found.causes.first();
    let cause = cause.ok_or_else(|| {
        format!(
            "with {} the tree of pixel {},{} is as ours",
            bend.name(),
            at.0,
            at.1
        )
    })?;
    Ok((cause.first.path.clone(), field(&cause.first.name)))
}
