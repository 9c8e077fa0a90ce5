//! Numbers on the command line: any text, at any flag, is taken or refused with one message that names the flag.

use std::process::Command;

use super::dice::Dice;

const FLAGS: [&str; 15] = [
    "--size",
    "--samples",
    "--light-samples",
    "--depth",
    "--min-weight",
    "--exposure",
    "--seed",
    "--max-rays",
    "--threads",
    "--offset",
    "--triangle",
    "--accel",
    "--sampling",
    "--fresnel",
    "--pixel",
];

const VALUES: [&str; 41] = [
    "",
    " ",
    "0",
    "-0",
    "-1",
    "1",
    "00001",
    "+1",
    "1e3",
    "1.5",
    "1e308",
    "-1e308",
    "1e309",
    "1e-320",
    "nan",
    "NaN",
    "inf",
    "-inf",
    "4294967295",
    "4294967296",
    "18446744073709551615",
    "18446744073709551616",
    "99999999999999999999999999",
    "0x10",
    "1_000",
    "1,5",
    "1x1",
    "0x0",
    "2X2",
    "x",
    "1x",
    "1x1x1",
    "4294967296x1",
    "16384x16384",
    "0,0",
    "1,1",
    "9,9",
    "fixed:1e-4",
    "fixed:nan",
    "triangles:3",
    "\u{1b}[2J",
];

#[test]
fn whatever_a_flag_is_given_there_is_one_clear_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let [picture, tree] =
        ["a.png", "a.json"].map(|name| folder.path().join(name).display().to_string());
    let many = std::env::var_os("RAYTREE_FUZZ").is_some();
    let (mut taken, mut refused) = (0, 0);
    for number in 0..if many { 2000 } else { 80 } {
        let dice = &mut Dice::new(7, number);
        let flag = dice.pick(&FLAGS);
        let value = dice.pick(&VALUES);
        let given = format!("{flag}={value}");
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
        match flag {
            "--pixel" => command.args(["trace", "triangle", "--size", "2x2", "-o", &tree, &given]),
            // A large picture is no mistake, but a long wait.
            "--size" => command.args(["trace", "triangle", "--pixel", "0,0", "-o", &tree, &given]),
            _ => command.args([
                "render", "triangle", "--size", "2x2", "-o", &picture, &given,
            ]),
        };
        let output = command.output().expect("it runs");
        let said = String::from_utf8(output.stderr).expect("UTF-8");
        let code = output.status.code();
        assert!(!said.contains("panicked"), "{given:?}: {said}");
        match code {
            Some(0 | 3) => taken += 1,
            Some(2) => {
                refused += 1;
                assert!(
                    said.contains(flag.trim_start_matches('-')),
                    "{given:?} is named: {said}"
                );
                assert!(
                    said.starts_with("error: ") && said.lines().count() < 12,
                    "{given:?}: {said}"
                );
            }
            _ => panic!("{given:?} ends with {code:?}: {said}"),
        }
    }
    assert!(
        taken > 3 && refused > 20,
        "both are met: {taken}, {refused}"
    );
}
