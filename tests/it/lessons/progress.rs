//! Progress: nothing of it is ever lost, whatever happens to its file or to the program.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

fn lesson(state: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.arg("lesson").arg("--state").arg(state);
    command
}

/// Runs and gives the status, standard output and standard error.
fn ran(command: &mut Command) -> (Option<i32>, String, String) {
    let output = command.output().expect("runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

/// Takes the next hint of the first exercise: the cheapest change of progress.
fn hint(state: &Path) -> (Option<i32>, String, String) {
    ran(lesson(state).args(["hint", "first-ray"]))
}

fn hints(state: &Path) -> u64 {
    let text = fs::read_to_string(state).expect("a file");
    let progress: Value = serde_json::from_str(&text).expect("JSON, whole");
    progress["exercises"]["first-ray"]["hints"]
        .as_u64()
        .unwrap_or(0)
}

#[test]
fn a_broken_or_foreign_file_is_put_aside() {
    for (text, what) in [
        (
            "{\"format\": \"raytree-progress/1\", \"cou",
            "cannot be read",
        ),
        ("", "cannot be read"),
        (
            "{\"format\": \"raytree-progress/1\", \"course\": \"other\"}",
            "another course",
        ),
        (
            "{\"format\": \"raytree-progress/9\", \"course\": \"raytree\"}",
            "another course",
        ),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let state = folder.path().join("p.json");
        fs::write(&state, text).expect("room");
        let (code, _, told) = hint(&state);
        assert_eq!(code, Some(0), "{told}");
        assert!(
            told.contains(what) && told.contains("p.json.broken"),
            "{told}"
        );
        assert_eq!(
            fs::read_to_string(folder.path().join("p.json.broken"))
                .ok()
                .as_deref(),
            Some(text)
        );
        assert_eq!(hints(&state), 1);
        // A second one does not replace the first.
        fs::write(&state, "again").expect("room");
        hint(&state);
        assert_eq!(
            fs::read_to_string(folder.path().join("p.json.broken"))
                .ok()
                .as_deref(),
            Some(text)
        );
        assert_eq!(
            fs::read_to_string(folder.path().join("p.json.broken2"))
                .ok()
                .as_deref(),
            Some("again")
        );
    }
}

#[test]
fn what_another_version_of_the_course_knows_is_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("p.json");
    let text = r#"{"format":"raytree-progress/1","course":"raytree","exercises":{"gone":{"done":true,"tries":3}},"chapter":""}"#;
    fs::write(&state, text).expect("room");
    assert_eq!(hint(&state).0, Some(0));
    let now: Value =
        serde_json::from_str(&fs::read_to_string(&state).expect("a file")).expect("JSON");
    assert_eq!(now["exercises"]["gone"]["tries"], 3);
}

/// In a folder that is no folder, and where the disk is full: one warning, and it goes on.
#[test]
fn where_nothing_can_be_written_it_goes_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    fs::write(&file, "").expect("room");
    let (code, said, told) = hint(&file.join("p.json"));
    assert_eq!(code, Some(0), "{told}");
    assert!(said.contains("hint 1 of 3"), "{said}");
    assert_eq!(told.matches("cannot be kept").count(), 1, "{told}");
    assert!(told.lines().count() == 1, "{told}");
}

/// A disk without room, by a limit on the size of files.
#[cfg(unix)]
#[test]
fn a_full_disk_loses_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("p.json");
    assert_eq!(hint(&state).0, Some(0));
    let before = fs::read(&state).expect("a file");
    let script = format!(
        "trap '' XFSZ; ulimit -f 0; exec {} lesson --state {} hint first-ray",
        env!("CARGO_BIN_EXE_raytree"),
        state.display()
    );
    let (code, said, told) = ran(Command::new("sh").args(["-c", &script]));
    assert_eq!(code, Some(0), "{told}");
    assert!(said.contains("hint 2 of 3"), "{said}");
    assert!(told.contains("cannot be kept"), "{told}");
    assert_eq!(fs::read(&state).expect("a file"), before);
    assert_eq!(hint(&state).0, Some(0));
    assert_eq!(hints(&state), 2);
}

/// A home without permission to write: as any other user would have it.
#[cfg(unix)]
#[test]
fn a_home_that_cannot_be_written_is_told_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let home = folder.path().join("home");
    fs::write(&home, "no folder").expect("room");
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(["lesson", "hint", "first-ray"]);
    command
        .env("HOME", &home)
        .env_remove("XDG_STATE_HOME")
        .env("LANG", "C");
    let (code, said, told) = ran(&mut command);
    assert!(
        code == Some(0) && said.contains("hint 1 of 3"),
        "{said}{told}"
    );
    assert!(told.contains("cannot be kept"), "{told}");
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(["lesson", "hint", "first-ray"]);
    command.env_remove("HOME").env_remove("XDG_STATE_HOME");
    let (code, _, told) = ran(&mut command);
    assert!(code == Some(0) && told.contains("--state FILE"), "{told}");
    // The usual place.
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command
        .args(["lesson", "hint", "first-ray"])
        .env("XDG_STATE_HOME", folder.path());
    assert_eq!(ran(&mut command).0, Some(0));
    assert_eq!(hints(&folder.path().join("raytree/raytree.json")), 1);
}

/// Killed at 100 random moments while it changes its progress: the file is whole each time, and never older than what was told.
#[cfg(unix)]
#[test]
fn a_killed_program_loses_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("p.json");
    assert_eq!(hint(&state).0, Some(0));
    let took = {
        let start = Instant::now();
        assert!(ran(lesson(&state).args(["reset", "first-ray", "--yes"])).0 == Some(0));
        start.elapsed()
    };
    let mut random = crate::random::Random(20_261_130);
    let (mut killed, mut known) = (0, 0);
    for _ in 0..100 {
        let mut child = lesson(&state)
            .args(["answer", "first-ray", "77"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("runs");
        let wait = took.mul_f64(1.5 * random.share());
        std::thread::sleep(wait.min(Duration::from_millis(400)));
        if child.kill().is_ok() {
            killed += 1;
        }
        let status = child.wait().expect("ended");
        let text = fs::read_to_string(&state).expect("a file");
        let progress: Value = serde_json::from_str(&text).expect("JSON, whole");
        let tries = progress["exercises"]["first-ray"]["tries"]
            .as_u64()
            .unwrap_or(0);
        // What was answered by one that ended by itself is there.
        let least = known + u64::from(status.code() == Some(4));
        assert!(tries >= least, "{tries} of {least}");
        known = tries;
    }
    assert!(killed > 10, "{killed}");
    let names = fs::read_dir(folder.path()).expect("a folder").count();
    assert!(names <= 3, "{names} files are left");
}
