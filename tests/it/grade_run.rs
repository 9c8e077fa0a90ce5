//! `raytree grade --run`: programs earn what they print, and whatever they do, they end and harm nobody.

mod lessons;

use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

use super::flat::lesson;
use super::hello::is_found;

/// Both scenes of the first rays, and a check that students do not see.
const TASK: &str = r#"
format = "raytree-task/1"
name = "First rays"
size = "320x240"
settings = { depth = 0 }
[[check]]
id = "triangle"
points = 1
scene = "triangle"
pixels = [[160, 100], [3, 5]]
ask = ["outcome", "object", "t"]
[[check]]
id = "shapes"
points = 2
scene = "hits.json"
pixels = [[75, 150], [200, 130], [188, 95]]
ask = ["outcome", "object", "t"]
[[check]]
id = "unseen"
points = 1
visible = false
scene = "hits.json"
pixels = [[75, 150], [105, 165]]
ask = ["outcome", "object", "t"]
"#;

const A_SCENE: &str = "python3 a.py {flat} {width} {height} {pixels} {out}";
const A_PIXEL: &str = "python3 a.py {flat} {x} {y} {width} {height}";

/// A task with its scenes, and a submission.
struct Handed {
    folder: TempDir,
}

impl Handed {
    fn new(name: &str, program: &[u8]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, bytes: &[u8]| {
            fs::write(folder.path().join(name), bytes).expect("written");
        };
        write("task.toml", TASK.as_bytes());
        write(
            "hits.json",
            &fs::read(lesson("tasks/hits.json")).expect("there"),
        );
        fs::create_dir(folder.path().join("alice")).expect("made");
        write(&format!("alice/{name}"), program);
        Self { folder }
    }

    fn python(program: &str) -> Self {
        Self::new("a.py", program.as_bytes())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn graded(&self, command: &str, args: &[&str]) -> Graded {
        graded(&self.path("task.toml"), &self.path("alice"), command, args)
    }
}

/// The report on one submission.
struct Graded {
    score: f64,
    max: f64,
    problems: Vec<String>,
    all: Value,
    took: Duration,
}

#[track_caller]
fn graded(task: &Path, submission: &Path, command: &str, args: &[&str]) -> Graded {
    let report = tempfile::NamedTempFile::new().expect("a file");
    let start = Instant::now();
    let ran = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .arg("grade")
        .args([task, submission])
        .args(["--run", command])
        .arg(format!("--output=json={}", report.path().display()))
        .args(args)
        .env("RAYTREE_SECRET", "of the teacher")
        .output()
        .expect("runs");
    let took = start.elapsed();
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    let text = fs::read_to_string(report.path()).expect("UTF-8");
    let report: Value = serde_json::from_str(&text).expect("JSON");
    let all = report["submissions"][0].clone();
    let problems = all["problems"].as_array().expect("a list").iter();
    let problems = problems.map(|p| p.as_str().expect("text").to_owned());
    Graded {
        score: all["score"].as_f64().expect("a number"),
        max: all["max"].as_f64().expect("a number"),
        problems: problems.collect(),
        all,
        took,
    }
}

impl Graded {
    /// One of the problems has these words.
    #[track_caller]
    fn tells(&self, words: &str) {
        let told = self.problems.iter().any(|problem| problem.contains(words));
        assert!(told, "`{words}` in {:#?}", self.problems);
    }

    fn sandbox(&self) -> &str {
        let first = self.problems.first().map_or("", String::as_str);
        assert!(first.starts_with("sandbox: "), "{first}");
        first
    }

