//! `raytree lesson watch`: what is saved is checked within a second, on a terminal and in a pipe.
#![cfg(unix)]

use std::fs;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use portable_pty::CommandBuilder;

use crate::hello::is_found;
use crate::tui::Session;

/// How long anything may take before a test gives up.
const PATIENCE: Duration = Duration::from_secs(60);

/// An exercise that changes a scene, and its file below the folder of work.
const CHANGE: &str = "free-the-floor";
const SCENE: &str = "09-shadows/free-the-floor.json";

/// An exercise that is a program, how one is run, and one that is right.
const PROGRAM: &str = "write-rays";
const RUN: &str = "python3 tracer.py {flat} {width} {height} {pixels}";
const RIGHT: &str = r#"
import json, sys
flat, width, height, pixels = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
cam = json.load(open(flat))["camera"]
for line in open(pixels):
    x, y = map(int, line.split())
    right = (2 * (x + 0.5) / width - 1) * cam["half_height"] * width / height
    up = (1 - 2 * (y + 0.5) / height) * cam["half_height"]
    d = [right * u + up * v - w for u, v, w in zip(cam["u"], cam["v"], cam["w"])]
    size = sum(c * c for c in d) ** 0.5
    root = {"kind": "I", "origin": cam["eye"], "direction": [c / size for c in d]}
    print(json.dumps({"pixel": {"x": x, "y": y}, "root": root}))
"#;

/// `raytree` in the folder of work; progress is kept beside it.
fn raytree(args: &[&str], folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(args).current_dir(folder);
    command.arg("--state").arg(progress(folder));
    command
}

fn progress(folder: &Path) -> PathBuf {
    folder.with_extension("progress")
}

/// A folder with the files of all exercises.
fn work() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let ran = raytree(&["lesson", "start", "."], folder.path()).output();
    let ran = ran.expect("runs");
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
    folder
}

/// What watches, and the lines that it prints.
struct Watching {
    child: Child,
    lines: Receiver<String>,
}

