//! Values of the kinds that facts have. A value of another kind is noted, and the fact is told as nothing.

use super::kind::ValueKind;
use super::notes::{Broken, ReadNotes};
use super::place::FieldPlace;
use super::value::JsonValue;
use crate::math::Rgb;
use crate::scene::printable::excerpt;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::trace::facts::Fact;

/// Reads the value of a fact.
pub type ReadFact = fn(JsonValue, &FieldPlace, &mut ReadNotes) -> Fact;

/// A number.
pub fn number(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Option<f64> {
    let number = value.number();
    number.map_err(|why| notes.wrong(place, || why)).ok()
}

/// A list of so many numbers.
pub fn numbers<const N: usize>(
    value: JsonValue,
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> Option<[f64; N]> {
    let Some(items) = value.items() else {
        notes.wrong(place, || {
            format!(
                "is {}, and a list of {N} numbers is wanted",
                value.described()
            )
        });
        return None;
    };
    let (mut read, mut count, mut whole) = ([0.0; N], 0, true);
    for (i, item) in items.take(N + 1).enumerate() {
        count += 1;
        let Some(place_of) = read.get_mut(i) else {
            break;
        };
        match number(item, &place.item(i), notes) {
            Some(x) => *place_of = x,
            None => whole = false,
        }
    }
    if count != N {
        let has = if count > N {
            "more".to_owned()
        } else {
            count.to_string()
        };
        notes.wrong(place, || format!("has {has}, and {N} numbers are wanted"));
    }
    (count == N && whole).then_some(read)
}

/// A colour: three channels, or one number for all of them.
pub fn rgb(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Option<Rgb> {
    match value.kind() {
        ValueKind::List => numbers::<3>(value, place, notes).map(Rgb::from),
        _ => number(value, place, notes).map(Rgb::grey),
    }
}

/// A text.
pub fn text(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Option<String> {
    let text = value.text();
    text.map_err(|why| notes.wrong(place, || why))
        .ok()
        .map(Into::into)
}

/// One of some words.
pub fn one_of(
    value: JsonValue,
    words: &[&str],
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> Option<String> {
    let text = text(value, place, notes)?;
    if words.contains(&text.as_str()) {
        return Some(text);
    }
    notes.wrong(place, || unknown_word(&text, words));
    None
}

/// What is said of a word that is none of those that are wanted.
pub fn unknown_word(word: &str, words: &[&str]) -> String {
    let shown = excerpt(word);
    match did_you_mean(word, words.iter().copied()) {
        Some(near) => format!("is \"{shown}\"; did you mean \"{near}\"?"),
        None => format!("is \"{shown}\", and one of {} is wanted", words.join(", ")),
    }
}

/// A whole number that names something: if it is none, nobody knows what is meant, and the pixel is broken.
pub fn whole(value: JsonValue, least: f64, most: f64, place: &FieldPlace) -> Result<f64, Broken> {
    let cure = format!("write a whole number from {least} to {most}");
    let number = value
        .number()
        .map_err(|why| Broken::new(value, place, why, &cure))?;
    if number.fract() != 0.0 || !(least..=most).contains(&number) {
        return Err(Broken::new(value, place, format!("is {number}"), &cure));
    }
    Ok(number)
}

/// A vector as a fact.
pub fn vector_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    numbers(value, place, notes).map_or(Fact::Nothing, Fact::Vector)
}

/// A pair of numbers as a fact.
pub fn pair_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    numbers(value, place, notes).map_or(Fact::Nothing, Fact::Pair)
}

/// A number as a fact.
pub fn number_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    number(value, place, notes).map_or(Fact::Nothing, Fact::Number)
}

/// A colour as a fact.
pub fn color_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    rgb(value, place, notes).map_or(Fact::Nothing, Fact::Color)
}

/// A name as a fact.
pub fn word_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    text(value, place, notes).map_or(Fact::Nothing, Fact::Word)
}

/// The side of a surface as a fact.
pub fn side_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    one_of(value, &["front", "back"], place, notes).map_or(Fact::Nothing, Fact::Word)
}

/// How a ray ended, as a fact: that it met a light is a hit.
pub fn outcome_fact(value: JsonValue, place: &FieldPlace, notes: &mut ReadNotes) -> Fact {
    let words = ["hit", "miss", "light", "lit", "blocked"];
    match one_of(value, &words, place, notes) {
        Some(word) if word == "light" => Fact::Word("hit".to_owned()),
        Some(word) => Fact::Word(word),
        None => Fact::Nothing,
    }
}
