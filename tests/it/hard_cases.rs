//! The list of hard cases of shapes: each has a number of its own and a test that is there.

use std::fs;
use std::path::Path;

/// Number, file and test of a row of the list.
fn row(line: &str) -> Option<(usize, &str, &str)> {
    let cells: Vec<&str> = line.strip_prefix("| ")?.split(" | ").collect();
    let [number, _, place] = cells[..] else {
        return None;
    };
    let mut words = place.split('`');
    let (file, test) = (words.nth(1)?, words.nth(1)?);
    Some((number.parse().ok()?, file, test))
}

/// What is wrong with a list, whose first number is given; `source` reads files.
fn wrong(list: &str, first: usize, source: impl Fn(&str) -> String) -> Vec<String> {
    let rows: Vec<_> = list.lines().filter_map(row).collect();
    let mut told = Vec::new();
    for (expected, (number, file, test)) in (first..).zip(&rows) {
        if *number != expected {
            told.push(format!("case {number} stands where {expected} should"));
        }
        if !source(file).contains(&format!("fn {test}(")) {
            told.push(format!("case {number}: `{test}` is not in {file}"));
        }
    }
    if rows.len() < 2 {
        told.push("there are no cases".to_owned());
    }
    told
}

#[test]
fn every_hard_case_of_shapes_has_its_test() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |file: &str| fs::read_to_string(root.join(file)).unwrap_or_default();
    let list = read("tests/stability/README.md");
    let shapes = list.split("## Shapes").nth(1).expect("a part about shapes");
    assert_eq!(wrong(shapes, 105, read), Vec::<String>::new());
    assert!(shapes.lines().filter_map(row).count() >= 66);
}

#[test]
fn what_is_wrong_with_a_list_is_found() {
    let source = |_: &str| "fn a() {}".to_owned();
    let good = "| 7 | what | `f.rs`: `a` |\n| 8 | what | `f.rs`: `a` |\n";
    assert!(wrong(good, 7, source).is_empty());
    assert_eq!(wrong(&good.replace("| 8", "| 9"), 7, source).len(), 1);
    assert_eq!(wrong(&good.replacen("`a`", "`b`", 1), 7, source).len(), 1);
    assert_eq!(wrong("", 7, source).len(), 1);
}
