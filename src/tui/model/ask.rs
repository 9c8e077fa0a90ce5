//! A question beside the panes: what is asked, what is typed, which hints are shown, what came of it. Whoever asks puts it there and
//! takes what is given; the debugger knows no course.

use crossterm::event::KeyCode;

use crate::debug::asked::AskedEvent;
use crate::scene::Settings;
use crate::trace::Address;

/// Letters of an answer at most.
const MOST_LETTERS: usize = 80;

/// Words that have a key of their own at most.
pub const MOST_KEYS: usize = 9;

/// Hints after which the difference with our tracer is shown.
pub const HINTS_BEFORE_DIFFERENCE: usize = 2;

/// A question.
#[derive(Clone, Debug)]
pub struct AskState {
    /// Where it is asked: chapter, exercise, which of how many.
    pub title: String,
    /// What is asked.
    pub text: String,
    /// What is switched on and off, in a line.
    pub remark: String,
    /// What is answered.
    pub kind: AskKind,
    /// The quantity that must not be seen before it is told.
    pub at: Option<Address>,
    /// Where what is known ends, as soon as the tree is there.
    pub asked: Option<AskedEvent>,
    /// How many hints there are.
    pub hints: usize,
    /// Those that are shown.
    pub shown: Vec<String>,
    /// What was typed by now.
    pub typed: String,
    /// What came of the answer.
    pub told: Option<AskTold>,
    /// What whoever asks is to do next.
    pub request: Option<AskRequest>,
}

/// What is answered.
#[derive(Clone, Debug, PartialEq)]
pub enum AskKind {
    /// Numbers that are typed: which, in words.
    Value(String),
    /// A word of these, by its number.
    Word(Vec<String>),
    /// A pixel of the picture.
    Pixel,
    /// A law of these, and the ray under the cursor.
    Law {
        /// What may be broken.
        among: Vec<String>,
        /// The settings of the tracer that is not broken.
        ours: Box<Settings>,
    },
}

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub enum AskReply {
    /// What was typed.
    Value(String),
    /// The number of a word, from 0.
    Word(usize),
    /// A pixel.
    Pixel((u32, u32)),
    /// The number of a law, from 0, and an event.
    Law(usize, usize),
}

/// What whoever asks is to do.
#[derive(Clone, Debug, PartialEq)]
pub enum AskRequest {
    /// Check an answer.
    Check(AskReply),
    /// Show the next hint.
    Hint,
    /// Go on: the answer was right, or is asked for anew.
    GoOn,
    /// Back to where it was asked.
    Leave,
}

/// What came of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct AskTold {
    /// Whether it is right.
    pub is_right: bool,
    /// What is said.
    pub text: String,
}

/// What a key did.
#[derive(Clone, Debug, PartialEq)]
pub enum AskKey {
    /// It is no key of the question.
    Other,
    /// It was taken.
    Taken,
    /// It cannot be meant.
    Wrong(String),
}

impl AskState {
    /// A question of which nothing is answered.
    pub fn new(title: impl Into<String>, text: impl Into<String>, kind: AskKind) -> Self {
        Self {
            title: title.into(),
            text: text.into(),
            remark: String::new(),
            kind,
            at: None,
            asked: None,
            hints: 0,
            shown: Vec::new(),
            typed: String::new(),
            told: None,
            request: None,
        }
    }

    /// True until it is answered.
    pub fn is_open(&self) -> bool {
        self.told.is_none()
    }

    /// True while an answer can be given: also after a wrong pixel or a wrong law, of which the next one is tried at once.
    pub fn takes_answers(&self) -> bool {
        let again = matches!(self.kind, AskKind::Pixel | AskKind::Law { .. });
        self.told
            .as_ref()
            .is_none_or(|told| again && !told.is_right)
    }

    /// True if the tracer that is shown has a mistake.
    pub fn is_of_a_bug(&self) -> bool {
        matches!(self.kind, AskKind::Law { .. })
    }

    /// True if other pixels and other settings would tell too much.
    pub fn hides(&self) -> bool {
        match self.kind {
            AskKind::Pixel => false,
            AskKind::Law { .. } => !self.told.as_ref().is_some_and(|told| told.is_right),
            AskKind::Value(_) | AskKind::Word(_) => self.is_open(),
        }
    }

