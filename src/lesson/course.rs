//! A course: its chapters in order, read from its files.

use std::collections::BTreeSet;
use std::path::Path;

use serde::Deserialize;

use super::chapter::Chapter;
use super::exercise::Exercise;
use super::feature::Features;
use super::files::{CourseError, CourseFiles, clean, from_toml};
use super::names::is_id;
use crate::scene::printable::excerpt;
use crate::scene::read::did_you_mean::did_you_mean;

/// Chapters and exercises of a course at most.
const MAX_CHAPTERS: usize = 200;
const MAX_EXERCISES: usize = 2000;

/// `course.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CourseFile {
    format: String,
    id: String,
    title: String,
    #[serde(default)]
    program: Option<String>,
    chapters: Vec<String>,
}

/// A course.
#[derive(Clone, Debug)]
pub struct Course {
    /// Its name in the file of progress: of a-z, 0-9 and -.
    pub id: String,
    /// Its title.
    pub title: String,
    /// The chapters, in order.
    pub chapters: Vec<Chapter>,
    /// Its files.
    pub files: CourseFiles,
}

impl Course {
    /// The course that the program brings along.
    pub fn embedded() -> Result<Self, CourseError> {
        Self::of(CourseFiles::embedded())
    }

    /// The course in a folder or an archive.
    pub fn read(path: &Path) -> Result<Self, CourseError> {
        Self::of(CourseFiles::read(path)?)
    }

    /// The course that these files make.
    pub fn of(files: CourseFiles) -> Result<Self, CourseError> {
        const FILE: &str = "course.toml";
        let file: CourseFile = from_toml(FILE, files.text(FILE)?)?;
        let wrong = |what: String| CourseError::new(FILE, what);
        if file.format != "raytree-course/1" {
            return Err(wrong(format!(
                "`format` is `{}`; this program reads raytree-course/1",
                excerpt(&file.format)
            )));
        }
        if !is_id(&file.id) {
            return Err(wrong("`id` is not of a-z, 0-9 and -".to_owned()));
        }
        if let Some(wanted) = &file.program {
            check_program(wanted).map_err(wrong)?;
        }
        if file.chapters.is_empty() || file.chapters.len() > MAX_CHAPTERS {
            return Err(wrong(format!("a course has 1 to {MAX_CHAPTERS} chapters")));
        }
        let mut chapters: Vec<Chapter> = Vec::new();
        let mut features = Features::default();
        for (number, folder) in (1..).zip(&file.chapters) {
            let folder = CourseFiles::beside("", folder).map_err(wrong)?;
            let chapter = Chapter::read(&files, &folder, number, features)?;
            features = chapter.features;
            chapters.push(chapter);
        }
        let course = Self {
            id: file.id,
            title: clean(&file.title),
            chapters,
            files,
        };
        course.check_ids()?;
        Ok(course)
    }

    /// An error if two exercises have one name.
    fn check_ids(&self) -> Result<(), CourseError> {
        let mut seen = BTreeSet::new();
        for (chapter, exercise) in self.exercises() {
            let file = format!("{}/chapter.toml", chapter.folder);
            if !seen.insert(exercise.id.as_str()) {
                let what = format!("exercise `{}` is there twice in the course", exercise.id);
                return Err(CourseError::new(&file, what));
            }
            if seen.len() > MAX_EXERCISES {
                let what = format!("a course has {MAX_EXERCISES} exercises at most");
                return Err(CourseError::new(&file, what));
            }
        }
        Ok(())
    }

    /// All exercises with their chapters, in order.
    pub fn exercises(&self) -> impl Iterator<Item = (&Chapter, &Exercise)> {
        let chapters = self.chapters.iter();
        chapters.flat_map(|chapter| chapter.exercises.iter().map(move |e| (chapter, e)))
    }

    /// The exercise of this name; if there is none, in words which may be meant.
    pub fn exercise(&self, id: &str) -> Result<(&Chapter, &Exercise), String> {
        let found = self.exercises().find(|(_, exercise)| exercise.id == id);
        found.ok_or_else(|| {
            let ids = self.exercises().map(|(_, exercise)| exercise.id.as_str());
            let guess = match did_you_mean(id, ids) {
                Some(near) => format!("did you mean `{near}`?"),
                None => "`raytree lesson list` shows them all".to_owned(),
            };
            format!("there is no exercise `{}`; {guess}", excerpt(id))
        })
    }

    /// The chapter by its number, its folder, or a part of its title.
    pub fn chapter(&self, name: &str) -> Result<&Chapter, String> {
        let small = name.to_lowercase();
        let by_number = name
            .parse()
            .ok()
            .and_then(|n: usize| self.chapters.get(n.wrapping_sub(1)));
        let by_name = || self.chapters.iter().find(|c| c.folder == name);
        let by_title = || {
            let mut those = self.chapters.iter();
            those.find(|c| !small.is_empty() && c.title.to_lowercase().contains(&small))
        };
        let found = by_number.or_else(by_name).or_else(by_title);
        found.ok_or_else(|| {
            let count = self.chapters.len();
            format!(
                "there is no chapter `{}`; give a number from 1 to {count}, or a word of its title",
                excerpt(name)
            )
        })
    }
}

/// An error if this program is older than a course wants it: `>=0.2`.
fn check_program(wanted: &str) -> Result<(), String> {
    let numbers = |text: &str| -> Option<Vec<u32>> {
        text.split('.')
            .map(|part| part.trim().parse().ok())
            .collect()
    };
    let least = wanted.trim().strip_prefix(">=").and_then(numbers);
    let Some(least) = least else {
        return Err(format!(
            "`program` is `{}`; write the least version, such as \">=0.1\"",
            excerpt(wanted)
        ));
    };
    let own = numbers(env!("CARGO_PKG_VERSION")).unwrap_or_default();
    if own < least {
        return Err(format!(
            "this course needs raytree {} or newer; this is {}",
            excerpt(wanted),
            env!("CARGO_PKG_VERSION")
        ));
    }
    Ok(())
}
