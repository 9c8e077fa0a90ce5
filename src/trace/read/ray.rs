//! A ray of a document: its kind, who sent it, and its facts.

use super::fields::{FieldNames, NamedValues, fields};
use super::notes::{Broken, ReadNotes};
use super::parts::{FactField, absences, part, steps, terms};
use super::place::FieldPlace;
use super::typed;
use super::value::JsonValue;
use crate::probe::RayKind;
use crate::scene::limits::MAX_NAME_BYTES;
use crate::trace::facts::{Fact, FactName, sorted};

/// The fields of a ray, in the order in which this program writes them.
pub const RAY_FIELDS: [&str; 26] = [
    "id",
    "parent",
    "kind",
    "depth",
    "origin",
    "direction",
    "t_min",
    "t_max",
    "weight",
    "throughput",
    "medium",
    "ior",
    "outcome",
    "passed",
    "hit",
    "light",
    "sample",
    "bundles",
    "light_point",
    "boundary",
    "terms",
    "radiance",
    "contribution",
    "absent",
    "children",
    "traversal",
];

/// The facts that every ray has.
const OWN: [FactField; 5] = [
    ("origin", FactName::Origin, typed::vector_fact),
    ("direction", FactName::Direction, typed::vector_fact),
    ("medium", FactName::Medium, typed::word_fact),
    ("ior", FactName::Ior, typed::number_fact),
    ("outcome", FactName::Outcome, typed::outcome_fact),
];

/// Further facts of an L ray.
const LIGHT_RAY: [FactField; 1] = [("t_max", FactName::Distance, typed::number_fact)];

/// Further facts of all others.
const OTHER_RAY: [FactField; 2] = [
    ("weight", FactName::Weight, typed::color_fact),
    ("radiance", FactName::Radiance, typed::color_fact),
];

/// The facts of `hit`.
const HIT: [FactField; 9] = [
    ("t", FactName::T, typed::number_fact),
    ("point", FactName::Point, typed::vector_fact),
    ("object", FactName::Object, typed::word_fact),
    ("primitive", FactName::Primitive, typed::number_fact),
    ("barycentric", FactName::Barycentric, typed::vector_fact),
    ("uv", FactName::Uv, typed::pair_fact),
    (
        "geometric_normal",
        FactName::GeometricNormal,
        typed::vector_fact,
    ),
    ("normal", FactName::Normal, typed::vector_fact),
    ("side", FactName::Side, typed::side_fact),
];

/// The facts of `boundary`.
const BOUNDARY: [FactField; 3] = [
    ("n1", FactName::N1, typed::number_fact),
    ("n2", FactName::N2, typed::number_fact),
    ("reflectance", FactName::Reflectance, typed::number_fact),
];

/// A ray whose place in the tree is not known yet.
#[derive(Debug)]
pub struct LooseRay {
    /// Where it stands, in bytes.
    pub at: usize,
    /// Its kind.
    pub kind: RayKind,
    /// Of an L ray.
    pub light: Option<String>,
    /// Of an L ray to an area light, which of its samples; of an I ray, which sample of the pixel.
    pub sample: u32,
    /// The number by which others name it.
    pub id: Option<i64>,
    /// Who sent it.
    pub parent: LooseParent,
    /// The facts, sorted by name.
    pub facts: Vec<(FactName, Fact)>,
    /// Rays that its hit did not send.
    pub absent: Vec<(RayKind, Option<String>, String)>,
}

/// Who sent a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LooseParent {
    /// The eye, or nobody who is known.
    None,
    /// The ray of this id.
    Id(i64),
    /// The ray of this number in the list.
    Index(usize),
}

