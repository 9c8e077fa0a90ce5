//! Table of the keys of the lesson screen: dispatch, the help and the line of keys are made from it.

use crossterm::event::{KeyCode, KeyEvent};

use crate::tui::model::key::{Key, ch, control, key};

/// What a reader can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LessonAction {
    /// Begin the chosen exercise, or answer it where it is asked.
    Begin,
    /// To the next exercise that is open, wherever it is.
    NextOpen,
    /// To the exercise so many further in the chapter.
    Exercise(i32),
    /// To the chapter so many further.
    Chapter(i32),
    /// List the chapters to go to.
    Chapters,
    /// Scroll by so many lines.
    Scroll(i32),
    /// Scroll by so many pages.
    Page(i32),
    /// Show the next hint to the chosen exercise.
    Hint,
    /// Show the solution of the chosen exercise.
    Solution,
    /// The picture alone on the screen, and back.
    Picture,
    /// Catch the mouse, or leave it to the terminal.
    Mouse,
    /// Show or hide the keys.
    Help,
    /// Close what lies on top; at the bottom, leave.
    Back,
    /// Leave at once.
    Quit,
    /// Stop as a shell's Ctrl-Z does.
    Suspend,
}

/// A line of the table.
pub struct LessonBinding {
    /// The keys, and what each asks for.
    pub keys: &'static [(Key, LessonAction)],
    /// What they do, in a word or two.
    pub name: &'static str,
    /// What they do, in a sentence.
    pub doc: &'static str,
    /// True if the line of keys shows it.
    pub hint: bool,
}

const fn row(
    hint: bool,
    keys: &'static [(Key, LessonAction)],
    name: &'static str,
    doc: &'static str,
) -> LessonBinding {
    LessonBinding {
        keys,
        name,
        doc,
        hint,
    }
}

/// More lines than any text has.
pub const FAR: i32 = i16::MAX as i32;

/// The table.
#[rustfmt::skip]
pub const LESSON_KEYS: &[LessonBinding] = {
    use KeyCode::{BackTab, Down, End, Enter, Esc, Home, Left, PageDown, PageUp, Right, Tab, Up};
    use LessonAction as A;
    &[
        row(true, &[(key(Enter), A::Begin)], "begin", "Begin the chosen exercise; in a list, go there."),
        row(true, &[(ch('n'), A::NextOpen)], "next open", "To the next exercise that is open, in this chapter or a later one."),
        row(true, &[(ch('H'), A::Hint)], "hint", "The next of three hints to the chosen exercise: where to look, which law, almost the answer."),
        row(true, &[(ch('s'), A::Solution)], "solution", "The solution of the chosen exercise, once it is done; asked for twice, it gives the exercise up."),
        row(true, &[(key(Down), A::Scroll(1)), (key(Up), A::Scroll(-1)), (ch('j'), A::Scroll(1)), (ch('k'), A::Scroll(-1))], "scroll", "Scroll the text; in a list, choose."),
        row(false, &[(key(PageDown), A::Page(1)), (key(PageUp), A::Page(-1)), (ch(' '), A::Page(1)), (ch('b'), A::Page(-1))], "page", "The same by a page."),
        row(false, &[(key(Home), A::Scroll(-FAR)), (key(End), A::Scroll(FAR))], "start, end", "To the start of the text, to its end."),
        row(true, &[(key(Tab), A::Exercise(1)), (key(BackTab), A::Exercise(-1)), (key(Right), A::Exercise(1)), (key(Left), A::Exercise(-1))], "exercise", "To the next (previous) exercise of the chapter."),
        row(false, &[(ch('>'), A::Chapter(1)), (ch('<'), A::Chapter(-1))], "chapter", "To the next (previous) chapter."),
        row(true, &[(ch('g'), A::Chapters)], "go to chapter", "List the chapters, to go to one."),
        row(true, &[(ch('v'), A::Picture)], "picture large", "The picture alone on the screen, and back."),
        row(false, &[(ch('m'), A::Mouse)], "mouse", "Leave the mouse to the terminal, to select text, or take it again."),
        row(true, &[(ch('?'), A::Help)], "help", "This list."),
        row(true, &[(ch('q'), A::Back), (key(Esc), A::Back)], "back", "Close what lies on top; from the text, leave. Nothing is lost."),
        row(false, &[(control('c'), A::Quit)], "quit", "Leave at once."),
        #[cfg(unix)]
        row(false, &[(control('z'), A::Suspend)], "suspend", "Back to the shell for a while; fg comes back."),
    ]
};

/// What a key asks for.
pub fn lesson_action(event: KeyEvent) -> Option<LessonAction> {
    let keys = LESSON_KEYS.iter().flat_map(|b| b.keys);
    keys.into_iter()
        .find_map(|(key, action)| key.matches(event).then_some(*action))
}

impl LessonBinding {
    /// All its keys.
    pub fn labels(&self) -> String {
        let labels: Vec<_> = self.keys.iter().map(|(key, _)| key.label()).collect();
        labels.join(" ")
    }

    /// Its first key.
    pub fn label(&self) -> String {
        self.keys
            .first()
            .map_or_else(String::new, |(key, _)| key.label())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_of_the_lesson_screen_means_two_things() {
        let mut seen: Vec<Key> = Vec::new();
        for (key, action) in LESSON_KEYS.iter().flat_map(|b| b.keys) {
            assert!(!seen.contains(key), "{} twice", key.label());
            seen.push(*key);
            assert_eq!(lesson_action(key.event()), Some(*action));
        }
    }
}
