//! Comparison of a text with the format: the first place where it is no scene, what is wrong there, and the right shape.
//!
//! It runs where the parser has refused a file, over its text and with the schema: nothing depends on the parser's words.

use std::cell::RefCell;
use std::collections::HashSet;
use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::expected::Expected;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::Problem;

/// Where the comparison is, and what it has found.
#[derive(Default)]
pub struct Comparison {
    /// Keys, and numbers of elements as `[3]`, from the outside.
    path: RefCell<Vec<String>>,
    /// What is wrong at the end of the path.
    pub problem: RefCell<Option<Problem>>,
    /// The last text of which nothing was expected.
    text: RefCell<Option<String>>,
}

/// Part of a text that is compared with the format.
#[derive(Clone, Copy)]
pub struct Part<'a> {
    at: &'a Comparison,
    /// What is expected; anything if it is none.
    expected: Option<Expected>,
    takes_null: bool,
}

impl Comparison {
    /// Path of the place, such as `objects[3].sphere.radius`.
    pub fn path(&self) -> String {
        self.path.borrow().join(".").replace(".[", "[")
    }
}

impl<'a> Part<'a> {
    /// The whole text.
    pub fn scene(at: &'a Comparison) -> Self {
        Self {
            at,
            expected: Some(Expected::scene()),
            takes_null: false,
        }
    }

    fn with(self, expected: Option<Expected>, takes_null: bool) -> Self {
        Self {
            expected,
            takes_null,
            ..self
        }
    }

    /// Goes on to a part inside.
    fn inside<T, E>(self, step: String, look: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        self.at.path.borrow_mut().push(step);
        let found = look()?;
        self.at.path.borrow_mut().pop();
        Ok(found)
    }

    /// Ends the comparison.
    fn refuse<T, E: Error>(self, what: impl Into<String>, cure: impl Into<String>) -> Result<T, E> {
        *self.at.problem.borrow_mut() = Some(Problem::new(what, cure));
        Err(E::custom("this is no scene"))
    }

    /// Ends the comparison at a field of this part.
    fn refuse_at<T, E: Error>(self, step: &str, what: String, cure: String) -> Result<T, E> {
        self.at.path.borrow_mut().push(step.to_owned());
        self.refuse(what, cure)
    }

    /// Something else than what is expected.
    fn other<E: Error>(self, found: &str) -> Result<(), E> {
        let Some(expected) = self.expected else {
            return Ok(());
        };
        let example = expected.example(false);
        if !expected.kinds().is_empty() {
            let what = "here is not an object {...} with one kind";
            return self.refuse(
                what,
                format!("put everything inside of its kind, such as {example}"),
            );
        }
        if !expected.words().is_empty() {
            return self.no_word(expected, found.trim_start_matches("the number "));
        }
        let last = self.last();
        let mut cure = if last.is_empty() || last.starts_with('[') {
            format!("write {example}")
        } else {
            format!("write {}", expected.as_field(&last))
        };
        if found == "null" {
            cure.push_str(", or leave the field out");
        }
        let words = expected.in_words();
        self.refuse(
            format!("here stands {found}; what is expected is {words}"),
            cure,
        )
    }

    /// A value where one of a few words is expected.
    fn no_word<E: Error>(self, expected: Expected, given: &str) -> Result<(), E> {
        let (last, words) = (self.last(), expected.in_words());
        let cure = match did_you_mean(given, expected.words()) {
            Some(near) if expected.words().len() > 1 => {
                format!("did you mean `{near}`? Possible here is {words}")
            }
            _ => format!("write \"{last}\": {words}"),
        };
        self.refuse(format!("there is no {last} `{given}`"), cure)
    }

    /// The last step of the path.
    fn last(self) -> String {
        self.at.path.borrow().last().cloned().unwrap_or_default()
    }

    fn whole_number<E: Error>(self, n: i128) -> Result<(), E> {
        let expected = self.expected.filter(|e| e.of_type("number").is_none());
        let range = expected.and_then(Expected::whole);
        match (expected, range) {
            (None, _) => Ok(()),
            (_, Some([least, most])) if (least..=most).contains(&n) => Ok(()),
            _ => self.other(&format!("the number {n}")),
        }
    }

    /// An object of which one kind is expected.
    fn one_kind<'de, A: MapAccess<'de>>(
        self,
        expected: Expected,
        mut map: A,
    ) -> Result<(), A::Error> {
        let Some(key) = map.next_key::<String>()? else {
            let cure = format!("name its kind, such as {}", expected.example(false));
            return self.refuse("the object {} does not say what it is", cure);
        };
        let Some(fields) = expected.kind(&key) else {
            return self.no_kind(expected, key, map);
        };
        self.inside(key.clone(), || {
            map.next_value_seed(self.with(Some(fields), false))
        })?;
        match map.next_key::<IgnoredAny>()? {
            None => Ok(()),
            Some(_) => self.refuse(
                "a second field stands beside the kind of an object",
                format!(
                    "one object has one kind: put everything inside, such as {}",
                    expected.example_of(&key, false)
                ),
            ),
        }
    }