/// A ray, and the list of its children. `also` are names of fields that may stand beside its own.
pub fn ray<'a>(
    value: JsonValue<'a>,
    also: &[&str],
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> Result<(LooseRay, Option<JsonValue<'a>>), Broken> {
    let names = FieldNames {
        asked: RAY_FIELDS,
        passed: also,
        noted: true,
    };
    let values = fields(value, &names, place, notes)?;
    let values = NamedValues {
        names: RAY_FIELDS,
        values,
    };
    let kind = ray_kind(value, values.get("kind"), place)?;
    let light = values.get("light").filter(|_| kind == RayKind::Light);
    let sample = |sample| {
        typed::whole(sample, 0.0, f64::from(u32::MAX), &place.key("sample")).map(|n| n as u32)
    };
    let id = |id| number_of_ray(id, &place.key("id"));
    let parent = |parent| number_of_ray(parent, &place.key("parent")).map(LooseParent::Id);
    let absent = values
        .get("absent")
        .map(|list| absences(list, &place.key("absent"), notes));
    let ray = LooseRay {
        at: value.at(),
        kind,
        light: light
            .map(|light| light_name(light, &place.key("light")))
            .transpose()?,
        sample: values.get("sample").map(sample).transpose()?.unwrap_or(0),
        id: values.get("id").map(id).transpose()?,
        parent: values
            .get("parent")
            .map(parent)
            .transpose()?
            .unwrap_or(LooseParent::None),
        absent: absent.transpose()?.unwrap_or_default(),
        facts: facts(&values, kind, place, notes)?,
    };
    Ok((ray, values.get("children")))
}

/// The facts of a ray, sorted by name. What an L ray brings is told where it was sent; what blocks it is no fact.
fn facts(
    values: &NamedValues<{ RAY_FIELDS.len() }>,
    kind: RayKind,
    place: &FieldPlace,
    notes: &mut ReadNotes,
) -> Result<Vec<(FactName, Fact)>, Broken> {
    let is_light = kind == RayKind::Light;
    let mut facts = Vec::with_capacity(if is_light { 8 } else { 32 });
    let simple: &[FactField] = if is_light { &LIGHT_RAY } else { &OTHER_RAY };
    for (name, fact, read) in OWN.iter().chain(simple) {
        let value = values.get(name);
        facts.extend(value.map(|value| (fact.clone(), read(value, &place.key(name), notes))));
    }
    if let Some(hit) = values.get("hit").filter(|_| !is_light) {
        part(
            hit,
            HIT,
            &["material", "part", "gradient", "shading", "frames"],
            &place.key("hit"),
            notes,
            &mut facts,
        )?;
    }
    if let Some(boundary) = values.get("boundary") {
        part(
            boundary,
            BOUNDARY,
            &["touching"],
            &place.key("boundary"),
            notes,
            &mut facts,
        )?;
    }
    if let Some(list) = values.get("terms") {
        terms(list, &place.key("terms"), notes, &mut facts)?;
    }
    if let Some(list) = values.get("traversal") {
        steps(list, &place.key("traversal"), notes, &mut facts)?;
    }
    Ok(sorted(facts))
}

fn ray_kind(
    ray: JsonValue,
    kind: Option<JsonValue>,
    place: &FieldPlace,
) -> Result<RayKind, Broken> {
    let cure = "write \"kind\": \"I\" (from the eye), \"L\" (to a light), \"R\" (reflected) or \"T\" (transmitted)";
    let kind = kind.ok_or_else(|| Broken::new(ray, place, "a ray has no `kind`", cure))?;
    let place = place.key("kind");
    let word = kind
        .text()
        .map_err(|why| Broken::new(kind, &place, why, cure))?;
    let is = |known: &RayKind| known.letter() == word;
    let unknown = || {
        Broken::new(
            kind,
            &place,
            typed::unknown_word(&word, &["I", "L", "R", "T"]),
            cure,
        )
    };
    RayKind::ALL.into_iter().find(is).ok_or_else(unknown)
}

/// The name of a light: if it is none, there is no telling which ray this is.
fn light_name(light: JsonValue, place: &FieldPlace) -> Result<String, Broken> {
    let cure = "write the name of a light of the scene";
    let name = light
        .text()
        .map_err(|why| Broken::new(light, place, why, cure))?;
    if name.len() > MAX_NAME_BYTES {
        let what = format!(
            "has {} bytes; no light has a name of more than {MAX_NAME_BYTES}",
            name.len()
        );
        return Err(Broken::new(light, place, what, cure));
    }
    Ok(name.into_owned())
}

/// Numbers of rays are whole and far below those at which 64 bits round.
fn number_of_ray(value: JsonValue, place: &FieldPlace) -> Result<i64, Broken> {
    const MOST: f64 = 9e15;
    typed::whole(value, -MOST, MOST, place).map(|id| id as i64)
}

impl LooseParent {
    /// As it is if so many rays are put before those of its list.
    pub fn moved_by(self, rays: usize) -> Self {
        match self {
            Self::Index(index) => Self::Index(index + rays),
            other => other,
        }
    }
}
