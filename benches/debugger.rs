//! How quick the debugger is: from a key to the last byte of the redrawn screen, and from the program's start to its first
//! picture.
//!
//! The real program runs on a pseudo-terminal. What a user waits for is what counts, so times are those of the clock; the
//! processor time that stands beside them tells a busy machine from a slow program.
//!
//! `cargo bench -p raytree-benches --bench debugger`, with `-- start` only the second; with `RAYTREE_BOOK=1` the tables go into the book as well.

#[path = "common/ball.rs"]
mod ball;
#[path = "common/lamps.rs"]
mod lamps;
#[path = "common/obj.rs"]
mod obj;
#[path = "common/program.rs"]
mod program;
#[path = "common/table.rs"]
mod table;
#[path = "common/terminal.rs"]
mod terminal;

use std::fmt::Write;
use std::time::Duration;

use table::{markdown, median, publish};
use terminal::{Terminal, covered};

/// A key must be answered within this.
const KEY: Duration = Duration::from_millis(16);

/// The first picture must be there within this.
const FIRST: Duration = Duration::from_millis(300);

/// Presses of each kind of key.
const PRESSES: usize = 60;

/// Starts of the program.
const STARTS: usize = 9;

/// The screens: the usual one and a large one.
const SCREENS: [(u16, u16); 2] = [(80, 24), (160, 50)];

/// A scene whose trees are opened: its name in the tables, and arguments of `raytree view`.
struct Opened {
    name: &'static str,
    args: Vec<String>,
    /// True if its tree is as large as a log can keep: it is opened once, and not measured how quick that is.
    is_huge: bool,
}

/// A usual tree, a large one, and one of a million rays, in the scene in this file.
fn scenes(million: &str) -> [Opened; 3] {
    let of = |name, args: &str, is_huge| Opened {
        name,
        args: args.split(' ').map(str::to_owned).collect(),
        is_huge,
    };
    [
        of("whitted", "whitted", false),
        of(
            "lamps, 64x48, 16 samples of 64 shadow rays",
            "lamps --size 64x48 --samples 16 --light-samples 64",
            false,
        ),
        of(
            "3950 samples of 256 shadow rays: 1,015,150 rays, 5.1 million events",
            &format!("{million} --size 8x6 --samples 3950 --sampling random"),
            true,
        ),
    ]
}

/// A kind of key, the key, and what is pressed after it, untimed, so that it has something to do again.
type Kind = (&'static str, &'static str, &'static [&'static str]);

/// While a pixel is chosen.
const IN_PICTURE: [Kind; 3] = [
    ("move", "l", &["h"]),
    ("leap", "L", &["H"]),
    ("open", "\r", &["q"]),
];

/// While a tree is open.
const IN_TREE: [Kind; 20] = [
    ("close", "q", &["\r"]),
    ("step", "n", &[]),
    ("back", "p", &[]),
    ("over", "o", &[]),
    ("out", "u", &["n"]),
    ("next ray", "l", &[]),
    ("row", "j", &[]),
    ("page", "\x1b[6~", &[]),
    ("end", "G", &["g"]),
    ("fold", " ", &[]),
    ("pane", "\t", &[]),
    ("zoom", "z", &[]),
    ("view", "v", &[]),
    ("run", "x", &["g"]),
    ("next change", ")", &[]),
    ("change before", "(", &[]),
    ("watches", "#", &["\x1b"]),
    ("find next", "f", &[]),
    ("where from", "w", &["\x1b"]),
    ("help", "?", &[]),
];

fn milliseconds(time: Duration) -> f64 {
    1000.0 * time.as_secs_f64()
}

/// Waits until a tree is open.
fn open(terminal: &mut Terminal) {
    while !terminal.text().contains("ray tree:") {
        terminal.redraw();
    }
}

/// Milliseconds from a kind's key to the end of the redraw: the median, the worst, and processor time a press.
fn pressed(terminal: &mut Terminal, (_, key, others): Kind) -> [f64; 3] {
    let before = terminal.cpu();
    let mut times = Vec::new();
    for _ in 0..PRESSES {
        times.push(milliseconds(terminal.press(key)));
        for other in others {
            if *other == "q" {
                open(terminal);
            }
            terminal.press(other);
            if *other == "\r" {
                open(terminal);
            }
        }
    }
    let worst = times.iter().copied().fold(0.0, f64::max);
    let cpu = milliseconds(terminal.cpu().saturating_sub(before));
    let presses = PRESSES * (1 + others.len());
    [median(times), worst, cpu / presses as f64]
}

