//! Scenes of a chapter: they grow from chapter to chapter, and settings enable nothing that comes later.

use serde_json::Value;

use super::CheckName;
use crate::lesson::chapter::Chapter;
use crate::lesson::course::Course;
use crate::lesson::exercise::ExerciseKind;
use crate::lesson::feature::{Feature, Features};
use crate::lesson::files::is_scene_file;
use crate::scene::Settings;

/// What is wrong with the scenes and settings of a chapter.
pub fn wrong(
    course: &Course,
    chapter: &Chapter,
    before: Option<&Chapter>,
) -> Vec<(CheckName, String)> {
    let mut wrong = Vec::new();
    match course.stage(chapter, None, &[]) {
        Err(error) => wrong.push((CheckName::Files, error.to_string())),
        Ok(stage) => {
            for what in not_enabled(chapter.features, &stage.settings) {
                wrong.push((CheckName::Enabled, format!("its settings {what}")));
            }
        }
    }
    for exercise in &chapter.exercises {
        match course.stage_of(chapter, exercise) {
            Err(error) => wrong.push((CheckName::Files, error.to_string())),
            Ok(stage) => {
                for what in not_enabled(chapter.features, &stage.settings) {
                    let what = format!("exercise `{}`: its settings {what}", exercise.id);
                    wrong.push((CheckName::Enabled, what));
                }
            }
        }
        if let ExerciseKind::Write { task } = &exercise.kind
            && !course.files.has(task)
        {
            wrong.push((
                CheckName::Files,
                format!("there is no task `{task}` in the course"),
            ));
        }
    }
    if let Some(before) = before.filter(|_| !chapter.restart) {
        for name in lost(course, before, chapter) {
            let what = format!(
                "its scene has no `{name}`, which that of {} has; put it there, or write restart = true",
                before.folder
            );
            wrong.push((CheckName::Grows, what));
        }
    }
    wrong
}

/// What settings turn on that no chapter up to here enables.
fn not_enabled(features: Features, settings: &Settings) -> Vec<String> {
    let mut limited = *settings;
    features.limit(&mut limited);
    let mut wrong = Vec::new();
    if limited.effects != settings.effects {
        wrong.push("turn on an effect that is not enabled yet".to_owned());
    }
    if limited.recursion.depth != settings.recursion.depth && !features.has(Feature::Tree) {
        wrong.push("need the feature `tree`, for a depth of more than 1".to_owned());
    }
    if limited.pixel.samples != settings.pixel.samples {
        wrong.push("need the feature `samples`".to_owned());
    }
    if limited.fresnel != settings.fresnel {
        wrong.push("need the feature `fresnel`".to_owned());
    }
    if limited.light.sampler != settings.light.sampler {
        wrong.push("need the feature `light-random`".to_owned());
    }
    wrong
}

/// Objects and lights of the scene before that a scene does not have any more.
fn lost(course: &Course, before: &Chapter, chapter: &Chapter) -> Vec<String> {
    let names = |scene: &str| -> Vec<String> {
        if !is_scene_file(scene) {
            return Vec::new();
        }
        let text = course.files.text(scene).unwrap_or_default();
        let file: Value = serde_json::from_str(text).unwrap_or_default();
        ["objects", "lights"]
            .iter()
            .filter_map(|part| file.get(part)?.as_array())
            .flatten()
            .filter_map(|item| item.as_object()?.values().next()?.get("name")?.as_str())
            .map(str::to_owned)
            .collect()
    };
    let now = names(&chapter.scene);
    let earlier = names(&before.scene);
    earlier
        .into_iter()
        .filter(|name| !now.contains(name))
        .collect()
}
