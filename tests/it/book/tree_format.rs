//! The page of ray trees: every field of the schema, with a value that the program writes.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::Value;

use super::links::id;
use super::made::{cell, heading, shows};
use super::schema::{Described, Schema};
use super::{page, printed};

const PAGE: &str = "tree-format.md";

/// Types that stand elsewhere, or need no table: the text of the page tells.
const ELSEWHERE: [&str; 2] = ["WarningCode", "Rgb"];

/// Where the values come from, and the page says so.
const SOURCES: [&str; 16] = [
    "raytree trace whitted --pixel 150,130 --traversal",
    "raytree trace glass-block --pixel 80,120",
    "raytree trace nested-glass --pixel 160,120 --change object.water.radius=1",
    "raytree trace nested-glass --pixel 160,120 --change material.water.priority=-1",
    "raytree trace soft-shadow --pixel 160,180 --light-samples 4",
    "raytree trace soft-shadow --pixel 160,180 --light-samples 4 --light-sampling projected",
    "raytree trace teapot --pixel 160,120 --samples 4 --sampling random --adaptive 0.01",
    "raytree trace teapot --pixel 160,120 --samples 4 --sampling random --sets 2",
    "raytree trace whitted --pixel 45,31 --size 94x62 --min-weight 0.01 --without shadows --offset none",
    "raytree trace shadows --pixel 200,180 --bend shadow-endless",
    "raytree trace mirrors --pixel 208,96 --depth 2 --traversal",
    "raytree trace whitted --pixel 150,130 --change material.glass.diffuse=[2,2,2]",
    "raytree trace csg --pixel 85,150",
    "raytree trace torus --pixel 160,120",
    "raytree trace solar --pixel 190,152",
    "raytree trace gouraud --pixel 170,120 --shading gouraud",
];

/// Fields that no usual tree has, with the values that they can have.
const RARE: [(&str, &str); 5] = [
    ("raytree/1.spoiled", "1"),
    ("raytree/1.truncated", "1200"),
    ("DocumentWarning.line", "7"),
    ("AbsentRay.cos_angle", "0.91"),
    ("AbsentRay.n_dot_r", "-0.02"),
];

/// The first value of each field in some trees, by `Type.field`.
type Seen = BTreeMap<String, Value>;

fn collect(schema: &Schema, described: &Described, value: &Value, seen: &mut Seen) {
    let Some(object) = value.as_object() else {
        return;
    };
    for (name, value) in object {
        let of = |f: &&super::schema::Field| f.name == *name;
        let field = described
            .fields
            .iter()
            .find(of)
            .unwrap_or_else(|| panic!("{}.{name} is not in the schema", described.name));
        let empty = value.is_null() || value.as_array().is_some_and(Vec::is_empty);
        if !empty {
            seen.entry(format!("{}.{name}", described.name))
                .or_insert_with(|| value.clone());
        }
        if let Some(inner) = schema.within(&field.schema) {
            match value {
                Value::Array(parts) => parts
                    .iter()
                    .for_each(|part| collect(schema, inner, part, seen)),
                value => collect(schema, inner, value, seen),
            }
        }
    }
}

fn seen(schema: &Schema) -> Seen {
    let mut seen = Seen::new();
    for command in SOURCES {
        let words: Vec<&str> = command.split(' ').skip(1).chain(["-q"]).collect();
        let tree: Value = serde_json::from_str(&printed(&words)).expect("JSON");
        assert_eq!(schema.refuses(&schema.whole, &tree), None, "{command}");
        collect(schema, &schema.types[0], &tree, &mut seen);
    }
    for (name, value) in RARE {
        let value = serde_json::from_str(value).expect("JSON");
        assert!(
            seen.insert(name.to_owned(), value).is_none(),
            "{name} is not rare: take it out of the list"
        );
    }
    seen
}

/// A value in a cell: not all digits of long numbers.
fn short(value: &Value) -> String {
    match value {
        Value::Number(n) if n.is_f64() => {
            let x = n.as_f64().expect("a number");
            let text = format!("{x}");
            if text.len() > 9 {
                format!("{x:.5}")
            } else {
                text
            }
        }
        Value::Array(parts) => format!(
            "[{}]",
            parts.iter().map(short).collect::<Vec<_>>().join(", ")
        ),
        other => other.to_string(),
    }
}

fn table(schema: &Schema, text: &str, described: &Described, seen: &Seen) -> String {
    let mut out = format!("{}\n\n", described.doc);
    if described.fields.is_empty() {
        out += "| word | what it means |\n|---|---|\n";
        for (word, doc) in &described.words {
            let _ = writeln!(out, "| `{word}` | {doc} |");
        }
        return out;
    }
    out += "| field | for example | what it is | |\n|---|---|---|---|\n";
    for field in &described.fields {
        let inner = schema
            .within(&field.schema)
            .filter(|t| !ELSEWHERE.contains(&t.name.as_str()));
        let link = inner.map(|inner| {
            let title = heading(text, &inner.name)
                .unwrap_or_else(|| panic!("{PAGE} needs a heading for {}", inner.name));
            (
                format!("[{}](#{})", title.replace('`', ""), id(title)),
                inner.fields.is_empty(),
            )
        });
        let place = format!("{}.{}", described.name, field.name);
        let value = || {
            let value = seen
                .get(&place)
                .unwrap_or_else(|| panic!("no tree has {place}: add a source"));
            assert_eq!(schema.refuses(&field.schema, value), None, "{place}");
            format!("`{}`", cell(&short(value)))
        };
        let (example, more) = match link {
            Some((link, false)) => (link, String::new()),
            Some((link, true)) => (value(), format!(" ({link})")),
            None => (value(), String::new()),
        };
        let always = if field.required { "always" } else { "" };
        let _ = writeln!(
            out,
            "| `{}` | {example} | {}{more} | {always} |",
            field.name,
            cell(&field.doc)
        );
    }
    out
}

#[test]
fn every_field_of_a_ray_tree_stands_on_its_page() {
    let schema = Schema::of("tree");
    let text = page(PAGE);
    let seen = seen(&schema);
    let types = schema
        .types
        .iter()
        .filter(|t| !ELSEWHERE.contains(&t.name.as_str()));
    let pieces: Vec<(String, String)> = types
        .map(|t| (t.name.clone(), table(&schema, &text, t, &seen)))
        .collect();
    assert!(pieces.len() > 25, "the types are there");
    shows(PAGE, &pieces);
}

#[test]
fn the_page_of_ray_trees_says_where_its_values_come_from() {
    let text = page(PAGE);
    for command in SOURCES {
        assert!(text.contains(command), "{PAGE}: {command}");
    }
}
