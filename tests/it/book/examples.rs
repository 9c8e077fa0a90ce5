//! The examples of the pages run: each line `$ raytree ...` ends as it says, and prints what stands below it.

use std::path::Path;
use std::process::{Command, Stdio};

use super::page;

/// Pages whose examples are run, one after the other in a folder of their own. (Those of `monday.md` are run by `monday.rs`.)
const PAGES: [&str; 6] = [
    "commands.md",
    "find.md",
    "course-format.md",
    "teach.md",
    "packs.md",
    "errors.md",
];

/// A line of a page.
#[derive(Debug, PartialEq)]
struct Example {
    line: String,
    /// The exit status: 0, or what stands behind it, such as `# exit status 4`.
    status: i32,
    /// What it prints, if the page shows it.
    printed: String,
}

/// The examples of a page. Those that need a screen say `# on a terminal`, and are left out.
fn examples(text: &str) -> Vec<Example> {
    let mut all = Vec::new();
    for block in text
        .split("```console\n")
        .skip(1)
        .filter_map(|block| block.split("```").next())
    {
        for part in format!("\n{block}").split("\n$ ").skip(1) {
            let (line, printed) = part.split_once('\n').unwrap_or((part, ""));
            let (line, status) = line.split_once(" # exit status ").unwrap_or((line, "0"));
            let status = status.trim().parse().expect("a number");
            all.push(Example {
                line: line.trim().to_owned(),
                status,
                printed: printed.trim_end().to_owned(),
            });
        }
    }
    all.retain(|example| !example.line.ends_with("# on a terminal"));
    all
}

/// Runs a line by the shell: `raytree` is this program, and the folder `lessons` is there.
fn run(line: &str, folder: &Path) -> (Option<i32>, String) {
    let program = Path::new(env!("CARGO_BIN_EXE_raytree"))
        .parent()
        .expect("a folder");
    let path = std::env::var_os("PATH").unwrap_or_default();
    let paths = std::iter::once(program.to_owned()).chain(std::env::split_paths(&path));
    let mut command = Command::new("sh");
    command
        .args(["-c", line])
        .current_dir(folder)
        .stdin(Stdio::null());
    command.env("PATH", std::env::join_paths(paths).expect("paths"));
    command.env("XDG_STATE_HOME", folder.join("state"));
    let output = command.output().expect("a shell");
    let printed = [output.stdout, output.stderr].concat();
    (
        output.status.code(),
        String::from_utf8_lossy(&printed).trim_end().to_owned(),
    )
}

#[test]
#[cfg(unix)]
fn the_examples_of_the_pages_run() {
    for name in PAGES {
        let folder = tempfile::tempdir().expect("a folder");
        let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
        std::os::unix::fs::symlink(lessons, folder.path().join("lessons")).expect("a link");
        let examples = examples(&page(name));
        assert!(!examples.is_empty(), "{name} has no examples");
        for Example {
            line,
            status,
            printed,
        } in examples
        {
            let (ended, now) = run(&line, folder.path());
            assert_eq!(ended, Some(status), "{name}: {line}\n{now}");
            assert!(
                printed.is_empty() || printed == now,
                "{name}: {line}\n{now}"
            );
        }
    }
}

#[test]
fn examples_are_read_with_their_status_and_output() {
    let text = "```console\n$ raytree find a b # exit status 4\nx\n  y\n$ raytree scenes\n$ raytree view a # on a terminal\n```\n\n```sh\n$ no\n```\n";
    let example = |line: &str, status, printed: &str| Example {
        line: line.to_owned(),
        status,
        printed: printed.to_owned(),
    };
    assert_eq!(
        examples(text),
        [
            example("raytree find a b", 4, "x\n  y"),
            example("raytree scenes", 0, "")
        ]
    );
}
