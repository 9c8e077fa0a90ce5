//! Every exercise of the course is answered in a pipe, right and wrong.

use std::path::Path;

use assert_cmd::Command;
use rayon::prelude::*;
use raytree::lesson::answer::letter;
use raytree::lesson::check::solution_text;
use raytree::lesson::solution::solution;
use raytree::lesson::{Chapter, Exercise, ExerciseKind};

use super::course;

fn lesson(state: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.arg("lesson").arg("--state").arg(state);
    command
}

/// A right answer as it is typed, and a wrong one; `tries` answers were given before.
fn answers(chapter: &Chapter, exercise: &Exercise, folder: &Path) -> [Vec<String>; 2] {
    let course = course();
    let told = |tries| solution(&course, chapter, exercise, tries).expect(&exercise.id);
    let words = |text: &str| {
        text.split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    match &exercise.kind {
        ExerciseKind::Predict { .. } => {
            // After a wrong answer it is asked about another pixel.
            let told = told(1)[0].clone();
            let answer = told.split(" at ").next().expect("a value").to_owned();
            let is_word = !answer.contains(|c: char| c.is_ascii_digit());
            let wrong = if is_word {
                "nothing of the kind"
            } else {
                "12345"
            };
            let count = answer.split(',').count();
            let wrong = if count > 1 {
                vec![wrong; count].join(",")
            } else {
                wrong.to_owned()
            };
            [vec![answer], vec![wrong]]
        }
        ExerciseKind::Find(_) => {
            let told = told(0)[0].clone();
            let pixel = told.split(", and").next().expect("a pixel").to_owned();
            [vec![pixel], vec!["9999,9999".to_owned()]]
        }
        ExerciseKind::Change(task) => {
            let stage = course.stage_of(chapter, exercise).expect("a stage");
            let text =
                solution_text(&course, &stage, &task.start, &task.solution).expect("a solution");
            let path = folder.join(format!("{}.json", exercise.id));
            std::fs::write(&path, text).expect("room");
            let path = path.to_string_lossy().into_owned();
            [vec![path], vec!["none.json".to_owned()]]
        }
        ExerciseKind::Bug { bend, among, .. } => {
            let right = words(&told(0)[0]);
            let other = among.iter().find(|other| *other != bend).expect("another");
            let wrong = vec![other.name().to_owned(), right[1].clone()];
            [right, wrong]
        }
        ExerciseKind::Choose { options, .. } => {
            let right = words(&told(0)[0]);
            let mut wrong = right.clone();
            let chosen = right.last().expect("a letter").clone();
            let other = (0..options.len())
                .map(|i| letter(i).to_string())
                .find(|l| *l != chosen);
            *wrong.last_mut().expect("a letter") = other.expect("another");
            [right, wrong]
        }
        ExerciseKind::Write { .. } => [Vec::new(), Vec::new()],
    }
}

/// All at once, into one file of progress: as many windows, and nothing is lost.
#[test]
fn every_exercise_can_be_answered_in_a_pipe() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("progress.json");
    let course = course();
    let all: Vec<(&Chapter, &Exercise)> = course.exercises().collect();
    let done = all
        .par_iter()
        .filter(|(_, exercise)| !matches!(exercise.kind, ExerciseKind::Write { .. }))
        .map(|(chapter, exercise)| {
            let id = &exercise.id;
            let [right, wrong] = answers(chapter, exercise, folder.path());
            let said = lesson(&state)
                .args(["answer", id])
                .args(&wrong)
                .output()
                .expect("runs");
            let code = said.status.code();
            let told = String::from_utf8_lossy(&said.stdout).into_owned()
                + &String::from_utf8_lossy(&said.stderr);
            assert!(
                matches!(code, Some(1 | 2 | 4)),
                "{id} {wrong:?}: {code:?} {told}"
            );
            let mut right_answer = right.clone();
            if matches!(exercise.kind, ExerciseKind::Predict { .. }) && code != Some(4) {
                // What cannot be read is no try: it is still asked about the first pixel.
                let told = solution(&course, chapter, exercise, 0).expect("a solution");
                right_answer = vec![told[0].split(" at ").next().expect("a value").to_owned()];
            }
            let said = lesson(&state)
                .args(["answer", id])
                .args(&right_answer)
                .output()
                .expect("runs");
            let told = String::from_utf8_lossy(&said.stdout).into_owned()
                + &String::from_utf8_lossy(&said.stderr);
            assert_eq!(said.status.code(), Some(0), "{id} {right_answer:?}: {told}");
            assert!(told.contains("right"), "{id}: {told}");
        })
        .count();
    assert!(done >= 120, "{done}");
    let report = lesson(&state)
        .args(["report", "--json"])
        .output()
        .expect("runs");
    let report: serde_json::Value = serde_json::from_slice(&report.stdout).expect("JSON");
    assert_eq!(report["done"], report["exercises"], "{report:#}");
}

