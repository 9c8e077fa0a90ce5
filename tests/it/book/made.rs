//! Pieces of a page that are made from the program: they stand between `<!-- made: NAME -->` and `<!-- end -->`.

use super::{page, source};

/// What stands in a piece of a text now.
pub fn piece<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let (_, behind) = text.split_once(&format!("<!-- made: {name} -->\n"))?;
    let (piece, _) = behind.split_once("<!-- end -->")?;
    (!piece.contains("<!-- made:")).then_some(piece)
}

/// The names of all pieces of a text.
pub fn names(text: &str) -> Vec<&str> {
    let pieces = text.split("<!-- made: ").skip(1);
    pieces
        .filter_map(|piece| piece.split_once(" -->"))
        .map(|(name, _)| name)
        .collect()
}

/// The heading before a piece.
pub fn heading<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let (before, _) = text.split_once(&format!("<!-- made: {name} -->\n"))?;
    before.lines().rev().find_map(|line| {
        line.strip_prefix("## ")
            .or_else(|| line.strip_prefix("### "))
    })
}

/// A page has all of these pieces and no others. With RAYTREE_BOOK they are written.
#[track_caller]
pub fn shows(name: &str, pieces: &[(String, String)]) {
    let mut text = page(name);
    for piece in names(&text) {
        assert!(
            pieces.iter().any(|(made, _)| made == piece),
            "{name}: nothing makes `{piece}`"
        );
    }
    for (made, wanted) in pieces {
        let now = piece(&text, made)
            .unwrap_or_else(|| panic!("{name} needs <!-- made: {made} --> and <!-- end -->"));
        if std::env::var_os("RAYTREE_BOOK").is_none() {
            assert_eq!(
                now, wanted,
                "{name}, {made}: RAYTREE_BOOK=1 cargo test --test it book makes it anew"
            );
        }
        let start = format!("<!-- made: {made} -->\n");
        text = text.replacen(
            &format!("{start}{now}<!-- end -->"),
            &format!("{start}{wanted}<!-- end -->"),
            1,
        );
    }
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        std::fs::write(source().join(name), text).expect("the page is written");
    }
}

/// Text for a cell of a table.
pub fn cell(text: &str) -> String {
    text.split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .replace('|', "\\|")
}

#[test]
fn a_piece_is_found_with_its_heading() {
    let text =
        "## One\n\n<!-- made: a -->\nx\n<!-- end -->\n### Two\n<!-- made: b -->\n<!-- end -->\n";
    assert_eq!(
        (piece(text, "a"), piece(text, "b"), piece(text, "c")),
        (Some("x\n"), Some(""), None)
    );
    assert_eq!(
        (heading(text, "a"), heading(text, "b")),
        (Some("One"), Some("Two"))
    );
    assert_eq!(names(text), ["a", "b"]);
}
