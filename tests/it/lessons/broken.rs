//! Each of the twelve checks, broken on purpose once: it is seen, and told with its file.

use raytree::lesson::Course;
use raytree::lesson::check::{CheckName, check};
use raytree::lesson::files::CourseError;

use super::{findings, small};

/// The small course with a text exchanged in one of its files.
fn with(file: &str, from: &str, to: &str) -> Result<Course, CourseError> {
    let files = small(|name, text| {
        if name != file {
            return text;
        }
        assert!(text.contains(from), "{name} has no {from}");
        text.replacen(from, to, 1)
    });
    Course::of(files)
}

/// What the check finds in it: one thing of this check at least, with these words.
#[track_caller]
fn is_found(file: &str, from: &str, to: &str, check: CheckName, words: &str) {
    let course = with(file, from, to).expect("a course that can be read");
    let found = findings(&course);
    let told: Vec<String> = found.iter().map(ToString::to_string).collect();
    let is_it = found
        .iter()
        .any(|f| f.check == check && f.what.contains(words));
    assert!(is_it, "{to}: {told:?}");
    assert!(
        found.iter().all(|f| f.file.starts_with("01-first/")),
        "{told:?}"
    );
}

/// A course that cannot be read, and what is said of it.
#[track_caller]
fn is_refused(file: &str, from: &str, to: &str, words: &[&str]) {
    let error = with(file, from, to).expect_err(to).to_string();
    assert!(
        words.iter().all(|word| error.contains(word)),
        "{to}: {error}"
    );
    assert!(!error.contains('\n'), "{error}");
}

const CHAPTER: &str = "01-first/chapter.toml";
const TEXT: &str = "01-first/text.md";

#[test]
fn check_1_files() {
    is_refused(
        "course.toml",
        "raytree-course/1",
        "raytree-course/2",
        &["course.toml", "raytree-course/1"],
    );
    is_refused(
        "course.toml",
        "01-first",
        "02-none",
        &["02-none/chapter.toml", "no such file"],
    );
    is_refused(
        "course.toml",
        "01-first",
        "../01-first",
        &["leads out of the course"],
    );
    is_refused("course.toml", ">=0.1", ">=99.0", &["needs raytree"]);
    is_refused(
        "course.toml",
        "title",
        "titel",
        &["line 3", "`titel`", "did you mean `title`"],
    );
    is_refused(CHAPTER, "in-shadow", "ball-t", &["`ball-t` is there twice"]);
    is_refused(
        CHAPTER,
        "\"shadows\"",
        "\"shadow\"",
        &["no feature `shadow`", "did you mean `shadows`"],
    );
    is_refused(
        CHAPTER,
        "kind = \"find\"",
        "kind = \"fint\"",
        &["`in-shadow`", "`fint`", "predict"],
    );
    is_refused(
        CHAPTER,
        "scene.json",
        "../../scene.json",
        &["leads out of the course"],
    );
    is_refused(
        CHAPTER,
        "scene.json",
        "/etc/passwd.json",
        &["leads out of the course"],
    );
    is_refused(CHAPTER, "hits:floor and", "hits:floor und", &["`where`"]);
    is_found(
        CHAPTER,
        "scene = \"scene.json\"",
        "scene = \"none.json\"",
        CheckName::Files,
        "no such file",
    );
    is_found(
        CHAPTER,
        "scene = \"scene.json\"",
        "scene = \"scene.json\"\nsettings = { size = \"2000x2000\" }",
        CheckName::Files,
        "too large",
    );
}

#[test]
fn check_2_directives() {
    for (to, words) in [
        ("{{trace 160,120.u}}", "no field `u`"),
        ("{{trace 160,120/R.t}}", "no step R"),
        ("{{trace 1000,120.t}}", "not in the picture"),
        ("{{count hits:flor}}", "flor"),
        ("{{counts hit}}", "is no value"),
        ("{{trace 160,120.t", "does not end"),
        ("a {{picture}}", "on a line of its own"),
        ("<b>a</b>", "not in the Markdown"),
        ("![a](b.png)", "not in the Markdown"),
        ("At 4.0131", "by hand"),
        ("{{exercise none}}", "there is no exercise `none`"),
        (
            "{{exercise ball-t}}\n\n{{exercise ball-t}}",
            "offered 3 times",
        ),
        ("{{console rm -rf x}}", "not `rm -rf x`"),
        ("{{file ../../secret}}", "leads out of the course"),
        ("{{picture show=nothing}}", "nothing that is shown"),
        ("{{picture bend=none}}", "is no bend"),
    ] {
        is_found(
            TEXT,
            "    P = o + t d\n",
            &format!("{to}\n"),
            CheckName::Directives,
            words,
        );
    }
}

#[test]
fn checks_3_to_5_predict_find_and_change() {
    let predict = |to: &str, words: &str| {
        is_found(CHAPTER, "at = \"160,120.t\"", to, CheckName::Predict, words);
    };
    predict("at = \"160,10.t\"", "no field");
    predict(
        "at = \"160,120.n_dot_v\"\ntolerance = 0.1",
        "whoever says 0 or 1",
    );
    predict(
        "at = \"160,120.direction.x\"\ntolerance = 0.01",
        "whoever says 0 or 1",
    );
    let find = |to: &str, words: &str| {
        let from = "where = \"hits:floor and blocked:lamp\"";
        is_found(CHAPTER, from, to, CheckName::Find, words);
    };
    find("where = \"t > 1e9\"", "no pixel");
    find("where = \"not hits:ball\"", "more than half");
    let change = |from: &str, to: &str, words: &str| {
        is_found(CHAPTER, from, to, CheckName::Change, words);
    };
    change(
        "count = [0, 0]",
        "count = [0, 99999]",
        "fulfils all goals already",
    );
    change(
        "position=[0,1,5]",
        "position=[0,20,5]",
        "its solution fails",
    );
    change(
        "\"objects\", \"materials\"]",
        "\"objects\", \"lights\"]",
        "`lights` has changed",
    );
    change(
        "light.lamp.position=[0,1,5]",
        "light.lamb.position=[0,1,5]",
        "lamp",
    );
}

