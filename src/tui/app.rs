//! The state of the debugger, and how actions change it. Drawing (see [`super::draw`]) only reads it.

use std::sync::Arc;
use std::time::{Duration, Instant};

use ratatui::layout::Rect;

use super::Options;
use super::actions::{Action, Context};
use super::layout::{Pane, Panes, Shown, inside};
use super::nearing::Nearing;
use super::outline::{self, Outline};
use super::path_pane::Axis;
use super::picture::Picture;
use super::renderer::{News, Renderer};
use super::session::Session;
use super::{details, help};
use crate::scene::Settings;
use crate::scene::effects::{Finding, findings};
use crate::trace::Cursor;
use crate::world::World;

/// How long Enter waits for the tree before the screen is drawn and other keys have their turn: within a frame of 16 ms.
const AT_ONCE: Duration = Duration::from_millis(10);

/// What lies over the panes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The help, from this line on.
    Help(u16),
    /// The number of an event is typed.
    GoTo(String),
    /// The effects, with this one chosen.
    Effects(usize),
}

/// What the debugger wants of the program around it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wish {
    /// To go on.
    #[default]
    Stay,
    /// To be stopped until the shell says `fg`.
    Suspend,
    /// To end.
    Quit,
}

/// Everything that a screen shows is in here.
pub struct App {
    /// The scene and its accelerator.
    pub world: Arc<World>,
    /// How it is rendered; the size is that of the image.
    pub settings: Settings,
    /// What the command line chose.
    pub options: Options,
    /// The screen.
    pub screen: Rect,
    /// Every effect, and whether the scene calls for it.
    pub findings: Vec<Finding>,
    /// The image.
    pub picture: Picture,
    /// What the pixel under the cursor looks at.
    pub seen: String,
    /// The open tree.
    pub session: Option<Box<Session>>,
    /// Since when a pixel is being traced.
    pub waiting: Option<Instant>,
    /// How the pixel under the cursor nears its value, if that is shown.
    pub nearing: Option<Nearing>,
    /// What lies over the panes.
    pub overlay: Option<Overlay>,
    /// The pane that has the keys while a tree is open.
    pub focus: Pane,
    /// True if it stands alone.
    pub zoom: bool,
    /// The objects as the drawing of the path shows them.
    pub outlines: Vec<Outline>,
    /// From where the path is seen.
    pub axis: Axis,
    /// One sentence for the user, until the next key.
    pub message: Option<String>,
    /// True if the mouse is caught.
    pub mouse: bool,
    /// What the main loop is asked to do next.
    pub wish: Wish,
    /// Who works in the background.
    pub renderer: Renderer,
}

impl App {
    /// The picture of a world on a screen of this size; rendering begins at once.
    pub fn new(world: World, settings: Settings, options: Options, screen: Rect) -> Self {
        let mut app = Self {
            outlines: outline::outlines(&world.scene),
            findings: findings(&world.scene),
            world: Arc::new(world),
            settings,
            renderer: Renderer::new(options.threads),
            mouse: options.mouse,
            options,
            screen,
            picture: Picture::default(),
            seen: String::new(),
            session: None,
            waiting: None,
            nearing: None,
            overlay: None,
            focus: Pane::Tree,
            zoom: false,
            axis: Axis::Side,
            message: None,
            wish: Wish::Stay,
        };
        app.fit();
        app.picture.cursor = (app.picture.size.0 / 2, app.picture.size.1 / 2);
        app.picture.follow();
        app.render();
        app.look();
        app
    }

    /// Does what a user asks for.
    pub fn handle(&mut self, action: Action) {
        self.message = None;
        match action {
            Action::Quit => self.wish = Wish::Quit,
            Action::Suspend => self.wish = Wish::Suspend,
            Action::Back => self.back(),
            Action::Help => {
                self.overlay = match self.overlay {
                    Some(Overlay::Help(_)) => None,
                    _ => Some(Overlay::Help(0)),
                }
            }
            Action::Mouse => {
                self.mouse = !self.mouse;
                let text = if self.mouse {
                    "the mouse picks and scrolls"
                } else {
                    "the mouse is the terminal's: select text with it; m takes it back"
                };
                self.message = Some(text.to_owned());
            }
            Action::Rows(by) | Action::Move(_, by) if self.scrolls_help(by) => {}
            Action::Pages(by) if self.scrolls_help(by * 10) => {}
            // Any other key closes the help, and does no more.
            _ if matches!(self.overlay, Some(Overlay::Help(_))) => self.overlay = None,
            Action::Effects => self.show_effects(),
            Action::Choose(by) => self.choose_effect(by),
            Action::Switch => self.switch_effect(),
            Action::Nearing => self.show_nearing(),
            Action::Move(dx, dy) => {
                let before = self.picture.cursor;
                self.picture.move_by(dx, dy);
                if self.picture.cursor != before {
                    self.moved();
                }
            }
            Action::Open => self.open(),
            Action::View => self.axis = self.axis.next(),
            Action::Zoom => self.zoom = !self.zoom,
            Action::NextPane => self.focus = self.focus.next(true),
            Action::PreviousPane => self.focus = self.focus.next(false),
            Action::GoTo => self.overlay = Some(Overlay::GoTo(String::new())),
            Action::Erase => {
                if let Some(Overlay::GoTo(digits)) = &mut self.overlay {
                    digits.pop();
                }
            }
            Action::Accept => self.accept(),
            Action::Rows(by) => self.by_rows(by),
            Action::Pages(by) => {
                let page = inside(self.panes().place(self.focus)).height.max(2) - 1;
                self.by_rows(by * i32::from(page));
            }
            _ => self.step(action),
        }
    }

