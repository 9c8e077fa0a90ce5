//! Tokens of Rust source: names, numbers, `::` and single characters, without comments, texts and tests.

/// A token, and the line that it is on, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token<'t> {
    pub text: &'t str,
    pub line: usize,
}

/// The tokens of a file without those behind `#[cfg(test)]`.
pub fn code(text: &str) -> Vec<Token<'_>> {
    without_tests(&tokens(text))
}

/// All tokens of a file.
pub fn tokens(text: &str) -> Vec<Token<'_>> {
    let (mut tokens, mut at, mut line) = (Vec::new(), 0, 1);
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = skipped(rest).unwrap_or_else(|| {
            let length = token(rest, first);
            let text = &rest[..length];
            if !first.is_whitespace() {
                tokens.push(Token { text, line });
            }
            length
        });
        line += rest[..length].matches('\n').count();
        at += length;
    }
    tokens
}

/// Bytes of the comment or literal that begins here, if one does.
fn skipped(rest: &str) -> Option<usize> {
    if rest.starts_with("//") {
        return Some(rest.find('\n').unwrap_or(rest.len()));
    }
    if rest.starts_with("/*") {
        return Some(rest.find("*/").map_or(rest.len(), |end| end + 2));
    }
    let plain = rest.trim_start_matches(['b', 'c', 'r', '#']);
    let prefix = &rest[..rest.len() - plain.len()];
    if plain.starts_with('"') && prefix.contains('r') {
        let hashes = prefix.matches('#').count();
        let end = format!("\"{}", "#".repeat(hashes));
        let body = &plain[1..];
        return Some(prefix.len() + 1 + body.find(&end).map_or(body.len(), |e| e + end.len()));
    }
    if plain.starts_with('"') && !prefix.contains('#') {
        return Some(prefix.len() + closed(plain, '"'));
    }
    // A character, not a lifetime: 'x' or '\n'.
    let mut inner = plain.strip_prefix('\'')?.chars();
    let character = match inner.next()? {
        '\\' => true,
        _ => inner.next() == Some('\''),
    };
    (character && prefix.trim_start_matches('b').is_empty())
        .then(|| prefix.len() + closed(plain, '\''))
}

/// Bytes of a literal with escapes that begins and ends with `quote`.
fn closed(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        if !escaped && c == quote {
            return at + 1;
        }
        escaped = c == '\\' && !escaped;
    }
    text.len()
}

/// Bytes of the token that begins here.
fn token(rest: &str, first: char) -> usize {
    if first.is_alphanumeric() || first == '_' {
        let end = |c: char| !c.is_alphanumeric() && c != '_';
        return rest.find(end).unwrap_or(rest.len());
    }
    if rest.starts_with("::") {
        2
    } else {
        first.len_utf8()
    }
}

/// Where what is opened at `open` is closed; the end if it never is.
pub fn closing(tokens: &[Token], open: usize) -> usize {
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.text {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    tokens.len() - 1
}

fn without_tests<'t>(all: &[Token<'t>]) -> Vec<Token<'t>> {
    let (mut kept, mut at) = (Vec::new(), 0);
    while at < all.len() {
        let starts = |words: &[&str]| {
            let here = all[at..].iter().map(|t| t.text);
            here.take(words.len()).eq(words.iter().copied())
        };
        if starts(&["#", "[", "cfg", "(", "test", ")", "]"]) {
            at = item_end(all, at + 7) + 1;
        } else {
            kept.push(all[at]);
            at += 1;
        }
    }
    kept
}

/// The last token of the item that begins at `start`.
fn item_end(tokens: &[Token], start: usize) -> usize {
    let mut at = start;
    while at < tokens.len() {
        match tokens[at].text {
            ";" => return at,
            "{" => return closing(tokens, at),
            "(" | "[" => at = closing(tokens, at) + 1,
            _ => at += 1,
        }
    }
    tokens.len() - 1
}

#[test]
fn tokens_leave_out_comments_texts_and_tests() {
    let text = r##"
// a::b
fn f<'a>(x: &'a str) -> char { g("c::d", 'e', '\'', r#"h"i"#) } /* j */
#[cfg(test)]
mod tests { fn k() {} }
use l::m;"##;
    let words: Vec<&str> = code(text).iter().map(|t| t.text).collect();
    assert_eq!(
        words.join(" "),
        "fn f < ' a > ( x : & ' a str ) - > char { g ( , , , ) } use l :: m ;"
    );
    assert_eq!(code(text).last().map(|t| t.line), Some(6));
}
