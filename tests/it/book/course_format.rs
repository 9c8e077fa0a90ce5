//! The page of the course format: its blocks together are a course that passes its check, and it has all words of the format.

use std::path::Path;
use std::process::Command;

use super::page;

const PAGE: &str = "course-format.md";
const CHAPTER: &str = "01-light";

/// The blocks of a language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let start = format!("```{language}\n");
    text.split(start.as_str())
        .skip(1)
        .filter_map(|block| block.split("\n```").next())
        .collect()
}

/// The files of the course on the page.
fn files(text: &str) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut chapter = String::new();
    for block in blocks(text, "toml") {
        match block.lines().next().unwrap_or_default() {
            "format = \"raytree-course/1\"" => {
                files.push(("course.toml".to_owned(), block.to_owned()));
            }
            "format = \"raytree-task/1\"" => {
                files.push((format!("{CHAPTER}/task.toml"), block.to_owned()));
            }
            _ => {
                chapter.push_str(block);
                chapter.push_str("\n\n");
            }
        }
    }
    let one = |language| {
        let blocks = blocks(text, language);
        assert_eq!(blocks.len(), 1, "blocks of {language}");
        blocks[0].to_owned()
    };
    files.push((format!("{CHAPTER}/chapter.toml"), chapter));
    files.push((format!("{CHAPTER}/scene.json"), one("json")));
    files.push((format!("{CHAPTER}/text.md"), one("markdown")));
    files
}

/// What the check of the course says, and its exit status.
fn checked(folder: &Path) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    // This program is not optimised: the check of time is not for it.
    let output = command
        .args(["lesson", "check", "--json"])
        .arg(folder)
        .output()
        .expect("it runs");
    let text = [output.stdout, output.stderr].concat();
    (
        output.status.code(),
        String::from_utf8_lossy(&text).into_owned(),
    )
}

/// Puts the course of the page into a folder, with one text in the place of another.
fn written(folder: &Path, old: &str, new: &str) {
    std::fs::create_dir(folder.join(CHAPTER)).expect("a folder");
    let files = files(&page(PAGE));
    assert!(files.iter().any(|(_, text)| text.contains(old)), "{old}");
    for (name, text) in files {
        std::fs::write(folder.join(name), text.replacen(old, new, 1)).expect("written");
    }
}

/// The words that the program lists when one is not known: those behind `there are`.
fn known_words(old: &str, new: &str) -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    written(folder.path(), old, new);
    let (_, told) = checked(folder.path());
    let (_, list) = told
        .split_once("there are ")
        .unwrap_or_else(|| panic!("no list in: {told}"));
    let list = list.split(['\n', '"', '(']).next().unwrap_or_default();
    let words = list
        .split(", ")
        .map(|word| word.trim().trim_end_matches('.').to_owned());
    words.collect()
}

#[test]
fn the_page_has_all_words_of_the_format() {
    let text = page(PAGE);
    let features = known_words("enables = [\"rays\"", "enables = [\"zzzzzzzz\"");
    assert!(features.len() > 20, "{features:?}");
    for feature in features {
        assert!(text.contains(&format!("`{feature}`")), "{feature}");
    }
    let kinds = known_words("kind = \"predict\"", "kind = \"zzzzzzzz\"");
    assert!(kinds.len() > 6, "{kinds:?}");
    for kind in kinds {
        let example = text.contains(&format!("\nkind = \"{kind}\"\n"));
        assert!(
            example && text.contains(&format!("\n### {kind}\n")),
            "{kind}"
        );
    }
    let values = known_words("{{tree 190,90}}", "{{zzzzzzzz}}");
    assert!(values.len() > 5, "{values:?}");
    for value in values.iter().filter_map(|value| value.split(' ').next()) {
        assert!(text.contains(&format!("`{value}")), "{value}");
    }
}

#[test]
fn the_course_on_the_page_passes_its_check() {
    let folder = tempfile::tempdir().expect("a folder");
    written(folder.path(), "Light", "Light");
    let (status, told) = checked(folder.path());
    let findings: serde_json::Value =
        serde_json::from_str(&told).unwrap_or_else(|_| panic!("{status:?}: {told}"));
    let findings = findings["findings"].as_array().expect("a list");
    let wrong: Vec<_> = findings
        .iter()
        .filter(|finding| finding["check"] != "time")
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_text_on_the_page_has_each_directive() {
    let example = blocks(&page(PAGE), "markdown").concat();
    let directives = [
        "trace", "count", "rays", "tree", "steps", "diff", "equation", "picture", "console",
        "exercise", "file",
    ];
    for directive in directives {
        assert!(example.contains(&format!("{{{{{directive}")), "{directive}");
    }
}
