//! Every link of the book and of the README leads to a file, and to a heading in it; every page is in the summary.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use super::{page, source};

/// The id that mdBook gives a heading.
pub fn id(heading: &str) -> String {
    let letters = heading.trim().chars().filter_map(|c| match c {
        c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_ascii_lowercase()),
        c if c.is_whitespace() => Some('-'),
        _ => None,
    });
    letters.collect()
}

/// What a page links to, and the ids of its headings.
#[derive(Default)]
struct Parsed {
    links: Vec<String>,
    ids: BTreeSet<String>,
    /// What is HTML, by intention or because a `<` was forgotten.
    html: Vec<String>,
}

fn parsed(text: &str) -> Parsed {
    let mut parsed = Parsed::default();
    let mut heading: Option<String> = None;
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => {
                let title = id(&heading.take().unwrap_or_default());
                let count = |n: usize| {
                    if n == 0 {
                        title.clone()
                    } else {
                        format!("{title}-{n}")
                    }
                };
                let free = (0..1000).map(count).find(|id| !parsed.ids.contains(id));
                parsed.ids.extend(free);
            }
            Event::Text(part) | Event::Code(part) => {
                if let Some(title) = &mut heading {
                    *title += &part;
                }
            }
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                parsed.links.push(dest_url.to_string());
            }
            Event::Html(html) | Event::InlineHtml(html) => parsed.html.push(html.trim().to_owned()),
            _ => {}
        }
    }
    parsed
}

/// All Markdown files of a folder and below.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(pages(&path));
        } else if path.extension().is_some_and(|e| e == "md") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// True for what `raytree lesson book` writes and the repository need not have: it is checked by its name.
fn is_made(path: &Path) -> bool {
    let lessons = source().join("lessons");
    let Ok(name) = path.strip_prefix(&lessons) else {
        return false;
    };
    name.starts_with("pictures")
        || !lessons.exists()
            && lesson_pages()
                .iter()
                .any(|(page, _)| Path::new(page) == name)
}

/// The pages of the course, each with its title.
fn lesson_pages() -> Vec<(String, String)> {
    let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let read = |path: &str| -> toml::Table {
        let text = std::fs::read_to_string(lessons.join(path)).expect("a file of the course");
        text.parse().expect("TOML")
    };
    let course = read("course.toml");
    let folders = course["chapters"].as_array().expect("chapters").iter();
    let chapters = folders.map(|folder| {
        let folder = folder.as_str().expect("a name");
        let chapter = read(&format!("{folder}/chapter.toml"));
        (
            format!("{folder}.md"),
            chapter["title"].as_str().expect("a title").to_owned(),
        )
    });
    std::iter::once(("README.md".to_owned(), "The course".to_owned()))
        .chain(chapters)
        .collect()
}

/// True for a link of a page to what is not among the pages: it would lead nowhere in what mdBook builds.
fn leaves_the_book(path: &Path, file: &str) -> bool {
    let folders = path
        .strip_prefix(source())
        .map(|name| name.components().count() - 1);
    folders.is_ok_and(|folders| file.split('/').take_while(|part| *part == "..").count() > folders)
}

/// What is wrong with the links of a text at a path.
fn broken(path: &Path, text: &str) -> Vec<String> {
    let here = parsed(text);
    let wrong = |link: &String| {
        if link.contains("://") {
            return None;
        }
        let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
        let target = if file.is_empty() {
            path.to_owned()
        } else {
            path.parent()?.join(file)
        };
        if is_made(&target) {
            return None;
        }
        if leaves_the_book(path, file) {
            return Some(format!("{}: {link}: it leaves the book", path.display()));
        }
        if !target.exists() {
            return Some(format!("{}: {link}: there is no such file", path.display()));
        }
        if anchor.is_empty() {
            return None;
        }
        let known = if file.is_empty() {
            here.ids.contains(anchor)
        } else {
            parsed(&std::fs::read_to_string(&target).ok()?)
                .ids
                .contains(anchor)
        };
        (!known).then(|| format!("{}: {link}: there is no such heading", path.display()))
    };
    here.links.iter().filter_map(wrong).collect()
}

