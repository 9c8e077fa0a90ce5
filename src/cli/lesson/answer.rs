//! `raytree lesson answer`, `hint`, `solution` and `reset`: exercises without the screen.

use std::io::{BufRead as _, IsTerminal as _, Read as _, Write as _};
use std::path::Path;

use clap::Args;

use super::exercise;
use crate::cli::output::to_stdout;
use crate::cli::{Completion, Failure};
use crate::grade::submission::Submission;
use crate::lesson::answer::{StudentAnswer, judge};
use crate::lesson::progress::ProgressFile;
use crate::lesson::reader::{markdown, question};
use crate::lesson::solution::solution;
use crate::lesson::{Course, ExerciseKind};
use crate::scene::limits::MAX_CHANGED_BYTES;
use crate::scene::printable::{excerpt, printable};
use crate::scene::read::files::{regular, unreadable};
use crate::trace::Address;
use crate::trace::facts::TreePath;

#[derive(Args)]
pub struct Answer {
    /// The exercise
    id: String,
    /// The answer: a value, a pixel X,Y, the letter or number of an option, a mistake and a ray, the path of a file
    #[arg(required = true, num_args = 1.., allow_hyphen_values = true)]
    value: Vec<String>,
}

impl Answer {
    pub fn run(&self, course: &Course, state: &mut ProgressFile) -> Result<Completion, Failure> {
        let (chapter, exercise) = exercise(course, &self.id)?;
        let given = given(&exercise.kind, &self.value)?;
        let tries = state.progress().of(&self.id).asked_before();
        let verdict = judge(course, chapter, exercise, &given, tries).map_err(Failure::Usage)?;
        let skipped = state.change(|progress| {
            progress.chapter.clone_from(&chapter.folder);
            progress.answered(course, &self.id, verdict.right)
        });
        let lines = verdict.lines.iter().chain(&skipped);
        let lines: Vec<&str> = lines.map(String::as_str).collect();
        let mut text = lines.join("\n");
        if !verdict.right {
            // It may be about another pixel now.
            let tries = state.progress().of(&self.id).asked_before();
            text = text + "\n" + &question(course, chapter, exercise, tries);
        }
        let lines = text.lines().map(|line| printable(line).into_owned());
        let out: String = lines.map(|line| line + "\n").collect();
        to_stdout(out.as_bytes())?;
        Ok(if verdict.right {
            Completion::Whole
        } else {
            Completion::No
        })
    }
}

/// An answer from the words that were typed.
fn given(kind: &ExerciseKind, words: &[String]) -> Result<StudentAnswer, Failure> {
    if let Some(flag) = words.iter().find(|word| word.starts_with("--")) {
        let flag = excerpt(flag);
        return Err(Failure::Usage(format!(
            "`{flag}` stands behind the answer; write it before: raytree lesson {flag} ... answer EXERCISE VALUE"
        )));
    }
    let usage = || Failure::Usage(kind.answered_by().to_owned());
    Ok(match (kind, words) {
        (ExerciseKind::Predict { .. }, words) => StudentAnswer::Value(words.join(" ")),
        (ExerciseKind::Find(_), [pixel]) => {
            StudentAnswer::Pixel(pixel_of(pixel).ok_or_else(usage)?)
        }
        (ExerciseKind::Change(_), [path]) => StudentAnswer::Scene(text_of(Path::new(path))?),
        (ExerciseKind::Bug { .. }, [law, ray]) => {
            StudentAnswer::Bug(law.clone(), path_of(ray).map_err(Failure::Usage)?)
        }
        (ExerciseKind::Choose { bend: None, .. }, [letter]) => {
            StudentAnswer::Choice(None, letter_of(letter).ok_or_else(usage)?)
        }
        (ExerciseKind::Choose { .. }, [pixel, letter]) => StudentAnswer::Choice(
            Some(pixel_of(pixel).ok_or_else(usage)?),
            letter_of(letter).ok_or_else(usage)?,
        ),
        (ExerciseKind::Write { .. }, [path]) => {
            StudentAnswer::HandedIn(Submission::read(Path::new(path)))
        }
        _ => return Err(usage()),
    })
}

fn pixel_of(text: &str) -> Option<(u32, u32)> {
    text.parse::<Address>().ok().map(|address| address.pixel)
}

fn letter_of(text: &str) -> Option<char> {
    let mut letters = text.chars();
    let letter = letters.next().filter(|_| letters.next().is_none())?;
    // On the screen they have numbers.
    let number = letter.to_digit(10).filter(|n| *n > 0);
    Some(number.map_or(letter, |n| crate::lesson::answer::letter(n as usize - 1)))
}

