//! Exercises of each kind: the answer is there, it is none that anybody guesses, and the start is not solved already.

use std::collections::BTreeSet;

use crate::grade::report::Marked;
use crate::grade::submission::Submission;
use crate::lab;
use crate::lab::differ::pixels_that_differ;
use crate::lab::show::ShownValue;
use crate::lesson::answer::{
    AnswerVerdict, StudentAnswer, first_wrong, is_right, judge, load_task, parts, start_text,
};
use crate::lesson::chapter::Chapter;
use crate::lesson::course::Course;
use crate::lesson::exercise::{Choices, Exercise, ExerciseKind, Solution, Wanted};
use crate::lesson::question::Question;
use crate::lesson::stage::Stage;
use crate::scene::{Bend, Bends};
use crate::tracer::thread_pool;

/// An error if an exercise has no answer, or an answer that is too easy.
pub fn check(course: &Course, chapter: &Chapter, exercise: &Exercise) -> Result<(), String> {
    let stage = course.stage_of(chapter, exercise);
    let stage = stage.map_err(|e| e.to_string())?;
    match &exercise.kind {
        ExerciseKind::Predict { asked, tolerance } => {
            predict(&Question::new(&stage, asked, 0)?, *tolerance)
        }
        ExerciseKind::Find(wanted) => find(&stage, wanted),
        ExerciseKind::Change(task) => {
            let start = start_text(&stage, task)?;
            let judged = |text: String| -> Result<AnswerVerdict, String> {
                judge(course, chapter, exercise, &StudentAnswer::Scene(text), 0)
            };
            if judged(start)?.right {
                return Err("its start fulfils all goals already".to_owned());
            }
            let solved = judged(solution_text(course, &stage, &task.start, &task.solution)?)?;
            if !solved.right {
                return Err(format!("its solution fails: {}", solved.lines.join("; ")));
            }
            Ok(())
        }
        ExerciseKind::Bug { bend, among, at } => bug(&stage, *bend, among, *at),
        ExerciseKind::Choose { bend, options, .. } => {
            choose(course, chapter, &stage, *bend, options)
        }
        ExerciseKind::Write { task } => thread_pool::install(0, || write(course, task)),
    }
}

/// The text of a solution.
pub fn solution_text(
    course: &Course,
    stage: &Stage,
    start: &[String],
    solution: &Solution,
) -> Result<String, String> {
    match solution {
        Solution::File(file) => {
            let text = course.files.text(file);
            text.map(str::to_owned).map_err(|e| e.to_string())
        }
        Solution::Changes(changes) => {
            let all: Vec<String> = start.iter().chain(changes).cloned().collect();
            let task = crate::lesson::exercise::ChangeTask {
                keep: Vec::new(),
                goals: Vec::new(),
                start: all,
                solution: Solution::Changes(Vec::new()),
            };
            start_text(stage, &task)
        }
    }
}

/// The answer is finite, and none of those that anybody tries.
fn predict(question: &Question, tolerance: Option<f64>) -> Result<(), String> {
    let answer = &question.answer;
    if answer.numbers().iter().any(|x| !x.is_finite()) {
        return Err("its answer is not finite".to_owned());
    }
    if question.is_guessed(tolerance) {
        return Err("whoever says 0 or 1 is right: ask another pixel".to_owned());
    }
    Ok(())
}

/// At least one pixel, and at most half of them.
fn find(stage: &Stage, wanted: &Wanted) -> Result<(), String> {
    let those = found(stage, wanted)?;
    let (width, height) = stage.settings.size();
    let all = width as usize * height as usize;
    if those.is_empty() {
        return Err("it holds for no pixel".to_owned());
    }
    if 2 * those.len() > all {
        return Err(format!(
            "it holds for {} of {all} pixels, more than half: whoever guesses is right",
            those.len()
        ));
    }
    Ok(())
}

