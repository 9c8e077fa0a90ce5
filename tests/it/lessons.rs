//! `raytree lesson`: the course holds, its exercises can be done in a pipe, nothing of a student's work is lost, and a course
//! of a stranger harms nobody.

mod answers;
mod broken;
mod numbers;
mod packs;
mod progress;
mod watch;

use std::path::PathBuf;

use raytree::lesson::check::{CourseFinding, check};
use raytree::lesson::files::CourseFiles;
use raytree::lesson::template::template;
use raytree::lesson::{Course, book};

/// The course that the program brings along.
pub fn course() -> Course {
    Course::embedded().expect("the course")
}

/// What the check of a course finds. It may take its time: this program is not optimised.
pub fn findings(course: &Course) -> Vec<CourseFinding> {
    check(course, f64::INFINITY, &mut |_| ())
}

/// The small course that `lesson new` makes, as files that a test can change.
pub fn small(change: impl Fn(&str, String) -> String) -> CourseFiles {
    let files = template().map(|(name, text)| (name.to_owned(), change(name, text.to_owned())));
    CourseFiles::of("small", files)
}

#[test]
fn the_course_passes_its_check() {
    let course = course();
    let told: Vec<String> = findings(&course).iter().map(ToString::to_string).collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
    assert_eq!(course.chapters.len(), 24);
    assert!(course.exercises().filter(|(_, e)| !e.optional).count() >= 120);
}

#[test]
fn a_new_course_passes_its_check() {
    let course = Course::of(small(|_, text| text)).expect("a course");
    assert_eq!(findings(&course), []);
}

/// The packs beside the course pass as well.
#[test]
fn the_packs_pass_their_check() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("lessons/packs");
    let packs = std::fs::read_dir(folder).expect("packs");
    let mut count = 0;
    for pack in packs {
        let path = pack.expect("an entry").path();
        let course = Course::read(&path).expect("a pack");
        let told: Vec<String> = findings(&course).iter().map(ToString::to_string).collect();
        assert!(told.is_empty(), "{}: {}", path.display(), told.join("\n"));
        count += 1;
    }
    assert!(count >= 2, "{count}");
}

/// The pages in the book are those that are made of the course. `RAYTREE_BOOK=1` writes them.
#[test]
fn the_pages_of_the_book_are_those_of_the_course() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("book/src/lessons");
    let texts = book::texts(&course()).expect("pages");
    let mut wrong = Vec::new();
    for (name, text) in texts {
        let path = folder.join(&name);
        if std::env::var_os("RAYTREE_BOOK").is_some() {
            std::fs::create_dir_all(&folder).expect("a folder");
            std::fs::write(&path, &text).expect("room");
        }
        if std::fs::read_to_string(&path).ok() != Some(text) {
            wrong.push(name);
        }
    }
    assert!(
        wrong.is_empty(),
        "raytree lesson book book/src/lessons writes anew: {}",
        wrong.join(", ")
    );
}
