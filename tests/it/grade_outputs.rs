//! What `raytree grade` writes: each output is what its readers expect, whatever students hand in.

mod class;
mod gradescope;
mod handed_in;
mod pages;
mod shards;
mod tables;

use std::path::Path;

use serde_json::{Value, json};

use class::{Class, HIDDEN, Mistake};

/// A value satisfies a schema of `tests/it/grade/schemas`.
#[track_caller]
fn satisfies(value: &Value, schema: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/grade/schemas");
    let text = std::fs::read_to_string(folder.join(schema)).expect("a schema");
    let schema: Value = serde_json::from_str(&text).expect("JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    let errors: Vec<String> = validator
        .iter_errors(value)
        .map(|error| format!("{}: {error}", error.instance_path()))
        .collect();
    assert!(errors.is_empty(), "{errors:#?}\n{value:#}");
    // It does not satisfy everything.
    assert!(!validator.is_valid(&json!({})));
}

#[test]
fn json_is_as_its_schema_says_for_teachers_and_students() {
    let class = Class::new();
    let marks = class.json("");
    satisfies(&marks, "raytree-grade-1.json");
    let of = |name: &str, marks: &Value| {
        let all = marks["submissions"].as_array().expect("a list");
        let one = all.iter().find(|s| s["name"] == name);
        one.expect("it is there").clone()
    };
    let right = of("ada", &marks);
    assert_eq!(
        (&right["score"], &right["percent"]),
        (&json!(9), &json!(100))
    );
    let wrong = of("bo", &marks);
    assert_eq!(wrong["bends"][0]["names"][0], "cos-missing", "{wrong:#}");
    assert_eq!(wrong["checks"][2]["id"], "secret");
    assert!(wrong["checks"][2]["causes"][0]["address"].is_string());
    let empty = of("empty", &marks);
    assert_eq!(empty["score"], 0);

    let shown = class.json("--student");
    satisfies(&shown, "raytree-grade-1.json");
    let hidden = &of("bo", &shown)["checks"][2];
    assert_eq!(hidden["score"], wrong["checks"][2]["score"]);
    let fields: Vec<&String> = hidden.as_object().expect("fields").keys().collect();
    assert_eq!(fields, ["id", "max", "score", "status", "title", "visible"]);
}

#[test]
fn what_is_hidden_has_neither_values_nor_addresses_for_students() {
    let class = Class::new();
    let trees = class::trees(Mistake::Bend("cos-missing"));
    // The hidden pixel alone, so that it is where a law is broken first.
    let hidden = trees.lines().last().expect("a line");
    std::fs::write(class.path("in/cleo.ndjson"), hidden).expect("written");
    let (x, y) = HIDDEN;
    let address = format!("{x},{y}");
    // The teacher sees it, so that this test can fail.
    let marks = class.json("");
    let all = marks["submissions"].as_array().expect("a list");
    let cleo = all.iter().find(|s| s["name"] == "cleo").expect("there");
    let cause = &cleo["checks"][2]["causes"][0];
    assert!(
        cause["address"]
            .as_str()
            .is_some_and(|a| a.starts_with(&address))
    );
    let value = cause["ours"][0].as_f64().expect("a number");
    let value = format!("{value:.5}");
    for (kind, file) in [("html", "t.html"), ("junit", "t.xml")] {
        let text = class.written(kind, file, "cleo", "");
        assert!(text.contains(&address) && text.contains(&value), "{text}");
    }
    let public = [
        class.written("html", "a.html", "cleo", "--student"),
        class.written("text", "a.txt", "cleo", "--student"),
        class.written("json", "a.json", "cleo", "--student"),
        class.written("junit", "a.xml", "cleo", "--student"),
        class.written("gradescope", "results.json", "cleo", ""),
        class.classroom("cleo"),
    ];
    for text in public {
        assert!(text.contains("secret"));
        assert!(!text.contains(&address), "{text}");
        assert!(!text.contains(&value[..6]), "{text}");
    }
}

#[test]
fn an_output_takes_the_place_of_nothing_that_is_read() {
    let class = Class::new();
    let task = class.path("task.toml");
    let before = std::fs::read(&task).expect("the task");
    for file in ["task.toml", "hits.json", "in/bo.ndjson"] {
        let (status, _, told) = class.run(&format!("task.toml in/bo.ndjson --output text={file}"));
        assert_eq!(status, 2, "{told}");
        assert!(told.contains("would be replaced"), "{told}");
    }
    assert_eq!(std::fs::read(&task).expect("the task"), before);
    for (output, what) in [
        ("json=a.csv", ".csv file"),
        ("csv=none/a.csv", "folder does not exist"),
        ("pdf=a.pdf", "is no output"),
        (
            "json=a.json --output csv=b.json",
            "give a name that ends in .csv",
        ),
        ("json=a --output csv=a", "already"),
    ] {
        let (status, _, told) = class.run(&format!("task.toml in/bo.ndjson --output {output}"));
        assert!(status != 0 && told.contains(what), "{output}: {told}");
    }
    assert!(!class.path("a.json").exists());
}

#[test]
fn students_of_the_list_who_handed_in_nothing_have_no_points() {
    let class = Class::new();
    std::fs::write(class.path("list.csv"), "name,id\nBo Berg,bo\nZoe,77\n").expect("written");
    let (status, out, told) = class
        .run("task.toml in/ada.ndjson in/bo.ndjson --students list.csv --output json=/dev/stdout");
    assert_eq!(status, 0, "{told}");
    assert!(told.contains("in/ada.ndjson is of nobody"), "{told}");
    let marks: Value = serde_json::from_str(&out).expect("JSON");
    satisfies(&marks, "raytree-grade-1.json");
    let all = marks["submissions"].as_array().expect("a list");
    let rows: Vec<_> = all.iter().map(|s| (&s["name"], &s["id"])).collect();
    let expected = [
        (&json!("ada"), &Value::Null),
        (&json!("Bo Berg"), &json!("bo")),
        (&json!("Zoe"), &json!("77")),
    ];
    assert_eq!(rows, expected);
    assert_eq!(all[2]["score"], 0);
    assert_eq!(all[2]["problems"][0], "nothing was handed in");
}

#[test]
fn a_difference_is_as_its_schema_says() {
    let class = Class::new();
    let mut command = assert_cmd::Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.current_dir(class.path("."));
    command.args(
        "diff hits.json@13,41 hits.json@13,41 --size 64x48 --bend-b cos-missing --format json"
            .split(' '),
    );
    let output = command.output().expect("it runs");
    assert_eq!(output.status.code(), Some(4));
    let difference: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    satisfies(&difference, "raytree-diff-1.json");
    assert_eq!(difference["causes"][0]["as_if"][0], "cos-missing");
}
