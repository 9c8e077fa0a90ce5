//! What platforms read: Gradescope's and Classroom 50's results, and the archive that Gradescope runs.

use std::fs;
use std::process::Command;

use serde_json::{Value, json};

use super::class::Class;
use super::satisfies;

#[test]
fn gradescope_reads_the_results_and_students_only_our_control_sequences() {
    let class = Class::new();
    for (name, score) in [("ada", json!(9)), ("bo", json!(4))] {
        let text = class.written("gradescope", "results.json", name, "");
        let results: Value = serde_json::from_str(&text).expect("JSON");
        satisfies(&results, "gradescope-results.json");
        assert!(results["score"].as_f64() >= score.as_f64(), "{text}");
        let tests = results["tests"].as_array().expect("a list");
        let status = |i: usize| tests[i]["status"].as_str().expect("a word").to_owned();
        assert_eq!(status(0), "passed");
        assert_eq!(status(1), if name == "ada" { "passed" } else { "failed" });
        assert_eq!(tests[2]["visibility"], "hidden");
        assert_eq!(results["extra_data"]["raytree"]["for"], "students");
    }
    let (status, _, told) =
        class.run("task.toml in/ada.ndjson in/bo.ndjson --output gradescope=results.json");
    assert_eq!(status, 2);
    assert!(told.contains("once for each"), "{told}");
}

#[test]
fn classroom_50_reads_whole_numbers_and_what_its_runner_says() {
    let class = Class::new();
    let result: Value = serde_json::from_str(&class.classroom("bo")).expect("JSON");
    satisfies(&result, "classroom50-result.json");
    assert_eq!(result["max-score"], 900);
    assert_eq!(result["owner"], "bo");
    assert_eq!(result["review"], result["commit"]);
    assert_eq!(result["datetime"], "2026-02-28T23:59:00Z");
    assert_eq!(result["tests"][0]["score"], 400);
    assert_eq!(result["tests"][0]["passed"], true);
    assert_eq!(result["tests"][1]["passed"], false);
    let (status, _, told) = class.run_with(
        &[
            "task.toml",
            "in/bo.ndjson",
            "--output",
            "classroom50=r.json",
        ],
        &[("CLASSROOM", "graphics"), ("ASSIGNMENT", "")],
    );
    assert_eq!(status, 2);
    assert!(told.contains("ASSIGNMENT is not set"), "{told}");
}

/// The archive is unpacked and run as Gradescope's harness does it.
#[cfg(unix)]
#[test]
fn the_exported_grader_gives_the_same_results() {
    let class = Class::new();
    // The program is large where it is built for tests; this one stands for it.
    let program = class.path("program");
    let own = env!("CARGO_BIN_EXE_raytree");
    fs::write(&program, format!("#!/bin/sh\nexec '{own}' \"$@\"\n")).expect("written");
    let words = [
        "--export",
        "gradescope",
        "task.toml",
        "--program",
        "program",
    ];
    for file in ["autograder.zip", "again.zip"] {
        let (status, _, told) = class.run_with(&[&words[..], &["-o", file]].concat(), &[]);
        assert_eq!(status, 0, "{told}");
    }
    let bytes = fs::read(class.path("autograder.zip")).expect("written");
    assert_eq!(bytes, fs::read(class.path("again.zip")).expect("written"));

    let root = class.path("autograder");
    let mut zip = zip::ZipArchive::new(std::io::Cursor::new(bytes)).expect("an archive");
    zip.extract(root.join("source")).expect("unpacked");
    let submission = root.join("submission");
    fs::create_dir(&submission).expect("a folder");
    fs::copy(class.path("in/bo.ndjson"), submission.join("bo.ndjson")).expect("copied");
    let run = |script: &str| {
        let mut command = Command::new(root.join("source").join(script));
        command.env("AUTOGRADER_ROOT", &root).current_dir("/");
        let output = command.output().expect("it runs");
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{script}: {told}");
    };
    run("setup.sh");
    // The task that it was made of is gone.
    fs::remove_file(class.path("hits.json")).expect("removed");
    run("run_autograder");
    let results = fs::read_to_string(root.join("results/results.json")).expect("written");
    let value: Value = serde_json::from_str(&results).expect("JSON");
    satisfies(&value, "gradescope-results.json");

    fs::copy(root.join("source/task/hits.json"), class.path("hits.json")).expect("copied");
    let words = [
        "task.toml",
        "autograder/submission",
        "--output",
        "gradescope=direct.json",
    ];
    let (status, _, told) = class.run_with(&words, &[]);
    assert_eq!(status, 0, "{told}");
    let direct = fs::read_to_string(class.path("direct.json")).expect("written");
    assert_eq!(results, direct);
    assert_eq!(value["tests"][0]["status"], "passed");
}

