//! The rules of the house, enforced, and that each of them can fail.

mod circles;
mod house;
mod lexer;
mod rules;
mod uses;

use std::fs;
use std::path::Path;

use house::{House, sources};

fn house() -> House {
    let house = House::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    assert!(house.files.len() > 30, "the house is here");
    house
}

/// A house of these files, by name and text.
fn made(files: &[(&str, &str)]) -> House {
    let owned = |(name, text): &(&str, &str)| ((*name).to_string(), (*text).to_string());
    House::of(files.iter().map(owned))
}

#[track_caller]
fn holds(broken: &[String]) {
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
}

/// Exactly one thing breaks the rule, in words that have these in them.
#[track_caller]
fn fails(broken: &[String], words: &str) {
    assert!(matches!(broken, [one] if one.contains(words)), "{broken:?}");
}

#[test]
fn a_layer_uses_only_those_below_it() {
    holds(&rules::layers(&house()));
}

#[test]
fn the_rule_of_layers_can_fail() {
    let uses = |text| rules::layers(&made(&[("probe.rs", text)]));
    fails(&uses("use crate::trace::tree;"), "`trace`");
    fails(&uses("fn f() { super::tui::g() }"), "`tui`");
    fails(
        &uses("use super::scene; fn f() -> scene::World {}"),
        "`scene`",
    );
    holds(&uses(
        "// use crate::trace\nuse crate::math::Ray; fn f() { \"crate::tui\" }",
    ));
    fails(&rules::layers(&made(&[("cellar.rs", "")])), "no layer");
}

#[test]
fn a_layer_is_left_by_the_path_from_the_root() {
    holds(&rules::ways_out(&house()));
}

#[test]
fn the_rule_of_ways_out_can_fail() {
    let uses = |text| rules::ways_out(&made(&[("probe/words.rs", text)]));
    fails(&uses("use super::super::math::Ray;"), "write `crate::`");
    fails(
        &uses("fn f() { super::super::math::g() }"),
        "write `crate::`",
    );
    fails(&uses("use crate::{math, geometry};"), "a line of its own");
    holds(&uses("use super::Probe; use crate::math::Ray;"));
}

#[test]
fn no_file_needs_one_that_needs_it() {
    holds(&circles::told(&house()));
}

#[test]
fn the_rule_of_circles_can_fail() {
    let told = |a, b, layer| {
        let files = [
            ("lib.rs", "mod l;"),
            ("l.rs", layer),
            ("l/a.rs", a),
            ("l/b.rs", b),
        ];
        circles::told(&made(&files))
    };
    let layer = "mod a; mod b; pub use a::A; pub use b::B; pub struct L(A);";
    let (a, b) = ("pub struct A;", "pub struct B(super::A);");
    holds(&told(a, b, layer));
    fails(
        &told("use super::b::B; pub struct A;", b, layer),
        "l/a -> l/b",
    );
    fails(
        &told("pub fn f() -> crate::l::B {}\npub struct A;", b, layer),
        "l/b -> l/a",
    );
    fails(
        &told(
            "use crate::l; pub fn f(_: l::B) {}\npub struct A;",
            b,
            layer,
        ),
        "a circle of 2",
    );
    // What is shared with the parts is no circle.
    holds(&told("pub struct A(super::L);", b, layer));
}

#[test]
fn every_file_says_what_it_is_and_stays_short() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let all = ["src", "tests", "benches"]
        .iter()
        .flat_map(|folder| sources(&root.join(folder)));
    let texts: Vec<(String, String)> = all
        .map(|path| {
            let name = path.strip_prefix(root).expect("below it").display();
            (name.to_string(), fs::read_to_string(&path).expect("UTF-8"))
        })
        .collect();
    let texts = || {
        texts
            .iter()
            .map(|(name, text)| (name.as_str(), text.as_str()))
    };
    holds(&rules::long_files(texts()));
}

