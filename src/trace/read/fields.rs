//! The fields of an object by their names.

use super::kind::ValueKind;
use super::notes::{Broken, ReadNotes};
use super::place::FieldPlace;
use super::value::JsonValue;

/// Names of the fields that an object may have.
#[derive(Clone, Copy)]
pub struct FieldNames<'a, const N: usize> {
    /// Those that are asked for.
    pub asked: [&'a str; N],
    /// Those that are let pass.
    pub passed: &'a [&'a str],
    /// Whether any other one is noted.
    pub noted: bool,
}

/// The fields of an object by their names, in the order of the names; `null` is no value. A name that stands there twice breaks
/// the pixel: nobody knows which is meant.
pub fn fields<'a, const N: usize>(
    object: JsonValue<'a>,
    names: &FieldNames<'_, N>,
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> Result<[Option<JsonValue<'a>>; N], Broken> {
    let mut values = [None; N];
    if object.kind() != ValueKind::Object {
        notes.wrong(place, || {
            format!("is {}, and an object is wanted", object.described())
        });
        return Ok(values);
    }
    let mut seen = [false; N];
    // Programs write the fields of all objects in one order: the search goes on behind the last.
    let mut next = 0;
    for (key, value) in object.fields() {
        let name = key.text().map_err(|what| {
            Broken::new(
                key,
                place,
                format!("the name of a field {what}"),
                "use the names of the format",
            )
        })?;
        let order = (next..N).chain(0..next);
        let Some(index) = order.into_iter().find(|i| names.asked[*i] == name) else {
            if names.noted && !names.passed.contains(&name.as_ref()) {
                notes.unknown(place, &name, &names.asked);
            }
            continue;
        };
        if seen[index] {
            let cure = "write each field once: nobody knows which is meant";
            return Err(Broken::new(
                key,
                &place.key(&name),
                "stands here twice",
                cure,
            ));
        }
        seen[index] = true;
        values[index] = Some(value).filter(|v| v.kind() != ValueKind::Null);
        next = index + 1;
    }
    Ok(values)
}

/// Values by the names of their fields.
pub struct NamedValues<'a, const N: usize> {
    /// The names.
    pub names: [&'static str; N],
    /// A value each, if it is told.
    pub values: [Option<JsonValue<'a>>; N],
}

impl<'a, const N: usize> NamedValues<'a, N> {
    /// The value of this field.
    pub fn get(&self, name: &str) -> Option<JsonValue<'a>> {
        let index = self.names.iter().position(|field| *field == name);
        self.values[index?]
    }
}