    /// Takes a key of the answer itself.
    pub fn press(&mut self, code: KeyCode) -> AskKey {
        match (&self.kind, code) {
            _ if !self.is_open() => AskKey::Other,
            (AskKind::Word(words), KeyCode::Char(digit @ '1'..='9'))
                if words.len() <= MOST_KEYS =>
            {
                let number = digit as usize - '1' as usize;
                let count = words.len();
                if number < count {
                    return self.give(AskReply::Word(number));
                }
                AskKey::Wrong(format!("there are 1 to {count}"))
            }
            (AskKind::Word(words), _) if words.len() > MOST_KEYS => self.type_number(code),
            (AskKind::Value(_), _) => self.type_number(code),
            _ => AskKey::Other,
        }
    }

    fn type_number(&mut self, code: KeyCode) -> AskKey {
        let is_begun = !self.typed.is_empty();
        match code {
            KeyCode::Char('0'..='9' | '.' | '-' | ',' | '(') => {}
            // Letters and blanks mean something else until a number is begun.
            KeyCode::Char('e' | 'E' | '+' | '/' | ' ' | ')') if is_begun => {}
            KeyCode::Backspace if is_begun => {
                self.typed.pop();
                return AskKey::Taken;
            }
            KeyCode::Enter if is_begun => return self.enter(),
            _ => return AskKey::Other,
        }
        if let KeyCode::Char(letter) = code
            && self.typed.len() < MOST_LETTERS
        {
            self.typed.push(letter);
        }
        AskKey::Taken
    }

    fn enter(&mut self) -> AskKey {
        let AskKind::Word(words) = &self.kind else {
            return self.give(AskReply::Value(self.typed.clone()));
        };
        let number = self.typed.parse::<usize>().ok();
        let number = number.and_then(|n| n.checked_sub(1));
        match number.filter(|n| *n < words.len()) {
            Some(number) => self.give(AskReply::Word(number)),
            None => AskKey::Wrong(format!("there are 1 to {}", words.len())),
        }
    }

    /// Gives an answer to whoever asks.
    pub fn give(&mut self, reply: AskReply) -> AskKey {
        (self.told, self.request) = (None, Some(AskRequest::Check(reply)));
        AskKey::Taken
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers() -> AskState {
        AskState::new("", "", AskKind::Value("a number".to_owned()))
    }

    fn words(count: usize) -> AskState {
        let words = (0..count).map(|n| format!("word {n}")).collect();
        AskState::new("", "", AskKind::Word(words))
    }

    fn type_in(ask: &mut AskState, letters: &str) {
        for letter in letters.chars() {
            ask.press(KeyCode::Char(letter));
        }
    }

    #[test]
    fn numbers_are_taken_as_they_are_typed() {
        for typed in ["-2.5", "1e-3", "1/3", "0.5,-1, 2"] {
            let mut ask = numbers();
            type_in(&mut ask, typed);
            ask.press(KeyCode::Char('7'));
            ask.press(KeyCode::Backspace);
            assert_eq!(ask.press(KeyCode::Enter), AskKey::Taken);
            let given = AskReply::Value(typed.to_owned());
            assert_eq!(ask.request, Some(AskRequest::Check(given)));
        }
    }

    #[test]
    fn letters_are_letters_of_the_debugger_until_a_number_is_begun() {
        let mut ask = numbers();
        for code in [
            KeyCode::Char('e'),
            KeyCode::Char('/'),
            KeyCode::Char(' '),
            KeyCode::Enter,
            KeyCode::Backspace,
        ] {
            assert_eq!(ask.press(code), AskKey::Other, "{code:?}");
        }
        assert_eq!(ask.request, None);
    }

    #[test]
    fn a_word_is_chosen_by_a_key_and_one_of_many_by_its_number() {
        let given = |n| Some(AskRequest::Check(AskReply::Word(n)));
        let mut ask = words(2);
        assert!(matches!(ask.press(KeyCode::Char('3')), AskKey::Wrong(_)));
        assert_eq!(ask.press(KeyCode::Char('2')), AskKey::Taken);
        assert_eq!(ask.request, given(1));
        let mut ask = words(12);
        type_in(&mut ask, "11");
        assert_eq!(
            (ask.request.clone(), ask.press(KeyCode::Enter)),
            (None, AskKey::Taken)
        );
        assert_eq!(ask.request, given(10));
        let mut ask = words(12);
        type_in(&mut ask, "13");
        assert!(matches!(ask.press(KeyCode::Enter), AskKey::Wrong(_)));
    }
}
