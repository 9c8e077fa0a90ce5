//! Parser of queries: recursive descent over the grammar in [`super`].

use std::str::FromStr;

use strum::VariantNames;

use super::error::{QueryError, error};
use super::pattern::Pattern;
use super::quantity::NodeQuantity;
use super::token::{Token, tokens};
use super::{Property, TreeQuery};
use crate::probe::{AbsenceReason, RayKind};
use crate::scene::read::did_you_mean::did_you_mean;

/// Brackets inside of each other, and `not` before `not`, at most.
const DEEPEST: u32 = 50;

/// Words that stand alone.
const WORDS: [(&str, Property); 8] = [
    ("hit", Property::Hit),
    ("miss", Property::Miss),
    ("front", Property::Front),
    ("back", Property::Back),
    ("I", Property::Kind(RayKind::Incident)),
    ("L", Property::Kind(RayKind::Light)),
    ("R", Property::Kind(RayKind::Reflected)),
    ("T", Property::Kind(RayKind::Transmitted)),
];

/// Words that a name follows, and an example of each.
const NAMED: [(&str, &str); 7] = [
    ("hits", "hits:ball"),
    ("material", "material:glass"),
    ("part", "part:wall"),
    ("lit", "lit:lamp"),
    ("blocked", "blocked:lamp"),
    ("absent", "absent:depth-limit"),
    ("path", "path:TT>floor"),
];

impl FromStr for TreeQuery {
    type Err = QueryError;

    fn from_str(text: &str) -> Result<Self, QueryError> {
        let mut parser = Parser {
            tokens: tokens(text)?,
            next: 0,
            end: text.chars().count(),
        };
        let query = parser.any(0)?;
        match parser.tokens.get(parser.next) {
            None => Ok(query),
            Some((at, _)) => Err(error(
                *at,
                "the query ends before this",
                "write `and` or `or` between two parts",
            )),
        }
    }
}

struct Parser {
    /// Each with the number of letters before it.
    tokens: Vec<(usize, Token)>,
    next: usize,
    end: usize,
}

impl Parser {
    fn any(&mut self, depth: u32) -> Result<TreeQuery, QueryError> {
        let mut query = self.all(depth)?;
        while self.take_word("or") {
            query = TreeQuery::Or(Box::new(query), Box::new(self.all(depth)?));
        }
        Ok(query)
    }

    fn all(&mut self, depth: u32) -> Result<TreeQuery, QueryError> {
        let mut query = self.part(depth)?;
        while self.take_word("and") {
            query = TreeQuery::And(Box::new(query), Box::new(self.part(depth)?));
        }
        Ok(query)
    }

    fn part(&mut self, depth: u32) -> Result<TreeQuery, QueryError> {
        let at = self.at();
        if depth > DEEPEST {
            return Err(error(at, "it is nested too deeply", "use fewer brackets"));
        }
        if self.take_word("not") {
            return Ok(TreeQuery::Not(Box::new(self.part(depth + 1)?)));
        }
        if self.take_word("some") {
            if !self.take(&Token::Open) {
                return Err(error(
                    self.at(),
                    "`some` needs brackets",
                    "write some(R and t < 1)",
                ));
            }
            return Ok(TreeQuery::Some(Box::new(self.inside(depth)?)));
        }
        if self.take(&Token::Open) {
            return self.inside(depth);
        }
        let Some((_, Token::Word(word))) = self.tokens.get(self.next).cloned() else {
            return Err(error(
                at,
                "a property is missing here",
                "write one, such as hits:ball or depth >= 3",
            ));
        };
        self.next += 1;
        if let Some((_, Token::Compare(comparison))) = self.tokens.get(self.next).cloned() {
            self.next += 1;
            return Ok(TreeQuery::Compare(
                quantity(at, &word)?,
                comparison,
                self.number()?,
            ));
        }
        property(at, &word)
    }

    /// What stands before a closing bracket.
    fn inside(&mut self, depth: u32) -> Result<TreeQuery, QueryError> {
        let query = self.any(depth + 1)?;
        if self.take(&Token::Close) {
            return Ok(query);
        }
        Err(error(
            self.at(),
            "a closing bracket is missing",
            "write `)`",
        ))
    }

