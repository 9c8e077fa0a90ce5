//! Addresses of rays: a scene, a pixel, and the way from the eye, as in `whitted@160,120/R/L:lamp`.
//!
//! ```text
//! address = [ SCENE "@" ] X "," Y [ ":" SAMPLE ] *( "/" step ) [ "." field | "#" event ]
//! step    = "R" | "T" | "L:" light [ "~" n ]
//! ```
//!
//! What a hit sends is unique, so a path is an exact name, whoever wrote the tree. In the names of lights the letters
//! `% / # @ ~ .` are written `%25 %2F %23 %40 %7E %2E`. Size, seed and the like are no part of an address: they are flags.

mod find;

use std::fmt;
use std::str::FromStr;

pub use find::{node_at, path_of, subtree};

use super::facts::TreePath;
use crate::scene::printable::excerpt;

/// Where a ray is, and what of it is meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// The scene as on the command line, if it is named.
    pub scene: Option<String>,
    /// Column and row of the pixel.
    pub pixel: (u32, u32),
    /// The ray.
    pub path: TreePath,
    /// A part of it.
    pub part: Option<AddressPart>,
}

/// What of a ray is meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AddressPart {
    /// A field, such as `hit.t`, `terms.diffuse:sun` or `order[4]`, as it is written.
    Field(String),
    /// An event of the pixel's log, counted from 0.
    Event(usize),
}

impl FromStr for Address {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // In names of lights and fields the sign is escaped: the last one stands behind the scene.
        let (scene, rest) = match text.rsplit_once('@') {
            Some(("", _)) => {
                return Err(format!("`{}` names no scene before the @", excerpt(text)));
            }
            Some((scene, rest)) => (Some(scene.to_owned()), rest),
            None => (None, text),
        };
        let (way, part) = match rest.find(['.', '#']) {
            Some(at) => (&rest[..at], Some(part(&rest[at..])?)),
            None => (rest, None),
        };
        let mut steps = way.split('/');
        let start = steps.next().unwrap_or_default();
        let (pixel, sample) = match start.split_once(':') {
            Some((pixel, sample)) => (pixel, number(sample, "number of a sample, such as :2")?),
            None => (start, 0),
        };
        let wrong = || {
            format!(
                "`{}` is no pixel; write X,Y, such as 160,120",
                excerpt(pixel)
            )
        };
        let (x, y) = pixel.split_once(',').ok_or_else(wrong)?;
        let axis = |digits: &str| digits.parse().map_err(|_| wrong());
        let steps = steps.map(str::parse).collect::<Result<_, _>>()?;
        Ok(Self {
            scene,
            pixel: (axis(x)?, axis(y)?),
            path: TreePath { sample, steps },
            part,
        })
    }
}

/// A part of a ray, from its `.` or `#` on.
fn part(text: &str) -> Result<AddressPart, String> {
    if let Some(event) = text.strip_prefix('#') {
        return number(event, "number of an event, such as #41").map(AddressPart::Event);
    }
    let field = &text[1..];
    if field.is_empty() || field.contains(['/', '#', '@']) {
        let shown = excerpt(field);
        return Err(format!(
            "`{shown}` is no field; write one behind the steps, such as .hit.t or .direction"
        ));
    }
    Ok(AddressPart::Field(field.to_owned()))
}

fn number<T: FromStr>(digits: &str, what: &str) -> Result<T, String> {
    // Without a sign, which `parse` would take.
    let number = digits
        .parse()
        .ok()
        .filter(|_| digits.bytes().all(|b| b.is_ascii_digit()));
    number.ok_or_else(|| format!("`{}` is no {what}", excerpt(digits)))
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(scene) = &self.scene {
            write!(f, "{scene}@")?;
        }
        write!(f, "{},{}{}", self.pixel.0, self.pixel.1, self.path)?;
        match &self.part {
            Some(AddressPart::Field(field)) => write!(f, ".{field}"),
            Some(AddressPart::Event(event)) => write!(f, "#{event}"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::facts::Step;
    use proptest::prelude::*;

    fn step() -> impl Strategy<Value = Step> {
        prop_oneof![
            Just(Step::Reflected),
            Just(Step::Transmitted),
            ("[ -~é☃]{1,12}", 0u32..9).prop_map(|(name, sample)| Step::Light(name, sample)),
        ]
    }

    fn part_of_ray() -> impl Strategy<Value = Option<AddressPart>> {
        prop_oneof![
            Just(None),
            "[a-z_]{1,8}(\\.[a-z]{1,8})?(:[a-z0-9%]{1,6})?(\\[[0-9]\\])?"
                .prop_map(|field| Some(AddressPart::Field(field))),
            any::<u32>().prop_map(|event| Some(AddressPart::Event(event as usize))),
        ]
    }

    proptest! {
        #[test]
        fn an_address_is_read_as_it_is_written(
            scene in proptest::option::of("[ -~ü]{1,20}"),
            pixel: (u32, u32),
            sample in 0u32..3,
            steps in proptest::collection::vec(step(), 0..6),
            part in part_of_ray(),
        ) {
            let address = Address { scene, pixel, path: TreePath { sample, steps }, part };
            prop_assert_eq!(address.to_string().parse(), Ok(address));
        }
    }

    #[test]
    fn what_is_no_address_is_told() {
        for (text, said) in [
            ("", "`` is no pixel"),
            ("whitted", "`whitted` is no pixel; write X,Y"),
            ("whitted@160", "`160` is no pixel"),
            ("@1,2", "names no scene"),
            ("a@1,-2", "is no pixel"),
            ("a@1,2,3", "is no pixel"),
            ("a@1,2:x", "`x` is no number of a sample"),
            ("a@1,2/", "`` is no step; write R, T or L:"),
            ("a@1,2/X", "`X` is no step"),
            ("a@1,2/L", "`L` is no step"),
            ("a@1,2/L:a~b", "`b` in `L:a~b` is no number"),
            ("a@1,2.", "`` is no field"),
            ("a@1,2.hit/T", "`hit/T` is no field"),
            ("a@1,2#", "`` is no number of an event"),
            ("a@1,2#+1", "`+1` is no number of an event"),
        ] {
            let error = text.parse::<Address>().expect_err("no address");
            assert!(error.contains(said), "{error}, not {said}");
        }
        let address: Address = "a@b.json@70,150:2/T/L:la%2Fmp~3.terms.diffuse:sun"
            .parse()
            .expect("an address");
        assert_eq!(address.scene.as_deref(), Some("a@b.json"));
        assert_eq!(address.path.to_string(), ":2/T/L:la%2Fmp~3");
    }
}
