//! Layout of the lesson screen: a pure function of the screen and of what is asked.

use ratatui::layout::{Constraint, Layout, Rect};

/// Rows of the exercises below the text.
const BELOW: u16 = 6;

/// Columns below which the picture and the list of chapters go, and then the exercises.
const WITH_PICTURE: u16 = 100;
const WITH_LIST: u16 = 70;

/// Rectangles of the lesson screen; an empty one is not shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LessonPanes {
    /// The line at the top.
    pub title: Rect,
    /// The list of chapters.
    pub chapters: Rect,
    /// The exercises of the chapter.
    pub exercises: Rect,
    /// The text.
    pub text: Rect,
    /// The picture.
    pub picture: Rect,
    /// A question that is asked here.
    pub ask: Rect,
    /// The line of keys.
    pub hint: Rect,
}

impl LessonPanes {
    /// The layout of a screen with so many rows for a question; `large` if the picture stands alone.
    pub fn new(screen: Rect, ask: u16, large: bool) -> Self {
        let lines = u16::from(screen.height >= 8);
        let [title, body, ask, hint] = Layout::vertical([
            Constraint::Length(lines),
            Constraint::Fill(1),
            Constraint::Length(ask.min(screen.height)),
            Constraint::Length(lines),
        ])
        .areas(screen);
        let panes = Self {
            title,
            ask,
            hint,
            ..Self::default()
        };
        if large {
            return Self {
                picture: body,
                ..panes
            };
        }
        let width = body.width;
        if width < WITH_PICTURE {
            // Formulas need the whole width: the exercises stand below the text.
            let below = if width >= WITH_LIST && body.height >= 16 {
                BELOW
            } else {
                0
            };
            let [text, exercises] =
                Layout::vertical([Constraint::Fill(1), Constraint::Length(below)]).areas(body);
            return Self {
                exercises,
                text,
                ..panes
            };
        }
        let (list, picture) = ((width / 4).min(36), width * 3 / 10);
        let [list, text, picture] = Layout::horizontal([
            Constraint::Length(list),
            Constraint::Fill(1),
            Constraint::Length(picture),
        ])
        .areas(body);
        let [chapters, exercises] =
            Layout::vertical([Constraint::Fill(2), Constraint::Fill(3)]).areas(list);
        Self {
            chapters,
            exercises,
            text,
            picture,
            ..panes
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_goes_first_then_the_lists_and_nothing_overlaps() {
        for width in (0..200).step_by(9).chain([1, 79, 80, 99, 100, 160]) {
            for height in (0..60).step_by(7).chain([1, 2, 24, 50]) {
                let screen = Rect::new(0, 0, width, height);
                for (ask, large) in [(0, false), (5, false), (0, true), (9, true)] {
                    let p = LessonPanes::new(screen, ask, large);
                    let all = [
                        p.title,
                        p.chapters,
                        p.exercises,
                        p.text,
                        p.picture,
                        p.ask,
                        p.hint,
                    ];
                    let area: u32 = all.iter().map(|r| r.area()).sum();
                    assert_eq!(area, screen.area(), "{width}x{height}");
                    let is_shown = |r: Rect| r.width > 0;
                    assert_eq!(is_shown(p.picture), width > 0 && (large || width >= 100));
                    assert_eq!(is_shown(p.chapters), !large && width >= 100);
                }
            }
        }
        let text = LessonPanes::new(Rect::new(0, 0, 80, 24), 0, false).text;
        assert_eq!((text.width, text.height), (80, 16));
    }
}
