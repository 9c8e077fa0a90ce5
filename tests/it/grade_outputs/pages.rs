//! The pages for a browser: whole by themselves, with no script, no link out, and nothing of a student's that is markup.

use std::fs;

use super::class::{Class, Mistake};

/// The tags of a page, without their ends.
fn tags(text: &str) -> Vec<&str> {
    let starts = text.split('<').skip(1);
    let tags = starts.filter_map(|rest| rest.split('>').next());
    tags.filter(|tag| !tag.starts_with('/')).collect()
}

/// The page is closed, has no tag but those we write, and asks for nothing.
fn check(text: &str) {
    const KNOWN: [&str; 21] = [
        "!DOCTYPE", "html", "head", "meta", "title", "style", "body", "h1", "h2", "h3", "p", "a",
        "table", "tr", "th", "td", "ul", "li", "section", "code", "b",
    ];
    for tag in tags(text) {
        let name = tag.split([' ', '\n']).next().unwrap_or_default();
        assert!(KNOWN.contains(&name), "<{tag}>");
        assert!(!tag.contains(" on") && !tag.contains("src="), "<{tag}>");
        if let Some(link) = tag.strip_prefix("a href=\"") {
            let inside = link.starts_with("#s") || link.ends_with(".html\"");
            assert!(
                inside && !link.contains(':') && !link.contains('/'),
                "<{tag}>"
            );
        }
    }
    for name in &KNOWN[1..] {
        let of = |open: &str| text.matches(open).count();
        let open = of(&format!("<{name}>")) + of(&format!("<{name} "));
        let closed = of(&format!("</{name}>"));
        assert!(
            *name == "meta" || open == closed,
            "{name}: {open}, {closed}"
        );
    }
    assert!(!text.contains("@import") && !text.contains("url("));
    assert!(text.contains("default-src 'none'"));
    assert!(text.chars().all(|c| c == '\n' || !c.is_control()));
}

#[test]
fn a_folder_of_pages_shows_the_class_and_each_submission() {
    let class = Class::new();
    let folder = class.path("in/<script>alert(1)<!-- & \"\u{1b}[2J");
    fs::create_dir(&folder).expect("a folder");
    let trees = super::class::trees(Mistake::Bend("cos-missing"));
    fs::write(folder.join("hits.ndjson"), trees).expect("written");
    for number in 1..=5 {
        class.hand_in(&format!("u{number}"), Mistake::Scaled(1.37));
    }
    let names = class.submissions();
    let mut words = vec!["task.toml"];
    words.extend(names.iter().map(String::as_str));
    words.extend(["--output", "html=pages", "--output", "html=one.html"]);
    let (status, _, told) = class.run_with(&words, &[]);
    assert_eq!(status, 0, "{told}");
    let read = |name: &str| fs::read_to_string(class.path(name)).expect(name);
    let index = read("pages/index.html");
    check(&index);
    for what in [
        "The class",
        "cos-missing</td><td class=\"n\">2",
        "lowest",
        "1.4e0 times ours",
    ] {
        assert!(index.contains(what), "{what}: {index}");
    }
    assert!(index.contains("u1, u2, u3, u4, u5"));
    assert_eq!(
        tags(&index).iter().filter(|t| t.starts_with("a ")).count(),
        names.len()
    );
    for number in 1..=names.len() {
        check(&read(&format!("pages/{number:04}.html")));
    }
    let bo = names
        .iter()
        .position(|n| n == "in/bo.ndjson")
        .expect("there")
        + 1;
    let bo = read(&format!("pages/{bo:04}.html"));
    for what in [
        "wrong: law diffuse",
        "radiance = ",
        "terms.diffuse:sun",
        "n_dot_l",
        "raytree view",
    ] {
        assert!(bo.contains(what), "{what}: {bo}");
    }
    let one = read("one.html");
    check(&one);
    assert_eq!(one.matches("<section ").count(), names.len());
    // A right one has nothing to show.
    let ada = names
        .iter()
        .position(|n| n == "in/ada.ndjson")
        .expect("there")
        + 1;
    assert!(!read(&format!("pages/{ada:04}.html")).contains("Where it breaks"));
}

#[test]
fn pages_for_students_have_no_view_of_the_class() {
    let class = Class::new();
    let words = [
        "task.toml",
        "in/ada.ndjson",
        "in/bo.ndjson",
        "--student",
        "--output",
        "html=pages",
    ];
    let (status, _, told) = class.run_with(&words, &[]);
    assert_eq!(status, 0, "{told}");
    let index = fs::read_to_string(class.path("pages/index.html")).expect("written");
    check(&index);
    assert!(!index.contains("The class"));
}
