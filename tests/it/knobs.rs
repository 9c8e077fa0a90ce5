//! The table of knobs: each can be set by its flag and in scene files, and is told in ray trees; the book lists all.

use std::fmt::Write as _;
use std::process::Command;

use raytree::scene::Settings;
use raytree::scene::settings::knob::{Kind, Knob, Value};
use raytree::scene::settings::knobs::{knob, knobs};

const BOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/settings.md");

/// The settings of a ray tree of a pixel.
fn told(scene: &str, flags: &[String]) -> serde_json::Value {
    let output = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["trace", scene, "--pixel", "1,1"])
        .args(flags)
        .output()
        .expect("it runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{flags:?}: {errors}");
    let tree: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    tree["settings"].clone()
}

fn at<'a>(settings: &'a serde_json::Value, path: &str) -> &'a serde_json::Value {
    path.split('.').fold(settings, |value, key| &value[key])
}

/// A value that is not the default.
fn another(knob: &Knob) -> Value {
    let default = (knob.field.get)(&Settings::default());
    let text = match knob.kind {
        Kind::Size => "9x7",
        // A ray for each pixel, and some more.
        Kind::Whole(_) if knob.flag == "max-rays" => "77",
        Kind::Count { .. } | Kind::Whole(_) => "7",
        Kind::Real { .. } => "0.25",
        Kind::Text(_) if knob.flag == "bend" => "shadow-none",
        Kind::Text(_) if knob.flag == "patch-test" => "triangles:2",
        Kind::Text(_) => "none",
        Kind::Choices(words) => return Value::List(vec![words()[0].name.to_owned()]),
        Kind::Choice(words) => {
            let mut words = words().into_iter().rev().map(|word| word.name);
            let other = words.find(|name| !default.as_ref().is_some_and(|d| d.is(name)));
            other.expect("two words at least")
        }
    };
    knob.kind.parse(text).expect("a value of its kind")
}

/// Flags without which a knob cannot be set.
fn with(knob: &Knob) -> Vec<String> {
    let more: &[&str] = match (knob.flag, knob.requires) {
        ("sets", _) => &["--samples", "8", "--sampling", "random"],
        (_, Some("adaptive")) => &["--adaptive", "0.1"],
        _ => &[],
    };
    more.iter().map(|word| (*word).to_owned()).collect()
}

#[test]
fn what_a_flag_sets_is_told_in_the_tree() {
    for knob in knobs().filter(|knob| !knob.json.is_empty()) {
        let value = another(knob);
        let mut flags = with(knob);
        flags.extend([format!("--{}", knob.flag), value.to_string()]);
        if knob.flag != "size" {
            flags.extend(["--size".to_owned(), "8x6".to_owned()]);
        }
        let expected = serde_json::to_value(&value).expect("plain data");
        assert_eq!(
            at(&told("whitted", &flags), knob.json),
            &expected,
            "{flags:?}"
        );
    }
}

#[test]
fn what_a_scene_file_sets_is_told_in_the_tree() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.json");
    let in_files = || knobs().filter(|knob| knob.in_files && !knob.json.is_empty());
    let values = in_files().map(|knob| (knob.key(), another(knob)));
    let scene = serde_json::json!({
        "format": "raytree-scene/1", "camera": {"eye": [0, 1, 5], "look_at": [0, 1, 0]},
        "settings": values.collect::<std::collections::BTreeMap<_, _>>(),
    });
    std::fs::write(&path, scene.to_string()).expect("room on the disk");
    let settings = told(path.to_str().expect("a plain path"), &[]);
    for knob in in_files() {
        let expected = serde_json::to_value(another(knob)).expect("plain data");
        assert_eq!(at(&settings, knob.json), &expected, "{}", knob.flag);
    }
}

#[test]
fn rows_are_whole() {
    for row in knobs() {
        let Knob {
            flag,
            doc,
            requires,
            conflicts_with,
            ..
        } = row;
        assert!(
            !flag.is_empty() && !doc.is_empty() && !doc.contains("  "),
            "{flag}"
        );
        assert_eq!(
            knobs().filter(|other| other.flag == *flag).count(),
            1,
            "{flag}"
        );
        let others = requires.iter().chain(conflicts_with);
        assert!(
            others.into_iter().all(|other| knob(other).is_some()),
            "{flag}"
        );
        assert!(
            row.steps().len() >= row.steps.len(),
            "{flag}: a step is no value"
        );
        let value = another(row);
        let base = Settings::default().with(|s| {
            for needed in requires.iter().filter_map(|flag| knob(flag)) {
                (needed.field.set)(s, &another(needed));
            }
        });
        assert_eq!(
            (row.field.get)(&base.with(|s| (row.field.set)(s, &value))),
            Some(value),
            "{flag}"
        );
    }
}

/// Values of a kind, in words.
fn values(kind: Kind) -> String {
    match kind {
        Kind::Size => "width and height".to_owned(),
        Kind::Count {
            range: [least, u32::MAX],
            ..
        } => format!("whole number from {least}"),
        Kind::Count {
            range: [least, most],
            ..
        } => format!("whole number from {least} to {most}"),
        Kind::Whole(least) => format!("whole number from {least}"),
        Kind::Real { must_be, .. } => must_be.trim_start_matches("a ").to_owned(),
        Kind::Text(_) => "text".to_owned(),
        Kind::Choice(words) | Kind::Choices(words) => {
            let words: Vec<String> = words()
                .iter()
                .map(|word| format!("`{}`", word.name))
                .collect();
            words.join(" ")
        }
    }
}

#[test]
fn the_book_lists_the_knobs_as_they_are() {
    let mut rows = String::from(
        "| flag | what it does | values | default | in scene files | changes the picture |\n|---|---|---|---|---|---|\n",
    );
    for knob in knobs() {
        let default =
            (knob.field.get)(&Settings::default()).map_or(String::new(), |v| format!("`{v}`"));
        let file = if knob.in_files {
            format!("`{}`", knob.key())
        } else {
            String::new()
        };
        let picture = if knob.changes_picture { "yes" } else { "no" };
        let (flag, doc, values) = (knob.flag, knob.doc, values(knob.kind));
        let _ = writeln!(
            rows,
            "| `--{flag}` | {doc} | {values} | {default} | {file} | {picture} |"
        );
    }
    let book = std::fs::read_to_string(BOOK).expect("the chapter");
    let start = book.find("| flag |").expect("the table");
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        return std::fs::write(BOOK, format!("{}{rows}", &book[..start]))
            .expect("the chapter is written");
    }
    assert_eq!(
        &book[start..],
        rows,
        "write it anew: RAYTREE_BOOK=1 cargo test --test it knobs"
    );
}
