//! The README tells the truth: what it shows behind a `$` is what the program prints.

use std::process::Command;

/// The commands of the README's console blocks, with what they print.
fn sessions(text: &str) -> Vec<(Vec<String>, String)> {
    let blocks = text.split("```console\n").skip(1);
    let inner = blocks.filter_map(|block| block.split("```").next());
    inner
        .filter_map(|block| {
            let (command, output) = block.strip_prefix("$ raytree ")?.split_once('\n')?;
            let words = command.split_whitespace().map(str::to_owned).collect();
            Some((words, output.to_owned()))
        })
        .collect()
}

#[test]
fn the_sessions_in_the_readme_are_real() {
    let sessions = sessions(include_str!("../../README.md"));
    assert_eq!(sessions.len(), 2);
    for (words, expected) in sessions {
        let output = Command::new(env!("CARGO_BIN_EXE_raytree"))
            .args(&words)
            .output()
            .expect("runs");
        let printed = [output.stdout, output.stderr].concat();
        assert_eq!(String::from_utf8_lossy(&printed), expected, "{words:?}");
    }
}

#[test]
fn the_readme_names_its_two_commands() {
    let readme = include_str!("../../README.md");
    assert!(readme.contains("\ncargo run --release ") && readme.contains("\ncargo test "));
}
