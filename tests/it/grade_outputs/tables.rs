//! CSV and JUnit, and no text of a student gets out of its place in them.

use std::fs;
use std::path::Path;
use std::process::Command;

use raytree::scene::printable::is_printable;
use serde_json::Value;

use super::class::{Class, Mistake, trees};
use crate::hello::is_found;

/// Names of submissions that try to be more than a name.
const HOSTILE: [&str; 6] = [
    "=cmd|'calc'!A0",
    "+1+1",
    "@SUM(A1)",
    "<script>alert(1)<script>\u{202e}",
    "a\u{1b}[2Jb\nc\td",
    "x\",\"9\",\"9\r\n&]]><!--",
];

/// A class with those, of whom one hands in trees with the same texts in them.
fn hostile() -> Class {
    let class = Class::new();
    for name in HOSTILE {
        let folder = class.path("in").join(name);
        fs::create_dir(&folder).expect("a folder");
        let text = trees(Mistake::Bend("cos-missing"));
        let text = text.replace("large ball", "<img src=x onerror=alert(1)>\\u001b[31m=1");
        fs::write(folder.join("hits.ndjson"), text).expect("written");
        fs::write(
            folder.join("b.json"),
            "{\"pixel\": [1, 2], \"<script>\": \"\\u0007\"}",
        )
        .expect("written");
    }
    class
}

/// What is written for all submissions.
fn all(class: &Class, kind: &str, file: &str) -> String {
    let names = class.submissions();
    let mut words = vec!["task.toml"];
    words.extend(names.iter().map(String::as_str));
    let output = format!("{kind}={file}");
    words.extend(["--output", &output]);
    let (status, _, told) = class.run_with(&words, &[]);
    assert_eq!(status, 0, "{told}");
    let plain = |c: char| c == '\n' || is_printable(c);
    assert!(told.chars().all(plain), "{told:?}");
    fs::read_to_string(class.path(file)).expect("written")
}

/// Rows of cells, read as RFC 4180 says.
fn rows(text: &str) -> Vec<Vec<String>> {
    let mut rows = vec![vec![String::new()]];
    let mut quoted = false;
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        let row = rows.last_mut().expect("a row");
        let cell = row.last_mut().expect("a cell");
        match c {
            '"' if quoted && letters.peek() == Some(&'"') => cell.extend(letters.next()),
            '"' => quoted = !quoted,
            ',' if !quoted => row.push(String::new()),
            '\r' if !quoted => {
                assert_eq!(letters.next(), Some('\n'));
                rows.push(vec![String::new()]);
            }
            c => cell.push(c),
        }
    }
    assert_eq!(rows.pop(), Some(vec![String::new()]), "the last line ends");
    rows
}

#[test]
fn a_table_has_a_line_a_submission_and_no_formula() {
    let class = hostile();
    let text = all(&class, "csv", "a.csv");
    let rows = rows(&text);
    assert_eq!(rows.len(), 1 + 3 + HOSTILE.len());
    let head = [
        "name", "score", "max", "percent", "hits", "light", "secret", "bends", "problems",
    ];
    assert_eq!(rows[0], head);
    for row in &rows {
        assert_eq!(row.len(), head.len(), "{row:?}");
        for cell in row {
            assert!(!cell.starts_with(['=', '+', '-', '@', '\t']), "{cell}");
            assert!(cell.chars().all(is_printable), "{cell:?}");
        }
    }
    let of = |name: &str| rows.iter().find(|r| r[0] == name).expect(name);
    assert_eq!(of("ada")[1..4], ["9", "9", "100"]);
    assert_eq!(of("bo")[7], "cos-missing");
    assert!(rows.iter().any(|r| r[0] == "'=cmd|'calc'!A0"), "{text}");
    assert!(rows.iter().any(|r| r[0] == "'+1+1"), "{text}");
}

/// The elements of an XML file, by a reader that is not ours: of each the name, its attributes and its text.
fn elements(path: &Path) -> Option<Vec<(String, Value, String)>> {
    const READ: &str = "
import json, sys, xml.etree.ElementTree as tree
print(json.dumps([[e.tag, e.attrib, e.text or ''] for e in tree.parse(sys.argv[1]).iter()]))";
    if !is_found("python3", true) {
        return None;
    }
    let ran = Command::new("python3")
        .args(["-c", READ])
        .arg(path)
        .output();
    let ran = ran.expect("it runs");
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
    Some(serde_json::from_slice(&ran.stdout).expect("JSON"))
}

#[test]
fn junit_is_as_its_schema_says_and_has_a_case_a_check() {
    let class = hostile();
    let text = all(&class, "junit", "a.xml");
    assert!(text.chars().all(|c| c == '\n' || is_printable(c)));
    let Some(elements) = elements(&class.path("a.xml")) else {
        return;
    };
    let count = |name: &str| elements.iter().filter(|e| e.0 == name).count();
    let suites = 3 + HOSTILE.len();
    assert_eq!((count("testsuites"), count("testsuite")), (1, suites));
    assert_eq!(count("testcase"), 3 * suites);
    assert_eq!(
        count("skipped"),
        1,
        "the empty one has no hits, so light is not asked"
    );
    assert_eq!(elements[0].1["failures"], count("failure").to_string());
    assert_eq!(elements[0].1["name"], "Hits & <b>terms</b>");
    let names: Vec<&str> = elements
        .iter()
        .filter_map(|e| e.1["name"].as_str())
        .collect();
    assert!(
        names.contains(&"<script>alert(1)<script>\\u{202e}"),
        "{names:#?}"
    );
    let known = [
        "testsuites",
        "testsuite",
        "testcase",
        "failure",
        "skipped",
        "system-out",
    ];
    assert!(elements.iter().all(|e| known.contains(&e.0.as_str())));
    let cos = |e: &&(String, Value, String)| {
        e.0 == "failure"
            && e.1["message"]
                .as_str()
                .is_some_and(|m| m.contains("cos-missing"))
    };
    assert!(elements.iter().find(cos).is_some(), "{text}");
    by_schema(&class.path("a.xml"));
}

/// Checks a file against the schema with lxml, where that is installed.
fn by_schema(file: &Path) {
    const CHECK: &str = "
import sys
try:
    from lxml import etree
except ImportError:
    sys.exit(0)
schema = etree.XMLSchema(etree.parse(sys.argv[1]))
schema.assertValid(etree.parse(sys.argv[2]))
assert not schema.validate(etree.fromstring('<testsuite name=\"a\"/>'))";
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/grade/schemas");
    let mut command = Command::new("python3");
    command
        .args(["-c", CHECK])
        .arg(folder.join("junit.xsd"))
        .arg(file);
    let ran = command.output().expect("it runs");
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
}
