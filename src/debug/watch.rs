//! Watched numbers: what each is at a step, what it was before, and where it changes.
//!
//! A step tells a number or not; what is shown is what was told last, up to the step. So it depends on the step alone, not on the
//! way to it, and a step back shows again what was shown before.

mod known;
#[cfg(test)]
mod tests;

use super::session::Session;
use crate::math::Rgb;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::trace::explain;

/// Numbers that can be watched at any step.
pub const FIELDS: [&str; 4] = ["radiance", "throughput", "running sum", "depth"];

/// Steps that are asked for the number in the details, and sums that are added up, at most: a screen must not wait for more.
const ASKED: usize = 120;
const ADDED: usize = 12;

/// Steps of a tree that are asked at most whether any tells a number of such a name.
const LOOKED_AT: usize = 2000;

/// A number that is watched.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Watch {
    /// As it was typed.
    pub text: String,
    field: WatchField,
    /// The only ray whose steps tell it; none: each step's own.
    ray: Option<u32>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum WatchField {
    /// What a ray brings back: its last step tells it.
    Radiance,
    /// The factor of a ray in its sample.
    Throughput,
    /// What a ray has summed up.
    Sum,
    /// Bounces since the eye.
    Depth,
    /// A number of this name in the details.
    Detail(String),
}

/// A value of a watched number.
#[derive(Clone, Debug)]
pub struct WatchValue {
    /// In digits.
    pub text: String,
    /// The colour, if it is one.
    pub color: Option<Rgb>,
    /// The step that tells it.
    pub event: usize,
}

impl WatchValue {
    /// True if both are the same, to the last bit.
    fn is_same(&self, other: &Self) -> bool {
        let bits = |value: &Self| value.color.map(|c| c.channels().map(f64::to_bits));
        bits(self) == bits(other) && self.text == other.text
    }
}

/// What is shown of a watched number.
#[derive(Clone, Debug)]
pub struct WatchState {
    /// What it is; none if no step near before tells it.
    pub now: Option<WatchValue>,
    /// The last value before that which is another one.
    pub before: Option<WatchValue>,
    /// True if it changes at this very step.
    pub changes: bool,
}

impl WatchState {
    /// In words: `≠` where it changes, what it is, what it was, and the step that told it.
    pub fn told(&self, name: &str) -> String {
        let sign = if self.changes { '≠' } else { ' ' };
        let Some(now) = &self.now else {
            return format!("{sign} {name}: not told yet");
        };
        let before = self.before.as_ref().map_or(String::new(), |before| {
            format!(", before {} (event {})", before.text, before.event)
        });
        format!("{sign} {name}: {} (event {}){before}", now.text, now.event)
    }
}

impl Watch {
    /// A watch from its text: a number, and ` of ray 7` if it is to be that of one ray. An error says what could be typed.
    pub fn new(text: &str, session: &Session) -> Result<Self, String> {
        let text = text.trim();
        let (name, ray) = match text.rsplit_once(" of ray ") {
            Some((name, number)) => (name.trim(), Some(ray_of(number, session)?)),
            None => (text, None),
        };
        let watch = Self {
            text: text.to_owned(),
            field: match name {
                "radiance" => WatchField::Radiance,
                "throughput" => WatchField::Throughput,
                "running sum" => WatchField::Sum,
                "depth" => WatchField::Depth,
                _ => WatchField::Detail(name.to_owned()),
            },
            ray,
        };
        if let WatchField::Detail(name) = &watch.field
            && (name.is_empty() || !is_told(session, name))
        {
            return Err(no_number(name, session));
        }
        Ok(watch)
    }

    /// What is shown of it at a step.
    pub fn state(&self, session: &Session, event: usize) -> WatchState {
        let mut left = self.effort();
        let now = self.known(session, event, &mut left);
        let before = now.as_ref().and_then(|now| {
            let mut known = now.clone();
            while known.is_same(now) {
                let start = self.start_of(session, known.event);
                known = self.known(session, start.checked_sub(1)?, &mut left)?;
            }
            Some(known)
        });
        WatchState {
            changes: self.changes_at(session, event),
            now,
            before,
        }
    }

    /// True if a step tells another value than was told before it, or the first one.
    pub fn changes_at(&self, session: &Session, event: usize) -> bool {
        if !self.may_change(session, event) {
            return false;
        }
        let Some(now) = self.told(session, event) else {
            return false;
        };
        let before = event.checked_sub(1);
        let before = before.and_then(|at| self.known(session, at, &mut self.effort()));
        before.is_none_or(|before| !before.is_same(&now))
    }

    /// How many steps may be asked.
    fn effort(&self) -> usize {
        match self.field {
            WatchField::Sum => ADDED,
            _ => ASKED,
        }
    }
}

/// The numbers that can be watched at the cursor: those in the details, then those of any step.
pub fn names(session: &Session) -> Vec<String> {
    let rows = explain(session.view(), session.cursor().position()).rows;
    let mut names: Vec<String> = Vec::new();
    let details = rows.into_iter().map(|row| row.name);
    for name in details.chain(FIELDS.map(str::to_owned)) {
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn ray_of(number: &str, session: &Session) -> Result<u32, String> {
    let count = session.tree().nodes.len();
    let ray = number.trim().parse::<u32>().ok();
    ray.filter(|ray| (*ray as usize) < count).ok_or_else(|| {
        format!(
            "there is no ray {}: they are numbered from 0 to {}",
            number.trim(),
            count.saturating_sub(1)
        )
    })
}

/// True if a step tells a number of this name: one of the current ray, of those around the cursor, or among the first.
fn is_told(session: &Session, name: &str) -> bool {
    let (view, here) = (session.view(), session.cursor().position());
    let near = here.saturating_sub(LOOKED_AT / 4)..here + LOOKED_AT / 4;
    let first = 0..LOOKED_AT / 2;
    near.chain(first)
        .any(|at| explain(view, at).rows.iter().any(|row| row.name == name))
}

fn no_number(name: &str, session: &Session) -> String {
    let names = names(session);
    let near = Some(name).filter(|name| !name.is_empty());
    let near = near.and_then(|name| did_you_mean(name, names.iter().map(String::as_str)));
    near.map_or_else(
        || {
            format!(
                "no step near here tells `{name}`; type {}, or a number of the details as it stands there",
                FIELDS.join(", ")
            )
        },
        |near| format!("did you mean `{near}`?"),
    )
}