#[test]
fn every_link_leads_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = pages(&source());
    files.extend(["README.md", "ARCHITECTURE.md", "CHANGELOG.md"].map(|name| root.join(name)));
    files.extend(
        pages(&root.join("lessons"))
            .into_iter()
            .filter(|path| path.ends_with("README.md")),
    );
    let mut links = 0;
    let mut wrong = Vec::new();
    for path in files {
        let text = std::fs::read_to_string(&path).expect("UTF-8");
        links += parsed(&text).links.len();
        wrong.extend(broken(&path, &text));
    }
    assert!(links > 60, "{links} links");
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn a_broken_link_is_found() {
    let path = source().join("find.md");
    let all = "[a](limits.md) [b](limits.md#limits) [c](#here) [d](https://x.org/y)\n\n# Here\n";
    assert_eq!(broken(&path, all), [] as [String; 0]);
    let wrong = "[a](nowhere.md) [b](limits.md#nothing) ![c](pictures/nothing.png) [d](#there) [e](lessons/99-none.md) [f](../book.toml)\n\n# Here\n\n`[g](no.md)`\n";
    assert_eq!(broken(&path, wrong).len(), 6);
    assert_eq!(
        id("`no-light`, and *what* to do"),
        "no-light-and-what-to-do"
    );
}

#[test]
fn no_page_has_html_by_mistake() {
    const MEANT: [&str; 4] = ["<!--", "<details", "</details", "<summary"];
    for path in pages(&source()) {
        let text = std::fs::read_to_string(&path).expect("UTF-8");
        for html in parsed(&text).html.iter().filter(|html| !html.is_empty()) {
            assert!(
                MEANT.iter().any(|tag| html.starts_with(tag)),
                "{}: {html}",
                path.display()
            );
        }
    }
    assert_eq!(parsed("A list<u8> of `Vec<u8>`").html, ["<u8>"]);
}

#[test]
fn every_page_is_in_the_summary() {
    let links = parsed(&page("SUMMARY.md")).links;
    for link in &links {
        assert_eq!(
            links.iter().filter(|other| *other == link).count(),
            1,
            "{link} is there twice"
        );
    }
    for path in pages(&source()) {
        let name = path
            .strip_prefix(source())
            .expect("below it")
            .to_string_lossy()
            .replace('\\', "/");
        let listed = links.contains(&name) || name == "SUMMARY.md" || name.starts_with("tables/");
        assert!(listed, "{name} is not in the summary");
    }
}

#[test]
fn the_summary_has_the_chapters_of_the_course_in_order() {
    let summary = page("SUMMARY.md");
    let expected: Vec<String> = lesson_pages()
        .iter()
        .map(|(page, title)| format!("[{title}](lessons/{page})"))
        .collect();
    let lines = summary.lines().filter(|line| line.contains("(lessons/"));
    let listed: Vec<&str> = lines
        .map(|line| line.trim_start_matches([' ', '-']))
        .collect();
    assert_eq!(listed, expected);
}

#[test]
fn every_table_stands_on_a_page() {
    let all: Vec<String> = pages(&source())
        .iter()
        .map(|path| std::fs::read_to_string(path).expect("UTF-8"))
        .collect();
    let included = |text: &String| {
        let names = text
            .split("{{#include ")
            .skip(1)
            .filter_map(|rest| rest.split("}}").next().map(str::to_owned));
        names.collect::<Vec<_>>()
    };
    let included: Vec<String> = all.iter().flat_map(included).collect();
    for name in &included {
        assert!(source().join(name).exists(), "{name} is not there");
    }
    for entry in std::fs::read_dir(source().join("tables")).expect("the tables") {
        let name = format!(
            "tables/{}",
            entry.expect("an entry").file_name().to_string_lossy()
        );
        assert!(included.contains(&name), "{name} is on no page");
    }
}
