//! Model: everything that a screen shows.

use std::borrow::Cow;
use std::sync::Arc;
use std::time::Instant;

use ratatui::layout::Rect;

use super::action::Context;
use super::ask::AskState;
use super::ask_lines::ask_rows;
use super::change::{Before, PendingChange};
use super::layout::{Pane, Panes, Shown, inside};
use super::message::Job;
use super::motion::{History, LongRun, Play, PlayUnit};
use super::options::Options;
use super::overlay::Overlay;
use super::placement::Placement;
use crate::debug::breaks::BreakPoint;
use crate::debug::fan::Fan;
use crate::debug::marks::Marks;
use crate::debug::watch::Watch;
use crate::debug::{
    Axis, Convergence, ObjectOutline, PartialPicture, QuerySearch, Session, outlines,
};
use crate::lab::show::ShowMode;
use crate::scene::effects::{Finding, findings};
use crate::scene::{Patch, Settings, Warning};
use crate::trace::facts::TreePath;
use crate::world::World;

/// What the debugger asks of the program around it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Request {
    /// To go on.
    #[default]
    Stay,
    /// To be stopped until the shell says `fg`.
    Suspend,
    /// To end.
    Quit,
}

/// What the user arranged on the screen.
#[derive(Clone, Copy, Debug)]
pub struct LayoutState {
    /// The screen.
    pub screen: Rect,
    /// The pane that has the keys while a tree is open.
    pub focus: Pane,
    /// True if it stands alone.
    pub zoom: bool,
    /// First line of the details that is shown.
    pub scroll: u16,
    /// From where the ray paths are seen.
    pub axis: Axis,
    /// The eye rays that are drawn beside the tree.
    pub fan: Option<Fan>,
}

/// The state.
pub struct Model {
    /// The scene and its accelerator.
    pub world: Arc<World>,
    /// How it is rendered; the size is that of the image.
    pub settings: Settings,
    /// What the command line chose.
    pub options: Options,
    /// Every effect, and whether the scene calls for it.
    pub findings: Vec<Finding>,
    /// The objects as the drawing of the ray paths shows them.
    pub outlines: Vec<ObjectOutline>,
    /// The image.
    pub picture: PartialPicture,
    /// What the picture shows in the place of colours.
    pub show: Option<ShowMode>,
    /// What the pixel under the cursor shows.
    pub picked: String,
    /// The open tree.
    pub session: Option<Box<Session>>,
    /// Since when a pixel is being traced.
    pub waiting: Option<Instant>,
    /// The convergence of the pixel under the cursor, if that is shown.
    pub convergence: Option<Convergence>,
    /// Steps that run by themselves, if they do.
    pub play: Option<Play>,
    /// What a step of these is.
    pub play_unit: PlayUnit,
    /// Where a run through the log stops.
    pub breaks: Vec<BreakPoint>,
    /// A run or a search that takes long.
    pub running: Option<LongRun>,
    /// Numbers that are watched.
    pub watches: Vec<Watch>,
    /// Places that were left by jumps.
    pub history: History,
    /// The query that is searched for.
    pub search: Option<QuerySearch>,
    /// The question of a lesson that is answered here.
    pub ask: Option<AskState>,
    /// What lies over the panes.
    pub overlay: Option<Overlay>,
    /// Of the text that is typed, how many letters stand behind the place where the next one goes.
    pub behind: usize,
    /// What the user arranged.
    pub layout: LayoutState,
    /// One sentence for the user, until the next key.
    pub message: Option<String>,
    /// What is changed of the scene.
    pub patch: Patch,
    /// The change that is being made.
    pub changing: Option<PendingChange>,
    /// The settings, and the changes of the scene, before each change, the last one at the end.
    pub undone: Vec<(Settings, Patch)>,
    /// What the last change left: the other one of two pictures to look at in turn.
    pub before: Option<Box<Before>>,
    /// True if the picture shows how far both are apart.
    pub is_difference: bool,
    /// The ray to go to when the pixel is traced again.
    pub again: Option<TreePath>,
    /// Marked places, and the number of the one that was shown last.
    pub marks: Marks,
    pub marked: usize,
    /// True if marks were made that are in no file.
    pub unsaved: bool,
    /// What the terminal is asked to copy next.
    pub clipboard: Option<String>,
    /// True if the mouse is caught.
    pub mouse: bool,
    /// What the main loop is asked to do next.
    pub request: Request,
    /// What the worker is asked to do next, in this order.
    pub jobs: Vec<Job>,
}

