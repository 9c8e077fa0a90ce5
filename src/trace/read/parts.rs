//! What a ray has more of than one: the facts of its hit, the terms of its equation, the rays that it did not send, the steps of
//! its search.

use super::fields::{FieldNames, fields};
use super::limits::MAX_CHILDREN;
use super::notes::{Broken, ReadNotes};
use super::place::FieldPlace;
use super::typed::{self, ReadFact};
use super::value::JsonValue;
use crate::probe::{RayKind, TermKind};
use crate::scene::limits::MAX_NAME_BYTES;
use crate::trace::facts::{Fact, FactName};

/// A field, the fact that it tells, and how it is read.
pub type FactField = (&'static str, FactName, ReadFact);

type Facts = Vec<(FactName, Fact)>;

/// The facts in an object.
pub fn part<const N: usize>(
    value: JsonValue,
    known: [FactField; N],
    passed: &[&str],
    place: &FieldPlace,
    notes: &mut ReadNotes,
    facts: &mut Facts,
) -> Result<(), Broken> {
    let asked: [&str; N] = std::array::from_fn(|i| known[i].0);
    let names = FieldNames {
        asked,
        passed,
        noted: true,
    };
    let values = fields(value, &names, place, notes)?;
    for ((name, fact, read), value) in known.into_iter().zip(values) {
        facts.extend(value.map(|value| (fact, read(value, &place.key(name), notes))));
    }
    Ok(())
}

/// The items of a list; none, and a note, of what is no list.
fn listed<'a>(
    list: JsonValue<'a>,
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> impl Iterator<Item = JsonValue<'a>> + use<'a> {
    let items = list.items();
    if items.is_none() {
        notes.wrong(place, || {
            format!("is {}, and a list is wanted", list.described())
        });
    }
    items.into_iter().flatten()
}

/// The terms of the shading equation: value, and the cosines that are facts by themselves.
pub fn terms(
    list: JsonValue,
    place: &FieldPlace,
    notes: &mut ReadNotes,
    facts: &mut Facts,
) -> Result<(), Broken> {
    const KINDS: [TermKind; 5] = [
        TermKind::Emission,
        TermKind::Ambient,
        TermKind::Diffuse,
        TermKind::Specular,
        TermKind::Background,
    ];
    for (i, item) in listed(list, place, notes).enumerate() {
        let place = place.item(i);
        let asked = [
            "term", "light", "sample", "value", "n_dot_l", "r_dot_v", "corners",
        ];
        // Other factors are the student's own.
        let names = FieldNames {
            asked,
            passed: &[],
            noted: false,
        };
        let [term, light, sample, value, n_dot_l, r_dot_v, of_corners] =
            fields(item, &names, &place, notes)?;
        let Some(term) = term else {
            notes.wrong(&place, || "has no `term`, the name of its kind".to_owned());
            continue;
        };
        let words = KINDS.map(TermKind::name);
        let word = typed::one_of(term, &words, &place.key("term"), notes);
        let Some(kind) = word.and_then(|word| KINDS.into_iter().find(|kind| kind.name() == word))
        else {
            continue;
        };
        let light = light.and_then(|light| short_name(light, &place.key("light"), notes));
        let sample = match sample {
            Some(sample) => {
                typed::whole(sample, 0.0, f64::from(u32::MAX), &place.key("sample"))? as u32
            }
            None => 0,
        };
        let of_light = || light.clone().unwrap_or_default();
        if let Some(value) = value {
            let fact = typed::color_fact(value, &place.key("value"), notes);
            facts.push((FactName::Term(kind, light.clone(), sample), fact));
        }
        if let Some(value) = n_dot_l {
            let fact = typed::number_fact(value, &place.key("n_dot_l"), notes);
            facts.push((FactName::NDotL(of_light(), sample), fact));
        }
        if let Some(value) = r_dot_v {
            let fact = typed::number_fact(value, &place.key("r_dot_v"), notes);
            facts.push((FactName::RDotV(of_light(), sample), fact));
        }
        if let Some(list) = of_corners {
            let of = |i| FactName::CornerValue(kind, light.clone(), sample, i);
            corners(list, of, &place.key("corners"), notes, facts)?;
        }
    }
    Ok(())
}

/// The values of a blended term at the three corners of a triangle.
fn corners(
    list: JsonValue,
    of: impl Fn(u8) -> FactName,
    place: &FieldPlace,
    notes: &mut ReadNotes,
    facts: &mut Facts,
) -> Result<(), Broken> {
    for (item, i) in listed(list, place, notes).zip(0..3) {
        let place = place.item(usize::from(i));
        let names = FieldNames {
            asked: ["value"],
            passed: &[],
            noted: false,
        };
        let [value] = fields(item, &names, &place, notes)?;
        if let Some(value) = value {
            let fact = typed::color_fact(value, &place.key("value"), notes);
            facts.push((of(i), fact));
        }
    }
    Ok(())
}

/// A name that is not longer than names of scenes are.
fn short_name(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Option<String> {
    let name = typed::text(value, place, notes)?;
    if name.len() > MAX_NAME_BYTES {
        notes.wrong(place, || {
            format!(
                "has {} bytes; no name has more than {MAX_NAME_BYTES}",
                name.len()
            )
        });
        return None;
    }
    Some(name)
}

/// The rays that were not sent: kind, light and reason.
pub fn absences(
    list: JsonValue,
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> Result<Vec<(RayKind, Option<String>, String)>, Broken> {
    let mut absent = Vec::new();
    for (i, item) in listed(list, place, notes).take(MAX_CHILDREN).enumerate() {
        let place = place.item(i);
        let asked = ["kind", "reason", "light"];
        let names = FieldNames {
            asked,
            passed: &[],
            noted: false,
        };
        let [kind, reason, light] = fields(item, &names, &place, notes)?;
        let kind =
            kind.and_then(|kind| typed::one_of(kind, &["L", "R", "T"], &place.key("kind"), notes));
        let kind =
            kind.and_then(|word| RayKind::ALL.into_iter().find(|kind| kind.letter() == word));
        let reason = reason.and_then(|reason| short_name(reason, &place.key("reason"), notes));
        let light = light.and_then(|light| short_name(light, &place.key("light"), notes));
        absent.extend(kind.zip(reason).map(|(kind, reason)| (kind, light, reason)));
    }
    Ok(absent)
}

/// The steps of the search for the hit, each a word: the number of a node, the name and number of a primitive, or a text.
pub fn steps(
    list: JsonValue,
    place: &FieldPlace,
    notes: &mut ReadNotes,
    facts: &mut Facts,
) -> Result<(), Broken> {
    let mut words = Vec::new();
    let noted = false;
    for (i, item) in listed(list, place, notes).enumerate() {
        let place = place.item(i);
        if let Ok(word) = item.text() {
            words.push(word.into_owned());
            continue;
        }
        let names = FieldNames {
            asked: ["node", "test"],
            passed: &[],
            noted,
        };
        let [node, test] = fields(item, &names, &place, notes)?;
        if let Some(node) = node.and_then(|node| typed::number(node, &place.key("node"), notes)) {
            words.push(format!("node {node}"));
        }
        let Some(test) = test else {
            continue;
        };
        let place = place.key("test");
        let names = FieldNames {
            asked: ["object", "primitive"],
            passed: &[],
            noted,
        };
        let [object, primitive] = fields(test, &names, &place, notes)?;
        let object = object.and_then(|object| typed::text(object, &place.key("object"), notes));
        let primitive =
            primitive.and_then(|number| typed::number(number, &place.key("primitive"), notes));
        words.extend(object.map(|object| format!("test {object} {}", primitive.unwrap_or(0.0))));
    }
    if !words.is_empty() {
        facts.push((FactName::Order, Fact::Steps(words)));
    }
    Ok(())
}
