//! What a scene calls for and a chapter does not enable yet.

use strum::VariantArray as _;

use super::chapter::Chapter;
use super::course::Course;
use super::feature::Feature;
use crate::scene::Scene;
use crate::scene::effects::findings;

/// An effect that a scene calls for and that is off in a chapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OffEffect {
    /// The feature.
    pub feature: Feature,
    /// The number of the chapter that enables it, if one does.
    pub until: Option<usize>,
    /// What in the scene calls for it.
    pub reason: String,
}

/// What a scene calls for and a chapter does not enable.
pub fn off(course: &Course, chapter: &Chapter, scene: &Scene) -> Vec<OffEffect> {
    let found = findings(scene);
    let those = Feature::VARIANTS.iter().filter_map(|feature| {
        let effect = feature.effect()?;
        let finding = found.iter().find(|f| f.effect == effect && f.on)?;
        (!chapter.features.has(*feature)).then(|| OffEffect {
            feature: *feature,
            until: course
                .chapters
                .iter()
                .find(|c| c.enables.contains(feature))
                .map(|c| c.number),
            reason: finding.reason.clone(),
        })
    });
    those.collect()
}
