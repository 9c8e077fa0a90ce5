//! Pages of a course for mdBook: a Markdown file a chapter, with numbers and pictures of today's tracer.

use std::fmt::Write as _;

use super::answer::letter;
use super::chapter::Chapter;
use super::course::Course;
use super::exercise::{Exercise, ExerciseKind};
use super::files::CourseError;
use super::page::{PagePart, page};
use super::picture::picture;
use super::reader::features;
use super::solution::solution;
use crate::tracer::image::png;

/// The size of pictures at most.
const PICTURE: (u32, u32) = (320, 240);

/// The files of all pages by their names: `09-shadows.md`, and the pictures in a folder.
pub fn pages(course: &Course) -> Result<Vec<(String, Vec<u8>)>, CourseError> {
    let mut files = Vec::new();
    for chapter in &course.chapters {
        let mut pictures = Vec::new();
        let text = chapter_page(course, chapter, &mut pictures)?;
        files.push((format!("{}.md", chapter.folder), text.into_bytes()));
        files.extend(pictures);
    }
    files.push(("README.md".to_owned(), contents(course).into_bytes()));
    Ok(files)
}

/// The pages without their pictures, for a comparison with what is in the repository.
pub fn texts(course: &Course) -> Result<Vec<(String, String)>, CourseError> {
    let text = |chapter: &Chapter| {
        let name = format!("{}.md", chapter.folder);
        chapter_text(course, chapter).map(|(text, _)| (name, text))
    };
    let mut all: Vec<_> = course.chapters.iter().map(text).collect::<Result<_, _>>()?;
    all.push(("README.md".to_owned(), contents(course)));
    Ok(all)
}

/// A page; its pictures are added to those.
fn chapter_page(
    course: &Course,
    chapter: &Chapter,
    pictures: &mut Vec<(String, Vec<u8>)>,
) -> Result<String, CourseError> {
    let (text, asked) = chapter_text(course, chapter)?;
    for (name, asked) in asked {
        let film = picture(course, chapter, &asked, PICTURE)?;
        let bytes = png::encode(&film, 1.0);
        let bytes = bytes.map_err(|e| CourseError::new(&name, e.to_string()))?;
        pictures.push((name, bytes));
    }
    Ok(text)
}

/// Pictures by the names of their files.
type NamedPictures = Vec<(String, super::page::PagePicture)>;

/// The text of a page, and the pictures that it shows.
fn chapter_text(
    course: &Course,
    chapter: &Chapter,
) -> Result<(String, NamedPictures), CourseError> {
    let mut out = String::from(
        "<!-- Made by `raytree lesson book book/src/lessons` of the texts in `lessons/`. Change those. -->\n\n",
    );
    let mut pictures = NamedPictures::new();
    let mut answers = String::new();
    for part in page(course, chapter)? {
        match part {
            PagePart::Text(text) => out += &text,
            PagePart::Block(title, text) => {
                let _ = write!(out, "```text\n{title}\n\n{text}```\n\n");
            }
            PagePart::Picture(asked) => {
                let name = format!("pictures/{}-{}.png", chapter.folder, pictures.len() + 1);
                let caption = asked.caption();
                let _ = write!(out, "![{caption}]({name})  \n*{caption}*\n\n");
                pictures.push((name, asked));
            }
            PagePart::Exercise(id) => {
                if let Some(exercise) = chapter.exercise(&id) {
                    out += &offered(exercise);
                    answers += &answer(course, chapter, exercise)?;
                }
            }
        }
    }
    let _ = write!(
        out,
        "\n---\n\n{}\n\n<details><summary>Answers</summary>\n\n{answers}\n</details>\n",
        features(course, chapter).trim().replace('\n', "  \n")
    );
    Ok((out, pictures))
}

/// An exercise on a page.
fn offered(exercise: &Exercise) -> String {
    let kind = exercise.kind.name();
    let mut out = format!("> **Exercise `{}`** ({kind})\n>\n", exercise.id);
    let mut quote = |text: &str| {
        for line in text.lines() {
            let _ = writeln!(out, "> {line}");
        }
        out.push_str(">\n");
    };
    quote(&exercise.text);
    match &exercise.kind {
        ExerciseKind::Find(wanted) if !wanted.text.is_empty() => {
            quote(&format!("Find a pixel for which holds: `{}`", wanted.text));
        }
        ExerciseKind::Change(task) => {
            let goals: Vec<String> = task
                .goals
                .iter()
                .map(|goal| format!("- {}", goal.words()))
                .collect();
            quote(&goals.join("\n"));
        }
        ExerciseKind::Bug { among, at, .. } => {
            let names: Vec<String> = among.iter().map(|b| format!("`{}`", b.name())).collect();
            quote(&format!(
                "Look at pixel {},{}. It is one of {}.",
                at.0,
                at.1,
                names.join(", ")
            ));
        }
        ExerciseKind::Choose { says, options, .. } => {
            if !says.is_empty() {
                quote(&format!("A slide says: {says}"));
            }
            let list: Vec<String> = options
                .iter()
                .enumerate()
                .map(|(i, option)| format!("- {}) {}", letter(i), option.text))
                .collect();
            quote(&list.join("\n"));
        }
        _ => {}
    }
    quote(&format!("`raytree lesson run {}`", exercise.id));
    out.truncate(out.trim_end_matches(">\n").len());
    out + "\n"
}

/// The answer of an exercise, in a line of a list.
fn answer(course: &Course, chapter: &Chapter, exercise: &Exercise) -> Result<String, CourseError> {
    if matches!(exercise.kind, ExerciseKind::Write { .. }) {
        return Ok(String::new());
    }
    let lines = solution(course, chapter, exercise, 0);
    let file = format!("{}/chapter.toml", chapter.folder);
    let lines =
        lines.map_err(|what| CourseError::new(&file, format!("{}: {what}", exercise.id)))?;
    let mut lines = lines.into_iter();
    let first = lines.next().unwrap_or_default();
    let rest: Vec<String> = lines.collect();
    Ok(format!(
        "- `{}`: `{first}` {}\n",
        exercise.id,
        rest.join("; ")
    ))
}

/// The list of chapters.
fn contents(course: &Course) -> String {
    let mut out = format!(
        "# {}\n\n`raytree lesson` opens these chapters in the terminal, where pictures and numbers move and exercises are \
         answered. Here they can be read.\n\n",
        course.title
    );
    for chapter in &course.chapters {
        let (number, title, folder) = (chapter.number, &chapter.title, &chapter.folder);
        let _ = writeln!(out, "{number}. [{title}]({folder}.md)");
    }
    out
}
