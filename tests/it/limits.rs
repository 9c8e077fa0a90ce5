//! Every limit is reached: what is just within it is accepted, one more is refused with one message that tells the limit.

mod files;
mod runs;

use std::fmt::Write;

use raytree::grade::submission;
use raytree::probe::{Event, Probe};
use raytree::scene::limits::{MAX_EVENT_BYTES, MAX_EVENTS, table};
use raytree::scene::{Scene, load_from_memory};
use raytree::trace::Recorder;
use raytree::trace::read::limits as trees;

const CAMERA: &str =
    r#""format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;

fn read(name: &str, files: &[(&str, &str)]) -> Result<Scene, String> {
    let held = files
        .iter()
        .map(|(name, text)| ((*name).to_string(), text.as_bytes().to_vec()));
    load_from_memory(name, held.collect()).map_err(|e| e.to_string())
}

/// A scene with these fields beside format and camera, and a material `a`.
fn scene(fields: &str) -> Result<Scene, String> {
    let text = format!("{{{CAMERA}, \"materials\": {{\"a\": {{}}}}, {fields}}}");
    read("a.json", &[("a.json", &text)])
}

/// The first is accepted, the second refused in two lines that have these words.
#[track_caller]
fn limit(within: Result<Scene, String>, beyond: Result<Scene, String>, words: &[&str]) {
    if let Err(said) = within {
        panic!("within the limit: {said}");
    }
    let said = beyond.expect_err("beyond the limit");
    assert_eq!(said.lines().count(), 2, "{said}");
    for word in words {
        assert!(said.contains(word), "`{word}` is not in:\n{said}");
    }
}

#[test]
fn the_book_shows_the_limits_as_they_are() {
    shows("limits.md", table());
    let handed_in = [trees::table(), submission::limits::table()].concat();
    shows("handing-in.md", handed_in);
}

/// A chapter shows these limits.
fn shows(chapter: &str, limits: Vec<[String; 3]>) {
    let mut rows = String::from("| what | at most | beyond |\n|---|---|---|\n");
    for [what, most, beyond] in limits {
        let _ = writeln!(rows, "| {what} | {most} | {beyond} |");
    }
    let path = format!("{}/book/src/{chapter}", env!("CARGO_MANIFEST_DIR"));
    let book = std::fs::read_to_string(&path).expect("the chapter");
    let start = book.find("| what |").expect("the table");
    let end = start
        + book[start..]
            .find("\n\n")
            .map_or(book.len() - start, |end| end + 1);
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        let new = format!("{}{rows}{}", &book[..start], &book[end..]);
        return std::fs::write(path, new).expect("the chapter is written");
    }
    assert_eq!(
        &book[start..end],
        rows,
        "write it anew: RAYTREE_BOOK=1 cargo test --test it limits"
    );
}

#[test]
fn a_recording_keeps_what_there_is_room_for() {
    // The real limit is reached below.
    let mut recorder = Recorder::<true>::with_limit(1000);
    (0..1003).for_each(|_| recorder.event(Event::Miss));
    assert_eq!((recorder.events.len(), recorder.dropped), (1000, 3));
    const {
        assert!(
            MAX_EVENTS * size_of::<Event>() >= MAX_EVENT_BYTES,
            "the bytes decide"
        );
    };
}
