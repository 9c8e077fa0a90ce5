//! The debugger on a pseudo-terminal: what a user sees, and that the terminal is as before when it is over.
#![cfg(unix)]

mod outside;
mod stories;
mod typed_at_random;

use std::io::{Read, Write};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
use raytree::scene::{Patch, VertexData, load, source};
use raytree::tracer::image::ColorLevel;
use raytree::tui::{Options, run};
use raytree::world::World;

/// How long anything may take before a test gives up.
const PATIENCE: Duration = Duration::from_secs(30);

/// A program on a terminal of our own.
pub struct Session {
    child: Box<dyn Child + Send + Sync>,
    master: Box<dyn MasterPty + Send>,
    keyboard: Box<dyn Write + Send>,
    output: Receiver<Vec<u8>>,
    screen: vt100::Parser,
    /// Everything that was written.
    raw: Vec<u8>,
    /// The beginning of a frame whose end was not read yet.
    frame: Vec<u8>,
    started: Instant,
}

impl Session {
    pub fn start(mut command: CommandBuilder) -> Self {
        let size = PtySize {
            rows: 36,
            cols: 120,
            pixel_width: 0,
            pixel_height: 0,
        };
        let pair = native_pty_system()
            .openpty(size)
            .expect("a pseudo-terminal");
        command.env("TERM", "xterm-256color");
        command.env("COLORTERM", "truecolor");
        command.env_remove("NO_COLOR");
        command.env_remove("FORCE_COLOR");
        let started = Instant::now();
        let child = pair.slave.spawn_command(command).expect("the program");
        let mut reader = pair.master.try_clone_reader().expect("its output");
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut bytes = vec![0; 65536];
            while let Ok(n @ 1..) = reader.read(&mut bytes) {
                if sender.send(bytes[..n].to_vec()).is_err() {
                    break;
                }
            }
        });
        Self {
            child,
            keyboard: pair.master.take_writer().expect("a keyboard"),
            master: pair.master,
            output,
            screen: vt100::Parser::new(36, 120, 0),
            raw: Vec::new(),
            frame: Vec::new(),
            started,
        }
    }

    /// `raytree` with these arguments.
    fn raytree(args: &[&str]) -> Self {
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_raytree"));
        command.args(args);
        Self::start(command)
    }

    pub fn text(&self) -> String {
        self.screen.screen().contents()
    }

    /// Shows what was written, a whole frame at a time, as a terminal does that knows synchronized output: half of a frame
    /// beside half of the one before is nothing that a user sees.
    fn take_in(&mut self, bytes: &[u8]) {
        const BEGIN: &[u8] = b"\x1b[?2026h";
        const END: &[u8] = b"\x1b[?2026l";
        let last = |of: &[u8], mark: &[u8]| of.windows(mark.len()).rposition(|part| part == mark);
        self.raw.extend(bytes);
        self.frame.extend(bytes);
        let begin = last(&self.frame, BEGIN);
        let whole = match begin {
            Some(begin) if last(&self.frame, END).is_none_or(|end| end < begin) => begin,
            _ => self.frame.len(),
        };
        let shown: Vec<u8> = self.frame.drain(..whole).collect();
        self.screen.process(&shown);
    }

    /// Reads what the program writes until the screen is as wanted.
    pub fn wait(&mut self, what: &str, wanted: impl Fn(&vt100::Screen) -> bool) {
        let start = Instant::now();
        while !wanted(self.screen.screen()) {
            if let Ok(bytes) = self.output.recv_timeout(Duration::from_millis(20)) {
                self.take_in(&bytes);
            }
            assert!(
                start.elapsed() < PATIENCE,
                "never saw {what}:\n{}",
                self.text()
            );
        }
    }

    pub fn wait_for(&mut self, part: &str) {
        self.wait(part, |screen| screen.contents().contains(part));
    }

    pub fn keys(&mut self, keys: &str) {
        self.keyboard
            .write_all(keys.as_bytes())
            .expect("a keyboard");
        self.keyboard.flush().expect("a keyboard");
    }

    /// Waits for the end and gives the exit status. The terminal must be as it was.
    pub fn end(&mut self) -> u32 {
        let start = Instant::now();
        let status = loop {
            if let Some(status) = self.child.try_wait().expect("a child") {
                break status;
            }
            assert!(
                start.elapsed() < PATIENCE,
                "it never ends:\n{}",
                self.text()
            );
            std::thread::sleep(Duration::from_millis(5));
        };
        while let Ok(bytes) = self.output.recv_timeout(Duration::from_millis(200)) {
            self.take_in(&bytes);
        }
        let screen = self.screen.screen();
        assert!(!screen.alternate_screen(), "the alternate screen stays");
        assert!(!screen.hide_cursor(), "the cursor stays hidden");
        assert_eq!(screen.mouse_protocol_mode(), vt100::MouseProtocolMode::None);
        assert!(!self.is_raw(), "the terminal stays raw");
        status.exit_code()
    }

    /// Whether the terminal hands over each key as it is, without a line of its own.
    fn is_raw(&self) -> bool {
        let modes = self.master.get_termios().expect("a terminal").local_flags;
        !format!("{modes:?}").contains("ICANON")
    }

    fn signal(&self, name: &str) {
        let id = self.child.process_id().expect("it runs").to_string();
        let status = std::process::Command::new("kill")
            .args(["-s", name, &id])
            .status();
        assert!(status.expect("kill").success());
    }
}

