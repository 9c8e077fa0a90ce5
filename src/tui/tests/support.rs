//! Helpers of the screen tests: a program in memory, keys in, screens out.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use crate::probe::Silent;
use crate::scene::{Patch, SceneSource};
use crate::tracer::image::ColorLevel;
use crate::tracer::pixel;
use crate::tui::model::{Action, Message, Mouse, Options};
use crate::tui::panes;
use crate::tui::terminal::program::Program;
use crate::world::World;

impl Program {
    pub fn act(&mut self, action: Action) {
        self.send(Message::Action(action));
    }

    pub fn mouse(&mut self, mouse: Mouse, at: Position) {
        self.send(Message::Mouse(mouse, at));
    }

    pub fn press(&mut self, key: KeyEvent) -> bool {
        self.send(Message::Key(key))
    }

    pub fn resize(&mut self, screen: Rect) {
        self.send(Message::Resize(screen));
    }
}

pub fn app_with(width: u16, height: u16, change: impl FnOnce(&mut Options)) -> Program {
    of_scene("whitted", width, height, change)
}

pub fn of_scene(
    scene: &str,
    width: u16,
    height: u16,
    change: impl FnOnce(&mut Options),
) -> Program {
    let source = crate::scene::source(scene).expect("a built-in scene");
    of_source(scene, source, (width, height), change)
}

pub fn of_source(
    name: &str,
    source: SceneSource,
    (width, height): (u16, u16),
    change: impl FnOnce(&mut Options),
) -> Program {
    let scene = source.scene().expect("a scene");
    let settings = scene.settings;
    let world = World::new(scene, settings.accel);
    let mut options = Options {
        scene: name.to_owned(),
        source: Arc::new(source),
        patch: Patch::default(),
        color: ColorLevel::True,
        mouse: true,
        threads: 2,
        size: None,
        at: None,
        compare: None,
        marks: None,
        show: None,
        ask: None,
        folder: PathBuf::new(),
    };
    change(&mut options);
    Program::new(world, settings, options, Rect::new(0, 0, width, height))
}

pub fn app(width: u16, height: u16) -> Program {
    let mut app = app_with(width, height, |_| ());
    settle(&mut app);
    app
}

/// Waits until the background has done all its work.
pub fn settle(app: &mut Program) {
    let start = Instant::now();
    while app.is_busy() {
        app.receive();
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "the background never ends"
        );
        std::thread::sleep(Duration::from_millis(1));
    }
    app.receive();
}

pub fn buffer(app: &Program) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(
        app.model.layout.screen.width,
        app.model.layout.screen.height,
    ))
    .expect("in memory");
    terminal
        .draw(|frame| panes::draw(&app.model, frame.area(), frame.buffer_mut()))
        .expect("in memory");
    terminal.backend().buffer().clone()
}

pub fn text(app: &Program) -> String {
    text_of(&buffer(app))
}

/// A screen as lines of text.
pub fn text_of(buffer: &Buffer) -> String {
    let width = usize::from(buffer.area.width).max(1);
    let line = |cells: &[ratatui::buffer::Cell]| {
        cells
            .iter()
            .map(ratatui::buffer::Cell::symbol)
            .collect::<String>()
    };
    buffer
        .content
        .chunks(width)
        .map(|cells| line(cells) + "\n")
        .collect()
}

pub fn key(app: &mut Program, code: KeyCode) {
    app.press(KeyEvent::new(code, KeyModifiers::NONE));
    settle(app);
}

pub fn keys(app: &mut Program, letters: &str) {
    for letter in letters.chars() {
        key(app, KeyCode::Char(letter));
    }
}

/// Types letters, then Enter.
pub fn enter(app: &mut Program, letters: &str) {
    keys(app, letters);
    key(app, KeyCode::Enter);
}

/// Every pixel that is known is the tracer's, for the present scene and settings.
#[track_caller]
pub fn is_as_set(app: &Program) {
    let (width, height) = app.model.picture.size;
    for at in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let traced = pixel(&app.model.world, &app.model.settings, at, &mut Silent).color;
        assert_eq!(app.model.picture.color(at), Some(traced), "{at:?}");
    }
}

/// The tree of the pixel in the middle: a glass sphere.
pub fn opened(width: u16, height: u16) -> Program {
    let mut app = app(width, height);
    key(&mut app, KeyCode::Enter);
    assert!(app.model.session.is_some());
    app
}

pub fn position(app: &Program) -> usize {
    app.model
        .session
        .as_ref()
        .map_or(0, |s| s.cursor().position())
}
