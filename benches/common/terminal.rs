//! A program on a terminal of our own, and the moment at which each of its redraws ends.

#![allow(dead_code)] // Not every program that includes this file needs all of it.

use std::io::{Read, Write};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use super::program::raytree;
use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};

/// How long anything may take.
const PATIENCE: Duration = Duration::from_secs(60);

/// A program that has neither written nor worked for so long waits for its user.
const QUIET: Duration = Duration::from_millis(400);

/// Every redraw ends with this: "the update is complete".
const END: &[u8] = b"\x1b[?2026l";

/// A running debugger.
pub struct Terminal {
    child: Box<dyn Child + Send + Sync>,
    keyboard: Box<dyn Write + Send>,
    _master: Box<dyn MasterPty + Send>,
    /// What it writes, and when that was read.
    output: Receiver<(Instant, Vec<u8>)>,
    /// The last bytes, since a chunk may end within [`END`].
    tail: Vec<u8>,
    screen: vt100::Parser,
    /// Before it was started.
    pub started: Instant,
}

impl Terminal {
    /// Starts `raytree view` with these arguments on a screen of this many columns and rows.
    pub fn view(args: &[&str], (cols, rows): (u16, u16)) -> Self {
        let size = PtySize {
            rows,
            cols,
            pixel_width: 0,
            pixel_height: 0,
        };
        let pair = native_pty_system()
            .openpty(size)
            .expect("a pseudo-terminal");
        let mut command = CommandBuilder::new(raytree());
        command.arg("view");
        command.args(args);
        command.env("TERM", "xterm-256color");
        command.env("COLORTERM", "truecolor");
        command.env_remove("NO_COLOR");
        let mut reader = pair.master.try_clone_reader().expect("its output");
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut bytes = vec![0; 1 << 16];
            while let Ok(n @ 1..) = reader.read(&mut bytes) {
                if sender.send((Instant::now(), bytes[..n].to_vec())).is_err() {
                    break;
                }
            }
        });
        let started = Instant::now();
        Self {
            child: pair.slave.spawn_command(command).expect("the program"),
            keyboard: pair.master.take_writer().expect("a keyboard"),
            _master: pair.master,
            output,
            tail: Vec::new(),
            screen: vt100::Parser::new(rows, cols, 0),
            started,
        }
    }

    /// Reads until a redraw ends, and tells when that was.
    pub fn redraw(&mut self) -> Instant {
        loop {
            let next = self.output.recv_timeout(PATIENCE);
            let (when, bytes) = next.expect("the debugger redraws");
            if self.take_in(&bytes) {
                return when;
            }
        }
    }

    /// Reads until a redraw after which the screen is as wanted.
    pub fn until(&mut self, wanted: impl Fn(&vt100::Screen) -> bool) -> Instant {
        loop {
            let when = self.redraw();
            if wanted(self.screen.screen()) {
                return when;
            }
        }
    }

    /// Reads until it waits for its user, and tells when the last redraw ended, if there was one.
    pub fn settled(&mut self) -> Option<Instant> {
        let (mut last, mut worked) = (None, None);
        loop {
            let before = worked.replace(self.cpu());
            match self.output.recv_timeout(QUIET) {
                Ok((when, bytes)) => last = self.take_in(&bytes).then_some(when).or(last),
                Err(_) if before == worked => return last,
                Err(_) => {}
            }
        }
    }

    /// Presses a key: how long until the screen is redrawn.
    pub fn press(&mut self, key: &str) -> Duration {
        // As a user would: when nothing moves any more.
        while let Ok((_, bytes)) = self.output.recv_timeout(Duration::from_millis(10)) {
            self.take_in(&bytes);
        }
        let pressed = Instant::now();
        self.keyboard.write_all(key.as_bytes()).expect("a keyboard");
        self.keyboard.flush().expect("a keyboard");
        self.redraw() - pressed
    }

    /// Processor time that it has used.
    pub fn cpu(&self) -> Duration {
        cpu(&self.process())
    }

    /// Its number.
    pub fn process(&self) -> String {
        self.child.process_id().unwrap_or(0).to_string()
    }

    /// What is on the screen.
    pub fn text(&self) -> String {
        self.screen.screen().contents()
    }

    /// True if a redraw ends in these bytes.
    fn take_in(&mut self, bytes: &[u8]) -> bool {
        self.screen.process(bytes);
        self.tail.extend(bytes);
        let ends = self.tail.windows(END.len()).any(|part| part == END);
        // Nothing of what is kept is found again: it is too short.
        let keep = self.tail.len().min(END.len() - 1);
        self.tail.drain(..self.tail.len() - keep);
        ends
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Processor time that a process has used, by all its threads. Zero where the system does not tell.
pub fn cpu(process: &str) -> Duration {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
    // After the name in brackets: utime and stime are the 12th and 13th, in hundredths of a second.
    let after = stat.rsplit(')').next().unwrap_or_default();
    let fields = after.split_whitespace().skip(11).take(2);
    let ticks: u64 = fields.filter_map(|f| f.parse::<u64>().ok()).sum();
    Duration::from_millis(10 * ticks)
}

/// True if the picture covers its place, if only with coarse blocks.
pub fn covered(screen: &vt100::Screen) -> bool {
    let (rows, columns) = screen.size();
    let half = |y, x| screen.cell(y, x).is_some_and(|c| c.contents() == "▀");
    // Below it are three lines of text.
    let rows = rows - 3;
    let cells = (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x)));
    let painted = cells.filter(|(y, x)| half(*y, *x)).count();
    // All but the marks around the cursor.
    painted + 20 >= usize::from(rows) * usize::from(columns)
}