/// A ray by its steps: `/` or `I` for the eye ray, `/T/T`, `/L:lamp`.
fn path_of(text: &str) -> Result<TreePath, String> {
    if text == "I" {
        return Ok(TreePath::default());
    }
    let address: Address = format!("0,0{}", text.trim_end_matches('/'))
        .parse()
        .map_err(|what| {
            format!(
                "`{}`: {what}; write / for the eye ray, /T/T, /L:lamp",
                excerpt(text)
            )
        })?;
    Ok(address.path)
}

/// The text of a scene file.
fn text_of(path: &Path) -> Result<String, Failure> {
    let shown = path.to_string_lossy();
    let (file, length) = regular(path, ".json").map_err(|problem| problem.in_file(&shown))?;
    if length > MAX_CHANGED_BYTES as u64 {
        let what = format!(
            "{}: is too long for a scene of an exercise",
            excerpt(&shown)
        );
        return Err(Failure::Input(what));
    }
    let mut text = String::new();
    let read = file
        .take(MAX_CHANGED_BYTES as u64)
        .read_to_string(&mut text);
    read.map_err(|error| unreadable(&error).in_file(&shown))?;
    Ok(text)
}

/// Prints the next hint.
pub fn hint(course: &Course, state: &mut ProgressFile, id: &str) -> Result<Completion, Failure> {
    let (_, exercise) = exercise(course, id)?;
    let is_other = state.progress().of(id).asked_before() > 0
        && matches!(exercise.kind, ExerciseKind::Predict { .. });
    let next = state.change(|progress| {
        let next = progress.hint(exercise);
        next.map(|(number, hint)| (number, hint.to_owned()))
    });
    let of = if is_other {
        " (The numbers are those of the first pixel.)"
    } else {
        ""
    };
    let out = match next {
        Some((number, hint)) => format!(
            "hint {number} of {}: {}",
            exercise.hints.len(),
            markdown(&(hint + of), 80)
        ),
        None if exercise.hints.is_empty() => "this exercise has no hints\n".to_owned(),
        None => format!(
            "these are all hints; raytree lesson solution {id} --give-up tells the solution\n"
        ),
    };
    to_stdout(out.trim_end().as_bytes())?;
    to_stdout(b"\n")
}

#[derive(Args)]
pub struct ShowSolution {
    /// The exercise
    id: String,
    /// Though it is not done
    #[arg(long)]
    give_up: bool,
}

impl ShowSolution {
    pub fn run(&self, course: &Course, state: &mut ProgressFile) -> Result<Completion, Failure> {
        let (chapter, exercise) = exercise(course, &self.id)?;
        let done = state.progress().of(&self.id);
        if !done.done && !self.give_up {
            return Err(Failure::Usage(format!(
                "`{}` is not done yet; --give-up tells its solution all the same",
                self.id
            )));
        }
        let lines =
            solution(course, chapter, exercise, done.asked_before()).map_err(Failure::Input)?;
        state.change(|progress| progress.give_up(&self.id));
        to_stdout((lines.join("\n") + "\n").as_bytes())
    }
}

#[derive(Args)]
pub struct Reset {
    /// The exercise
    #[arg(required_unless_present = "all")]
    id: Option<String>,
    /// All of the course
    #[arg(long, conflicts_with = "id")]
    all: bool,
    /// Do not ask
    #[arg(long)]
    yes: bool,
}

impl Reset {
    pub fn run(&self, course: &Course, state: &mut ProgressFile) -> Result<Completion, Failure> {
        if let Some(id) = &self.id {
            exercise(course, id)?;
        }
        let what = self
            .id
            .as_ref()
            .map_or("all that is done".to_owned(), |id| format!("`{id}`"));
        if !self.yes && !confirmed(&what)? {
            return to_stdout(b"nothing is forgotten\n");
        }
        state.change(|progress| match &self.id {
            Some(id) => progress.reset(id),
            None => progress.exercises.clear(),
        });
        to_stdout(format!("{what} is forgotten\n").as_bytes())
    }
}

/// Whether the user says yes.
fn confirmed(what: &str) -> Result<bool, Failure> {
    if !std::io::stdin().is_terminal() {
        let what = "nobody can be asked here; add --yes to forget";
        return Err(Failure::Usage(what.to_owned()));
    }
    eprint!("Forget {what}? [y/N] ");
    let _ = std::io::stderr().flush();
    let mut line = String::new();
    let read = std::io::stdin().lock().read_line(&mut line);
    Ok(read.is_ok() && matches!(line.trim(), "y" | "Y" | "yes"))
}
