//! Task files from anywhere: any text is a task or one clear message.

use raytree::grade::task::TaskError;
use raytree::grade::task::parse::parse;
use raytree::scene::printable::is_printable;

use super::bytes;
use super::dice::Dice;
use super::laws::{catch_panics, without_panic};
use super::memory::counted;

const KNOWN: [&str; 5] = [
    include_str!("../../lessons/tasks/hits.toml"),
    include_str!("../../lessons/tasks/light.toml"),
    include_str!("../../lessons/tasks/glass.toml"),
    include_str!("../../lessons/tasks/soft.toml"),
    r#"{"format": "raytree-task/1", "name": "a", "attempts": {"best": true, "most": 3}, "check":
[{"id": "a", "points": 1, "scene": "whitted", "pixels": [[1, 2]], "ask": ["t", {"object": 2}], "expect": {"far-root": [0, 1]}}]}"#,
];

/// Whether it is a task; an error is what breaks the law.
fn check(text: &str) -> Result<bool, String> {
    let read = || Ok(counted(|| parse(text)));
    let (task, memory) = without_panic(read).map_err(|broken| broken.how)?;
    if memory.peak > (1 << 20) + 1024 * text.len() {
        return Err(format!(
            "{} bytes of memory for {}",
            memory.peak,
            text.len()
        ));
    }
    let Err(what) = task else {
        return Ok(true);
    };
    let file = "task.toml".to_owned();
    let told = TaskError::Task { file, what }.to_string();
    if told.trim().is_empty() || !told.chars().all(|c| is_printable(c) || c == '\n') {
        return Err(format!("message {told:?}"));
    }
    Ok(false)
}

#[test]
fn whatever_is_in_a_task_it_is_one_or_a_message() {
    catch_panics();
    for text in KNOWN {
        assert_eq!(check(text), Ok(true), "{text}");
    }
    let many = super::environment("RAYTREE_FUZZ_TREES").unwrap_or(6000) / 4;
    let (mut taken, mut refused) = (0, 0);
    for number in 0..many {
        let dice = &mut Dice::new(17, number);
        let mut file = dice.pick(&KNOWN).as_bytes().to_vec();
        let other = dice.pick(&KNOWN);
        bytes::change(dice, &mut file, other.as_bytes());
        let text = String::from_utf8_lossy(&file).into_owned();
        match check(&text) {
            Ok(true) => taken += 1,
            Ok(false) => refused += 1,
            Err(how) => panic!("task {number}: {how}: {text:?}"),
        }
    }
    println!("{taken} tasks, {refused} messages");
    assert!(taken > 10 && refused > 200, "{taken}, {refused}");
}

#[test]
fn deep_and_odd_tasks_end_soon() {
    catch_panics();
    for deep in [
        "a = ".to_owned() + &"[".repeat(100_000),
        "{\"a\":".repeat(100_000),
        "a.".repeat(100_000) + "b = 1",
    ] {
        let start = std::time::Instant::now();
        assert_eq!(check(&deep), Ok(false));
        assert!(start.elapsed().as_secs() < 10);
    }
    assert_eq!(check("name = \"\\u001b\"\n\u{202e} = 1"), Ok(false));
}
