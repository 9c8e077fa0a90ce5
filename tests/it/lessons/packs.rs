//! Courses of strangers: they are refused or read within limits, nothing of them is run, and no path leaves their folder.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use raytree::lesson::template::template;

use crate::cli::run;

/// The small course in a folder, changed.
fn folder(change: impl Fn(&Path)) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in template() {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("room");
        fs::write(path, text).expect("room");
    }
    change(folder.path());
    folder
}

fn zip(entries: &[(&str, &[u8])]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("pack.zip");
    let mut zip = zip::ZipWriter::new(fs::File::create(&path).expect("room"));
    for (name, bytes) in entries {
        let options = zip::write::SimpleFileOptions::default();
        zip.start_file(*name, options).expect("an entry");
        zip.write_all(bytes).expect("room");
    }
    zip.finish().expect("a zip");
    (folder, path)
}

/// One clear message with these words, quickly, and no panic.
#[track_caller]
fn is_refused(path: &Path, words: &[&str]) {
    let start = Instant::now();
    let path = path.to_string_lossy();
    for command in [&["list"][..], &["read", "1"], &["check"]] {
        let mut args = vec!["lesson", "--lessons", &path];
        args.extend(command);
        let ran = run(&args);
        let told = ran.err.clone() + &String::from_utf8_lossy(&ran.out);
        assert!(!told.contains("panicked"), "{told}");
        // What a chapter has inside shows when it is read.
        if ran.code == 0 && command[0] == "list" {
            continue;
        }
        assert!(matches!(ran.code, 1 | 4), "{args:?}: {} {told}", ran.code);
        assert!(
            words.iter().all(|word| told.contains(word)),
            "{args:?}: {told}"
        );
    }
    assert!(
        start.elapsed() < Duration::from_secs(20),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn a_pack_is_read_as_a_folder_and_as_a_zip() {
    let pack = folder(|_| ());
    let path = pack.path().to_string_lossy().into_owned();
    assert_eq!(run(&["lesson", "check", &path]).code, 0);
    let entries: Vec<(String, &[u8])> = template()
        .iter()
        .map(|(name, text)| (format!("my-course/{name}"), text.as_bytes()))
        .collect();
    let entries: Vec<(&str, &[u8])> = entries.iter().map(|(n, b)| (n.as_str(), *b)).collect();
    let (_folder, path) = zip(&entries);
    let path = path.to_string_lossy().into_owned();
    assert_eq!(run(&["lesson", "check", &path]).code, 0);
}

#[test]
fn packs_that_reach_out_are_refused() {
    for (scene, word) in [
        ("/etc/passwd", "course"),
        ("../../../../etc/passwd.json", "leads out of the course"),
        ("..\\\\..\\\\x.json", "leads out of the course"),
        ("C:/x.json", "leads out of the course"),
    ] {
        let pack = folder(|top| {
            let path = top.join("01-first/chapter.toml");
            let text = fs::read_to_string(&path).expect("a file");
            let text = text.replace("scene = \"scene.json\"", &format!("scene = \"{scene}\""));
            fs::write(path, text).expect("room");
        });
        is_refused(pack.path(), &[word]);
    }
    let (_folder, path) = zip(&[("../course.toml", b"x"), ("course.toml", b"")]);
    is_refused(&path, &["`..`"]);
    let (_folder, path) = zip(&[("/etc/course.toml", b"x")]);
    is_refused(&path, &["root"]);
}

/// Links are not followed.
#[cfg(unix)]
#[test]
fn a_link_in_a_pack_is_refused() {
    let pack = folder(|top| {
        let link = top.join("01-first/text.md");
        fs::remove_file(&link).expect("a file");
        std::os::unix::fs::symlink("/etc/passwd", link).expect("a link");
    });
    is_refused(pack.path(), &["link"]);
}

#[test]
fn packs_that_ask_for_too_much_are_refused() {
    let chapter = |from: &'static str, to: String| {
        folder(move |top| {
            let path = top.join("01-first/chapter.toml");
            let text = fs::read_to_string(&path).expect("a file");
            assert!(text.contains(from), "{from}");
            fs::write(path, text.replacen(from, &to, 1)).expect("room");
        })
    };
    let settings = |what: &str| {
        chapter(
            "scene = \"scene.json\"",
            format!("scene = \"scene.json\"\nsettings = {{ {what} }}"),
        )
    };
    is_refused(settings("size = \"60000x60000\"").path(), &["too large"]);
    let many = "[[exercise]]\nid = \"a\"\nkind = \"predict\"\nat = \"1,1.t\"\n".repeat(300);
    is_refused(
        chapter("[[exercise]]", many + "[[exercise]]").path(),
        &["exercises at most"],
    );
    let deep = format!("not {}", "(".repeat(20_000));
    is_refused(
        chapter("hits:floor and blocked:lamp", deep).path(),
        &["`where`"],
    );
    let huge = "x".repeat(3 << 20);
    let pack = folder(move |top| fs::write(top.join("01-first/text.md"), &huge).expect("room"));
    is_refused(pack.path(), &["1 MiB"]);
    let bomb = vec![b' '; 80 << 20];
    let (_folder, path) = zip(&[("course.toml", &bomb)]);
    is_refused(&path, &["course.toml"]);
    is_refused(
        Path::new("/dev/zero"),
        &["neither a folder nor a regular file"],
    );
    is_refused(Path::new("no-such-course"), &["no such file"]);
}

/// What a course says steers no terminal, and names no command that is run.
#[test]
fn texts_of_a_pack_are_shown_as_text() {
    let pack = folder(|top| {
        fs::write(
            top.join("01-first/text.md"),
            "# A\x1b[31mb\x07\n\n{{console touch pwned}}\n",
        )
        .expect("room");
    });
    is_refused(pack.path(), &["01-first"]);
    let pack = folder(|top| {
        let path = top.join("01-first/text.md");
        let text = fs::read_to_string(&path).expect("a file");
        fs::write(path, format!("{text}\nA \x1b[31mred\x1b[0m word.\n")).expect("room");
        let path = top.join("course.toml");
        let text = fs::read_to_string(&path).expect("a file");
        fs::write(path, text.replace("My course", "My\\u001b[2Jcourse")).expect("room");
    });
    let path = pack.path().to_string_lossy().into_owned();
    for command in [&["list"][..], &["read", "1"], &["report"]] {
        let state = pack.path().join("p.json").to_string_lossy().into_owned();
        let mut args = vec!["lesson", "--lessons", &path, "--state", &state];
        args.extend(command);
        let ran = run(&args);
        assert_eq!(ran.code, 0, "{}", ran.err);
        assert!(
            !ran.out.contains(&0x1b) && !ran.err.contains('\x1b'),
            "{command:?}"
        );
    }
}

/// `start` and `new` never replace what is there.
#[test]
fn files_of_the_student_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    let work = folder.path().join("work");
    let path = work.to_string_lossy().into_owned();
    let first = run(&["lesson", "start", &path]);
    assert_eq!(first.code, 0, "{}", first.err);
    let listed = String::from_utf8(first.out).expect("UTF-8");
    let one = listed
        .lines()
        .find(|line| Path::new(line).extension().is_some_and(|e| e == "json"))
        .expect("a file");
    fs::write(one, "mine").expect("room");
    let again = run(&["lesson", "start", &path]);
    assert_eq!(again.code, 0);
    assert_eq!(fs::read_to_string(one).ok().as_deref(), Some("mine"));
    assert!(String::from_utf8_lossy(&again.out).contains("stays as it is"));
    assert!(work.join("README.txt").is_file());
    let new = folder.path().join("new").to_string_lossy().into_owned();
    assert_eq!(run(&["lesson", "new", &new]).code, 0);
    assert_eq!(run(&["lesson", "new", &new]).code, 2);
    assert_eq!(run(&["lesson", "check", &new]).code, 0);
}
