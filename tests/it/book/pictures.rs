//! The pictures of the book are what the program draws: each PNG stands beside its command, each screen is the real one.

use std::path::Path;

use super::{page, source};

#[allow(dead_code)] // Its `main` writes the files.
#[path = "../../../examples/screens.rs"]
mod screens;

/// The commands of the pages that draw pictures of the book.
fn commands() -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(source()).expect("the pages") {
        let name = entry
            .expect("an entry")
            .file_name()
            .to_string_lossy()
            .into_owned();
        if std::path::Path::new(&name).extension() != Some("md".as_ref()) {
            continue;
        }
        let text = page(&name);
        let pieces = text
            .split('`')
            .filter(|piece| piece.starts_with("raytree render ") && !piece.contains('\n'));
        for piece in pieces {
            if let Some((command, file)) = piece.split_once(" -o book/src/pictures/") {
                found.push((command.to_owned(), file.to_owned()));
            }
        }
    }
    found
}

#[test]
fn every_picture_is_what_its_command_draws() {
    let commands = commands();
    let folder = tempfile::tempdir().expect("a folder");
    for entry in std::fs::read_dir(source().join("pictures")).expect("the pictures") {
        let name = entry
            .expect("an entry")
            .file_name()
            .to_string_lossy()
            .into_owned();
        if std::path::Path::new(&name).extension() != Some("png".as_ref()) {
            let shot = name
                .strip_suffix(".svg")
                .is_some_and(|name| screens::SHOTS.iter().any(|shot| shot.name == name));
            assert!(shot, "{name}: nothing draws it");
            continue;
        }
        let (command, _) = commands
            .iter()
            .find(|(_, file)| *file == name)
            .unwrap_or_else(|| panic!("{name}: no command draws it"));
        let drawn = folder.path().join(&name);
        let mut words: Vec<&str> = command.split(' ').skip(1).collect();
        words.extend(["-q", "-o", drawn.to_str().expect("a plain path")]);
        super::printed(&words);
        let same = std::fs::read(&drawn).expect("drawn")
            == std::fs::read(source().join("pictures").join(&name)).expect("a file");
        assert!(same, "{name} is not what `{command}` draws");
    }
}

#[test]
#[cfg(unix)]
fn every_screen_can_be_drawn() {
    for shot in &screens::SHOTS {
        let path = source().join(format!("pictures/{}.svg", shot.name));
        let kept = std::fs::read_to_string(&path).expect("the picture");
        let now = shot
            .drawn_as(Path::new(env!("CARGO_BIN_EXE_raytree")), &kept)
            .expect("a terminal");
        // Cells change with every number; what is drawn must be a whole screen.
        let texts = |svg: &str| svg.matches("<text").count();
        assert!(
            2 * texts(&now) > texts(&kept) && texts(&now) > 10,
            "{} draws no screen: cargo build --release && cargo run --release --example screens",
            shot.name
        );
    }
}
