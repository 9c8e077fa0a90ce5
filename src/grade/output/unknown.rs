//! Mistakes that nothing explains and that several submissions share: so a teacher learns which bend is missing.

use std::collections::BTreeMap;

use super::document::{GradedSubmission, UnknownGroup};

/// Submissions that must share a cause, for it to be listed.
const COMMON: usize = 5;

/// The groups, by law, quantity and ratio.
pub fn groups(submissions: &[GradedSubmission]) -> Vec<UnknownGroup> {
    let mut groups: BTreeMap<(&str, &str, &str), UnknownGroup> = BTreeMap::new();
    // By the index of the submission, since two may have one name.
    let mut last: BTreeMap<(&str, &str, &str), usize> = BTreeMap::new();
    for (index, submission) in submissions.iter().enumerate() {
        if !submission.bends.is_empty() {
            continue;
        }
        let checks = submission.checks.iter().filter_map(|c| c.shown.as_ref());
        let causes = checks.flat_map(|check| &check.causes);
        for cause in causes.filter(|cause| cause.as_if.is_empty()) {
            let law = cause.law.as_deref().unwrap_or_default();
            let key = (law, cause.quantity.as_str(), cause.ratio.as_str());
            let group = groups.entry(key).or_insert_with(|| UnknownGroup {
                law: law.to_owned(),
                quantity: cause.quantity.clone(),
                ratio: cause.ratio.clone(),
                submissions: Vec::new(),
                address: cause.address.clone(),
            });
            if last.insert(key, index) != Some(index) {
                group.submissions.push(submission.name.clone());
            }
        }
    }
    let common = groups.into_values();
    common.filter(|g| g.submissions.len() >= COMMON).collect()
}
