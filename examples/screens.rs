//! Draws screens of the program as SVG files for the README and the book, from the real screen on a terminal of 120x36:
//! `cargo build --release && cargo run --release --example screens` (behind `--` may stand the names of some).

use std::error::Error;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};

#[path = "screens/svg.rs"]
pub mod svg;

/// Columns and rows of the terminal.
const SIZE: (u16, u16) = (120, 36);
/// How long anything may take.
const PATIENCE: Duration = Duration::from_secs(60);
/// A screen that has not changed for so long is whole.
const QUIET: Duration = Duration::from_secs(5);

/// A screen that is drawn.
pub struct Shot {
    /// The name of its file in `book/src/pictures`.
    pub name: &'static str,
    /// What it shows, for those who do not see it.
    pub title: &'static str,
    /// The arguments of the program.
    pub args: &'static [&'static str],
    /// Keys, each behind what must be on the screen before they are typed.
    pub keys: &'static [(&'static str, &'static str)],
    /// What is on the screen at the end.
    pub wanted: &'static str,
}

/// The screens of the README and the book.
pub const SHOTS: [Shot; 3] = [
    Shot {
        name: "debugger",
        title: "The debugger: the ray tree of a pixel, its picture, and the diffuse term with its numbers",
        args: &["view", "whitted", "--size", "120x66", "--at", "50,38/R"],
        keys: &[("event 11 of", "nnnnnnnnnnnnnnnn")],
        wanted: "diffuse term of",
    },
    Shot {
        name: "lesson",
        title: "A lesson: chapters and exercises, the text with its numbers, and the picture",
        args: &["lesson", "--state", STATE],
        keys: &[("chapter 1 of", ">>>>>>>>")],
        wanted: "One more ray answers",
    },
    Shot {
        name: "question",
        title: "A question, asked in the debugger before the step that answers it",
        args: &["lesson", "run", "who-blocks", "--state", STATE],
        keys: &[],
        wanted: "before the answer",
    },
];

/// Stands for a file of progress that is not there yet.
const STATE: &str = "STATE";

fn main() -> Result<(), Box<dyn Error>> {
    let example = std::env::current_exe()?;
    let folder = example.parent().and_then(Path::parent);
    let program = folder
        .ok_or("no folder")?
        .join(format!("raytree{}", std::env::consts::EXE_SUFFIX));
    let names: Vec<String> = std::env::args().skip(1).collect();
    for shot in SHOTS
        .iter()
        .filter(|shot| names.is_empty() || names.iter().any(|name| name == shot.name))
    {
        let mut last = Instant::now();
        let svg = shot.draw(&program, |changed| {
            if changed {
                last = Instant::now();
            }
            last.elapsed() > QUIET
        })?;
        let path = format!("book/src/pictures/{}.svg", shot.name);
        std::fs::write(&path, svg)?;
        println!("{path}");
    }
    Ok(())
}

impl Shot {
    /// The screen as SVG, once it is `whole`, which is asked again and again, and told whether the screen may have changed.
    pub fn draw(
        &self,
        program: &Path,
        mut whole: impl FnMut(bool) -> bool,
    ) -> Result<String, Box<dyn Error>> {
        let mut terminal = self.typed(program)?;
        let started = Instant::now();
        while !whole(terminal.read()) && started.elapsed() < PATIENCE {}
        Ok(svg::drawing(terminal.screen.screen(), self.title))
    }

    /// The program after all keys.
    fn typed(&self, program: &Path) -> Result<Terminal, Box<dyn Error>> {
        let mut terminal = Terminal::start(program, self.args)?;
        for (before, keys) in self.keys {
            terminal.wait_for(before)?;
            terminal.keyboard.write_all(keys.as_bytes())?;
            terminal.keyboard.flush()?;
        }
        terminal.wait_for(self.wanted)?;
        Ok(terminal)
    }

    /// The screen as SVG, as soon as it is `expected` or does not change any more.
    pub fn drawn_as(&self, program: &Path, expected: &str) -> Result<String, Box<dyn Error>> {
        let mut terminal = self.typed(program)?;
        let started = Instant::now();
        let (mut last, mut since) = (String::new(), started);
        loop {
            terminal.read();
            let svg = svg::drawing(terminal.screen.screen(), self.title);
            if svg != last {
                since = Instant::now();
                last.clone_from(&svg);
            }
            if svg == expected || since.elapsed() > QUIET || started.elapsed() > PATIENCE {
                return Ok(svg);
            }
        }
    }
}

/// The program on a terminal of our own.
struct Terminal {
    child: Box<dyn Child + Send + Sync>,
    progress: PathBuf,
    keyboard: Box<dyn Write + Send>,
    _master: Box<dyn MasterPty + Send>,
    output: Receiver<Vec<u8>>,
    screen: vt100::Parser,
}

impl Terminal {
    fn start(program: &Path, args: &[&str]) -> Result<Self, Box<dyn Error>> {
        let (cols, rows) = SIZE;
        let size = PtySize {
            rows,
            cols,
            pixel_width: 0,
            pixel_height: 0,
        };
        let pair = native_pty_system().openpty(size)?;
        let mut command = CommandBuilder::new(program);
        let progress =
            std::env::temp_dir().join(format!("raytree-screens-{}.json", std::process::id()));
        // There may be none.
        drop(std::fs::remove_file(&progress));
        for arg in args {
            if *arg == STATE {
                command.arg(&progress);
            } else {
                command.arg(arg);
            }
        }
        command.cwd(std::env::current_dir()?);
        command.env("TERM", "xterm-256color");
        command.env("COLORTERM", "truecolor");
        command.env_remove("NO_COLOR");
        command.env_remove("FORCE_COLOR");
        let child = pair.slave.spawn_command(command)?;
        let mut reader = pair.master.try_clone_reader()?;
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut bytes = vec![0; 1 << 16];
            while let Ok(n @ 1..) = reader.read(&mut bytes) {
                if sender.send(bytes[..n].to_vec()).is_err() {
                    break;
                }
            }
        });
        Ok(Self {
            child,
            progress,
            keyboard: pair.master.take_writer()?,
            _master: pair.master,
            output,
            screen: vt100::Parser::new(rows, cols, 0),
        })
    }

    /// Takes in what the program writes now; false if there was nothing.
    fn read(&mut self) -> bool {
        let bytes = self.output.recv_timeout(Duration::from_millis(20));
        let bytes = bytes.unwrap_or_default();
        self.screen.process(&bytes);
        !bytes.is_empty()
    }

    fn wait_for(&mut self, part: &str) -> Result<(), Box<dyn Error>> {
        let started = Instant::now();
        while !self.screen.screen().contents().contains(part) {
            self.read();
            if started.elapsed() > PATIENCE {
                return Err(
                    format!("never saw `{part}`:\n{}", self.screen.screen().contents()).into(),
                );
            }
        }
        Ok(())
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        // It may have ended by itself.
        drop(self.child.kill());
        drop(self.child.wait());
        drop(std::fs::remove_file(&self.progress));
    }
}