impl Model {
    /// A world on a screen of this size, with an empty picture.
    pub fn new(mut world: World, settings: Settings, mut options: Options, screen: Rect) -> Self {
        world.scene = world.scene.with_printable_names();
        let marks = Marks::new(&options.scene, settings.size());
        Self {
            outlines: outlines(&world.scene),
            findings: findings(&world.scene),
            world: Arc::new(world),
            settings,
            mouse: options.mouse,
            patch: options.patch.clone(),
            ask: options.ask.take().map(|ask| *ask),
            show: options.show,
            options,
            picture: PartialPicture::default(),
            picked: String::new(),
            session: None,
            waiting: None,
            convergence: None,
            play: None,
            play_unit: PlayUnit::default(),
            breaks: Vec::new(),
            running: None,
            watches: Vec::new(),
            history: History::default(),
            search: None,
            overlay: None,
            behind: 0,
            changing: None,
            undone: Vec::new(),
            before: None,
            is_difference: false,
            again: None,
            marks,
            marked: 0,
            unsaved: false,
            clipboard: None,
            layout: LayoutState {
                screen,
                focus: Pane::Tree,
                zoom: false,
                scroll: 0,
                axis: Axis::Side,
                fan: None,
            },
            message: None,
            request: Request::Stay,
            jobs: Vec::new(),
        }
    }

    /// What the keys mean at present.
    pub fn context(&self) -> Context {
        match (&self.overlay, &self.session) {
            (Some(Overlay::Prompt(..)), _) => Context::Prompt,
            (Some(Overlay::Effects(_)), _) => Context::Effects,
            (Some(Overlay::Places(_)), _) => Context::Places,
            (Some(Overlay::Help(_) | Overlay::Warnings(_) | Overlay::Report(..)), _) => {
                Context::Text
            }
            (_, Some(_)) => Context::Tree,
            (_, None) => Context::Picture,
        }
    }

    /// The warnings about the scene, and about the picture as soon as all of it is there.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = self.world.scene.warnings.clone();
        if self.picture.progress() >= 1.0 && self.picture.hidden.is_none() {
            let cuts = &self.picture.cuts;
            warnings.extend(cuts.warning(&self.options.scene, &self.world.scene, &self.settings));
        }
        warnings
    }

    /// The picture before, if it is shown how far this one is from that.
    fn other(&self) -> Option<&PartialPicture> {
        let before = self.before.as_ref().filter(|_| self.is_difference)?;
        (before.show == self.show).then_some(&before.picture)
    }

    /// What the picture shows: itself, or how far it is from the one before.
    pub fn shown(&self) -> Cow<'_, PartialPicture> {
        match self.other() {
            Some(other) => Cow::Owned(self.picture.minus(other)),
            None => Cow::Borrowed(&self.picture),
        }
    }

    /// What its numbers are; none if it shows colours.
    pub fn unit(&self) -> Option<&'static str> {
        if self.other().is_some() {
            return Some("difference");
        }
        self.show.map(ShowMode::unit)
    }

    /// True while the cursor moves by itself.
    pub fn is_moving(&self) -> bool {
        self.play.is_some() || self.running.is_some()
    }

    /// The layout of the screen.
    pub fn panes(&self) -> Panes {
        self.panes_on(self.layout.screen)
    }

    /// The layout of another screen.
    pub fn panes_on(&self, screen: Rect) -> Panes {
        let shown = if self.session.is_some() {
            Shown::Tree {
                focus: self.layout.focus,
                zoom: self.layout.zoom,
            }
        } else {
            Shown::Picture
        };
        self.panes_for(screen, shown)
    }

    /// The layout of what is to be shown on another screen.
    pub fn panes_for(&self, screen: Rect, shown: Shown) -> Panes {
        match &self.ask {
            Some(ask) => Panes::beside(screen, shown, ask_rows(ask, screen)),
            None => Panes::new(screen, shown),
        }
    }

    /// Which pixel of the picture lies where.
    pub fn placement(&self, panes: &Panes) -> Placement {
        let area = if self.session.is_some() {
            inside(panes.picture)
        } else {
            panes.picture
        };
        Placement::new(self.picture.window, area)
    }
}