#[test]
fn picture_tree_resize_and_quit() {
    let mut session = Session::raytree(&["view", "whitted"]);
    session.wait_for("raytree trace whitted --size 120x66 --pixel 60,33");
    session.wait("the mouse caught", |s| {
        s.alternate_screen()
            && s.hide_cursor()
            && s.mouse_protocol_mode() != vt100::MouseProtocolMode::None
    });
    session.wait("colours", |s| {
        let sky = s.cell(0, 0).expect("a cell");
        sky.contents() == "▀" && matches!(sky.fgcolor(), vt100::Color::Rgb(..))
    });
    session.keys("\x1b[B\x1b[C\x1b[1;2C");
    session.wait_for("--pixel 69,34");
    session.keys("\r");
    session.wait_for("ray tree:");
    session.keys("nn");
    session.wait_for("event 2 of");
    session.keys("?");
    session.wait_for("Choosing a pixel");
    session.keys("q");
    session.wait("the help gone", |s| {
        !s.contents().contains("Choosing a pixel")
    });
    // Smaller, and a click on the third row of the tree.
    let size = PtySize {
        rows: 24,
        cols: 80,
        pixel_width: 0,
        pixel_height: 0,
    };
    session.master.resize(size).expect("resize");
    session.screen.screen_mut().set_size(24, 80);
    session.wait("the smaller screen", |s| {
        s.contents()
            .lines()
            .nth(23)
            .is_some_and(|l| l.contains("? help"))
    });
    session.keys("\x1b[<0;10;5M\x1b[<0;10;5m");
    session.wait("the third row", |s| {
        s.contents().lines().nth(4).is_some_and(|l| l.contains('▶'))
    });
    session.keys("q");
    // Another window shows another part of the same picture.
    session.wait_for("raytree trace whitted --size 120x66 --pixel 69,34");
    session.keys("q");
    assert_eq!(session.end(), 0);
}

#[test]
fn without_arguments_it_opens_and_control_c_quits() {
    // 0.3 s are promised on an idle machine. One that runs all tests at once is slower: the best of three counts.
    let first = (0..3).map(|_| {
        let mut session = Session::raytree(&[]);
        session.wait("the first picture", |s| {
            s.cell(0, 0).is_some_and(|c| c.contents() == "▀")
        });
        let first = session.started.elapsed();
        session.keys("\r");
        session.wait_for("ray tree:");
        session.keys("\x03");
        assert_eq!(session.end(), 0);
        first
    });
    let first = first.min().expect("three");
    println!("first picture after {first:?}");
    assert!(first < Duration::from_secs(3), "{first:?}");
}

