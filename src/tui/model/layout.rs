//! Layout of the panes: a pure function of the screen and of what is to be shown, so that drawing and the mouse agree.

use ratatui::layout::{Constraint, Layout, Position, Rect};

/// The panes that can have the focus while a tree is open, and the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pane {
    /// The picture with the cursor.
    Picture,
    /// The ray tree.
    Tree,
    /// The current event, explained.
    Details,
    /// The traversal of the acceleration structure.
    Steps,
    /// The rays in the scene.
    Path,
}

impl Pane {
    /// The panes that take the focus in turn.
    pub const FOCUS: [Self; 4] = [Self::Tree, Self::Details, Self::Steps, Self::Path];

    /// The pane after this one, or before it.
    #[must_use]
    pub fn next(self, forward: bool) -> Self {
        let count = Self::FOCUS.len();
        let here = Self::FOCUS.iter().position(|p| *p == self).unwrap_or(0);
        let by = if forward { 1 } else { count - 1 };
        Self::FOCUS[(here + by) % count]
    }
}

/// The part of the screen that may be covered: all but the line of keys.
pub fn covered(screen: Rect) -> Rect {
    Rect {
        height: screen.height.saturating_sub(1),
        ..screen
    }
}

/// What is to be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// The picture alone.
    Picture,
    /// A ray tree and the panes around it; those with the focus before others where there is little room.
    Tree {
        /// The pane that has the keys.
        focus: Pane,
        /// True if it stands alone.
        zoom: bool,
    },
}

/// Rectangles of the panes; an empty one is not shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Panes {
    /// The line at the top.
    pub title: Rect,
    /// Lines about the pixel under the cursor.
    pub status: Rect,
    /// The line of keys at the bottom.
    pub hint: Rect,
    /// The picture.
    pub picture: Rect,
    /// The tree.
    pub tree: Rect,
    /// The details.
    pub details: Rect,
    /// The steps.
    pub steps: Rect,
    /// The path.
    pub path: Rect,
    /// The question.
    pub ask: Rect,
}

impl Panes {
    /// The layout of a screen of which a question takes so many rows, above the line of keys.
    pub fn beside(screen: Rect, shown: Shown, rows: u16) -> Self {
        let rows = rows.min(screen.height);
        let free = Rect {
            height: screen.height - rows,
            ..screen
        };
        let mut panes = Self::new(free, shown);
        panes.ask = Rect {
            y: panes.hint.y,
            height: rows,
            ..screen
        };
        panes.hint.y += rows;
        panes
    }

    /// The layout of a screen.
    pub fn new(screen: Rect, shown: Shown) -> Self {
        match shown {
            Shown::Picture => Self::picture(screen),
            Shown::Tree { focus, zoom } => Self::tree(screen, focus, zoom),
        }
    }

    fn picture(screen: Rect) -> Self {
        let [hint, status] = match screen.height {
            0..4 => [0, 0],
            4..7 => [0, 1],
            _ => [1, 2],
        };
        let [picture, status, hint] = rows(
            screen,
            [
                Constraint::Fill(1),
                Constraint::Length(status),
                Constraint::Length(hint),
            ],
        );
        Self {
            status,
            hint,
            picture,
            ..Self::default()
        }
    }

    fn tree(screen: Rect, focus: Pane, zoom: bool) -> Self {
        let [title, hint] = match screen.height {
            0..6 => [0, 0],
            6..10 => [0, 1],
            _ => [1, 1],
        };
        let [title, body, hint] = rows(
            screen,
            [
                Constraint::Length(title),
                Constraint::Fill(1),
                Constraint::Length(hint),
            ],
        );
        let mut panes = Self {
            title,
            hint,
            ..Self::default()
        };
        let (width, height) = (body.width, body.height);
        if zoom || width < 50 || height < 12 {
            *panes.area_mut(focus) = body;
        } else if width >= 110 && height >= 26 {
            panes.all(body);
        } else {
            // The tree above, with the picture if there is room; below it what has the focus.
            let [above, below] = halves(body, 45);
            let picture = if width >= 72 { width * 3 / 10 } else { 0 };
            [panes.tree, panes.picture] =
                columns(above, [Constraint::Fill(1), Constraint::Length(picture)]);
            let lower = if focus == Pane::Tree {
                Pane::Details
            } else {
                focus
            };
            *panes.area_mut(lower) = below;
        }
        panes
    }

    /// Every pane.
    fn all(&mut self, body: Rect) {
        let side = (body.width * 38 / 100).min(76);
        let [left, right] = columns(body, [Constraint::Length(side), Constraint::Fill(1)]);
        [self.picture, self.path] = halves(left, 46);
        let below;
        [self.tree, below] = halves(right, 42);
        [self.details, self.steps] = columns(below, [Constraint::Fill(1), Constraint::Fill(1)]);
    }

    fn area_mut(&mut self, pane: Pane) -> &mut Rect {
        match pane {
            Pane::Picture => &mut self.picture,
            Pane::Tree => &mut self.tree,
            Pane::Details => &mut self.details,
            Pane::Steps => &mut self.steps,
            Pane::Path => &mut self.path,
        }
    }

    /// The rectangle of a pane.
    pub fn area(&self, pane: Pane) -> Rect {
        match pane {
            Pane::Picture => self.picture,
            Pane::Tree => self.tree,
            Pane::Details => self.details,
            Pane::Steps => self.steps,
            Pane::Path => self.path,
        }
    }

    /// The pane at a cell of the screen.
    pub fn at(&self, position: Position) -> Option<Pane> {
        let mut all = [Pane::Picture].into_iter().chain(Pane::FOCUS);
        all.find(|pane| self.area(*pane).contains(position))
    }
}

/// The inside of a pane with a frame.
pub fn inside(pane: Rect) -> Rect {
    if pane.width < 3 || pane.height < 3 {
        return Rect::default();
    }
    Rect {
        x: pane.x + 1,
        y: pane.y + 1,
        width: pane.width - 2,
        height: pane.height - 2,
    }
}

fn rows<const N: usize>(area: Rect, parts: [Constraint; N]) -> [Rect; N] {
    Layout::vertical(parts).areas(area)
}

fn columns<const N: usize>(area: Rect, parts: [Constraint; N]) -> [Rect; N] {
    Layout::horizontal(parts).areas(area)
}

/// Two parts above each other, the upper one with `percent` of the height.
fn halves(area: Rect, percent: u16) -> [Rect; 2] {
    let upper = (u32::from(area.height) * u32::from(percent) / 100) as u16;
    rows(area, [Constraint::Length(upper), Constraint::Fill(1)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panes_never_overlap_and_stay_on_the_screen() {
        for (width, height) in [
            (160, 50),
            (120, 36),
            (80, 24),
            (60, 20),
            (40, 10),
            (10, 5),
            (1, 1),
            (0, 0),
        ] {
            let screen = Rect::new(0, 0, width, height);
            for focus in Pane::FOCUS {
                for zoom in [false, true] {
                    let p = Panes::new(screen, Shown::Tree { focus, zoom });
                    let all = [
                        p.title, p.hint, p.picture, p.tree, p.details, p.steps, p.path,
                    ];
                    let area: u32 = all.iter().map(|r| r.area()).sum();
                    assert_eq!(area, screen.area(), "{width}x{height} {focus:?}");
                    assert!(
                        all.iter()
                            .all(|r| r.is_empty() || screen.union(*r) == screen)
                    );
                    let shown = !p.area(focus).is_empty() || screen.is_empty();
                    assert!(shown, "{width}x{height} {focus:?}");
                }
            }
        }
    }
}