    /// An object whose first key is no kind. The kind may stand as a text among its fields, or show by their names.
    fn no_kind<'de, A: MapAccess<'de>>(
        self,
        expected: Expected,
        first: String,
        mut map: A,
    ) -> Result<(), A::Error> {
        let kinds = expected.kinds();
        let listed = kinds.join(", ");
        let what = format!("there is no kind `{first}`");
        if let Some(near) = did_you_mean(&first, kinds.iter().copied()) {
            return self.refuse(
                what,
                format!("did you mean `{near}`? Possible here: {listed}"),
            );
        }
        let (mut keys, mut named) = (vec![first], None);
        loop {
            self.at.text.take();
            map.next_value_seed(self.with(None, true))?;
            let text = self.at.text.take().unwrap_or_default();
            named = named.or_else(|| kinds.iter().find(|kind| **kind == text));
            let Some(key) = map.next_key()? else {
                break;
            };
            keys.push(key);
        }
        let has_all = |kind: &&&str| {
            let fields = expected.kind(kind).map_or(Vec::new(), Expected::fields);
            keys.iter().all(|key| fields.contains(&key.as_str()))
        };
        let like = named.or_else(|| kinds.iter().find(has_all));
        let example = |kind: &&str| expected.example_of(kind, false);
        let cure = match like {
            Some(kind) => format!(
                "a kind is the key of an object around its fields: {}",
                example(kind)
            ),
            None => format!(
                "possible here: {listed}, such as {}",
                expected.example(false)
            ),
        };
        self.refuse(what, cure)
    }

    /// An object with fields, or with an entry for each name.
    fn fields<'de, A: MapAccess<'de>>(
        self,
        expected: Expected,
        mut map: A,
    ) -> Result<(), A::Error> {
        let mut given = HashSet::new();
        while let Some(key) = map.next_key::<String>()? {
            let Some((field, takes_null)) = expected.field(&key) else {
                let all = expected.fields();
                let list = all.join(", ");
                let cure = match did_you_mean(&key, all) {
                    Some(near) => format!("did you mean `{near}`? Possible here: {list}"),
                    None => format!("possible here: {list}"),
                };
                return self.refuse_at(&key, format!("there is no field `{key}`"), cure);
            };
            if given.contains(&key) {
                let cure = "keep one of them, or give the other a different name";
                return self.refuse(format!("`{key}` is given twice"), cure);
            }
            self.inside(key.clone(), || {
                map.next_value_seed(self.with(Some(field), takes_null))
            })?;
            given.insert(key);
        }
        let missing: Vec<&str> = expected
            .required()
            .filter(|name| !given.contains(*name))
            .collect();
        let add = |name: &&str| expected.field(name).map(|(field, _)| field.as_field(name));
        let cures: Vec<String> = missing.iter().filter_map(add).collect();
        let cure = format!("add {}", cures.join(", "));
        match &missing[..] {
            [] => Ok(()),
            [one] => self.refuse(format!("the field `{one}` is missing"), cure),
            more => self.refuse(
                format!("the fields `{}` are missing", more.join("`, `")),
                cure,
            ),
        }
    }
}

impl<'de> DeserializeSeed<'de> for Part<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Part<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a part of a scene")
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<(), E> {
        self.other(&format!("the value {value}"))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<(), E> {
        self.whole_number(number.into())
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<(), E> {
        self.whole_number(number.into())
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<(), E> {
        match self.expected {
            Some(expected) if expected.of_type("number").is_some() => Ok(()),
            _ => self.other(&format!("the number {number}")),
        }
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        if self.takes_null {
            Ok(())
        } else {
            self.other("null")
        }
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<(), E> {
        let Some(expected) = self.expected else {
            *self.at.text.borrow_mut() = Some(text.to_owned());
            return Ok(());
        };
        let words = expected.words();
        if expected.of_type("string").is_some() || words.contains(&text) {
            return Ok(());
        }
        if expected.kind(text).is_some() {
            let cure = format!(
                "write an object, such as {}",
                expected.example_of(text, false)
            );
            return self.refuse_at(
                text,
                "the kind stands here without its fields".to_owned(),
                cure,
            );
        }
        if words.is_empty() {
            return self.other(&format!("the text \"{text}\""));
        }
        self.no_word(expected, text)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let Some(expected) = self.expected else {
            while list.next_element::<IgnoredAny>()?.is_some() {}
            return Ok(());
        };
        let Some((item, length)) = expected.items() else {
            if expected.fields().is_empty() {
                return self.other("a list [...]");
            }
            let cure = format!("name the fields, such as {}", expected.example(false));
            return self.refuse(
                "a list [...] stands here instead of an object with named fields",
                cure,
            );
        };
        let mut count = 0;
        loop {
            if length == Some(count) {
                return match list.next_element::<IgnoredAny>()? {
                    None => Ok(()),
                    Some(_) => self.other("a longer list"),
                };
            }
            let part = self.with(Some(item), false);
            let more = self.inside(format!("[{count}]"), || list.next_element_seed(part))?;
            if more.is_none() {
                return match length {
                    None => Ok(()),
                    Some(_) => self.other(&format!("a list of length {count}")),
                };
            }
            count += 1;
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let Some(expected) = self.expected else {
            while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
            return Ok(());
        };
        if !expected.kinds().is_empty() {
            self.one_kind(expected, map)
        } else if let Some(object) = expected.of_type("object") {
            self.fields(object, map)
        } else {
            self.other("an object {...}")
        }
    }
}