    fn number(&mut self) -> Result<f64, QueryError> {
        let at = self.at();
        let number = match self.tokens.get(self.next) {
            Some((_, Token::Word(word))) => word.parse::<f64>().ok().filter(|x| x.is_finite()),
            _ => None,
        };
        self.next += 1;
        number.ok_or_else(|| error(at, "a number is missing here", "write one, such as 0.5"))
    }

    fn take(&mut self, token: &Token) -> bool {
        let there = self.tokens.get(self.next).is_some_and(|(_, t)| t == token);
        self.next += usize::from(there);
        there
    }

    fn take_word(&mut self, word: &str) -> bool {
        self.take(&Token::Word(word.to_string()))
    }

    fn at(&self) -> usize {
        self.tokens.get(self.next).map_or(self.end, |(at, _)| *at)
    }
}

/// The property that a word names.
fn property(at: usize, word: &str) -> Result<TreeQuery, QueryError> {
    if word == "tir" {
        let absent = Property::Absent("total-internal-reflection");
        return Ok(TreeQuery::Some(Box::new(TreeQuery::Is(absent))));
    }
    if let Some((_, property)) = WORDS.iter().find(|(name, _)| *name == word) {
        return Ok(TreeQuery::Is(property.clone()));
    }
    let Some((key, name)) = word.split_once(':').filter(|(_, name)| !name.is_empty()) else {
        return Err(unknown(at, word));
    };
    let pattern = Pattern(name.to_string());
    Ok(TreeQuery::Is(match key {
        "hits" => Property::Hits(pattern),
        "material" => Property::Material(pattern),
        "part" => Property::Part(pattern),
        "lit" => Property::Lit(pattern),
        "blocked" => Property::Blocked(pattern),
        "absent" => {
            let reasons = AbsenceReason::VARIANTS;
            let Some(reason) = reasons.iter().find(|reason| **reason == name) else {
                let cure = match did_you_mean(name, reasons.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("the reasons are: {}", reasons.join(", ")),
                };
                return Err(error(
                    at + "absent:".len(),
                    format!("`{name}` is no reason for absence"),
                    cure,
                ));
            };
            Property::Absent(reason)
        }
        "path" => path(name).ok_or_else(|| {
            error(
                at + "path:".len(),
                format!("`{name}` is no path"),
                "write the kinds of rays and an object, such as path:TT>floor",
            )
        })?,
        _ => return Err(unknown(at, word)),
    }))
}

/// The path in `TT>floor`.
fn path(text: &str) -> Option<Property> {
    let (kinds, object) = text
        .split_once('>')
        .filter(|(_, object)| !object.is_empty())?;
    let kind = |letter| match letter {
        'L' => Some(RayKind::Light),
        'R' => Some(RayKind::Reflected),
        'T' => Some(RayKind::Transmitted),
        _ => None,
    };
    let kinds = kinds.chars().map(kind).collect::<Option<_>>()?;
    Some(Property::Path(kinds, Pattern(object.to_string())))
}

/// The quantity that a word names.
fn quantity(at: usize, word: &str) -> Result<NodeQuantity, QueryError> {
    if let Some((_, quantity)) = NodeQuantity::PLAIN
        .into_iter()
        .find(|(name, _)| *name == word)
    {
        return Ok(quantity);
    }
    let of_light = word.split_once(':');
    let of_light =
        of_light.and_then(|(key, light)| NodeQuantity::of_light(key, Pattern(light.to_string())));
    of_light.ok_or_else(|| {
        if let Some(error) = no_number(at, word) {
            return error;
        }
        let plain = NodeQuantity::PLAIN.map(|(name, _)| name.to_string());
        let of_lights = NodeQuantity::OF_LIGHTS.map(|name| format!("{name}:LIGHT"));
        let all = [plain.as_slice(), of_lights.as_slice()].concat();
        let guess = did_you_mean(word, all.iter().map(String::as_str));
        let cure = match guess {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are: {}", all.join(", ")),
        };
        error(at, format!("`{word}` is no quantity"), cure)
    })
}

/// A property that is compared as if it were a number.
fn no_number(at: usize, word: &str) -> Option<QueryError> {
    let (_, property) = WORDS.iter().find(|(name, _)| *name == word)?;
    let what = match property {
        Property::Kind(_) => "a kind of ray",
        _ => "true or false",
    };
    Some(error(
        at,
        format!("`{word}` is {what} and no number"),
        match word {
            "R" | "T" => format!("write `{word} and t > 3`, or compare `reflectance`"),
            _ => format!("write `{word}` alone, or `{word} and t > 3`"),
        },
    ))
}