/// A bug, a slide, a task.
#[test]
fn checks_6_to_8_bug_choose_and_write() {
    let add = |exercise: &str, check: CheckName, words: &str| {
        let files = small(|name, text| match name {
            "01-first/chapter.toml" => format!(
                "{text}\n[[exercise]]\nid = \"new\"\nhints = [\"a\", \"b\", \"c\"]\n{exercise}\n"
            ),
            "01-first/text.md" => text + "\n{{exercise new}}\n",
            _ => text,
        });
        let found = findings(&Course::of(files).expect("a course"));
        let told: Vec<String> = found.iter().map(ToString::to_string).collect();
        if words.is_empty() {
            assert!(found.is_empty(), "{exercise}: {told:?}");
        } else {
            let is_it = found
                .iter()
                .any(|f| f.check == check && f.what.contains(words));
            assert!(is_it, "{exercise}: {told:?}");
        }
    };
    let bug = |bend: &str, among: &str, at: &str, words: &str| {
        let text = format!("kind = \"bug\"\nbend = \"{bend}\"\namong = [{among}]\nat = \"{at}\"");
        add(&text, CheckName::Bug, words);
    };
    bug("far-root", "\"far-root\", \"shadow-none\"", "160,120", "");
    bug(
        "far-root",
        "\"far-root\", \"shadow-none\"",
        "10,230",
        "is as ours",
    );
    bug(
        "shadow-none",
        "\"shadow-none\", \"shadow-inverted\"",
        "10,10",
        "is as ours",
    );
    bug(
        "l-not-unit",
        "\"l-not-unit\", \"attenuation-none\"",
        "160,120",
        "",
    );
    let choose = |options: &str, words: &str| {
        add(
            &format!("kind = \"choose\"\noptions = [{options}]"),
            CheckName::Choose,
            words,
        );
    };
    let (right, wrong) = (
        "{ text = \"a\", right = true }",
        "{ text = \"b\", say = \"no\" }",
    );
    choose(&format!("{right}, {wrong}"), "");
    choose(&format!("{wrong}, {wrong}"), "0 options are right");
    choose(&format!("{right}, {right}"), "2 options are right");
    choose(
        &format!("{right}, {{ text = \"c\" }}"),
        "does not `say` why",
    );
    let when = "{ text = \"a\", when = \"count hits:ball < count hits:floor\" }, { text = \"b\", say = \"no\", when = \"count hits:ball > count hits:floor\" }";
    choose(when, "");
    let slide = format!(
        "kind = \"slide\"\nsays = \"x\"\nbend = \"tir-black\"\noptions = [{right}, {wrong}]"
    );
    add(&slide, CheckName::Choose, "changes no pixel");
    add(
        "kind = \"write\"\ntask = \"task.toml\"",
        CheckName::Write,
        "no such file",
    );
}

#[test]
fn checks_9_to_11_hints_growth_and_features() {
    is_found(
        CHAPTER,
        "\"Draw the ray and the ball from the side.\", ",
        "",
        CheckName::Hints,
        "2 hints",
    );
    is_found(
        CHAPTER,
        "The distance to the middle, less the radius.",
        "It is 4.00.",
        CheckName::Hints,
        "tells the answer",
    );
    let enabled = |to: &str, words: &str| {
        is_found(
            CHAPTER,
            "scene = \"scene.json\"",
            &format!("scene = \"scene.json\"\nsettings = {to}"),
            CheckName::Enabled,
            words,
        );
    };
    enabled("{ samples = 4 }", "`samples`");
    enabled("{ depth = 4 }", "`tree`");
    enabled("{ fresnel = \"exact\" }", "`fresnel`");
    // A second chapter without the ball of the first.
    let grown = |restart: &str| {
        let files = small(|_, text| text);
        let mut all: Vec<(String, String)> = files
            .names()
            .map(|name| {
                (
                    name.to_owned(),
                    files.text(name).expect("a text").to_owned(),
                )
            })
            .collect();
        for (name, text) in &mut all {
            if name == "course.toml" {
                *text = text.replace("[\"01-first\"]", "[\"01-first\", \"02-next\"]");
            }
        }
        let scene = files.text("01-first/scene.json").expect("a scene");
        all.push((
            "02-next/scene.json".to_owned(),
            scene.replace("\"ball\"", "\"bowl\""),
        ));
        all.push(("02-next/text.md".to_owned(), "# Next\n".to_owned()));
        let chapter = format!(
            "format = \"raytree-chapter/1\"\ntitle = \"Next\"\nscene = \"scene.json\"\n{restart}\n"
        );
        all.push(("02-next/chapter.toml".to_owned(), chapter));
        let course = Course::of(raytree::lesson::files::CourseFiles::of("two", all));
        findings(&course.expect("a course"))
    };
    let lost = grown("");
    assert!(
        lost.len() == 1 && lost[0].check == CheckName::Grows,
        "{lost:?}"
    );
    assert!(lost[0].what.contains("`ball`"), "{lost:?}");
    assert_eq!(grown("restart = true"), []);
}

#[test]
fn check_12_time() {
    let course = Course::of(small(|_, text| text)).expect("a course");
    let found = check(&course, 0.0, &mut |_| ());
    let [one] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!((one.check, one.file.as_str()), (CheckName::Time, CHAPTER));
    assert!(one.what.contains("smaller pictures"), "{one}");
}
