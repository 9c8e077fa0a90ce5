//! Tests of the reader: each freedom, and what breaks a pixel.

mod flat;

use super::*;
use crate::math::Rgb;
use crate::probe::{RayKind, TermKind};
use crate::trace::facts::{Fact, FactName, TreePath};

fn all(text: &str) -> Vec<Result<PixelFacts, ReadError>> {
    read_trees(text.as_bytes(), "a.json")
}

#[track_caller]
fn one(text: &str) -> PixelFacts {
    let mut answers = all(text);
    assert_eq!(answers.len(), 1, "{answers:?}");
    answers.remove(0).expect("it can be read")
}

#[track_caller]
fn error(text: &str) -> String {
    let mut answers = all(text);
    assert_eq!(answers.len(), 1, "{answers:?}");
    answers.remove(0).expect_err("it is broken").to_string()
}

fn paths(facts: &PixelFacts) -> Vec<String> {
    facts.rays.iter().map(|ray| ray.path.to_string()).collect()
}

#[test]
fn a_document_may_say_little() {
    let facts = one(r#"{"root": {"kind": "I"}}"#);
    assert_eq!(facts.rays.len(), 1);
    assert_eq!(facts.rays[0].path, TreePath::default());
    assert!(facts.problems.is_empty() && facts.pixel.is_none());
    let facts = one(
        r#"{"format":"raytree/1","scene":{"name":"s"},"pixel":{"x":3,"y":4},"color":[0.1,0.2,0.3]}"#,
    );
    assert_eq!(
        (facts.scene.as_deref(), facts.pixel),
        (Some("s"), Some((3, 4)))
    );
    assert_eq!(facts.color, Some(Fact::Color(Rgb::new(0.1, 0.2, 0.3))));
    let facts = one(r#"{"scene":"s","pixel":[3,4],"color":{"linear":0.5,"srgb8":[1,2,3]}}"#);
    assert_eq!(
        (facts.scene.as_deref(), facts.pixel),
        (Some("s"), Some((3, 4)))
    );
    assert_eq!(facts.color, Some(Fact::Color(Rgb::grey(0.5))));
    assert_eq!(facts.srgb8, Some(Fact::Vector([1.0, 2.0, 3.0])));
    let facts = one(r#"{"pixel":[3,4],"estimates":[0.0,0.25],"mean":{"value":0.125,"samples":2}}"#);
    assert_eq!(
        (facts.estimates, facts.mean),
        (vec![0.0, 0.25], Some((0.125, 2)))
    );
}

#[test]
fn the_facts_of_a_ray_are_read() {
    let facts = one(
        r#"{"root": {"kind": "I", "origin": [0, 1, 2], "direction": [0, 0, -1], "outcome": "light",
        "medium": null, "hit": {"t": 2.5, "object": "floor", "side": "back", "uv": [0.5, 1], "primitive": 3},
        "terms": [{"term": "diffuse", "light": "lamp", "value": 0.5, "n_dot_l": 0.7, "mine": 1},
                  {"term": "specular", "light": "lamp", "sample": 2, "value": [1, 2, 3], "r_dot_v": 0.9}],
        "absent": [{"kind": "R", "reason": "depth-limit"}, {"kind": "L", "light": "fill", "reason": "facing-away"}],
        "traversal": [{"node": 3, "visit": "both"}, {"test": {"object": "floor", "primitive": 3}, "t": 1}, "node 4"],
        "children": [{"kind": "L", "light": "lamp", "outcome": "lit", "t_max": 4, "hit": {"t": 1}}]}}"#,
    );
    assert_eq!(facts.problems, [""; 0]);
    let ray = &facts.rays[0];
    assert_eq!(ray.vector(&FactName::Origin), Some([0.0, 1.0, 2.0]));
    assert_eq!(ray.word(&FactName::Outcome), Some("hit"));
    assert_eq!(ray.word(&FactName::Object), Some("floor"));
    assert_eq!(ray.word(&FactName::Side), Some("back"));
    assert_eq!(ray.get(&FactName::Medium), None);
    assert_eq!(ray.number(&FactName::T), Some(2.5));
    assert_eq!(ray.get(&FactName::Uv), Some(&Fact::Pair([0.5, 1.0])));
    let diffuse = FactName::Term(TermKind::Diffuse, Some("lamp".into()), 0);
    assert_eq!(ray.color(&diffuse), Some(Rgb::grey(0.5)));
    assert_eq!(ray.number(&FactName::NDotL("lamp".into(), 0)), Some(0.7));
    assert_eq!(ray.number(&FactName::RDotV("lamp".into(), 2)), Some(0.9));
    let steps = ["node 3", "test floor 3", "node 4"].map(str::to_owned);
    assert_eq!(
        ray.get(&FactName::Order),
        Some(&Fact::Steps(steps.to_vec()))
    );
    let absent = [
        (RayKind::Reflected, None, "depth-limit".to_owned()),
        (
            RayKind::Light,
            Some("fill".to_owned()),
            "facing-away".to_owned(),
        ),
    ];
    assert_eq!(ray.absent, absent);
    let light = &facts.rays[1];
    assert_eq!(light.number(&FactName::Distance), Some(4.0));
    assert_eq!(light.get(&FactName::T), None, "the blocker is no fact");
    assert_eq!(paths(&facts), ["", "/L:lamp"]);
}

#[test]
fn what_is_no_number_is_nothing_and_the_rest_is_read() {
    for word in [
        "NaN",
        "nan",
        "-nan",
        "Infinity",
        "-Infinity",
        "inf",
        "-inf",
        "1e999",
        "-1e999",
        "\"2\"",
        "true",
        "[]",
    ] {
        let text = format!(
            r#"{{"color": {word}, "root": {{"kind": "I", "origin": [0, {word}, 0], "ior": 1.5, "hit": {{"t": {word}, "object": "a"}}}}}}"#
        );
        let facts = one(&text);
        let ray = &facts.rays[0];
        assert_eq!(ray.get(&FactName::Origin), Some(&Fact::Nothing), "{word}");
        assert_eq!(ray.get(&FactName::T), Some(&Fact::Nothing), "{word}");
        assert_eq!(facts.color, Some(Fact::Nothing), "{word}");
        assert_eq!(ray.number(&FactName::Ior), Some(1.5));
        assert_eq!(ray.word(&FactName::Object), Some("a"));
        assert_eq!(facts.problems.len(), 3);
        assert!(
            facts.problems[1].contains("`root.origin[1]` is"),
            "{:?}",
            facts.problems
        );
    }
    let text = r#"{"root": {"kind": "I", "children": [{"kind": "L"}, {"kind": "T", "direction": [NaN, 0, 1]}]}}"#;
    assert_eq!(
        one(text).problems,
        ["`root.children[1].direction[0]` is NaN: a root of a negative number?"]
    );
    // Inside of a text such a word is a text.
    assert_eq!(
        one(r#"{"root": {"kind": "I", "medium": "NaN"}}"#).problems,
        [""; 0]
    );
    let sum = r#"{"root": {"kind": "I", "terms": [{"term": "ambient", "value": 1}, {"term": "ambient", "value": NaN}]}}"#;
    assert_eq!(one(sum).rays[0].facts[0].1, Fact::Nothing);
    assert_eq!(one(r#"{"estimates": [1, NaN]}"#).estimates, [0.0; 0]);
}

#[test]
fn values_of_another_kind_are_nothing() {
    for (field, said) in [
        (
            r#""origin": [1, 2]"#,
            "`root.origin` has 2, and 3 numbers are wanted",
        ),
        (r#""origin": [1, 2, 3, 4]"#, "has more"),
        (
            r#""origin": "here""#,
            "is the text \"here\", and a list of 3 numbers is wanted",
        ),
        (r#""medium": 1"#, "`root.medium` is 1, and a text is wanted"),
        (r#""outcome": "hti""#, "did you mean \"hit\"?"),
        (r#""hit": 5"#, "`root.hit` is 5, and an object is wanted"),
        (r#""hit": {"side": "left"}"#, "one of front, back is wanted"),
        (r#""terms": {}"#, "a list is wanted"),
        (
            r#""terms": [{"term": "difuse"}]"#,
            "did you mean \"diffuse\"?",
        ),
        (
            r#""terms": [{"value": 1}]"#,
            "`root.terms[0]` has no `term`",
        ),
        (r#""children": 3"#, "a list of rays is wanted"),
        (
            r#""hitt": {}"#,
            "1 unknown field: `root.hitt`; did you mean `hit`?",
        ),
        (
            r#""a": 1, "b": 2, "hitt": {}"#,
            "3 unknown fields, the first is `root.a`",
        ),
    ] {
        let facts = one(&format!(r#"{{"root": {{"kind": "I", {field}}}}}"#));
        let [problem] = &facts.problems[..] else {
            panic!("{field}: {:?}", facts.problems)
        };
        assert!(problem.contains(said), "{problem}, not {said}");
    }
    let many: String = (0..100)
        .map(|_| r#"{"term": "ambient", "value": NaN},"#)
        .collect();
    let facts = one(&format!(
        r#"{{"root": {{"kind": "I", "terms": [{many} {{"term": "ambient"}}]}}}}"#
    ));
    assert_eq!(facts.problems.len(), limits::MAX_PROBLEMS + 1);
    assert!(facts.problems[limits::MAX_PROBLEMS].starts_with("80 more fields"));
}

/// Broken documents, and what is said of each.
const BROKEN: [(&str, &str); 22] = [
    (
        r#"{"pixel":[2,2],"root":{"kind":"I","kind":"I"}}"#,
        "root.kind: stands here twice",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I","\u006bind":"I"}}"#,
        "root.kind: stands here twice",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I","children":[{"kind":"R"},{"kind":"R"}]}}"#,
        "root.children[1]: is a second R ray",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I","children":[{"kind":"L","light":"a"},{"kind":"L","light":"a"}]}}"#,
        "second L ray to `a`, sample 0",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I","children":[{"kind":"L","children":[{"kind":"R"}]}]}}"#,
        "root.children[0].children[0]: is of kind R, and an L ray",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I","children":[{"kind":"I"}]}}"#,
        "and a ray sent it",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"T"}}"#,
        "root: is of kind T",
    ),
    (r#"{"pixel":[2,2],"root":{}}"#, "root: a ray has no `kind`"),
    (
        r#"{"pixel":[2,2],"root":{"kind":"i"}}"#,
        "root.kind: is \"i\"; did you mean \"I\"?",
    ),
    (
        r#"{"pixel":[2,2],"format":"raytree/2"}"#,
        "format: is the text \"raytree/2\"",
    ),
    (r#"{"pixel":[2.5,2]}"#, "pixel: is 2.5"),
    (r#"{"pixel":[2]}"#, "has not both"),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I",}}"#,
        "the name of a field is wanted here",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I" "ior":1}}"#,
        "a comma or `}` is wanted here",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":'I'}}"#,
        "a value is wanted here",
    ),
    (
        r#"{"pixel":[2,2],"root":{"kind":None}}"#,
        "`None` is no value of JSON",
    ),
    (r#"{"pixel":[2,2],"ior":.5}"#, "`.5` is no number of JSON"),
    (r#"{"pixel":[2,2],"root":{"kind":"I"}"#, "is wanted here"),
    (
        r#"{"pixel":[2,2],"root":{"kind":"I"#,
        "control character or a line end",
    ),
    (
        "{\"pixel\":[2,2],\"root\":{\"kind\":\"\u{1}\"}}",
        "control character",
    ),
    ("17", "is 17, and a ray tree or a ray is wanted"),
    ("Rendering row 3", "`Rendering` is no value of JSON"),
];

#[test]
fn a_broken_document_breaks_no_other() {
    let good = r#"{"pixel":[1,1],"root":{"kind":"I"}}"#;
    for (bad, said) in BROKEN {
        for text in [
            format!("{good}\n{bad}\n{good}\n"),
            format!("{good}\r\n{bad}\r\n{good}"),
        ] {
            let answers = all(&text);
            let [Ok(first), Err(error), Ok(last)] = &answers[..] else {
                panic!("{bad}: {answers:?}")
            };
            assert_eq!((first.pixel, last.pixel), (Some((1, 1)), Some((1, 1))));
            assert!((2..4).contains(&error.line), "{error}");
            let told = error.to_string();
            assert!(told.contains(said), "{told}, not {said}");
            assert!(
                told.starts_with("a.json:") && told.lines().count() == 2,
                "{told}"
            );
        }
    }
    let last = format!("{good}\n{{\"root\": {{\"kind\"");
    assert!(
        all(&last)[1]
            .as_ref()
            .is_err_and(|e| e.to_string().contains("ends inside of a document"))
    );
}

#[test]
fn documents_stand_in_lists_and_on_many_lines() {
    let good = "{\n\"pixel\": [1,1],\n\"root\":\n{\n\"kind\": \"I\", \"children\": [\n{\"kind\": \"R\"}\n]\n}\n}";
    for text in [
        format!("[{good},{good}]"),
        format!("[\n  {good},\n  {good}\n]\n"),
        format!("{good}{good}"),
        format!("\u{feff}{good}\n\n{good}"),
    ] {
        let answers = all(&text);
        assert!(
            answers.len() == 2
                && answers
                    .iter()
                    .all(|a| a.as_ref().is_ok_and(|p| p.rays.len() == 2)),
            "{text}"
        );
    }
    // On one line what follows a broken one is still read, as long as its brackets close.
    let answers = all(r#"[{"root":{"kind":"I"}},{"root":{"kind" "I"}},{"root":{"kind":"I"}}]"#);
    assert_eq!(
        answers.iter().map(Result::is_ok).collect::<Vec<_>>(),
        [true, false, true]
    );
    for empty in ["", " \n", "[]", "\u{feff}"] {
        assert!(error(empty).contains("no ray tree"));
    }
    let utf16: Vec<u8> = [0xff, 0xfe]
        .into_iter()
        .chain("{}".encode_utf16().flat_map(u16::to_le_bytes))
        .collect();
    assert!(
        read_trees(&utf16, "a")[0]
            .as_ref()
            .is_err_and(|e| e.to_string().contains("UTF-16"))
    );
}

/// What is wrong with the lines about a pixel is known at the end of the file, and counts among the errors as well.
#[test]
fn no_more_errors_are_told_than_the_limit_says() {
    // Each pixel has a line whose parent is told nowhere.
    let line = |n: usize| format!("{{\"pixel\":[{n},0],\"kind\":\"L\",\"id\":7,\"parent\":11}}\n");
    let lines: Vec<String> = (0..limits::MAX_ERRORS + 200).map(line).collect();
    for broken in ["", "{\"pixel\" 1}\n"] {
        let answers = all(&[&lines.concat(), broken].concat());
        let errors = answers.iter().filter(|answer| answer.is_err()).count();
        assert_eq!(
            (answers.len(), errors),
            (limits::MAX_ERRORS + 1, limits::MAX_ERRORS + 1)
        );
        let last = answers.last().and_then(|answer| answer.as_ref().err());
        let told = last.map(ToString::to_string).unwrap_or_default();
        assert!(told.contains("more than 1000 errors"), "{told}");
    }
}