#[test]
fn the_rule_of_long_files_can_fail() {
    let long = format!("//! It is long.\n{}", "\n".repeat(400));
    fails(
        &rules::long_files([("a.rs", long.as_str())].into_iter()),
        "401 lines",
    );
    fails(
        &rules::long_files([("a.rs", "use b;")].into_iter()),
        "what it is",
    );
}

#[test]
fn a_function_has_seventy_lines_at_most() {
    holds(&rules::long_functions(&house()));
}

#[test]
fn the_rule_of_long_functions_can_fail() {
    let function = |lines: usize| {
        let text = format!(
            "// a\nfn f() {{\n{}// b\n\n}}\nfn g();\n",
            "h();\n".repeat(lines - 2)
        );
        rules::long_functions(&made(&[("math.rs", &text)]))
    };
    holds(&function(70));
    fails(&function(71), "`f` has 71 lines");
}

#[test]
fn a_name_means_one_type() {
    holds(&rules::names_of_two(&house()));
}

#[test]
fn the_rule_of_names_can_fail() {
    let two = |a, b| rules::names_of_two(&made(&[("math.rs", a), ("tui/rows.rs", b)]));
    fails(
        &two("pub struct Row;", "pub(super) enum Row {}"),
        "`Row` is a type in math.rs and in tui/rows.rs",
    );
    holds(&two("pub struct Row;", "struct Row;"));
    holds(&two("pub struct Row;", "pub fn f() { pub struct Row; }"));
}

#[test]
fn a_comment_says_what_a_thing_is() {
    holds(&rules::empty_comments(&house()));
}

#[test]
fn the_rule_of_comments_can_fail() {
    let comment = |text| rules::empty_comments(&made(&[("math.rs", text)]));
    fails(&comment("    /// The same, but longer.\n"), "math.rs:1");
    holds(&comment("/// A ray.\n/// The same as above.\n"));
}

#[test]
fn only_faces_print_and_only_main_exits() {
    holds(&rules::manners(&house()));
}

#[test]
fn the_rule_of_manners_can_fail() {
    let in_layer = |name, text| rules::manners(&made(&[(name, text)]));
    fails(
        &in_layer("math.rs", "fn f() { println!(\"a\") }"),
        "println",
    );
    holds(&in_layer("cli.rs", "fn f() { println!(\"a\") }"));
    fails(
        &in_layer("cli.rs", "fn f() { std::process::exit(1) }"),
        "process",
    );
    fails(&in_layer("cli.rs", "fn f() { todo!() }"), "todo");
    fails(
        &in_layer("accel/fast/simd.rs", "fn f() { unsafe { g() } }"),
        "unsafe",
    );
}

#[test]
fn a_probe_is_told_by_the_macro() {
    holds(&rules::told_directly(&house()));
}

#[test]
fn the_rule_of_telling_can_fail() {
    let told = |text| rules::told_directly(&made(&[("tracer/whitted.rs", text)]));
    fails(&told("fn f() { self.probe.event(Event::Miss) }"), "tell!");
    holds(&told("fn f() { tell!(self.probe, Event::Miss) }"));
}

/// What lies at the top of the checkout, with what tools and builds put there.
const TOP: [&str; 20] = [
    ".ci",
    ".git",
    ".gitignore",
    ".github",
    "ARCHITECTURE.md",
    "CHANGELOG.md",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "README.md",
    "benches",
    "book",
    "clippy.toml",
    "examples",
    "lessons",
    "scenes",
    "src",
    "target",
    "tests",
];

#[test]
fn nothing_else_lies_at_the_top() {
    let top = fs::read_dir(env!("CARGO_MANIFEST_DIR")).expect("the checkout");
    let names = top.map(|entry| entry.expect("an entry").file_name());
    let strange: Vec<_> = names
        .filter(|name| !TOP.iter().any(|known| name == known))
        .collect();
    assert!(strange.is_empty(), "{strange:?}");
}
