//! The chapter "Grade on Monday" of the book: what its blocks show is what the program prints.
//!
//! With `RAYTREE_BOOK=1` the blocks are made anew.

use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

use raytree::accel::AccelKind;
use raytree::grade::task::Task;
use raytree::scene::{Bend, Bends, load};
use raytree::trace::export::json;
use raytree::trace::{View, document, trace_pixel_here};
use raytree::tracer::thread_pool;
use raytree::world::World;
use zip::write::SimpleFileOptions;

use super::flat::lesson;
use super::hello::is_found;

const CHAPTER: &str = "book/src/monday.md";

/// The ray trees that a tracer with these bends prints of a scene of the task "Hits", a line a pixel.
fn trees(scene: &str, bends: Bends) -> Vec<u8> {
    let path = lesson("tasks/hits.toml");
    let task = thread_pool::install(0, || Task::load(path.to_str().expect("UTF-8")));
    let task = task.expect("a task");
    let of = task.scenes.iter().find(|s| s.label.starts_with(scene));
    let of = of.expect("it is asked");
    let world = World::new(load(&of.path).expect("there"), AccelKind::List);
    let settings = of.settings.with(|s| s.bends = bends);
    let mut out = Vec::new();
    for line in task.asked_pixels() {
        let words: Vec<&str> = line.split_whitespace().collect();
        if words[0] != scene {
            continue;
        }
        let at = [1, 2].map(|i| words[i].parse().expect("a number"));
        let trace = trace_pixel_here(&world, &settings, at.into(), false);
        let mut text = Vec::new();
        let document = document::of(View {
            world: &world,
            settings: &settings,
            trace: &trace,
        });
        json::write(&mut text, &document).expect("a buffer takes everything");
        let value: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
        writeln!(out, "{value}").expect("a buffer takes everything");
    }
    out
}

/// What is in the folder when the chapter begins.
fn prepare(folder: &Path) {
    let handed_in = folder.join("handed-in");
    fs::create_dir(&handed_in).expect("made");
    let far_root = Bend::FarRoot.into();
    for (student, bends) in [("ann", Bends::default()), ("ben", far_root)] {
        let file = fs::File::create(handed_in.join(format!("{student}.zip"))).expect("made");
        let mut zip = zip::ZipWriter::new(file);
        for scene in ["hits", "triangle"] {
            let name = format!("{scene}.ndjson");
            let options = SimpleFileOptions::default();
            zip.start_file(name, options).expect("begun");
            zip.write_all(&trees(scene, bends)).expect("written");
        }
        zip.finish().expect("whole");
    }
    let whole = trees("hits", Bends::default());
    fs::write(handed_in.join("cem.ndjson"), &whole[..whole.len() / 3]).expect("written");
    fs::write(folder.join("ben.ndjson"), trees("hits", far_root)).expect("written");
    let course = "name,id\nAnn,ann\nBen,ben\nCem,cem\nDina,dina\n";
    fs::write(folder.join("course.csv"), course).expect("written");
    std::os::unix::fs::symlink(lesson(""), folder.join("lessons")).expect("made");
}

/// What a line prints in the folder.
fn printed(line: &str, folder: &Path) -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_raytree"));
    let path = std::env::var("PATH").unwrap_or_default();
    let bin = program.parent().expect("a folder").display();
    let output = Command::new("sh")
        .args(["-c", line])
        .current_dir(folder)
        .env("PATH", format!("{bin}:{path}"))
        .env("LC_ALL", "C")
        .output()
        .expect("runs");
    let printed = String::from_utf8([output.stdout, output.stderr].concat());
    // Tables for spreadsheets end their lines with CR LF.
    printed.expect("UTF-8").replace('\r', "")
}

#[test]
fn the_blocks_of_the_chapter_are_what_the_program_prints() {
    if !is_found("python3", true) {
        return;
    }
    let chapter = Path::new(env!("CARGO_MANIFEST_DIR")).join(CHAPTER);
    let text = fs::read_to_string(&chapter).expect("there");
    let folder = tempfile::tempdir().expect("a folder");
    prepare(folder.path());
    let (mut made, mut commands, mut in_block) = (String::new(), 0, false);
    for line in text.lines() {
        let is_output = in_block && !line.starts_with("$ ") && line != "```";
        if is_output {
            continue;
        }
        made += line;
        made += "\n";
        match line {
            "```console" => in_block = true,
            "```" => in_block = false,
            _ => {}
        }
        if let Some(command) = line.strip_prefix("$ ").filter(|_| in_block) {
            commands += 1;
            made += &printed(command, folder.path());
        }
    }
    assert!(commands >= 15, "{commands}");
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        fs::write(&chapter, &made).expect("written");
    }
    assert_eq!(text, made, "RAYTREE_BOOK=1 makes the blocks anew");
}