/// Earlier attempts, as Gradescope's harness tells them, and a task in which the best one counts.
#[cfg(unix)]
#[test]
fn the_best_attempt_counts_where_the_task_says_so() {
    let class = Class::new();
    let task = fs::read_to_string(class.path("task.toml")).expect("there");
    let rule = format!("attempts = {{ best = true, most = 3 }}\n{task}");
    fs::write(class.path("rule.toml"), rule).expect("written");
    let score = |earlier: &str, task: &str| {
        let metadata = format!("{{\"previous_submissions\": {earlier}}}");
        fs::write(class.path("metadata.json"), metadata).expect("written");
        let words = [
            task,
            "in/bo.ndjson",
            "--metadata",
            "metadata.json",
            "--output",
            "gradescope=results.json",
        ];
        let (status, _, told) = class.run_with(&words, &[]);
        assert_eq!(status, 0, "{told}");
        let results = fs::read_to_string(class.path("results.json")).expect("written");
        let results: Value = serde_json::from_str(&results).expect("JSON");
        satisfies(&results, "gradescope-results.json");
        let output = results["output"].as_str().expect("text").to_owned();
        (results["score"].as_f64().expect("a number"), output)
    };
    let (now, _) = score("[]", "rule.toml");
    assert!(now > 0.5 && now < 9.0, "{now}");
    let (best, told) = score("[{\"score\": 8.5}]", "rule.toml");
    assert!(
        best == 8.5 && told.contains("An earlier attempt counts: 8.5 points."),
        "{told}"
    );
    assert_eq!(score("[{\"score\": 8.5}]", "task.toml").0, now);
    let many = "[{\"score\": 0.25}, {\"score\": 0.5}, {\"score\": 0}]";
    let (best, told) = score(many, "rule.toml");
    assert!(
        best == 0.5 && told.contains("Attempt 4; 3 count."),
        "{told}"
    );
    let two = [
        "rule.toml",
        "in/bo.ndjson",
        "in/ada.ndjson",
        "--metadata",
        "metadata.json",
    ];
    let (status, _, told) = class.run_with(&two, &[]);
    assert!(status == 2 && told.contains("of one student"), "{told}");
    fs::write(class.path("metadata.json"), "[").expect("written");
    let (status, _, told) = class.run_with(&two[..2], &[]);
    assert_eq!(status, 0, "{told}");
    let one = [two[0], two[1], two[3], two[4]];
    let (status, _, told) = class.run_with(&one, &[]);
    assert!(status == 1 && told.contains("metadata.json: "), "{told}");
}

