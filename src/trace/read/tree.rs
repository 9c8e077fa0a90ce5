//! Trees of documents: their rays in a list, parents before children.

use super::limits::{MAX_CHILDREN, MAX_RAYS};
use super::notes::{Broken, ReadNotes};
use super::place::{FieldPlace, RayPlace, RayPlaces};
use super::ray::{LooseParent, LooseRay, ray};
use super::value::JsonValue;
use crate::probe::RayKind;

/// The rays of a document as they stand there.
#[derive(Debug, Default)]
pub struct RayList {
    /// Parents before their children.
    pub rays: Vec<LooseRay>,
    /// Where each stands.
    pub places: RayPlaces,
}

impl RayList {
    /// Adds a ray with all that hang on it. `sample` is that of the pixel; a ray at the top of a document may have the fields
    /// of `also` beside its own.
    pub fn add(
        &mut self,
        value: JsonValue,
        place: RayPlace,
        sample: Option<u32>,
        also: &[&str],
        notes: &mut ReadNotes,
    ) -> Result<(), Broken> {
        // Values still to be read, the next one at the end. Trees may be deep, so nothing recurses.
        let mut open = vec![(value, place)];
        while let Some((value, place)) = open.pop() {
            let number = self.rays.len();
            let is_top = matches!(place, RayPlace::Top);
            self.places.0.push(place);
            let here = FieldPlace::Ray(&self.places, number);
            if number >= MAX_RAYS {
                return Err(too_many_rays(value, &here));
            }
            let (mut ray, children) = ray(value, if is_top { also } else { &[] }, &here, notes)?;
            match place {
                RayPlace::Child(parent, _) => ray.parent = LooseParent::Index(parent),
                RayPlace::Top => {}
                RayPlace::Root | RayPlace::SampleRoot(_) => ray.parent = LooseParent::None,
            }
            if let Some(sample) = sample.filter(|_| ray.kind == RayKind::Incident) {
                ray.sample = sample;
            }
            if !is_top {
                // What hangs on another one needs no number.
                ray.id = None;
            }
            self.rays.push(ray);
            if let Some(children) = children {
                push_children(children, number, &here.key("children"), &mut open, notes)?;
            }
        }
        Ok(())
    }
}

/// Puts the children of a ray on the list of what is to be read, the first at the end.
fn push_children<'a>(
    children: JsonValue<'a>,
    parent: usize,
    place: &FieldPlace,
    open: &mut Vec<(JsonValue<'a>, RayPlace)>,
    notes: &mut ReadNotes,
) -> Result<(), Broken> {
    let Some(items) = children.items() else {
        notes.wrong(place, || {
            format!("is {}, and a list of rays is wanted", children.described())
        });
        return Ok(());
    };
    let first = open.len();
    for (i, child) in items.enumerate() {
        if i >= MAX_CHILDREN {
            let what = format!("has more than {MAX_CHILDREN} rays");
            return Err(Broken::new(
                children,
                place,
                what,
                "send fewer samples to a light",
            ));
        }
        open.push((child, RayPlace::Child(parent, i)));
    }
    open[first..].reverse();
    Ok(())
}

fn too_many_rays(value: JsonValue, place: &FieldPlace) -> Broken {
    let what = format!("is one more than the {MAX_RAYS} rays that a pixel may have");
    Broken::new(value, place, what, "stop your tracer at a depth, such as 5")
}
