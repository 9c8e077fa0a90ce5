//! A change as it is typed.
//!
//! ```text
//! change = kind [ "." name ] *( "." field | "[" index "]" ) ( "=" | "+=" | "*=" ) value
//! name   = a name of the scene, or any in quotation marks, as JSON has texts
//! value  = JSON
//! ```
//!
//! A merge patch replaces lists as a whole: a change of one number of a list is one of the list.

use serde_json::{Map, Value, json};

use super::merge::merge;
use super::number::Operation;
use super::section::{Element, Section, elements, unknown};
use crate::scene::limits::MAX_PATCH_BYTES;
use crate::scene::printable::excerpt;
use crate::scene::read::error::Problem;

/// Elements at most of a list of which one is changed: the patch has all of them.
const LONGEST_LIST: usize = 64;

/// A step from a value to a part of it.
enum PatchStep<'a> {
    Field(&'a str),
    Index(usize),
}

/// The change as a merge patch.
pub fn typed(text: &str, scene: &Value) -> Result<Map<String, Value>, Problem> {
    if text.len() > MAX_PATCH_BYTES {
        return Err(wrong("this change is too long"));
    }
    let text = text.trim();
    let (kind, rest) = text.split_at(word_end(text));
    let section = Section::named(kind)?;
    let (name, pointer, rest) = if section.has_names() {
        let known = elements(scene, section);
        let (element, rest) = named(rest, section, &known, scene)?;
        (Some(element.name.clone()), element.pointer.clone(), rest)
    } else {
        (None, format!("/{}", section.key()), rest)
    };
    let (steps, rest) = steps(rest)?;
    let (operation, value) = operation(rest)?;
    let now = scene.pointer(&pointer);
    let mut change = changed(now, &steps, operation, &value)?;
    if let Some(name) = name {
        change = json!({ name: change });
    }
    Ok(Map::from_iter([(section.key().to_owned(), change)]))
}

/// Where the word ends that a text begins with.
fn word_end(text: &str) -> usize {
    let end = text.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
    end.unwrap_or(text.len())
}

fn wrong(what: impl Into<String>) -> Problem {
    Problem::new(
        what,
        "write KIND.NAME.FIELD=VALUE, such as material.glass.ior=1.3 or camera.eye=[0,1,5]",
    )
}

/// What is named behind the kind, and what comes then. Of names that could be meant, it is the longest.
fn named<'a, 'b>(
    text: &'a str,
    section: Section,
    known: &'b [Element],
    scene: &Value,
) -> Result<(&'b Element, &'a str), Problem> {
    let kind = section.singular();
    let text = text
        .strip_prefix('.')
        .ok_or_else(|| wrong(format!("the name of the {kind} is missing")))?;
    let (name, rest) = if text.starts_with('"') {
        let mut texts = serde_json::Deserializer::from_str(text).into_iter::<String>();
        let name = texts.next().and_then(Result::ok);
        let name = name.ok_or_else(|| wrong("the name has no closing quotation mark"))?;
        (name, &text[texts.byte_offset()..])
    } else {
        let ends = |rest: &str| rest.starts_with('.');
        let names = known.iter().map(|element| element.name.as_str());
        let meant = names.filter(|name| text.strip_prefix(name).is_some_and(ends));
        let unknown = || &text[..text.find(['.', '=']).unwrap_or(text.len())];
        let name = meant.max_by_key(|name| name.len()).unwrap_or_else(unknown);
        (name.to_owned(), &text[name.len()..])
    };
    let element = known.iter().find(|element| element.name == name);
    let element = element.ok_or_else(|| unknown(section, &name, known, scene))?;
    Ok((element, rest))
}

/// The steps that a text begins with, and the rest.
fn steps(mut text: &str) -> Result<(Vec<PatchStep<'_>>, &str), Problem> {
    let mut steps = Vec::new();
    loop {
        if let Some(rest) = text.strip_prefix('.') {
            let (field, after) = rest.split_at(word_end(rest));
            if field.is_empty() {
                return Err(wrong("the name of a field is missing behind a dot"));
            }
            steps.push(PatchStep::Field(field));
            text = after;
        } else if let Some(rest) = text.strip_prefix('[') {
            let end = rest.find(']').unwrap_or(rest.len());
            let index = rest[..end].trim().parse();
            let index = index.map_err(|_| {
                let shown = excerpt(&rest[..end]);
                wrong(format!("`[{shown}]` is no place in a list"))
            })?;
            steps.push(PatchStep::Index(index));
            text = rest.get(end + 1..).unwrap_or_default();
        } else {
            return Ok((steps, text));
        }
    }
}

/// The operation and the value that a text is.
fn operation(text: &str) -> Result<(Operation, Value), Problem> {
    let text = text.trim_start();
    let signs = [
        ("+=", Operation::Add),
        ("*=", Operation::Multiply),
        ("=", Operation::Set),
    ];
    let found = signs
        .iter()
        .find_map(|(sign, operation)| Some((*operation, text.strip_prefix(sign)?)));
    let (operation, value) = found.ok_or_else(|| {
        wrong(match text {
            "" => "there is no = and no value".to_owned(),
            _ => format!("`{}` stands where = should", excerpt(text)),
        })
    })?;
    let value = serde_json::from_str(value).map_err(|_| {
        Problem::new(
            format!("`{}` is no value in JSON", excerpt(value.trim())),
            "write a number, a list such as [1,0.5,0], or a text in double quotation marks",
        )
    })?;
    Ok((operation, value))
}

/// The patch of what is `now` there.
fn changed(
    now: Option<&Value>,
    steps: &[PatchStep],
    operation: Operation,
    value: &Value,
) -> Result<Value, Problem> {
    let Some((step, steps)) = steps.split_first() else {
        return operation.apply(now, value);
    };
    match step {
        PatchStep::Field(name) => {
            let field = now.and_then(|now| now.get(name));
            Ok(json!({ *name: changed(field, steps, operation, value)? }))
        }
        PatchStep::Index(index) => {
            let list = now.and_then(Value::as_array).ok_or_else(|| {
                Problem::new("what stands before [...] is no list", "leave the [...] out")
            })?;
            let count = list.len();
            if *index >= count {
                return Err(Problem::new(
                    format!("the list has no element [{index}]"),
                    format!("it has {count}, counted from 0"),
                ));
            }
            if count > LONGEST_LIST {
                return Err(Problem::new(
                    format!("the list has {count} elements: it is too long to change one"),
                    "change the scene file itself",
                ));
            }
            let mut list = list.clone();
            let change = changed(Some(&list[*index]), steps, operation, value)?;
            merge(&mut list[*index], &change);
            Ok(Value::Array(list))
        }
    }
}
