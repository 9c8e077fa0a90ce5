//! `raytree grade`: marks, the finder of mistakes, self-tests of the tasks in `lessons/tasks`.

use raytree::grade::marks::Given;
use raytree::grade::output::{Audience, OutputKind};
use raytree::grade::report::{Marked, Report};
use raytree::grade::selftest::{Naming, SelfTest, handed_in, naming};
use raytree::grade::submission::Submission;
use raytree::grade::task::{Check, CheckKind, Task};
use raytree::scene::{Bend, Bends};
use raytree::tracer::thread_pool;

fn task(name: &str) -> Task {
    let path = format!("{}/lessons/tasks/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    thread_pool::install(0, || Task::load(&path)).expect(name)
}

/// The bends as students of the three tasks: at least 95 of 100 that lose points are named, none wrongly.
#[test]
fn bends_are_named_in_the_tasks_and_never_wrongly() {
    let (mut all, mut named) = (0, 0);
    let mut wrong = Vec::new();
    for name in ["hits", "light", "glass"] {
        let mut task = task(name);
        // Seventy whole pictures take too long here; `raytree grade --selftest` draws them.
        let is_picture = |check: &Check| matches!(check.kind, CheckKind::Picture { .. });
        task.checks.retain(|check| !is_picture(check));
        let test =
            thread_pool::install(0, || SelfTest::new(std::slice::from_ref(&task))).expect(name);
        assert!(test.failures.is_empty(), "{name}: {:?}", test.failures);
        for (bend, marked) in &test.bends {
            all += 1;
            match naming(*bend, marked) {
                Naming::Named | Naming::Among => named += 1,
                Naming::Unnamed => wrong.push(format!("{name}: {bend} is not named")),
                Naming::Misnamed => panic!("{name}: {bend} is taken for {:?}", marked.diagnosis),
            }
        }
    }
    assert!(
        20 * named >= 19 * all,
        "{named} of {all}:\n{}",
        wrong.join("\n")
    );
    assert!(all >= 60, "{all}");
}

#[test]
fn the_order_of_submissions_and_threads_changes_nothing() {
    let task = task("hits");
    let tasks = [task];
    let bends = ["far-root", "farthest-hit", "normal-inward", "fov-full"];
    let report = |threads: usize| {
        thread_pool::install(threads, || {
            let marked = bends.iter().map(|name| {
                let bend: Bend = name.parse().expect("a bend");
                let given = handed_in(&tasks[0], bend.into());
                Marked::of_given(&tasks, &tasks[0], (*name).to_owned(), &given)
            });
            Report::of(marked.collect())
        })
    };
    let audience = Audience {
        task: &tasks[0],
        for_students: false,
    };
    let [one, eight] = [1, 8].map(|threads| {
        let written = OutputKind::Json.write(audience, &report(threads), &|| Err(String::new()));
        written.expect("written")
    });
    assert_eq!(one, eight);
    for name in bends {
        assert!(one.contains(&format!("\"{name}\"")), "{name}");
    }
}

#[test]
fn follow_gives_credit_for_what_is_right_in_itself() {
    let mut task = task("glass");
    let given = handed_in(&task, Bends::from(Bend::FovFull));
    let mark = |task: &Task, given: &Given| {
        Marked::of_given(std::slice::from_ref(task), task, "x".to_owned(), given).score()
    };
    let with = mark(&task, &given);
    task.follow = false;
    let without = mark(&task, &given);
    assert!(with > without, "{with} and {without}");
}

#[test]
fn nothing_earns_nothing_and_broken_files_are_told() {
    let task = task("hits");
    let broken = Submission::of_bytes("hits.ndjson", b"{\"pixel\":[1,2],\"root\":{".to_vec());
    let marked = Marked::new(std::slice::from_ref(&task), broken);
    assert_eq!(marked.score(), 0);
    assert_eq!(marked.problems.len(), 1, "{:?}", marked.problems);
    let audience = Audience {
        task: &task,
        for_students: true,
    };
    let report = Report::of(vec![marked]);
    let text = OutputKind::Text.write(audience, &report, &|| Err(String::new()));
    let text = text.expect("written");
    assert!(text.contains("0 of 12 (0 %)"), "{text}");
}