/// All pixels that fulfil what is wanted, row after row.
pub fn found(stage: &Stage, wanted: &Wanted) -> Result<Vec<(u32, u32)>, String> {
    // What cannot be asked is told by the first pixel.
    parts(stage, wanted, (0, 0))?;
    let (world, settings) = (&stage.world, &stage.settings);
    let (width, height) = settings.size();
    let mut those: Vec<(u32, u32)> = (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .collect();
    let mut keep = |some: &BTreeSet<(u32, u32)>| those.retain(|at| some.contains(at));
    if let Some(query) = &wanted.query {
        let go_on = |_: &[(u32, u32)], _| std::ops::ControlFlow::Continue(());
        let found = lab::find::find(world, settings, query, usize::MAX, 0, &go_on);
        keep(&found.pixels.into_iter().collect());
    }
    if !wanted.differs.is_empty() {
        let other = stage.with(&wanted.differs)?;
        let found = pixels_that_differ((world, settings), (&other.world, &other.settings), 0);
        keep(&found.into_iter().collect());
    }
    if let Some((mode, [least, most])) = wanted.shown {
        let values = lab::show::show(world, settings, mode, 0);
        let fits = |value: &ShownValue| matches!(value, ShownValue::Number(x) if (least..=most).contains(x));
        let numbers = (0..).zip(&values).filter(|(_, value)| fits(value));
        let at = |(i, _): (u32, &ShownValue)| (i % width, i / width);
        keep(&numbers.map(at).collect());
    }
    Ok(those)
}

/// The bend changes the tree, and differently from all others that are offered.
fn bug(stage: &Stage, bend: Bend, among: &[Bend], at: (u32, u32)) -> Result<(), String> {
    first_wrong(stage, bend, at)?;
    let tree = |bend: Bend| {
        let settings = stage.settings.with(|s| s.bends = Bends::from(bend));
        crate::grade::pixel_tree::traced(&stage.world, &settings, at)
    };
    let wanted = tree(bend);
    for other in among.iter().filter(|other| **other != bend) {
        if tree(*other) == wanted {
            return Err(format!(
                "`{}` gives the same tree at pixel {},{}: ask another pixel",
                other.name(),
                at.0,
                at.1
            ));
        }
    }
    Ok(())
}

/// One option is right, each other one says why not, and the slide fails somewhere.
fn choose(
    course: &Course,
    chapter: &Chapter,
    stage: &Stage,
    bend: Option<Bend>,
    options: &[Choices],
) -> Result<(), String> {
    let mut right = 0;
    for option in options {
        if is_right(course, chapter, stage, &option.right)? {
            right += 1;
        } else if option.say.is_empty() {
            return Err(format!(
                "option `{}` does not `say` why it is wrong",
                option.text
            ));
        }
    }
    if right != 1 {
        return Err(format!("{right} options are right; one is to be"));
    }
    let Some(bend) = bend else { return Ok(()) };
    slide_pixel(stage, bend).map(|_| ())
}

/// A pixel at which a slide fails.
pub fn slide_pixel(stage: &Stage, bend: Bend) -> Result<(u32, u32), String> {
    let (width, height) = stage.settings.size();
    let steps = |size: u32| (0..size).step_by((size as usize / 24).max(1));
    let mut tried = steps(height).flat_map(|y| steps(width).map(move |x| (x, y)));
    let found = tried.find(|at| first_wrong(stage, bend, *at).is_ok());
    found.ok_or_else(|| format!("`{}` changes no pixel of 576 that were tried", bend.name()))
}

/// Nothing earns nothing, and what our tracer hands in earns all.
fn write(course: &Course, path: &str) -> Result<(), String> {
    let task = load_task(course, path)?;
    if let Some(warning) = task.warnings.first() {
        return Err(warning.clone());
    }
    let tasks = std::slice::from_ref(&task);
    let empty = Marked::new(tasks, Submission::default());
    if empty.score() > 0 {
        return Err("who hands in nothing earns something".to_owned());
    }
    let given = crate::grade::selftest::handed_in(&task, Bends::default());
    let ours = Marked::of_given(tasks, &task, String::new(), &given);
    if ours.score() < ours.most() {
        return Err(format!(
            "our own tracer earns {} percent; take out the pixels that are not steady",
            ours.percent()
        ));
    }
    Ok(())
}
