//! The rules of the house: each gives a line for everything that breaks it.

use std::collections::{BTreeMap, BTreeSet};

use super::house::{File, House, items};
use super::lexer::{Token, closing, code};
use super::uses::paths;

/// From the ground up: a file may use its own layer and those before it.
pub const LAYERS: [&str; 17] = [
    "math", "sampling", "geometry", "probe", "accel", "shading", "scene", "world", "tracer",
    "trace", "reduce", "lab", "debug", "grade", "lesson", "cli", "tui",
];

/// The faces: only they may talk to a user. Each may use all the rest.
pub const FACES: [&str; 2] = ["cli", "tui"];

/// The one file that may be `unsafe`: it calls what was compiled for the instructions that it found.
const UNSAFE: &str = "accel/fast/simd/x86.rs";

/// A file of more lines holds more than one concept.
const LONGEST_FILE: usize = 400;

/// A function of more lines of code does more than one thing.
const LONGEST_FUNCTION: usize = 70;

/// Type names that stand for two things in two layers: those of `cli` are commands, by the names that users type; an end
/// of a ray and one of a case, a pixel's curve and a search, a part of the film and one of a strip never meet.
const TWICE: [&str; 5] = ["Convergence", "Effects", "Outcome", "Tile", "View"];

fn rank(layer: &str) -> Option<usize> {
    LAYERS.iter().position(|l| *l == layer)
}

/// What stands outside of a layer, or uses one above its own.
pub fn layers(house: &House) -> Vec<String> {
    let mut broken = Vec::new();
    for file in &house.files {
        let layer = file.layer();
        let Some(own) = rank(layer) else {
            if !file.module.is_empty() {
                broken.push(format!("{}: belongs to no layer", file.name));
            }
            continue;
        };
        let inline = paths(&file.code());
        let imported = file.uses.iter().map(|u| &u.path);
        let used: BTreeSet<String> = imported
            .chain(inline.iter().filter(|p| p.len() > 1))
            .filter_map(|path| House::absolute(file, path)?.first().cloned())
            .collect();
        for other in used {
            if rank(&other).is_some_and(|o| o > own) && !FACES.contains(&layer) {
                broken.push(format!(
                    "{}: uses `{other}`, which stands above it",
                    file.name
                ));
            }
        }
    }
    broken
}

/// Layers that are left by `super`, and imports of several layers in one line.
pub fn ways_out(house: &House) -> Vec<String> {
    let mut broken = Vec::new();
    for file in house.files.iter().filter(|f| !f.module.is_empty()) {
        let inline = paths(&file.code());
        let imported = file.uses.iter().map(|u| &u.path);
        for path in imported.chain(&inline) {
            let ups = path.iter().take_while(|name| *name == "super").count();
            if ups >= file.module.len() {
                let path = path.join("::");
                broken.push(format!(
                    "{}: `{path}` leaves the layer; write `crate::`",
                    file.name
                ));
            }
        }
        if file.text.contains("use crate::{") {
            broken.push(format!(
                "{}: name each layer in a line of its own",
                file.name
            ));
        }
    }
    broken
}

/// Files that do not say what they are, and long ones, of `src` and of others.
pub fn long_files<'f>(files: impl Iterator<Item = (&'f str, &'f str)>) -> Vec<String> {
    let mut broken = Vec::new();
    for (name, text) in files {
        if !text.starts_with("//! ") {
            broken.push(format!("{name}: begins with `//! ` and what it is"));
        }
        let lines = text.lines().count();
        if lines > LONGEST_FILE {
            broken.push(format!("{name}: has {lines} lines, {LONGEST_FILE} at most"));
        }
    }
    broken
}

/// Functions of too many lines of code.
pub fn long_functions(house: &House) -> Vec<String> {
    let mut broken = Vec::new();
    for file in &house.files {
        let tokens = code(&file.text);
        for at in 0..tokens.len() {
            let Some((name, lines)) = function(&tokens, at) else {
                continue;
            };
            if lines > LONGEST_FUNCTION {
                broken.push(format!(
                    "{}:{}: `{name}` has {lines} lines of code, {LONGEST_FUNCTION} at most",
                    file.name, tokens[at].line
                ));
            }
        }
    }
    broken
}