impl Watching {
    fn start(args: &[&str], folder: &Path) -> Self {
        let mut command = raytree(&[&["lesson", "watch"], args].concat(), folder);
        command.stdin(Stdio::null()).stdout(Stdio::piped());
        let mut child = command.spawn().expect("runs");
        let out = BufReader::new(child.stdout.take().expect("piped"));
        let (sender, lines) = channel();
        std::thread::spawn(move || {
            for line in out.lines().map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        Self { child, lines }
    }

    /// The lines up to one that has this in it.
    fn until(&self, part: &str) -> Vec<String> {
        let mut seen = Vec::new();
        loop {
            let line = self.lines.recv_timeout(PATIENCE);
            let line = line.unwrap_or_else(|_| panic!("never saw {part}: {seen:#?}"));
            let is_last = line.contains(part);
            seen.push(line);
            if is_last {
                return seen;
            }
        }
    }

    /// True if nothing is printed for so long.
    fn is_silent(&self, long: Duration) -> bool {
        self.lines.recv_timeout(long).is_err()
    }

    /// Ends it as a shell does, and gives its status.
    fn end(mut self) -> std::process::ExitStatus {
        let id = rustix::process::Pid::from_raw(self.child.id().cast_signed()).expect("a process");
        rustix::process::kill_process(id, rustix::process::Signal::TERM).expect("it is there");
        self.child.wait().expect("a status")
    }
}

#[test]
fn a_scene_is_checked_once_for_each_change_until_it_is_done() {
    let folder = work();
    let scene = folder.path().join(SCENE);
    let start = fs::read_to_string(&scene).expect("the scene");
    let watching = Watching::start(&[CHANGE], folder.path());
    let first = watching.until("raytree view").join("\n");
    assert!(first.contains("chapter 9, Shadows") && first.contains("not all goals hold yet"));
    // The line opens the changed scene at the goal, with the features of the chapter.
    assert!(
        first.contains(SCENE) && first.contains("--at 100,160/L:lamp"),
        "{first}"
    );
    assert!(watching.is_silent(Duration::from_millis(900)));
    // A file that is broken is told, and so is one that is whole again.
    fs::write(&scene, "{").expect("written");
    watching.until("chapter 9");
    let broken = watching.until("cut off").join("\n");
    assert!(!broken.contains("goals"), "{broken}");
    fs::write(&scene, &start).expect("written");
    watching.until("not all goals hold yet");
    watching.until("raytree view");
    let mut file: serde_json::Value = serde_json::from_str(&start).expect("JSON");
    let lights = file["lights"].as_array_mut().expect("lights");
    let lamp = lights
        .iter_mut()
        .find(|light| light["point"]["name"] == "lamp")
        .expect("the lamp");
    lamp["point"]["position"] = serde_json::json!([0, 4, 3]);
    fs::write(&scene, file.to_string()).expect("written");
    let done = watching.until("done").join("\n");
    assert!(done.contains("all goals hold: right"), "{done}");
    assert!(!watching.end().success());
    // It is kept: one try, those on the way were none.
    let kept = fs::read_to_string(progress(folder.path())).expect("progress");
    let kept: serde_json::Value = serde_json::from_str(&kept).expect("JSON");
    let of = &kept["exercises"][CHANGE];
    assert_eq!(
        (&of["done"], &of["tries"]),
        (&true.into(), &1.into()),
        "{kept}"
    );
}

#[test]
fn a_program_is_run_again_and_marked_within_a_second() {
    if !is_found("python3", true) {
        return;
    }
    let folder = work();
    let program = folder.path().join("tracer.py");
    let wrong = RIGHT.replace(
        "(1 - 2 * (y + 0.5) / height)",
        "(2 * (y + 0.5) / height - 1)",
    );
    assert_ne!(wrong, RIGHT);
    fs::write(&program, &wrong).expect("written");
    let watching = Watching::start(&[PROGRAM, "--run", RUN], folder.path());
    let first = watching.until("raytree view").join("\n");
    assert!(
        first.contains("eye-rays") && first.contains("rows-from-bottom"),
        "{first}"
    );
    let saved = Instant::now();
    fs::write(&program, RIGHT).expect("written");
    let done = watching.until("done").join("\n");
    let took = saved.elapsed();
    assert!(done.contains("4 of 4 (100 %)"), "{done}");
    // In a program that is optimised; here the machine may be busy with other tests.
    let most = if cfg!(debug_assertions) { 10 } else { 1 };
    assert!(took < Duration::from_secs(most), "{took:?}");
    watching.end();
}

#[test]
fn what_cannot_be_watched_says_why() {
    let folder = tempfile::tempdir().expect("a folder");
    for (args, status, words) in [
        (vec!["who-blocks"], 2, "lesson run who-blocks"),
        (vec![PROGRAM], 2, "--run 'python3"),
        (vec!["no-such"], 2, "there is no exercise"),
    ] {
        let ran = raytree(
            &[&["lesson", "watch"], args.as_slice()].concat(),
            folder.path(),
        );
        let ran = { ran }.output().expect("runs");
        let told = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(status), "{told}");
        assert!(told.contains(words), "{told}");
    }
    // A file that is not there is waited for.
    let watching = Watching::start(&[CHANGE], folder.path());
    watching.until("raytree lesson start");
    let path = folder.path().join(SCENE);
    fs::create_dir_all(path.parent().expect("a folder")).expect("made");
    fs::copy(work().path().join(SCENE), &path).expect("copied");
    watching.until("not all goals hold yet");
    watching.end();
}

#[test]
fn on_a_terminal_keys_ask_for_hints_the_next_one_once_more_and_the_end() {
    let folder = work();
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(["lesson", "watch", CHANGE, "--state"]);
    command.arg(progress(folder.path()));
    command.cwd(folder.path());
    let mut session = Session::start(command);
    session.wait_for("q quit");
    assert!(
        session.text().contains("hint (0 of 3)"),
        "{}",
        session.text()
    );
    session.keys("h");
    session.wait_for("hint 1 of 3:");
    session.keys("r");
    session.wait_for("hint (1 of 3)");
    session.keys("n");
    session.wait("another exercise", |screen| {
        let text = screen.contents();
        text.contains("q quit") && !text.contains(CHANGE)
    });
    session.keys("q");
    assert_eq!(session.end(), 0);
}
