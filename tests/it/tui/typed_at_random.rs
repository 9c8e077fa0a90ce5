//! Keys, pastes, clicks and window sizes by chance, through a terminal: the program neither ends nor hangs, and its memory is bounded.

use std::time::{Duration, Instant};

use portable_pty::PtySize;

use super::Session;
use crate::random::Random;

/// Inputs of a run; with `RAYTREE_KEYS=n` that many.
const INPUTS: u64 = 600;

/// Bytes that the program may have in memory at most.
const MEMORY: u64 = 2 << 30;

const SIZES: [(u16, u16); 10] = [
    (120, 36),
    (80, 24),
    (40, 10),
    (160, 50),
    (10, 6),
    (1, 1),
    (100, 30),
    (72, 13),
    (3, 3),
    (200, 20),
];

/// What is typed, beside single letters: escape sequences of keys, pastes, clicks, and texts for prompts.
const INPUT: [&str; 38] = [
    "\r",
    "\r",
    "\x1b[A",
    "\x1b[B",
    "\x1b[C",
    "\x1b[D",
    "\x1b[1;2C",
    "\x1b[1;2A",
    "\x1b[5~",
    "\x1b[6~",
    "\t",
    "\x7f",
    "/tir\r",
    "bdeepest\r",
    "babsent\r",
    "=samples=2\r",
    "=depth=1\r",
    "dbend=far-root\r",
    ":3,4\r",
    ":/R\r",
    "\x1b[200~hits:ball\x1b[201~",
    "\x1b[<0;30;10M",
    "\x1b[<0;70;20M",
    "\x1b[<64;70;20M",
    "\x1b[<65;90;5M",
    "\x1b[H",
    "\x1b[F",
    "\x1b[3~",
    "*running sum\r",
    "*t\r",
    "bL blocked every 3rd\r",
    "bchanges:depth\r",
    "daccel=kd\r",
    "dorder=far-first\r",
    "))((",
    "xxXX",
    "ww",
    ",.",
];

/// All letters but those that end the program at the picture.
const LETTERS: &str = "abcdefghijklmnoprstuvwyzABCDEFGHIJKLMNOPRSTUVWXYZ<>[]{}+!?*#()'";

#[test]
fn whatever_is_typed_it_goes_on() {
    let inputs = std::env::var("RAYTREE_KEYS").map_or(INPUTS, |n| n.parse().expect("a number"));
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = portable_pty::CommandBuilder::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(["view", "whitted", "--size", "120x70"]);
    // What is typed may become a file.
    command.cwd(folder.path());
    let mut session = Session::start(command);
    session.wait_for("open its ray tree");
    let mut random = Random(2026);
    let letters: Vec<char> = LETTERS.chars().collect();
    for number in 0..inputs {
        let dice = random.bits();
        let choice = (dice >> 8) as usize;
        match dice % 8 {
            0 => resize(&mut session, SIZES[choice % SIZES.len()]),
            1..=3 => session.keys(INPUT[choice % INPUT.len()]),
            _ => session.keys(&letters[choice % letters.len()].to_string()),
        }
        if number % 20 == 19 {
            // Out of a prompt, whatever was typed there; and many samples would take all the time.
            session.keys(&"\x7f".repeat(210));
            session.keys("\rUUUUUU");
        }
        if number % 100 == 99 {
            assert!(is_alive(&mut session), "it ended at input {number}");
        }
        drain(&mut session, Duration::from_millis(1));
    }
    // It still answers: a window of another size is drawn anew, and it ends when it is told to.
    resize(&mut session, (120, 36));
    drain(&mut session, Duration::from_millis(200));
    assert!(memory(&session) < MEMORY, "{} bytes", memory(&session));
    session.screen = vt100::Parser::new(36, 120, 0);
    session.keys("\x03");
    assert_eq!(session.end(), 0);
}

fn resize(session: &mut Session, (cols, rows): (u16, u16)) {
    let size = PtySize {
        rows,
        cols,
        pixel_width: 0,
        pixel_height: 0,
    };
    session.master.resize(size).expect("a size");
}

fn is_alive(session: &mut Session) -> bool {
    session.child.try_wait().expect("a child").is_none()
}

/// Takes in what is written for some time.
fn drain(session: &mut Session, time: Duration) {
    let until = Instant::now() + time;
    let left = || until.saturating_duration_since(Instant::now());
    // The terminal of the tests cannot draw the smallest windows.
    while session.output.recv_timeout(left()).is_ok() {}
}

/// The largest memory that the program ever had.
fn memory(session: &Session) -> u64 {
    let id = session.child.process_id().expect("a process");
    let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) * 1024
}
