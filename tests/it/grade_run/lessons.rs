//! The programs of `lessons` earn all points by `--run`.

use std::fs;

use super::{A_PIXEL, Handed, graded};
use crate::flat::lesson;
use crate::hello::is_found;

fn hello(name: &str) -> Vec<u8> {
    fs::read(lesson("hello").join(name)).expect("there")
}

/// A program of `lessons/hello` in the task of the fourth lesson.
#[track_caller]
fn first_ray(file: &str, command: &str) {
    let handed = Handed::new(file, &hello(file));
    let task = lesson("tasks/hits.toml");
    graded(&task, &handed.path("alice"), command, &["--time", "60"]).is_full();
    // It was compiled in a copy.
    assert!(!handed.path("alice/hello").exists());
}

#[test]
fn the_first_ray_in_python_earns_all_points() {
    if is_found("python3", true) {
        first_ray(
            "hello.py",
            "python3 hello.py {flat} {x} {y} {width} {height}",
        );
        // And what is wrong does not.
        let wrong = String::from_utf8(hello("hello.py")).expect("UTF-8");
        let wrong = wrong.replace("min(hits)", "max(hits)");
        assert_ne!(wrong.as_bytes(), hello("hello.py"));
        let graded = Handed::python(&wrong).graded(A_PIXEL, &[]);
        assert!(graded.score < graded.max, "{:#}", graded.all);
    }
}

#[test]
fn the_first_ray_in_c_is_compiled_and_earns_all_points() {
    if is_found("cc", true) {
        first_ray(
            "hello.c",
            "sh -c 'test -x hello || cc -O1 hello.c -lm -o hello && exec ./hello {flat-text} {x} {y} {width} {height}'",
        );
    }
}

#[test]
fn the_first_ray_in_cpp_is_compiled_and_earns_all_points() {
    if is_found("c++", false) {
        first_ray(
            "hello.cpp",
            "sh -c 'test -x hello || c++ -O1 hello.cpp -o hello && exec ./hello {flat-text} {x} {y} {width} {height}'",
        );
    }
}

#[test]
fn the_first_ray_in_javascript_earns_all_points() {
    if is_found("node", false) {
        // `node` asks for more addresses than it uses.
        let handed = Handed::new("hello.js", &hello("hello.js"));
        graded(
            &lesson("tasks/hits.toml"),
            &handed.path("alice"),
            "node hello.js {flat} {x} {y} {width} {height}",
            &["--time", "60", "--memory", "0"],
        )
        .is_full();
    }
}

#[test]
fn the_whole_tracer_earns_all_points() {
    if !is_found("python3", true) {
        return;
    }
    for task in ["hits", "light", "glass"] {
        graded(
            &lesson(&format!("tasks/{task}.toml")),
            &lesson("solutions/python"),
            "python3 tracer.py {flat} {width} {height} {pixels} {out}",
            &["--time", "100"],
        )
        .is_full();
    }
}
