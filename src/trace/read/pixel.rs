//! What a document says of its pixel: which one, its colour, its trees. A line of flat rays says a part of it.

use super::assemble::assemble;
use super::fields::{FieldNames, NamedValues, fields};
use super::kind::ValueKind;
use super::notes::{Broken, ReadNotes};
use super::place::{FieldPlace, RayPlace};
use super::tree::RayList;
use super::typed;
use super::value::JsonValue;
use crate::trace::facts::PixelFacts;

/// The fields of a document.
const PIXEL_FIELDS: [&str; 17] = [
    "format",
    "scene",
    "image",
    "pixel",
    "warnings",
    "settings",
    "color",
    "rays",
    "cut",
    "standard_error",
    "spoiled",
    "truncated",
    "samples",
    "root",
    "estimates",
    "mean",
    "srgb8",
];

type PixelValues<'a> = NamedValues<'a, { PIXEL_FIELDS.len() }>;

/// Which pixel a document is about: the name of the scene, column and row, as far as they are told.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct PixelName {
    /// Of the scene.
    pub scene: Option<String>,
    /// Column and row.
    pub pixel: Option<(u32, u32)>,
}

/// A document as it is read, before its rays have paths.
#[derive(Debug, Default)]
pub struct PixelRead {
    /// What is told of the pixel; its rays are below.
    pub facts: PixelFacts,
    /// Its rays.
    pub list: RayList,
    /// Whether it has a tree; if not, it is a line among others about its pixel.
    pub has_tree: bool,
    /// What was not understood.
    pub notes: ReadNotes,
}

/// Reads a document. If it is broken, `name` tells of which pixel, as far as it was read.
pub fn pixel(top: JsonValue, name: &mut PixelName) -> Result<PixelRead, Broken> {
    let place = FieldPlace::Top;
    if top.kind() != ValueKind::Object {
        let what = format!("is {}, and a ray tree or a ray is wanted", top.described());
        return Err(Broken::new(
            top,
            &place,
            what,
            "write an object: {\"pixel\": [x, y], \"root\": {\"kind\": \"I\", ...}}",
        ));
    }
    let mut read = PixelRead::default();
    let is_ray = top
        .fields()
        .any(|(key, _)| key.text().is_ok_and(|name| name == "kind"));
    // Of flat rays both these fields and their own are known; the ray tells which are neither.
    let names = FieldNames {
        asked: PIXEL_FIELDS,
        passed: &[],
        noted: !is_ray,
    };
    let values = fields(top, &names, &place, &mut read.notes)?;
    let values = NamedValues {
        names: PIXEL_FIELDS,
        values,
    };
    if let Some(scene) = values.get("scene") {
        name.scene = scene_name(scene, &mut read.notes)?;
    }
    let at = values
        .get("pixel")
        .map(|at| position(at, &place.key("pixel")));
    name.pixel = at.transpose()?;
    (read.facts.scene, read.facts.pixel) = (name.scene.clone(), name.pixel);
    if let Some(format) = values.get("format") {
        check_format(format)?;
    }
    color_and_estimates(&values, &mut read)?;
    let (list, notes) = (&mut read.list, &mut read.notes);
    if let Some(samples) = values.get("samples") {
        read_samples(samples, list, notes)?;
    }
    if let Some(root) = values.get("root") {
        list.add(root, RayPlace::Root, None, &[], notes)?;
    }
    if is_ray {
        list.add(top, RayPlace::Top, None, &PIXEL_FIELDS, notes)?;
    }
    read.has_tree = values.get("samples").or(values.get("root")).is_some();
    Ok(read)
}

/// What is told of the pixel itself.
fn color_and_estimates(values: &PixelValues, read: &mut PixelRead) -> Result<(), Broken> {
    let (facts, notes) = (&mut read.facts, &mut read.notes);
    if let Some(color) = values.get("color") {
        read_color(color, facts, notes)?;
    }
    if let Some(srgb8) = values.get("srgb8") {
        facts.srgb8 = Some(typed::vector_fact(
            srgb8,
            &FieldPlace::Top.key("srgb8"),
            notes,
        ));
    }
    if let Some(list) = values.get("estimates") {
        facts.estimates = read_estimates(list, notes);
    }
    if let Some(mean) = values.get("mean") {
        facts.mean = read_mean(mean, notes)?;
    }
    Ok(())
}

impl PixelRead {
    /// The facts, with the rays as a tree. Lines of flat rays stand in no document.
    pub fn finish(self, in_document: bool) -> Result<PixelFacts, Broken> {
        let places = in_document.then_some(&self.list.places);
        let rays = assemble(self.list.rays, places)?;
        let problems = self.notes.sentences();
        Ok(PixelFacts {
            rays,
            problems,
            ..self.facts
        })
    }

    /// Adds what a further line says of the same pixel.
    pub fn add(&mut self, more: Self, top: JsonValue) -> Result<(), Broken> {
        let (facts, new) = (&mut self.facts, more.facts);
        let is_twice = facts.color.is_some() && new.color.is_some()
            || facts.srgb8.is_some() && new.srgb8.is_some()
            || !facts.estimates.is_empty() && !new.estimates.is_empty()
            || facts.mean.is_some() && new.mean.is_some();
        if is_twice {
            let what = "tells the colour or the estimate of a pixel that another line tells, too";
            return Err(Broken::new(
                top,
                &FieldPlace::Top,
                what,
                "write it once a pixel",
            ));
        }
        facts.color = new.color.or(facts.color.take());
        facts.srgb8 = new.srgb8.or(facts.srgb8.take());
        facts.mean = new.mean.or(facts.mean);
        facts.estimates.extend(new.estimates);
        let first = self.list.rays.len();
        self.list
            .rays
            .extend(more.list.rays.into_iter().map(|mut ray| {
                ray.parent = ray.parent.moved_by(first);
                ray
            }));
        self.notes.add(more.notes);
        Ok(())
    }
}

