//! The book tells the truth: its tables are made from the program, its links lead somewhere, its pictures are what the
//! program draws. `RAYTREE_BOOK=1 cargo test --test it book` makes the tables anew.

mod commands;
mod course_format;
mod examples;
mod links;
mod made;
mod mistakes;
mod pictures;
mod scene_format;
mod schema;
mod tree_format;

use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the pages.
fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src")
}

/// The text of a page.
fn page(name: &str) -> String {
    let path = source().join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// What the program prints.
fn printed(args: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(args)
        .output();
    let output = output.expect("it runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{args:?}: {errors}");
    String::from_utf8(output.stdout).expect("UTF-8")
}
