//! An exercise that is worked on in files, checked again as often as they change: a changed scene, a program.

use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use super::answer::{AnswerVerdict, StudentAnswer, judge, load_task};
use super::chapter::Chapter;
use super::course::Course;
use super::exercise::{ChangeTask, Exercise, ExerciseKind};
use super::progress::CourseProgress;
use super::value::AskedValue;
use super::workspace::work_path;
use crate::grade::output::{Audience, text};
use crate::grade::report::Marked;
use crate::grade::run::{RunOptions, Runner};
use crate::grade::submission::Submission;
use crate::grade::task::Task;
use crate::scene::limits::MAX_CHANGED_BYTES;
use crate::scene::printable::shell_word;
use crate::scene::read::files::{regular, unreadable};
use crate::scene::settings::knobs::flags;
use crate::tracer::thread_pool;

/// An exercise with the files that it is done in.
pub struct WorkedExercise<'a> {
    course: &'a Course,
    /// Its chapter.
    pub chapter: &'a Chapter,
    /// The exercise.
    pub exercise: &'a Exercise,
    /// The folder of all files.
    folder: PathBuf,
    /// The file that is changed, or the folder of the task's files.
    path: PathBuf,
    /// What marks it, if it is a program.
    program: Option<Program>,
}

/// What marks a program.
struct Program {
    task: Task,
    /// The task as it is told: its scenes are where they lie on the disk.
    told: Task,
    runner: Runner,
}

/// The first exercise that is open and worked on in files, behind another one; without it, or if there is none, from the first
/// on. Programs count only if they can be run.
pub fn next_worked<'a>(
    course: &'a Course,
    progress: &CourseProgress,
    behind: Option<&str>,
    runs: bool,
) -> Option<&'a str> {
    let is_worked = |exercise: &Exercise| match exercise.kind {
        ExerciseKind::Change(_) => true,
        ExerciseKind::Write { .. } => runs,
        _ => false,
    };
    let all: Vec<&Exercise> = course.exercises().map(|(_, exercise)| exercise).collect();
    let at = all.iter().position(|e| Some(e.id.as_str()) == behind);
    let from = at.map_or(0, |at| at + 1);
    let turned = all[from..].iter().chain(&all[..from]);
    let mut open = turned.filter(|e| is_worked(e) && !progress.is_over(&e.id));
    open.next().map(|exercise| exercise.id.as_str())
}

impl<'a> WorkedExercise<'a> {
    /// The exercise of this name, worked on below a folder; `run` tells how a program is run.
    pub fn new(
        course: &'a Course,
        id: &str,
        folder: &Path,
        run: Option<RunOptions>,
    ) -> Result<Self, String> {
        let (chapter, exercise) = course.exercise(id)?;
        let path = work_path(chapter, id, &exercise.kind).ok_or_else(|| {
            format!(
                "`{id}` ({}) is done in the debugger and not in files: raytree lesson run {id}",
                exercise.kind.name()
            )
        })?;
        let path = folder.join(path);
        let program = match (&exercise.kind, run) {
            (ExerciseKind::Write { task }, Some(run)) => {
                // References are traced, on threads whose stacks are deep enough.
                let task = thread_pool::install(0, || load_task(course, task))?;
                Some(Program::new(task, &path, run)?)
            }
            (ExerciseKind::Write { .. }, None) => {
                return Err(format!(
                    "`{id}` is a program: tell how yours is run, such as --run 'python3 tracer.py {{flat}} {{pixels}}'"
                ));
            }
            _ => None,
        };
        Ok(Self {
            course,
            chapter,
            exercise,
            folder: folder.to_owned(),
            path,
            program,
        })
    }

    /// The file, or for a program the folder, in which a change is looked for.
    pub fn watched(&self) -> &Path {
        match self.program {
            Some(_) => &self.folder,
            None => &self.path,
        }
    }

    /// Checks what is there now. An error if it cannot be judged at all.
    pub fn check(&self) -> Result<AnswerVerdict, String> {
        match (&self.program, &self.exercise.kind) {
            (Some(program), _) => Ok(program.marks(&self.folder)),
            (None, ExerciseKind::Change(task)) => self.judge_scene(task),
            _ => Err("it is not done in files".to_owned()),
        }
    }

    fn judge_scene(&self, task: &ChangeTask) -> Result<AnswerVerdict, String> {
        let text = text_of(&self.path)?;
        let given = StudentAnswer::Scene(text);
        let verdict = judge(self.course, self.chapter, self.exercise, &given, 0)?;
        if verdict.right {
            return Ok(verdict);
        }
        let opens = self.opens(task, &verdict)?;
        Ok(verdict.line(opens))
    }

    /// The command that opens the changed scene in the debugger, at the first goal that does not hold.
    fn opens(&self, task: &ChangeTask, verdict: &AnswerVerdict) -> Result<String, String> {
        let stage = self.course.stage_of(self.chapter, self.exercise);
        let stage = stage.map_err(|e| e.to_string())?;
        let mut command = format!("raytree view {}", shell_word(&self.path.to_string_lossy()));
        for (flag, value) in flags(&stage.settings, &stage.world.scene) {
            let _ = write!(command, " --{flag} {}", shell_word(&value));
        }
        // Below the first line there is one for each goal.
        let goals = task.goals.iter().zip(verdict.lines.iter().skip(1));
        let first = goals.into_iter().find(|(_, line)| line.starts_with("no"));
        if let Some(AskedValue::Field(address, _)) = first.map(|(goal, _)| &goal.asked.what) {
            let _ = write!(command, " --at {}", shell_word(&address.to_string()));
        }
        Ok(command)
    }
}

impl Program {
    fn new(task: Task, files: &Path, run: RunOptions) -> Result<Self, String> {
        let runner = Runner::new(&task, run)?;
        let mut told = task.clone();
        for scene in &mut told.scenes {
            let (name, rest) = match scene.label.split_once(" without ") {
                Some((name, rest)) => (name, format!(" without {rest}")),
                None => (scene.label.as_str(), String::new()),
            };
            let file = files.join(name.rsplit('/').next().unwrap_or(name));
            if file.is_file() {
                scene.label = format!("{}{rest}", file.to_string_lossy());
            }
        }
        Ok(Self { task, told, runner })
    }

    /// The marks of the program in a folder.
    fn marks(&self, folder: &Path) -> AnswerVerdict {
        let submission = self.runner.run(Submission::read(folder));
        let tasks = std::slice::from_ref(&self.task);
        let marked = thread_pool::install(0, || Marked::new(tasks, submission));
        let audience = Audience {
            task: &self.told,
            for_students: true,
        };
        let told = text::submission(audience, &marked);
        AnswerVerdict {
            right: marked.score() == marked.most(),
            lines: told.lines().map(str::to_owned).collect(),
        }
    }
}

/// The text of a scene file.
fn text_of(path: &Path) -> Result<String, String> {
    let shown = path.to_string_lossy();
    if !path.exists() {
        return Err(format!(
            "{shown} is not there; `raytree lesson start FOLDER` puts the files of all exercises into a folder"
        ));
    }
    let most = MAX_CHANGED_BYTES as u64;
    let (file, length) =
        regular(path, ".json").map_err(|problem| problem.in_file(&shown).to_string())?;
    if length > most {
        return Err(format!("{shown} is too long for a scene of an exercise"));
    }
    let mut text = String::new();
    let read = file.take(most).read_to_string(&mut text);
    read.map_err(|error| unreadable(&error).in_file(&shown).to_string())?;
    Ok(text)
}
