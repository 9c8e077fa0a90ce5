//! The mark of a check of estimates: the share of its pixels whose samples are those of a right tracer.

use std::collections::BTreeSet;

use super::{CheckMark, CheckStatus, Given, status};
use crate::grade::estimate::EstimateReference;
use crate::grade::task::{AskedEstimate, Check, EstimateFile};
use crate::trace::facts::PixelFacts;

/// Marks the estimates of a check.
pub fn mark(
    check: &Check,
    asked: &EstimateFile,
    references: &[EstimateReference],
    given: &Given,
) -> CheckMark {
    let mut mark = CheckMark {
        most: check.points,
        ..CheckMark::default()
    };
    let mut right = 0;
    for reference in references {
        let told = given.tree(check.scene, reference.pixel).ok().flatten();
        match told.map_or(Err("is not told".to_owned()), |told| {
            is_right(reference, asked, told, references.len())
        }) {
            Ok(()) => right += 1,
            Err(what) if mark.note.is_empty() => {
                let (x, y) = reference.pixel;
                mark.note = format!("pixel {x},{y}: the estimate {what}");
            }
            Err(_) => {}
        }
    }
    let all = references.len().max(1) as u64;
    mark.score = check.points * right / all;
    mark.counts.right = right;
    mark.counts.wrong = all - right;
    mark.status = match status(mark.score, mark.most) {
        CheckStatus::None if given.problems.is_empty() => CheckStatus::None,
        other => other,
    };
    mark
}

/// Whether a pixel's samples are those of a right tracer; what is wrong with them.
fn is_right(
    reference: &EstimateReference,
    asked: &EstimateFile,
    told: &PixelFacts,
    pixels: usize,
) -> Result<(), String> {
    let values = &told.estimates;
    let of_samples = || {
        let n = values.len() as u64;
        (values.iter().sum::<f64>() / n as f64, n)
    };
    let (mean, n) = match asked.ask {
        AskedEstimate::Mean => told.mean.unwrap_or_else(of_samples),
        AskedEstimate::Samples => of_samples(),
    };
    if n < asked.samples {
        return Err(format!("has {n} samples, and {} are asked", asked.samples));
    }
    let allowed = reference.allowed(n as f64, pixels);
    if !mean.is_finite() || (mean - reference.mean).abs() > allowed {
        return Err(format!(
            "has the mean {mean:.5}; the true one is {:.5}, and {allowed:.5} off are allowed for {n} samples",
            reference.mean
        ));
    }
    if asked.ask == AskedEstimate::Mean {
        return Ok(());
    }
    let variance = values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n as f64;
    let spread = variance / reference.variance;
    if reference.variance > 0.0 && !(0.5..=2.0).contains(&spread) {
        return Err(format!(
            "has samples of variance {variance:.5}, and single samples have {:.5}: are they means?",
            reference.variance
        ));
    }
    let different: BTreeSet<u64> = values.iter().map(|x| x.to_bits()).take(10_000).collect();
    if reference.variance > 0.0 && different.len() < 3 {
        return Err("has fewer than three different samples".to_owned());
    }
    Ok(())
}