fn unknown(at: usize, word: &str) -> QueryError {
    let alone = WORDS.iter().map(|(name, _)| *name).chain(["tir"]);
    let with_name = NAMED.iter().map(|(name, _)| *name);
    let quantities = NodeQuantity::PLAIN.map(|(name, _)| name);
    if quantities.contains(&word) {
        return error(
            at,
            format!("`{word}` is a quantity"),
            format!("compare it, such as {word} > 1"),
        );
    }
    let key = word.split(':').next().unwrap_or(word);
    let guess = if word.contains(':') {
        did_you_mean(key, with_name)
    } else {
        did_you_mean(key, alone.clone().chain(with_name).chain(quantities))
    };
    let what = format!("`{word}` is no property of a ray");
    if let Some(near) = guess {
        return error(at, what, format!("did you mean `{near}`?"));
    }
    let examples: Vec<&str> = NAMED.iter().map(|(_, example)| *example).collect();
    let alone: Vec<&str> = alone.collect();
    let all = format!("there are: {}, {}", alone.join(", "), examples.join(", "));
    error(at, what, all)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> TreeQuery {
        text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
    }

    #[test]
    fn and_binds_tighter_than_or_and_brackets_change_that() {
        assert_eq!(
            parsed("hit or miss and back"),
            parsed("hit or (miss and back)")
        );
        assert_ne!(
            parsed("hit or miss and back"),
            parsed("(hit or miss) and back")
        );
        assert_eq!(parsed("not hit and miss"), parsed("(not hit) and miss"));
    }

    #[test]
    fn spaces_and_quotes_change_nothing() {
        assert_eq!(parsed("depth>=3"), parsed(" depth  >= 3 "));
        assert_eq!(
            parsed("hits:\"a b\""),
            TreeQuery::Is(Property::Hits(Pattern("a b".into())))
        );
        let floor = Pattern("floor".into());
        let kinds = vec![RayKind::Transmitted, RayKind::Reflected];
        assert_eq!(
            parsed("path:TR>floor"),
            TreeQuery::Is(Property::Path(kinds, floor))
        );
    }

    #[test]
    fn a_mistake_is_told_with_its_letter_and_a_cure() {
        for (text, at, words) in [
            ("", 0, "a property is missing"),
            ("hit and", 7, "a property is missing"),
            ("hit miss", 4, "`and` or `or`"),
            ("hitz:ball", 0, "did you mean `hits`?"),
            ("depth", 0, "compare it"),
            ("deph > 1", 0, "did you mean `depth`?"),
            ("depth > x", 8, "a number is missing"),
            ("depth > nan", 8, "a number is missing"),
            ("(hit", 4, "closing bracket"),
            ("hit !", 4, "`!=`"),
            ("some hit", 5, "brackets"),
            ("absent:x", 7, "total-internal-reflection"),
            ("absent:depth-limits", 7, "did you mean `depth-limit`?"),
            ("hit and absent:x", 15, "no reason"),
            ("path:X>y", 5, "path:TT>floor"),
            ("R > 3", 0, "a kind of ray"),
            ("R > 3", 0, "`reflectance`"),
            ("L < 3", 0, "`L and t > 3`"),
            ("hit = 1", 0, "true or false"),
            ("depth => 3", 6, "did you mean `>=`?"),
            ("depth =< 3", 6, "did you mean `<=`?"),
            ("depth == 3", 6, "did you mean `=`?"),
            ("depth <> 3", 6, "did you mean `!=`?"),
            ("hits:\"a", 0, "quotation mark"),
        ] {
            let error = text.parse::<TreeQuery>().expect_err(text);
            assert_eq!(error.at, at, "{text}: {error}");
            let said = error.to_string();
            assert!(said.contains(words), "{text}: {error}");
            // What is meant fits a line of a terminal.
            let has_guess = said.contains("did you mean");
            assert!(!has_guess || said.chars().count() <= 79, "{said}");
        }
        let deep = format!("{}hit{}", "(".repeat(900), ")".repeat(900));
        assert!(deep.parse::<TreeQuery>().is_err());
        assert!("not ".repeat(400).parse::<TreeQuery>().is_err());
        assert!("hit or ".repeat(1000).parse::<TreeQuery>().is_err());
    }
}