#[test]
fn hints_come_one_by_one_and_a_solution_only_when_it_is_done_or_given_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("progress.json");
    let course = course();
    let (_, exercise) = course.exercises().next().expect("an exercise");
    let id = exercise.id.as_str();
    let said = |words: &[&str]| {
        let output = lesson(&state).args(words).output().expect("runs");
        let text = String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr);
        (output.status.code(), text)
    };
    for number in 1..=3 {
        let (code, text) = said(&["hint", id]);
        assert!(
            code == Some(0) && text.contains(&format!("hint {number} of 3")),
            "{text}"
        );
    }
    assert!(said(&["hint", id]).1.contains("--give-up"));
    let (code, text) = said(&["solution", id]);
    assert!(code == Some(2) && text.contains("--give-up"), "{text}");
    assert_eq!(said(&["solution", id, "--give-up"]).0, Some(0));
    assert_eq!(said(&["solution", id]).0, Some(0));
    assert!(said(&["report"]).1.contains("given up"));
    let (code, text) = said(&["reset", id]);
    assert!(code == Some(2) && text.contains("--yes"), "{text}");
    assert_eq!(said(&["reset", id, "--yes"]).0, Some(0));
    assert!(!said(&["report"]).1.contains("given up"));
    let (code, text) = said(&["answer", "nothing-of-it", "1"]);
    assert!(code == Some(2) && text.contains("no exercise"), "{text}");
    let (code, text) = said(&["read", "99"]);
    assert!(code == Some(2) && text.contains("1 to 24"), "{text}");
}

/// The files that a student is given are no answer, and nothing is said against them.
#[test]
fn a_folder_as_it_is_given_has_no_answer_yet() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("progress.json");
    let work = folder.path().join("work");
    let path = |name: &str| work.join(name).display().to_string();
    let started = lesson(&state).args(["start", &path("")]).output();
    assert!(started.expect("runs").status.success());
    for (id, at) in [
        ("write-sphere", "05-sphere/write-sphere"),
        ("soft", "20-chance/soft"),
    ] {
        let output = lesson(&state).args(["answer", id, &path(at)]).output();
        let output = output.expect("runs");
        let text = String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{text}");
        for given in [".json:", "raytree-flat", "raytree-scene"] {
            assert!(!text.contains(given), "{id}: {text}");
        }
    }
}

/// Each chapter is read in a pipe: no escape sequence, every exercise is offered, and what is off is told.
#[test]
fn chapters_are_read_in_a_pipe() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("progress.json");
    let course = course();
    course.chapters.par_iter().for_each(|chapter| {
        let number = chapter.number.to_string();
        let output = lesson(&state)
            .args(["read", &number])
            .env("LANG", "C")
            .output()
            .expect("runs");
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        assert_eq!(output.status.code(), Some(0), "{number}");
        assert!(!text.contains('\x1b') && !text.contains("{{"), "{text}");
        for exercise in &chapter.exercises {
            assert!(
                text.contains(&format!("--- exercise {} ", exercise.id)),
                "{}",
                exercise.id
            );
        }
        assert!(text.contains("\non: rays"), "{text}");
    });
}