    /// Moves through the log.
    fn step(&mut self, action: Action) {
        let Some(session) = &mut self.session else {
            return;
        };
        let (cursor, tree) = (session.cursor(), session.tree());
        let found = match action {
            Action::Step => Some(cursor.step(tree)),
            Action::StepBack => Some(cursor.back()),
            Action::Over => Some(cursor.over(tree)),
            Action::Out => Some(cursor.out(tree)),
            Action::Start => Some(Cursor::start()),
            Action::End => Some(Cursor::end(tree)),
            Action::NextRay(kind) => cursor.next_ray(tree, kind),
            Action::PreviousRay(kind) => cursor.previous_ray(tree, kind),
            Action::Unfold => return session.fold(false),
            Action::Fold => return session.fold(true),
            Action::Toggle => return session.toggle(),
            _ => return,
        };
        match (found, action) {
            (Some(cursor), _) => session.go(cursor),
            (None, Action::NextRay(kind)) => {
                self.message = Some(format!("no {} ray comes after this", kind.letter()));
            }
            (None, Action::PreviousRay(kind)) => {
                self.message = Some(format!("no {} ray comes before this", kind.letter()));
            }
            (None, _) => {}
        }
    }

    pub fn by_rows(&mut self, by: i32) {
        let room = inside(self.panes().details);
        let Some(session) = &mut self.session else {
            return;
        };
        match self.focus {
            Pane::Tree | Pane::Picture => {
                let row = session.row().saturating_add_signed(by as isize);
                session.go_to_row(row);
            }
            Pane::Details => {
                let lines = details::lines(session, self.options.color, room.width).len();
                let last = lines.saturating_sub(usize::from(room.height)) as u16;
                session.scroll = session.scroll.saturating_add_signed(by as i16).min(last);
            }
            Pane::Steps => {
                let steps = session.steps();
                if !steps.is_empty() {
                    let here = session
                        .cursor()
                        .position()
                        .clamp(steps.start, steps.end - 1);
                    let on_a_step = here == session.cursor().position();
                    let by = if on_a_step { by as isize } else { 0 };
                    let to = here
                        .saturating_add_signed(by)
                        .clamp(steps.start, steps.end - 1);
                    session.go(Cursor::at(session.tree(), to));
                }
            }
            Pane::Path => session.go_by_rays(by),
        }
    }

    fn back(&mut self) {
        if self.overlay.take().is_some() {
            return;
        }
        if self.waiting.take().is_some() {
            self.renderer.give_up_trace();
        } else if self.nearing.is_some() {
            self.hide_nearing();
        } else if self.zoom && self.session.is_some() {
            self.zoom = false;
        } else if self.session.take().is_some() {
            self.refit();
        } else {
            self.wish = Wish::Quit;
        }
    }

    /// Traces the pixel under the cursor. Most are done at once, so that keys typed ahead mean what they should; for
    /// others a spinner turns.
    pub fn open(&mut self) {
        let start = Instant::now();
        self.waiting = Some(start);
        self.renderer
            .trace(&self.world, self.settings, self.picture.cursor);
        while self.renderer.is_tracing() && start.elapsed() < AT_ONCE {
            if !self.receive() {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }

    fn accept(&mut self) {
        if let Some(Overlay::GoTo(digits)) = self.overlay.take()
            && let Some(session) = &mut self.session
            && let Ok(number) = digits.parse::<usize>()
        {
            session.go(Cursor::at(session.tree(), number));
        }
    }

    /// A letter was typed where a number is asked for.
    pub fn typed(&mut self, letter: char) {
        if let Some(Overlay::GoTo(digits)) = &mut self.overlay
            && letter.is_ascii_digit()
            && digits.len() < 9
        {
            digits.push(letter);
        }
    }

    /// Scrolls the help if it is shown.
    pub fn scrolls_help(&mut self, by: i32) -> bool {
        let last = help::last_scroll(self.screen);
        let Some(Overlay::Help(scroll)) = &mut self.overlay else {
            return false;
        };
        *scroll = scroll.saturating_add_signed(by as i16).min(last);
        true
    }

    /// What the keys mean at present.
    pub fn context(&self) -> Context {
        match (&self.overlay, &self.session) {
            (Some(Overlay::GoTo(_)), _) => Context::Prompt,
            (Some(Overlay::Effects(_)), _) => Context::Effects,
            (_, Some(_)) => Context::Tree,
            (_, None) => Context::Picture,
        }
    }

    /// Takes in what the background has done by now. True if there was anything.
    pub fn receive(&mut self) -> bool {
        let mut any = false;
        while let Some(news) = self.renderer.news() {
            any = true;
            match news {
                News::Pixels(_, pixels) => {
                    for (at, color) in pixels {
                        self.picture.set(at, color);
                    }
                }
                News::Rendered(_) => {}
                News::Nearer(_, pixel) => {
                    if let Some(nearing) = &mut self.nearing {
                        nearing.points.push(pixel);
                    }
                }
                News::Near(_, end) => {
                    if let Some(nearing) = &mut self.nearing {
                        nearing.end = Some(end);
                    }
                }
                News::Traced(_, session) => {
                    self.session = Some(session);
                    self.waiting = None;
                }
            }
        }
        any
    }

    /// True while the background works.
    pub fn is_busy(&self) -> bool {
        self.renderer.is_working()
    }

    /// What is to be shown.
    pub fn shown(&self) -> Shown {
        if self.session.is_some() {
            Shown::Tree {
                focus: self.focus,
                zoom: self.zoom,
            }
        } else {
            Shown::Picture
        }
    }

    /// Where it stands.
    pub fn panes(&self) -> Panes {
        Panes::new(self.screen, self.shown())
    }
}