/// The name of the function that begins here, and how many lines have any of its code.
fn function<'t>(tokens: &[Token<'t>], at: usize) -> Option<(&'t str, usize)> {
    let name = tokens.get(at + 1).filter(|_| tokens[at].text == "fn")?;
    let signature = tokens[at..].iter().take_while(|t| t.text != ";");
    let open = at + signature.take_while(|t| t.text != "{").count();
    if tokens.get(open)?.text != "{" || !name.text.starts_with(|c: char| c.is_alphabetic()) {
        return None;
    }
    let end = closing(tokens, open);
    let lines: BTreeSet<usize> = tokens[at..=end].iter().map(|t| t.line).collect();
    Some((name.text, lines.len()))
}

/// Names of two types in two layers, both of which other files see.
pub fn names_of_two(house: &House) -> Vec<String> {
    const TYPES: [&str; 5] = ["struct", "enum", "trait", "type", "union"];
    let mut files: BTreeMap<&str, Vec<&File>> = BTreeMap::new();
    for file in &house.files {
        let types = items(&file.code()).into_iter();
        for item in types.filter(|i| i.shared && TYPES.contains(&i.kind)) {
            files.entry(item.name).or_default().push(file);
        }
    }
    files.retain(|name, files| {
        files.iter().any(|f| f.layer() != files[0].layer()) && !TWICE.contains(name)
    });
    let line = |(name, files): (&&str, &Vec<&File>)| {
        let files: Vec<&str> = files.iter().map(|f| f.name.as_str()).collect();
        format!("`{name}` is a type in {}", files.join(" and in "))
    };
    files.iter().map(line).collect()
}

/// Comments that say only what they resemble.
pub fn empty_comments(house: &House) -> Vec<String> {
    let mut broken = Vec::new();
    for file in &house.files {
        let mut inside = false;
        for (at, line) in (1..).zip(file.text.lines().map(str::trim)) {
            let comment = line.starts_with("///") || line.starts_with("//!");
            let words = line.trim_start_matches(['/', '!', ' ']);
            if comment && !inside && words.starts_with("The same") {
                broken.push(format!("{}:{at}: begins with `The same`", file.name));
            }
            inside = comment;
        }
    }
    broken
}

/// Who prints, exits, is unfinished or `unsafe` without leave.
pub fn manners(house: &House) -> Vec<String> {
    let mut broken = Vec::new();
    for file in &house.files {
        let face = FACES.contains(&file.layer());
        let tokens = code(&file.text);
        for pair in tokens.windows(2) {
            let (word, next) = (pair[0].text, pair[1].text);
            let bad = match (word, next) {
                ("println" | "print" | "eprintln" | "eprint" | "dbg", "!") => !face,
                ("todo" | "unimplemented", "!") => true,
                ("unsafe", "{") => file.name != UNSAFE,
                ("process", "::") => tokens
                    .iter()
                    .any(|t| t.text == "exit" && t.line == pair[0].line),
                _ => false,
            };
            if bad {
                broken.push(format!("{}:{}: uses {word}", file.name, pair[0].line));
            }
        }
    }
    broken
}

/// Calls of `Probe::event` that builds for counting cannot leave out.
pub fn told_directly(house: &House) -> Vec<String> {
    let mut broken = Vec::new();
    let traced = |layer| ["accel", "shading", "world", "tracer"].contains(&layer);
    for file in house.files.iter().filter(|f| traced(f.layer())) {
        for call in code(&file.text).windows(3) {
            if [".", "event", "("] == [call[0].text, call[1].text, call[2].text] {
                let line = call[1].line;
                broken.push(format!("{}:{line}: write `tell!(probe, ..)`", file.name));
            }
        }
    }
    broken
}