    /// All points, and nothing to be told but the sandbox.
    #[track_caller]
    fn is_full(&self) {
        assert!(self.max > 0.0 && self.score == self.max, "{:#}", self.all);
        self.sandbox();
        assert_eq!(self.problems.len(), 1, "{:#?}", self.problems);
    }
}

#[test]
fn files_in_the_folder_for_output_are_marked_and_what_was_handed_in_is_not() {
    if !is_found("python3", true) {
        return;
    }
    let source = fs::read_to_string(lesson("solutions/python/tracer.py")).expect("there");
    let handed = Handed::python(&source);
    // Whoever prints nothing has nothing, whatever lies beside the program.
    fs::write(
        handed.path("alice/triangle.ndjson"),
        r#"{"pixel":[3,5],"kind":"I","outcome":"miss"}"#,
    )
    .expect("written");
    let silent = handed.graded("true", &[]);
    assert_eq!(silent.score, 0.0, "{:#}", silent.all);
    let script = "sh -c 'python3 a.py {flat} {width} {height} {pixels} > {out}/hits.ndjson'";
    let written = handed.graded(script, &[]);
    // Both scenes write a file of this name: the trees are of the scene that their own word tells.
    assert_eq!(
        written.all["checks"][1]["score"],
        written.all["checks"][1]["max"]
    );
}

#[test]
fn an_endless_loop_ends_at_the_time_limit_and_is_not_tried_for_every_pixel() {
    if is_found("python3", true) {
        let handed = Handed::python("while True: pass");
        let graded = handed.graded(A_PIXEL, &["--time", "1"]);
        graded.tells("triangle at 3,5: ended at the time limit of 1 s");
        graded.tells("reached the time limit 3 times: it is not run further");
        // Six pixels, each with 10 s, were a minute.
        assert!(graded.took < Duration::from_secs(20), "{:?}", graded.took);
        assert_eq!(graded.score, 0.0);
    }
}

#[test]
fn output_without_end_is_cut() {
    if is_found("python3", true) {
        let handed = Handed::python("while True: print('x' * 60000, flush=True)");
        let graded = handed.graded(A_SCENE, &[]);
        graded.tells("triangle: ended after 64 MiB of output");
        assert_eq!(graded.score, 0.0);
    }
}

#[test]
fn memory_is_limited() {
    if is_found("python3", true) {
        let handed = Handed::python("a = bytearray(600 << 20)\nprint('no', file=1 / 0)");
        handed
            .graded(A_SCENE, &["--memory", "500"])
            .tells("MemoryError");
        handed
            .graded(A_SCENE, &["--memory", "0"])
            .tells("ZeroDivisionError");
    }
}

#[test]
fn what_stays_behind_is_ended() {
    if !is_found("python3", true) {
        return;
    }
    let written = tempfile::NamedTempFile::new().expect("a file");
    let program = |first: &str| {
        let path = written.path().display();
        format!(
            "import os, time\n\
             if os.fork() == 0:\n    {first}\n    while True:\n        open('{path}', 'a').write('x'); time.sleep(0.02)\n\
             time.sleep(0.4)"
        )
    };
    let length = || fs::metadata(written.path()).expect("there").len();
    let is_still = || {
        let before = length();
        std::thread::sleep(Duration::from_millis(500));
        assert_eq!(length(), before);
    };
    Handed::python(&program("pass")).graded(A_SCENE, &["--wrap", ""]);
    assert!(length() > 0);
    is_still();
    // A sandbox with processes of its own ends also those that leave the group.
    let before = length();
    let sandboxed = Handed::python(&program("os.setsid()")).graded(A_SCENE, &[]);
    if sandboxed.sandbox().contains("processes end") {
        assert!(length() > before);
        is_still();
    } else {
        eprintln!("skipped: {}", sandboxed.sandbox());
    }
}

#[test]
fn nothing_waits_for_a_process_that_keeps_the_output_open() {
    if is_found("python3", true) {
        let program = "import os, time\nif os.fork() == 0:\n    os.setsid(); time.sleep(30)";
        let graded = Handed::python(program).graded(A_SCENE, &["--wrap", ""]);
        assert!(graded.took < Duration::from_secs(20), "{:?}", graded.took);
        assert!(graded.sandbox().contains("none (as asked)"));
    }
}

#[test]
fn what_it_says_when_it_fails_is_shown_escaped() {
    if is_found("python3", true) {
        let program = "import sys\nprint('\\x1b[2J\\u202egone', file=sys.stderr)\nsys.exit(1)";
        let graded = Handed::python(program).graded(A_SCENE, &[]);
        graded.tells("triangle: exit status 1: \\u{1b}[2J\\u{202e}gone");
        Handed::python("")
            .graded("./nothing", &[])
            .tells("exit status 127");
    }
}

#[test]
fn it_has_no_input_no_environment_and_no_terminal() {
    if is_found("python3", true) {
        let program = "import os, sys\n\
                       try: tty = os.open('/dev/tty', os.O_RDWR)\n\
                       except OSError: tty = None\n\
                       sys.exit(f'{sys.stdin.read()!r} {tty} {os.environ.get(\"RAYTREE_SECRET\")} '\n\
                       f'{os.environ[\"HOME\"] == os.getcwd()}')";
        let graded = Handed::python(program).graded(A_SCENE, &[]);
        graded.tells("exit status 1: '' None None True");
    }
}

#[test]
fn the_network_is_refused() {
    if !is_found("python3", true) {
        return;
    }
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("bound").port();
    let program = format!(
        "import socket, sys\n\
         try: socket.create_connection(('127.0.0.1', {port}), 2)\n\
         except OSError: sys.exit(5)\n\
         sys.exit(6)"
    );
    let handed = Handed::python(&program);
    handed
        .graded(A_SCENE, &["--wrap", ""])
        .tells("triangle: exit status 6");
    let graded = handed.graded(A_SCENE, &[]);
    if graded.sandbox().contains("no network") {
        graded.tells("triangle: exit status 5");
    } else {
        eprintln!("skipped: {}", graded.sandbox());
    }
}

#[test]
fn hidden_pixels_are_asked_last_and_nothing_said_there_is_shown() {
    if !is_found("python3", true) {
        return;
    }
    let program = "import sys\n\
                   pixels = open(sys.argv[4]).read().split()\n\
                   print('{\"pixel\": [1, 1], \"at-' + '-'.join(pixels) + '\": 1}')\n\
                   sys.exit(' '.join(pixels))";
    let graded = Handed::python(program).graded(A_SCENE, &[]);
    graded.tells("hits: exit status 1: 188 95 200 130 75 150");
    graded.tells("at-188-95-200-130-75-150");
    // The pixel that a visible check asks as well is not asked again.
    assert_eq!(
        graded
            .problems
            .iter()
            .filter(|p| p.contains("hits, hidden pixels: exit status 1"))
            .count(),
        1
    );
    graded.tells("hidden pixels: 1 problem in what was printed");
    for problem in &graded.problems {
        assert!(!problem.contains("105"), "{problem}");
    }
}

#[test]
fn a_command_that_cannot_be_meant_is_refused() {
    let handed = Handed::python("");
    for (command, words) in [
        (
            "python3 a.py {pixel}",
            "`{pixel}` in the command is unknown",
        ),
        ("python3 'a.py", "has no end"),
        ("a {x} {y} {pixels}", "both"),
    ] {
        let ran = Command::new(env!("CARGO_BIN_EXE_raytree"))
            .arg("grade")
            .args([handed.path("task.toml"), handed.path("alice")])
            .args(["--run", command])
            .output()
            .expect("runs");
        let said = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{said}");
    }
}
