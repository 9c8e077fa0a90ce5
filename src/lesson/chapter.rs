//! A chapter: its text, the features that it enables, and its exercises.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::exercise::{Exercise, ExerciseFile};
use super::feature::{Feature, Features};
use super::files::{CourseError, CourseFiles, clean, from_toml};
use super::names::{pairs, scene_path};
use crate::grade::task::SettingValue;
use crate::scene::printable::excerpt;

/// Exercises of a chapter at most.
const MAX_EXERCISES: usize = 100;

/// `chapter.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChapterFile {
    format: String,
    title: String,
    #[serde(default)]
    enables: Vec<String>,
    scene: String,
    #[serde(default)]
    settings: BTreeMap<String, SettingValue>,
    #[serde(default)]
    restart: bool,
    #[serde(default, rename = "exercise")]
    exercises: Vec<ExerciseFile>,
}

/// A chapter.
#[derive(Clone, Debug)]
pub struct Chapter {
    /// Its folder in the course.
    pub folder: String,
    /// Its number, from 1.
    pub number: usize,
    /// Its title.
    pub title: String,
    /// What it enables.
    pub enables: Vec<Feature>,
    /// What this chapter and those before it enable.
    pub features: Features,
    /// Its scene: a file in the course, or the name of a built-in scene.
    pub scene: String,
    /// Settings on top of those of the features, by the names of flags.
    pub settings: Vec<(String, String)>,
    /// True if its scene does not have what the scene of the chapter before has.
    pub restart: bool,
    /// Its text with directives, in Markdown.
    pub text: String,
    /// Its exercises, in order.
    pub exercises: Vec<Exercise>,
}

impl Chapter {
    /// Reads the chapter in a folder of the course; `before` is what the chapters before it enable.
    pub fn read(
        files: &CourseFiles,
        folder: &str,
        number: usize,
        before: Features,
    ) -> Result<Self, CourseError> {
        let name = format!("{folder}/chapter.toml");
        let file: ChapterFile = from_toml(&name, files.text(&name)?)?;
        let wrong = |what: String| CourseError::new(&name, what);
        if file.format != "raytree-chapter/1" {
            return Err(wrong(format!(
                "`format` is `{}`; this program reads raytree-chapter/1",
                excerpt(&file.format)
            )));
        }
        if file.exercises.len() > MAX_EXERCISES {
            return Err(wrong(format!(
                "a chapter has {MAX_EXERCISES} exercises at most"
            )));
        }
        let enables = file
            .enables
            .iter()
            .map(|name| Feature::named(name))
            .collect::<Result<Vec<_>, _>>()
            .map_err(wrong)?;
        let mut exercises = Vec::new();
        for exercise in file.exercises {
            let id = exercise.id.clone();
            let told = |what: String| wrong(format!("exercise `{}`: {what}", excerpt(&id)));
            exercises.push(exercise.exercise(folder).map_err(told)?);
        }
        Ok(Self {
            folder: folder.to_owned(),
            number,
            title: clean(&file.title),
            features: enables.iter().fold(before, |all, one| all.with(*one)),
            enables,
            scene: scene_path(folder, &file.scene).map_err(wrong)?,
            settings: pairs(&file.settings),
            restart: file.restart,
            text: clean(files.text(&format!("{folder}/text.md"))?),
            exercises,
        })
    }

    /// The exercise of this name.
    pub fn exercise(&self, id: &str) -> Option<&Exercise> {
        self.exercises.iter().find(|exercise| exercise.id == id)
    }
}