/// The archive is unpacked where Classroom 50 has the files of an assignment, and its script is run in a student's repository.
#[cfg(unix)]
#[test]
fn the_grader_for_classroom_50_writes_result_json() {
    if !crate::hello::is_found("python3", true) {
        return;
    }
    let class = Class::new();
    let own = env!("CARGO_BIN_EXE_raytree");
    fs::write(
        class.path("program"),
        format!("#!/bin/sh\nexec '{own}' \"$@\"\n"),
    )
    .expect("written");
    let words = [
        "--export",
        "classroom50",
        "task.toml",
        "--program",
        "program",
        "-o",
        "a.zip",
    ];
    let (status, _, told) = class.run_with(&words, &[]);
    assert_eq!(status, 0, "{told}");
    let bundle = class.path("bundle");
    let bytes = fs::read(class.path("a.zip")).expect("written");
    let mut zip = zip::ZipArchive::new(std::io::Cursor::new(bytes)).expect("an archive");
    zip.extract(&bundle).expect("unpacked");
    let repository = class.path("repository");
    fs::create_dir(&repository).expect("a folder");
    fs::copy(class.path("in/bo.ndjson"), repository.join("bo.ndjson")).expect("copied");
    let mut command = Command::new("python3");
    command
        .arg(bundle.join("autograder.py"))
        .current_dir(&repository);
    for (name, value) in [
        ("CLASSROOM50_BUNDLE_DIR", bundle.to_str().expect("UTF-8")),
        ("CLASSROOM", "graphics"),
        ("ASSIGNMENT", "hits"),
        ("USERNAME", "bo"),
        ("SUBMISSION_TAG", "submit/1"),
        ("COMMIT_URL", "https://example.org/c"),
        ("RELEASE_URL", "https://example.org/r"),
    ] {
        command.env(name, value);
    }
    let output = command.output().expect("it runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let read = |name: &str| fs::read_to_string(repository.join(name)).expect("written");
    let result: Value = serde_json::from_str(&read("result.json")).expect("JSON");
    satisfies(&result, "classroom50-result.json");
    assert_eq!(
        (&result["owner"], &result["max-score"]),
        (&json!("bo"), &json!(900))
    );
    assert!(
        read("release-body.md").contains("    "),
        "{}",
        read("release-body.md")
    );
    let mut left: Vec<_> = fs::read_dir(&repository)
        .expect("a folder")
        .flatten()
        .collect();
    left.sort_by_key(std::fs::DirEntry::file_name);
    let left: Vec<_> = left.iter().map(std::fs::DirEntry::file_name).collect();
    assert_eq!(left, ["bo.ndjson", "release-body.md", "result.json"]);
}

#[test]
fn all_files_of_a_scene_are_exported() {
    let class = Class::new();
    let model = "mtllib near.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
    fs::create_dir(class.path("task")).expect("a folder");
    for (file, text) in [
        ("task/near.obj", model),
        ("task/near.mtl", "newmtl red\nKd 1 0 0\n"),
        ("task/solution.py", "print(42)\n"),
        ("program", ""),
    ] {
        fs::write(class.path(file), text).expect("written");
    }
    let task = "format = \"raytree-task/1\"\nname = \"a\"\nsize = \"8x6\"\n\
                [[check]]\nid = \"a\"\npoints = 1\nscene = \"near.obj\"\npixels = [[4, 3]]\nask = [\"outcome\"]\n";
    fs::write(class.path("task/task.toml"), task).expect("written");
    let words = [
        "--export",
        "gradescope",
        "task/task.toml",
        "--program",
        "program",
        "-o",
        "a.zip",
    ];
    let (status, _, told) = class.run_with(&words, &[]);
    assert_eq!(status, 0, "{told}");
    let file = fs::File::open(class.path("a.zip")).expect("written");
    let zip = zip::ZipArchive::new(file).expect("an archive");
    let names = zip
        .file_names()
        .map(|name| name.expect("UTF-8").into_owned());
    let mut names: Vec<String> = names.collect();
    names.sort_unstable();
    // What lies beside the task and is of no scene stays with the teacher.
    let expected = [
        "raytree",
        "run_autograder",
        "setup.sh",
        "task/near.mtl",
        "task/near.obj",
        "task/task.toml",
    ];
    assert_eq!(names, expected);
}
