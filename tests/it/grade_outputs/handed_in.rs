//! What is said where nothing fit to be marked was handed in.

use std::fs;

use super::class::Class;

#[test]
fn nothing_handed_in_is_a_wrong_command_line() {
    let class = Class::new();
    let (status, out, told) = class.run("task.toml");
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(
        told.contains("nothing is named that was handed in"),
        "{told}"
    );
}

/// A name that is misspelt on the command line is no student; what is missing in a folder is a problem of the student.
#[test]
fn a_submission_that_is_not_there_is_told_before_the_work() {
    let class = Class::new();
    let (status, out, told) = class.run("task.toml in/ada.ndjson in/nobody");
    assert_eq!((status, out.as_str()), (1, ""), "{told}");
    assert!(told.contains("in/nobody: there is no such file"), "{told}");
    let (status, out, _) = class.run("task.toml in/empty");
    assert_eq!(status, 0);
    assert!(out.contains("empty"), "{out}");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("nowhere", class.path("in/link")).expect("a link");
        let (status, out, _) = class.run("task.toml in/link");
        assert_eq!(status, 0);
        assert!(out.contains("problem: "), "{out}");
    }
}

/// A problem is one line, with what to do.
#[test]
fn a_problem_is_told_in_a_line_and_once() {
    let class = Class::new();
    fs::write(class.path("in/junk.json"), "junk").expect("written");
    let (_, out, _) = class.run("task.toml in/junk.json");
    let problem = out.lines().find(|line| line.contains("junk.json:1:1"));
    let problem = problem.expect("a problem");
    assert!(
        !problem.contains("\\n") && problem.contains("; write"),
        "{problem}"
    );

    let right = fs::read_to_string(class.path("in/ada.ndjson")).expect("trees");
    let other = right.replace("\"name\":\"hits\"", "\"name\":\"glass\"");
    assert!(other != right, "the trees tell their scene");
    fs::write(class.path("in/other.ndjson"), other).expect("written");
    let (_, out, _) = class.run("task.toml in/other.ndjson");
    let said = "is of the scene `glass`, and the task asks hits";
    assert_eq!(out.matches(said).count(), 1, "{out}");
    let (_, out, _) = class.run("task.toml in/ada.ndjson");
    assert!(!out.contains("is of the scene"), "{out}");
}

#[test]
fn a_name_in_a_task_that_nothing_has_is_told() {
    let class = Class::new();
    let task = fs::read_to_string(class.path("task.toml")).expect("a task");
    let drawn = "pixels = { count = 1, where = \"not hits:bal\" }";
    let drawn = task.replacen("pixels = [[20, 40], [32, 24], [44, 30]]", drawn, 1);
    fs::write(class.path("task.toml"), drawn).expect("written");
    let (_, _, told) = class.run("task.toml --show");
    let marked = class.run("task.toml in/ada.ndjson").2;
    assert!(
        marked.contains("check `hits`: `where`: no object is named `bal`"),
        "{told}{marked}"
    );
}
