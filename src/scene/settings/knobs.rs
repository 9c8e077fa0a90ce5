//! The table of knobs: every setting that users name. Command-line flags, settings in scene files, command lines that
//! do it again, sweeps of `raytree cost` and the book's list are made from it.

/// Getter and setter of a number: its kind of value, then its field.
macro_rules! number {
    ($kind:ident, $($field:ident).+) => {
        Field {
            get: |s| Some(Value::$kind(s.$($field).+.into())),
            set: |s, value| {
                if let Value::$kind(x) = value {
                    s.$($field).+ = *x as _;
                }
            },
        }
    };
}

/// Getter and setter of a choice: its words, then its field.
macro_rules! choice {
    ($words:expr, $($field:ident).+) => {
        Field {
            get: |s| {
                let words = $words;
                let word = words.iter().find(|w| w.0 == s.$($field).+)?;
                Some(Value::Text(word.1.to_owned()))
            },
            set: |s, value| {
                if let Some(word) = $words.iter().find(|w| value.is(w.1)) {
                    s.$($field).+ = word.0;
                }
            },
        }
    };
}

/// A field that is read from the text that it writes.
macro_rules! text {
    ($($field:ident).+) => {
        Field {
            get: |s| Some(Value::Text(s.$($field).+.to_string())),
            set: |s, value| {
                if let Ok(read) = value.to_string().parse() {
                    s.$($field).+ = read;
                }
            },
        }
    };
}

/// Words of a choice whose own text says what they mean, with their values.
macro_rules! names {
    ($kind:ident) => {
        $kind::ALL.map(|value| (value, value.name(), ""))
    };
}

mod arithmetic;
mod image;
mod light;
mod pixel;
mod tracing;

use super::Settings;
use super::knob::{Field, Kind, Knob, Value, Word};
use crate::scene::{Effects, Scene};

/// The knobs, in the order of help texts.
pub fn knobs() -> impl Iterator<Item = &'static Knob> {
    let groups = [
        image::ROWS,
        pixel::ROWS,
        light::ROWS,
        tracing::ROWS,
        arithmetic::ROWS,
    ];
    groups.into_iter().flatten()
}

/// The knob with this flag.
pub fn knob(flag: &str) -> Option<&'static Knob> {
    knobs().find(|knob| knob.flag == flag)
}

/// Sets a knob by its flag and the text of a value. An error says which flags or values there are.
pub fn set_knob(settings: &mut Settings, flag: &str, value: &str) -> Result<(), String> {
    let knob = knob(flag)
        .ok_or_else(|| format!("`{flag}` is no setting; write one by the name of its flag"))?;
    let value = match knob.kind {
        Kind::Choice(words) if !words().iter().any(|word| word.name == value) => {
            let words: Vec<&str> = words().iter().map(|word| word.name).collect();
            return Err(format!(
                "`{flag}` is `{value}`; it is one of {}",
                words.join(", ")
            ));
        }
        Kind::Choices(_) => Value::List(value.split(',').map(str::to_owned).collect()),
        kind => kind
            .parse(value)
            .map_err(|what| format!("`{flag}`: {what}"))?,
    };
    (knob.field.set)(settings, &value);
    Ok(())
}

/// What a row has unless it says otherwise.
const ROW: Knob = Knob {
    flag: "",
    value_name: "N",
    doc: "",
    heading: "Settings",
    kind: Kind::Size,
    field: Field {
        get: |_| None,
        set: |_, _| (),
    },
    json: "",
    in_files: false,
    changes_picture: true,
    shows_default: false,
    requires: None,
    conflicts_with: None,
    implies_others: false,
    steps: &[],
};

fn words<T: Copy>(list: &[(T, &'static str, &'static str)]) -> Vec<Word> {
    list.iter()
        .map(|&(_, name, doc)| Word { name, doc })
        .collect()
}

/// The settings that are not the scene's own, as names and values of flags: what must be said to do it again.
pub fn flags(now: &Settings, scene: &Scene) -> Vec<(&'static str, String)> {
    let left_out = now.left_out(scene);
    let now = now.with(|s| s.effects = left_out.fold(Effects::ALL, Effects::without));
    let changed = |knob: &Knob| {
        let value = (knob.field.get)(&now)?;
        let own = (knob.field.get)(&scene.settings);
        (own.as_ref() != Some(&value)).then(|| (knob.flag, value.to_string()))
    };
    let beside_size = knobs().filter(|knob| knob.flag != "size");
    beside_size.filter_map(changed).collect()
}
