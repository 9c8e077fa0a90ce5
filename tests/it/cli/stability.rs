//! `raytree stability`: tables, pictures, and what is refused.

use serde_json::Value;

use super::{refused, run};

#[test]
fn stability_tells_which_arithmetic_is_wrong() {
    let text = String::from_utf8(run(&["stability"]).out).expect("UTF-8");
    for part in ["shared-edges", "--triangle moller-trumbore", "wrong"] {
        assert!(text.contains(part), "no {part} in\n{text}");
    }
    assert!(text.lines().all(|l| l.chars().count() <= 80), "{text}");
    let one = run(&["stability", "far-sphere", "--json"]).out;
    let one: Value = serde_json::from_slice(&one).expect("JSON");
    assert_eq!(one.as_array().map(Vec::len), Some(1));
    let outcomes = one[0]["outcomes"].as_array().expect("a list");
    let verdict = |ours: bool| {
        let mut of = outcomes.iter().filter(|o| o["ours"] == ours);
        of.next().expect("there")["verdict"].clone()
    };
    assert_eq!(
        (verdict(true), verdict(false)),
        ("right".into(), "wrong".into())
    );
}

/// The cases that `raytree stability` knows.
fn cases() -> Vec<String> {
    let all: Value = serde_json::from_slice(&run(&["stability", "--json"]).out).expect("JSON");
    let all = all.as_array().expect("a list");
    let names = all.iter().map(|case| case["case"].as_str());
    names.map(|name| name.expect("a name").to_owned()).collect()
}

#[test]
fn a_hard_case_is_drawn_with_each_arithmetic_side_by_side() {
    let names = cases();
    assert_eq!(names.len(), 13);
    for case in &names {
        let ran = run(&["stability", case]);
        assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{case}");
        let text = String::from_utf8(ran.out).expect("UTF-8");
        assert!(text.is_ascii(), "{text}");
        let lines: Vec<&str> = text.lines().collect();
        // It fits a terminal, with a line for what is typed next.
        assert!(lines.len() < 24, "{text}");
        assert!(lines.iter().all(|l| l.len() <= 80), "{text}");
        let (table, picture) = text.split_once("\n\n").expect("a picture below the table");
        let (names, picture) = picture.split_once('\n').expect("names");
        let (picture, legend) = picture.trim_end().rsplit_once('\n').expect("a legend");
        assert!(legend.contains("; x: "), "{legend}");
        let measured = table
            .lines()
            .filter(|l| l.ends_with("wrong") || l.ends_with("right"));
        for outcome in measured {
            let name = outcome[4..41].trim_end();
            assert!(names.contains(name), "{name} in {names}");
        }
        // Ours is the last, under its name; only before it is anything wrong.
        let ours = names.find("ours").expect("ours");
        let (naive, right): (String, String) = picture
            .lines()
            .map(|line| line.split_at(ours.min(line.len())))
            .unzip();
        assert!(naive.contains('x') && !right.contains('x'), "{text}");
        assert!(right.trim().len() > 100, "{text}");
    }
}

#[test]
fn a_hard_case_is_drawn_in_colours_or_to_a_file() {
    let text = String::from_utf8(run(&["stability", "far-sphere", "--color", "truecolor"]).out);
    let text = text.expect("UTF-8");
    assert!(text.contains('▀') && text.contains("; red: "), "{text}");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sphere.png");
    let path = path.to_str().expect("a plain path");
    let ran = run(&["stability", "far-sphere", "-o", path]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let text = String::from_utf8(ran.out).expect("UTF-8");
    let told =
        format!("\n{path}, from left to right:\n  --quadratic naive, --precision single, ours\n");
    assert!(text.contains(&told), "{text}");
    // Three times 64 pixels, six times as large, with four pixels around.
    let picture = image::open(path).expect("a PNG").to_rgb8();
    assert_eq!(picture.dimensions(), (3 * 388 + 4, 388 + 4));
    let is_red = |x: u32| {
        let mut pixels = (x..x + 384).flat_map(|x| (4..388).map(move |y| (x, y)));
        pixels.any(|(x, y)| {
            let [r, g, _] = picture.get_pixel(x, y).0;
            r > 100 && g < r / 2 + 20
        })
    };
    assert_eq!([4, 392, 780].map(is_red), [true, true, false]);
    // Data stay data.
    let ran = run(&["stability", "far-sphere", "--json", "-o", path]);
    assert!(serde_json::from_slice::<Value>(&ran.out).is_ok() && ran.err.contains(path));
}

#[test]
fn a_picture_of_no_case_or_to_nowhere_is_refused() {
    refused(&["stability", "-o", "picture.png"], 2, &["CASE"]);
    let nowhere = ["stability", "far-sphere", "-o", "no/such/folder/x.png"];
    refused(&nowhere, 1, &["no/such/folder/x.png: cannot be written"]);
}
