//! Tokens of a query: brackets, comparisons and words.

use super::Relation;
use super::error::{QueryError, error};

/// Bytes of a query at most.
const LONGEST: usize = 2000;

/// A token.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// `(`
    Open,
    /// `)`
    Close,
    /// `<` and the like.
    Compare(Relation),
    /// Anything else, without its quotes.
    Word(String),
}

/// The tokens of a text, each with the number of letters before it.
pub fn tokens(text: &str) -> Result<Vec<(usize, Token)>, QueryError> {
    if text.len() > LONGEST {
        return Err(error(
            0,
            "the query is too long",
            format!("{LONGEST} bytes are allowed"),
        ));
    }
    let letters: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut next = 0;
    while let Some(&letter) = letters.get(next) {
        let at = next;
        next += 1;
        let token = match letter {
            letter if letter.is_whitespace() => continue,
            '(' => Token::Open,
            ')' => Token::Close,
            '<' | '>' | '=' | '!' => {
                if let Some(meant) = misspelt(letter, letters.get(next)) {
                    let what = "this is no comparison";
                    return Err(error(at, what, format!("did you mean `{meant}`?")));
                }
                let equal = letters.get(next) == Some(&'=');
                next += usize::from(equal && letter != '=');
                Token::Compare(match (letter, equal) {
                    ('<', false) => Relation::Less,
                    ('<', true) => Relation::AtMost,
                    ('>', false) => Relation::More,
                    ('>', true) => Relation::AtLeast,
                    ('=', _) => Relation::Equal,
                    (_, true) => Relation::Unequal,
                    (_, false) => {
                        return Err(error(
                            at,
                            "`!` stands alone",
                            "write `!=`, or `not` before a property",
                        ));
                    }
                })
            }
            _ => {
                let (word, end) = word(&letters, at)?;
                next = end;
                Token::Word(word)
            }
        };
        tokens.push((at, token));
    }
    Ok(tokens)
}

/// The comparison that other languages, or tired fingers, write so.
fn misspelt(first: char, second: Option<&char>) -> Option<&'static str> {
    match (first, second?) {
        ('=', '>') => Some(">="),
        ('=', '<') => Some("<="),
        ('=', '=') => Some("="),
        ('<', '>') => Some("!="),
        _ => None,
    }
}

/// The word that begins at a letter, without its quotes, and where it ends.
fn word(letters: &[char], at: usize) -> Result<(String, usize), QueryError> {
    let (mut word, mut next, mut quoted) = (String::new(), at, false);
    while let Some(&letter) = letters.get(next) {
        // The arrow of a path belongs to its word.
        let is_arrow = letter == '>' && word.starts_with("path:");
        let ends = letter.is_whitespace() || "()<>=!".contains(letter);
        if ends && !quoted && !is_arrow {
            break;
        }
        match letter {
            '"' => quoted = !quoted,
            letter => word.push(letter),
        }
        next += 1;
    }
    if quoted {
        return Err(error(
            at,
            "a quotation mark is missing",
            "write `\"` at the end of the name",
        ));
    }
    Ok((word, next))
}
