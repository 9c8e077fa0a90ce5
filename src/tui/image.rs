//! How the image follows the screen and the cursor.

use ratatui::layout::Rect;

use super::app::App;
use super::layout::{Panes, Shown};
use super::picture::Picture;

impl App {
    /// The screen has another size.
    pub fn resize(&mut self, screen: Rect) {
        if screen != self.screen {
            self.screen = screen;
            self.refit();
        }
    }

    /// Fits the image to the screen again and renders it. An open tree keeps the image that it belongs to.
    pub fn refit(&mut self) {
        if self.session.is_none() && self.fit() {
            self.render();
            self.look();
        }
    }

    /// Gives the image the size of its pane, unless the command line chose one; the cursor stays at the same place of
    /// the scene. True if anything changed.
    pub fn fit(&mut self) -> bool {
        let pane = Panes::new(self.screen, Shown::Picture).picture;
        let visible = (
            u32::from(pane.width).max(1),
            2 * u32::from(pane.height).max(1),
        );
        let size = self.options.size.unwrap_or(visible);
        let (old, cursor) = (self.picture.size, self.picture.cursor);
        let fitted = Picture::new(size, visible, (0, 0));
        let same = |a: &Picture, b: &Picture| {
            a.size == b.size
                && a.window.width == b.window.width
                && a.window.height == b.window.height
        };
        if same(&fitted, &self.picture) {
            return false;
        }
        let scaled = |at: u32, old: u32, new: u32| {
            let middle = (2 * u64::from(at) + 1) * u64::from(new) / (2 * u64::from(old.max(1)));
            middle as u32
        };
        let cursor = (
            scaled(cursor.0, old.0, fitted.size.0),
            scaled(cursor.1, old.1, fitted.size.1),
        );
        self.picture = Picture::new(size, visible, cursor);
        (self.settings.image.width, self.settings.image.height) = self.picture.size;
        true
    }

    /// Renders what is not known of the image.
    pub fn render(&mut self) {
        let (window, known) = (self.picture.window, self.picture.known());
        self.renderer
            .render(&self.world, self.settings, window, known);
    }

    /// The cursor is on another pixel.
    pub fn moved(&mut self) {
        if self.waiting.take().is_some() {
            self.renderer.give_up_trace();
        }
        if self.picture.follow() {
            self.render();
        }
        self.look();
    }

    /// Renders everything anew: the settings are others. An open tree is traced again.
    pub fn redo(&mut self) {
        self.picture.forget();
        self.render();
        self.look();
        if self.session.is_some() || self.waiting.is_some() {
            self.open();
        }
    }

    /// Looks what stands behind the pixel under the cursor, and how it nears its value if that is shown.
    pub fn look(&mut self) {
        self.restart_nearing();
        let seen = crate::trace::pick(&self.world, &self.settings, self.picture.cursor);
        self.seen = seen.map_or_else(
            || "nothing: the background".to_owned(),
            |seen| {
                let t = crate::trace::format::num(seen.t);
                format!("{} ({}) at t = {t}", seen.object, seen.shape)
            },
        );
    }
}
