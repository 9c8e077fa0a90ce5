//! Imports and inline paths of a file.

use super::lexer::Token;

/// One name that a `use` brings in.
#[derive(Clone, Debug, PartialEq)]
pub struct Use {
    /// The name here; `*` for all.
    pub name: String,
    /// The path as it is written.
    pub path: Vec<String>,
    /// True if it is passed on to others.
    pub public: bool,
}

/// All names that a file's `use` lines bring in.
pub fn uses(tokens: &[Token]) -> Vec<Use> {
    let mut found = Vec::new();
    for (start, end) in statements(tokens) {
        let public = tokens[..start]
            .last()
            .is_some_and(|t| matches!(t.text, "pub" | ")"));
        let mut at = start + 1;
        tree(&tokens[..end], &mut at, &[], &mut |path, name| {
            found.push(Use { name, path, public });
        });
    }
    found
}

/// From each `use` to its semicolon.
fn statements(tokens: &[Token]) -> Vec<(usize, usize)> {
    let starts = (0..tokens.len()).filter(|at| tokens[*at].text == "use");
    starts
        .filter_map(|start| {
            let length = tokens[start..].iter().position(|t| t.text == ";")?;
            Some((start, start + length))
        })
        .collect()
}

/// A tree of `a::{b, c::d as e}`, leaf by leaf.
fn tree(
    tokens: &[Token],
    at: &mut usize,
    before: &[String],
    tell: &mut impl FnMut(Vec<String>, String),
) {
    let mut path = before.to_vec();
    while let Some(token) = tokens.get(*at) {
        *at += 1;
        match token.text {
            "::" => {}
            "{" => {
                while tokens.get(*at).is_some_and(|t| t.text != "}") {
                    tree(tokens, at, &path, tell);
                    if tokens.get(*at).is_some_and(|t| t.text == ",") {
                        *at += 1;
                    }
                }
                *at += 1;
                return;
            }
            "*" => return tell(path, "*".to_string()),
            "as" => {
                let name = tokens.get(*at).map_or("_", |t| t.text);
                *at += 1;
                return tell(path, name.to_string());
            }
            name => {
                // `{self}` is the path before it.
                if name != "self" || path.is_empty() {
                    path.push(name.to_string());
                }
                let next = tokens.get(*at).map(|t| t.text);
                if !matches!(next, Some("::" | "as")) {
                    let name = path.last().cloned().unwrap_or_default();
                    return tell(path, name);
                }
            }
        }
    }
}

/// Paths of two names and more that stand in the code, and single names, without those of `use` lines.
pub fn paths(tokens: &[Token]) -> Vec<Vec<String>> {
    let inside = statements(tokens);
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if let Some((_, end)) = inside.iter().find(|(start, _)| *start == at) {
            at = *end;
        } else if is_name(tokens[at].text) && (at == 0 || tokens[at - 1].text != ".") {
            let mut path = vec![tokens[at].text.to_string()];
            while let [colons, name, ..] = &tokens[at + 1..]
                && colons.text == "::"
                && is_name(name.text)
            {
                path.push(name.text.to_string());
                at += 2;
            }
            found.push(path);
        }
        at += 1;
    }
    found
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

#[test]
fn uses_and_paths_are_found() {
    use super::lexer::code;
    let text = "pub use a::{self, b::{C, D as E}, *}; use super::F; fn g() { h::i(J) + x.k }";
    let tokens = code(text);
    let found = uses(&tokens);
    let names: Vec<(&str, String, bool)> = found
        .iter()
        .map(|u| (u.name.as_str(), u.path.join("::"), u.public))
        .collect();
    let expected = [
        ("a", "a", true),
        ("C", "a::b::C", true),
        ("E", "a::b::D", true),
        ("*", "a", true),
        ("F", "super::F", false),
    ];
    let expected = expected.map(|(name, path, public)| (name, path.to_string(), public));
    assert_eq!(names, expected);
    let found: Vec<String> = paths(&tokens).iter().map(|p| p.join("::")).collect();
    assert_eq!(found, ["pub", "fn", "g", "h::i", "J", "x"]);
}