fn check_format(format: JsonValue) -> Result<(), Broken> {
    let place = FieldPlace::Top.key("format");
    let cure = "write \"format\": \"raytree/1\", or leave it out";
    match format.text() {
        Ok(text) if text == "raytree/1" => Ok(()),
        Ok(_) => Err(Broken::new(
            format,
            &place,
            format!("is {}, and raytree/1 is wanted", format.described()),
            cure,
        )),
        Err(why) => Err(Broken::new(format, &place, why, cure)),
    }
}

/// The name of the scene, which may also be told without an object around it.
fn scene_name(scene: JsonValue, notes: &mut ReadNotes) -> Result<Option<String>, Broken> {
    let place = FieldPlace::Top.key("scene");
    if scene.kind() != ValueKind::Object {
        return Ok(typed::text(scene, &place, notes));
    }
    let asked = ["name", "hash", "lights"];
    let names = FieldNames {
        asked,
        passed: &[],
        noted: true,
    };
    let [name, ..] = fields(scene, &names, &place, notes)?;
    Ok(name.and_then(|name| typed::text(name, &place.key("name"), notes)))
}

/// Column and row, as a list or by name.
fn position(at: JsonValue, place: &FieldPlace) -> Result<(u32, u32), Broken> {
    let cure = "write [x, y], column and row from 0 at the top left";
    let mut found = [None; 2];
    if let Some(items) = at.items() {
        for (i, item) in items.enumerate() {
            *found
                .get_mut(i)
                .ok_or_else(|| Broken::new(at, place, "has more than two numbers", cure))? =
                Some(item);
        }
    } else {
        let names = FieldNames {
            asked: ["x", "y"],
            passed: &[],
            noted: false,
        };
        found = fields(at, &names, place, &mut ReadNotes::default())?;
    }
    let [Some(x), Some(y)] = found else {
        return Err(Broken::new(at, place, "has not both, column and row", cure));
    };
    let number = |value| typed::whole(value, 0.0, f64::from(u32::MAX), place).map(|x| x as u32);
    Ok((number(x)?, number(y)?))
}

/// The colour: linear, or linear and for the screen by name.
fn read_color(
    color: JsonValue,
    facts: &mut PixelFacts,
    notes: &mut ReadNotes,
) -> Result<(), Broken> {
    let place = FieldPlace::Top.key("color");
    if color.kind() != ValueKind::Object {
        facts.color = Some(typed::color_fact(color, &place, notes));
        return Ok(());
    }
    let names = FieldNames {
        asked: ["linear", "srgb8"],
        passed: &[],
        noted: true,
    };
    let [linear, srgb8] = fields(color, &names, &place, notes)?;
    facts.color = linear.map(|linear| typed::color_fact(linear, &place.key("linear"), notes));
    facts.srgb8 = srgb8.map(|srgb8| typed::vector_fact(srgb8, &place.key("srgb8"), notes));
    Ok(())
}

/// Values of single samples; none if one of them is no number, since then their mean is none.
fn read_estimates(list: JsonValue, notes: &mut ReadNotes) -> Vec<f64> {
    let place = FieldPlace::Top.key("estimates");
    let Some(items) = list.items() else {
        notes.wrong(&place, || {
            format!("is {}, and a list of numbers is wanted", list.described())
        });
        return Vec::new();
    };
    let read = items
        .enumerate()
        .map(|(i, item)| typed::number(item, &place.item(i), notes));
    read.collect::<Option<Vec<f64>>>().unwrap_or_default()
}

/// The mean of an estimate, and of how many samples.
fn read_mean(mean: JsonValue, notes: &mut ReadNotes) -> Result<Option<(f64, u64)>, Broken> {
    let place = FieldPlace::Top.key("mean");
    let names = FieldNames {
        asked: ["value", "samples"],
        passed: &[],
        noted: true,
    };
    let [value, samples] = fields(mean, &names, &place, notes)?;
    let value = value.and_then(|value| typed::number(value, &place.key("value"), notes));
    let count = |samples| typed::whole(samples, 1.0, 9e15, &place.key("samples")).map(|n| n as u64);
    let samples = samples.map(count).transpose()?;
    if mean.kind() == ValueKind::Object && (value.is_none() || samples.is_none()) {
        notes.wrong(&place, || "has not both, `value` and `samples`".to_owned());
    }
    Ok(value.zip(samples))
}

/// The trees of all samples.
fn read_samples(
    samples: JsonValue,
    list: &mut RayList,
    notes: &mut ReadNotes,
) -> Result<(), Broken> {
    let place = FieldPlace::Top.key("samples");
    let Some(items) = samples.items() else {
        notes.wrong(&place, || {
            format!(
                "is {}, and a list of samples is wanted",
                samples.described()
            )
        });
        return Ok(());
    };
    for (i, sample) in items.enumerate() {
        let place = place.item(i);
        let names = FieldNames {
            asked: ["index", "film", "weight", "root"],
            passed: &[],
            noted: true,
        };
        let [index, _, _, root] = fields(sample, &names, &place, notes)?;
        let index = match index {
            Some(index) => {
                typed::whole(index, 0.0, f64::from(u32::MAX), &place.key("index"))? as u32
            }
            None => u32::try_from(i).unwrap_or(u32::MAX),
        };
        if let Some(root) = root {
            list.add(root, RayPlace::SampleRoot(i), Some(index), &[], notes)?;
        }
    }
    Ok(())
}
