//! Solution of an exercise, computed: for who has done it, or given it up.

use super::answer::{first_wrong, is_right, letter};
use super::chapter::Chapter;
use super::check::{found, slide_pixel, solution_text};
use super::course::Course;
use super::exercise::{Choices, Exercise, ExerciseKind, Solution};
use super::question::Question;
use super::stage::Stage;

/// What could have been answered, in lines; `tries` counts the answers so far.
pub fn solution(
    course: &Course,
    chapter: &Chapter,
    exercise: &Exercise,
    tries: u32,
) -> Result<Vec<String>, String> {
    let stage = course.stage_of(chapter, exercise);
    let stage = stage.map_err(|e| e.to_string())?;
    Ok(match &exercise.kind {
        ExerciseKind::Predict { asked, .. } => {
            let question = Question::new(&stage, asked, tries)?;
            let place = question.ray.map_or(String::new(), |ray| {
                format!(" at {},{}{}", ray.pixel.0, ray.pixel.1, ray.path)
            });
            vec![format!("{}{place}", question.answer.text(None))]
        }
        ExerciseKind::Find(wanted) => {
            let all = found(&stage, wanted)?;
            let middle = all.get(all.len() / 2).copied();
            let (x, y) = middle.ok_or("no pixel is one")?;
            vec![format!("{x},{y}, and {} others", all.len() - 1)]
        }
        ExerciseKind::Change(task) => match &task.solution {
            Solution::Changes(changes) => changes
                .iter()
                .map(|change| format!("--change {change}"))
                .collect(),
            Solution::File(_) => {
                let text = solution_text(course, &stage, &task.start, &task.solution)?;
                text.lines().map(str::to_owned).collect()
            }
        },
        ExerciseKind::Bug { bend, at, .. } => {
            let (path, what) = first_wrong(&stage, *bend, *at)?;
            let ray = if path.steps.is_empty() {
                "/".to_owned()
            } else {
                path.to_string()
            };
            vec![
                format!("{} {ray}", bend.name()),
                format!(
                    "{}: it computes {}",
                    bend.entry().note,
                    bend.entry().formula
                ),
                format!("its first trace is {what}"),
            ]
        }
        ExerciseKind::Choose { bend, options, .. } => {
            let place = match bend {
                Some(bend) => {
                    let (x, y) = slide_pixel(&stage, *bend)?;
                    format!("{x},{y} ")
                }
                None => String::new(),
            };
            chosen(course, chapter, &stage, options, &place)?
        }
        ExerciseKind::Write { task } => {
            vec![format!("the book shows a whole tracer; the task is {task}")]
        }
    })
}

/// The right one of some options: its letter behind the pixel, and its text.
fn chosen(
    course: &Course,
    chapter: &Chapter,
    stage: &Stage,
    options: &[Choices],
    pixel: &str,
) -> Result<Vec<String>, String> {
    let mut lines = Vec::new();
    for (index, option) in options.iter().enumerate() {
        if is_right(course, chapter, stage, &option.right)? {
            lines.push(format!("{pixel}{}", letter(index)));
            lines.push(option.text.clone());
        }
    }
    Ok(lines)
}