/// Opens a tree, and sets what must not make keys slower: a break point that never stops, one that counts, four watched
/// numbers, and a search that goes on.
fn open_all(terminal: &mut Terminal) {
    terminal.press("\r");
    open(terminal);
    for typed in [
        "b",
        "hits:nothing\r",
        "b",
        "L blocked every 1000000th\r",
        "*",
        "running sum\r",
        "*",
        "throughput\r",
        "*",
        "t\r",
        "*",
        "N\r",
        "/",
        "some(depth >= 99)\r",
    ] {
        terminal.press(typed);
    }
}

/// A row for each kind of key: the median and the worst of each screen and scene.
fn keys() -> String {
    let mut text = String::new();
    let million = lamps::written();
    let path = million.path().to_str().expect("a plain path");
    for Opened {
        name,
        args,
        is_huge,
    } in scenes(path)
    {
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let kinds = || {
            let in_picture = IN_PICTURE.iter().map(|kind| (kind, false));
            let all = in_picture.chain(IN_TREE.iter().map(|kind| (kind, true)));
            all.filter(move |(kind, _)| !is_huge || !["open", "close"].contains(&kind.0))
        };
        let mut rows: Vec<_> = kinds().map(|(kind, _)| vec![kind.0.to_string()]).collect();
        for size in SCREENS {
            let mut terminal = Terminal::view(&args, size);
            terminal.redraw();
            terminal.settled();
            let mut is_open = false;
            for ((kind, in_tree), row) in kinds().zip(&mut rows) {
                if in_tree && !is_open {
                    open_all(&mut terminal);
                    is_open = true;
                }
                row.extend(pressed(&mut terminal, *kind).map(|t| format!("{t:.1}")));
            }
        }
        let head = SCREENS.iter().flat_map(|(columns, rows)| {
            ["median", "worst", "CPU"].map(|what| format!("{columns}x{rows}: {what}"))
        });
        let head: Vec<String> = std::iter::once(name.to_string()).chain(head).collect();
        let _ = writeln!(text, "{}", markdown(&head, &rows));
    }
    format!(
        "Milliseconds from a key to the last byte of the redrawn screen, of {PRESSES} presses each, and processor time of the \
         debugger a press. The bar is {} ms.\n\n{text}",
        KEY.as_millis()
    )
}

/// A row for each screen: the first picture, coarse, and the whole one.
fn first_picture() -> String {
    let triangles = ball::bumpy_ball(158);
    let file = obj::written(&triangles);
    let path = file.path().to_str().expect("a plain path");
    let head = [
        "screen",
        "first picture",
        "worst",
        "CPU",
        "whole picture",
        "worst",
        "CPU",
    ]
    .map(String::from);
    let mut rows = Vec::new();
    for size in SCREENS {
        let mut times = [(); 4].map(|()| Vec::new());
        for _ in 0..STARTS {
            let mut terminal = Terminal::view(&[path], size);
            let mut note = |at: usize, when, terminal: &Terminal| {
                let clock = milliseconds(when - terminal.started);
                times[at].push(clock);
                times[at + 1].push(milliseconds(terminal.cpu()));
            };
            let first = terminal.until(covered);
            note(0, first, &terminal);
            let whole = terminal.settled().unwrap_or(first);
            note(2, whole, &terminal);
        }
        let mut row = vec![format!("{}x{}", size.0, size.1)];
        for (clock, cpu) in [(0, 1), (2, 3)] {
            let worst = times[clock].iter().copied().fold(0.0, f64::max);
            let cpu = median(times[cpu].iter().copied());
            let times = [median(times[clock].iter().copied()), worst, cpu];
            row.extend(times.map(|t| format!("{t:.0}")));
        }
        rows.push(row);
    }
    format!(
        "Milliseconds from the start of `raytree view` on an OBJ file of {} triangles until its picture covers the screen (in \
         coarse blocks at first), medians and the worst of {STARTS} starts, and processor time until then. The bar is {} ms.\n\n{}",
        triangles.len(),
        FIRST.as_millis(),
        markdown(&head, &rows)
    )
}

fn main() {
    // `cargo test` runs this program as well, without the flag.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    if !std::env::args().any(|a| a == "start") {
        publish("keys", &keys());
    }
    publish("start", &first_picture());
}
