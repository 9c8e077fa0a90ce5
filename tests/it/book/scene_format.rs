//! The page of scene files: every field of the schema with an example, and all examples together are a scene.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::{Value, json};

use super::links::id;
use super::made::{cell, heading, piece, shows};
use super::schema::{Described, Schema, words_of};
use super::{page, source};

const PAGE: &str = "scene-format.md";

/// Types that have no fields of their own: the text of the page tells what they are.
const PLAIN: [&str; 2] = ["Rgb", "ScaleFile"];

/// The type whose table tells of a type: solids as parts of a csg have the fields that they have alone.
fn told_by(name: &str) -> &str {
    name.trim_end_matches('2')
}

/// The examples of a table, by their fields.
pub fn examples(text: &str, name: &str) -> BTreeMap<String, String> {
    let table = piece(text, told_by(name)).unwrap_or_default();
    let row = |line: &str| {
        let mut cells = line.strip_prefix("| `")?.split(" | ");
        let field = cells.next()?.trim_end_matches('`');
        let example = cells.next()?.strip_prefix('`')?.strip_suffix('`')?;
        Some((field.to_owned(), example.to_owned()))
    };
    table.lines().filter_map(row).collect()
}

/// The table of a type.
fn table(schema: &Schema, text: &str, described: &Described) -> String {
    let old = examples(text, &described.name);
    let mut out = format!(
        "{}\n\n| field | example | what it is | without it |\n|---|---|---|---|\n",
        described.doc
    );
    for field in &described.fields {
        let example = match schema.within(&field.schema) {
            Some(inner) if !inner.fields.is_empty() => {
                let title = heading(text, told_by(&inner.name))
                    .unwrap_or_else(|| panic!("{PAGE} needs a heading for {}", inner.name));
                format!("[{}](#{})", title.replace('`', ""), id(title))
            }
            _ => format!("`{}`", old.get(&field.name).map_or("?", String::as_str)),
        };
        let words = words_of(&field.schema);
        let words: String = words.iter().fold(String::new(), |all, (word, doc)| {
            format!("{all} `{word}`: {doc}")
        });
        let default = match &field.default {
            _ if field.required => "must be there".to_owned(),
            Some(default) => format!("`{default}`"),
            None => String::new(),
        };
        let _ = writeln!(
            out,
            "| `{}` | {example} | {}{words} | {default} |",
            field.name,
            cell(&field.doc)
        );
    }
    out
}

fn shown(schema: &Schema) -> impl Iterator<Item = &Described> {
    schema
        .types
        .iter()
        .filter(|t| !PLAIN.contains(&t.name.as_str()) && !t.fields.is_empty())
        .filter(|t| told_by(&t.name) == t.name)
}

#[test]
fn every_field_of_a_scene_file_stands_on_its_page() {
    let schema = Schema::of("scene");
    let text = page(PAGE);
    let pieces: Vec<(String, String)> = shown(&schema)
        .map(|t| (t.name.clone(), table(&schema, &text, t)))
        .collect();
    assert!(pieces.len() > 15, "the types are there");
    shows(PAGE, &pieces);
}

#[test]
fn every_example_of_a_scene_file_fits_its_field() {
    let schema = Schema::of("scene");
    let text = page(PAGE);
    for described in shown(&schema) {
        let examples = examples(&text, &described.name);
        for field in &described.fields {
            if schema
                .within(&field.schema)
                .is_some_and(|inner| !inner.fields.is_empty())
            {
                continue;
            }
            let at = format!("{}.{}", described.name, field.name);
            let example = examples
                .get(&field.name)
                .unwrap_or_else(|| panic!("{at} has no example"));
            let value =
                serde_json::from_str(example).unwrap_or_else(|e| panic!("{at}: {example}: {e}"));
            assert_eq!(
                schema.refuses(&field.schema, &value),
                None,
                "{at}: {example}"
            );
        }
    }
}

/// An object of a type, made of the examples of its table; `deep` is false inside of a group.
fn composed(schema: &Schema, text: &str, described: &Described, deep: bool) -> Vec<Value> {
    let examples = examples(text, &described.name);
    let mut whole = serde_json::Map::new();
    for field in &described.fields {
        let inner = schema
            .within(&field.schema)
            .filter(|inner| !inner.fields.is_empty());
        let value = match inner {
            None => serde_json::from_str(&examples[&field.name]).expect("checked by another test"),
            Some(inner) if inner.name == "GroupFile" && !deep => continue,
            Some(inner) if described.name == "CsgPartFile" && told_by(&inner.name) == "CsgFile" => {
                continue;
            }
            Some(inner) => {
                let mut parts =
                    composed(schema, text, inner, deep && described.name != "GroupFile");
                match field.schema.get("type").and_then(Value::as_str) {
                    Some("array") => Value::Array(parts),
                    Some("object") => json!({ "glass": parts.remove(0) }),
                    _ => parts.remove(0),
                }
            }
        };
        whole.insert(field.name.clone(), value);
    }
    // A choice: each of its fields is an object of its own.
    if described
        .fields
        .iter()
        .all(|field| !field.required && field.default.is_none())
        && schema.whole["$defs"][&described.name]
            .get("oneOf")
            .is_some()
    {
        return whole
            .into_iter()
            .map(|(name, value)| json!({ name: value }))
            .collect();
    }
    vec![Value::Object(whole)]
}

#[test]
fn all_examples_together_are_a_scene() {
    let schema = Schema::of("scene");
    let text = page(PAGE);
    let scene = composed(&schema, &text, &schema.types[0], true).remove(0);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("all.json");
    std::fs::write(
        folder.path().join("model.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .expect("written");
    std::fs::write(&path, serde_json::to_string_pretty(&scene).expect("JSON")).expect("written");
    let path = path.to_str().expect("a plain path");
    let tree: Value = serde_json::from_str(&super::printed(&[
        "trace", path, "--size", "4x3", "--pixel", "2,1", "-q",
    ]))
    .expect("JSON");
    assert_eq!(tree["scene"]["name"], scene["name"]);
    let objects = scene["objects"].as_array().expect("objects");
    assert!(objects.len() >= 9, "{} objects", objects.len());
}

#[test]
fn the_scenes_of_the_page_can_be_drawn() {
    let text = page(PAGE);
    let scenes: Vec<&str> = text
        .split("```json\n")
        .skip(1)
        .filter_map(|block| block.split("```").next())
        .collect();
    let whole: Vec<&&str> = scenes
        .iter()
        .filter(|scene| scene.contains("raytree-scene/1"))
        .collect();
    assert!(
        !whole.is_empty(),
        "no whole scene in {}",
        source().join(PAGE).display()
    );
    let folder = tempfile::tempdir().expect("a folder");
    for scene in whole {
        let path = folder.path().join("page.json");
        std::fs::write(&path, scene).expect("written");
        let path = path.to_str().expect("a plain path");
        let picture = super::printed(&["render", path, "--size", "16x12", "--deny-warnings"]);
        assert!(!picture.trim().is_empty(), "{scene}");
    }
}