#[test]
fn without_a_terminal_it_says_what_to_do() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["view", "whitted"])
        .output()
        .expect("the program");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1));
    assert!(message.contains("needs a terminal"), "{message}");
    assert!(message.contains("raytree trace whitted"), "{message}");
    assert!(output.stdout.is_empty());
}

#[test]
fn no_color_means_none() {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_raytree"));
    command.args(["view", "whitted", "--color", "never"]);
    let mut session = Session::start(command);
    session.wait_for("sRGB (");
    session.keys("\r");
    session.wait_for("ray tree:");
    session.keys("nr");
    session.wait_for("R: the reflected ray");
    let screen = session.screen.screen();
    let (rows, columns) = screen.size();
    let cells = (0..rows).flat_map(|y| (0..columns).filter_map(move |x| screen.cell(y, x)));
    for cell in cells {
        assert_eq!(cell.fgcolor(), vt100::Color::Default);
        assert_eq!(cell.bgcolor(), vt100::Color::Default);
    }
    session.keys("\x03");
    assert_eq!(session.end(), 0);
}

/// A closed window ends the debugger even where nobody sends SIGHUP, or where it is ignored: it must not stay behind
/// and read from a terminal that is gone for ever.
#[test]
fn a_terminal_that_is_gone_ends_it() {
    let mut command = CommandBuilder::new("sh");
    let program = env!("CARGO_BIN_EXE_raytree");
    command.args(["-c", &format!("trap '' HUP; exec '{program}' view whitted")]);
    let mut session = Session::start(command);
    session.wait_for("sRGB (");
    let Session {
        mut child,
        master,
        mut keyboard,
        output,
        ..
    } = session;
    // The thread that reads ends with the next output, and lets go of the terminal too.
    drop(output);
    keyboard.write_all(b"l").expect("a keyboard");
    std::thread::sleep(Duration::from_millis(300));
    drop((keyboard, master));
    let start = Instant::now();
    while child.try_wait().expect("a child").is_none() {
        assert!(start.elapsed() < PATIENCE, "it stays behind");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Names what is broken in the world of [`broken_world`].
const BROKEN: &str = "RAYTREE_TEST_BROKEN";

/// A panic while the debugger is open, by a world that no scene file can make: of the render threads, or of the
/// debugger itself.
#[test]
fn a_panic_leaves_nothing_behind_and_is_told() {
    for (broken, told) in [("normals", "this is a bug"), ("materials", "panicked at")] {
        let mut command = CommandBuilder::new(std::env::current_exe().expect("this test"));
        command.args(["--exact", "tui::broken_world", "--ignored", "--nocapture"]);
        command.env(BROKEN, broken);
        command.env("RUST_BACKTRACE", "0");
        let mut session = Session::start(command);
        assert_ne!(session.end(), 0);
        let raw = String::from_utf8_lossy(&session.raw);
        assert!(raw.contains("\x1b[?1049h"), "{broken}: it never began");
        let text = session.text();
        assert!(text.contains("panicked at"), "{broken}: {text}");
        assert!(text.contains(told), "{broken}: {text}");
    }
}

/// The program of the test above.
#[test]
#[ignore = "run by a_panic_leaves_nothing_behind_and_is_told, on a terminal"]
fn broken_world() {
    let scene = load("whitted").expect("a built-in scene");
    let settings = scene.settings;
    let mut world = World::new(scene, settings.accel);
    if std::env::var(BROKEN).as_deref() == Ok("materials") {
        world.scene.materials.clear();
    } else {
        for object in &mut world.scene.objects {
            let broken = VertexData {
                normal_indices: vec![[9; 3]; 2],
                ..VertexData::default()
            };
            object.vertices = Some(broken.into());
        }
    }
    let options = Options {
        scene: "broken".to_owned(),
        source: Arc::new(source("whitted").expect("a built-in scene")),
        patch: Patch::default(),
        color: ColorLevel::True,
        mouse: true,
        threads: 1,
        size: None,
        at: None,
        compare: None,
        marks: None,
        show: None,
        ask: None,
        folder: std::path::PathBuf::new(),
    };
    run(world, settings, options).expect("the debugger says what is wrong");
}
