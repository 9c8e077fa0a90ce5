//! What a program printed, marked by the task that the exercise names.

use super::AnswerVerdict;
use crate::grade::output::{Audience, text};
use crate::grade::report::Marked;
use crate::grade::submission::Submission;
use crate::grade::task::{Task, TaskError};
use crate::lesson::course::Course;
use crate::lesson::names::{given_files, scene_path};
use crate::scene::Bends;

/// Judges what was handed in.
pub fn judge(
    course: &Course,
    task: &str,
    mut submission: Submission,
) -> Result<AnswerVerdict, String> {
    let task = load(course, task)?;
    submission.files.retain(|file| !is_given(&task, &file.name));
    let marked = Marked::new(std::slice::from_ref(&task), submission);
    let audience = Audience {
        task: &task,
        for_students: true,
    };
    let told = text::submission(audience, &marked);
    Ok(AnswerVerdict {
        right: marked.percent() >= 100,
        lines: told.lines().map(str::to_owned).collect(),
    })
}

/// True for the files that a student's folder has from the start: they are no answer.
fn is_given(task: &Task, name: &str) -> bool {
    let mut given = task.scenes.iter().flat_map(|s| given_files(&s.label));
    name == "task.toml" || given.any(|given| given == name)
}

/// A task of the course, whose scenes are files of the course or built in.
pub fn load(course: &Course, path: &str) -> Result<Task, String> {
    let text = course.files.text(path).map_err(|e| e.to_string())?;
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let read = |name: &str| {
        let wrong = |what: String| TaskError::Task {
            file: path.to_owned(),
            what,
        };
        let scene = scene_path(folder, name).map_err(wrong)?;
        let source = course.source(&scene).map_err(|e| wrong(e.to_string()))?;
        Ok((scene, source.scene()?))
    };
    Task::of_text(path, text, Bends::default(), &read).map_err(|e| e.to_string())
}
