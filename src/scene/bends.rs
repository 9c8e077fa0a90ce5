//! Bends of a render: none, one, or two of different laws.

use std::fmt;
use std::str::FromStr;

use super::{Bend, Law};
use crate::math::Rgb;

/// Laws that are exchanged for mistakes, so that a picture shows what these do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Bends(pub [Option<Bend>; 2]);

impl From<Bend> for Bends {
    fn from(bend: Bend) -> Self {
        Self([Some(bend), None])
    }
}

impl Bends {
    /// The bends.
    pub fn iter(self) -> impl Iterator<Item = Bend> {
        self.0.into_iter().flatten()
    }

    /// True if no law is bent.
    pub fn is_empty(self) -> bool {
        self == Self::default()
    }

    /// True if this bend is among them.
    pub fn has(self, bend: Bend) -> bool {
        self.iter().any(|b| b == bend)
    }

    /// The bend of a law.
    pub fn of(self, law: Law) -> Option<Bend> {
        self.iter().find(|bend| bend.law() == law)
    }

    /// These without the bend of a law.
    pub fn without(self, law: Law) -> Self {
        Self(self.0.map(|bend| bend.filter(|bend| bend.law() != law)))
    }

    /// Colour of a pixel, given the mean of its samples and their number.
    pub fn color(self, mean: Rgb, samples: u32) -> Rgb {
        if self.has(Bend::NotAveraged) {
            mean * f64::from(samples.max(1))
        } else {
            mean
        }
    }

    /// What the screen shows of a colour.
    pub fn srgb8(self, color: Rgb) -> [u8; 3] {
        let encoded = |c: Rgb| Rgb::from(c.to_srgb8().map(|c| f64::from(c) / 255.0));
        match self.of(Law::Color) {
            Some(Bend::GammaTwice) => encoded(color).to_srgb8(),
            Some(Bend::GammaNone) => color
                .channels()
                .map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8),
            Some(Bend::Truncated) => color.to_srgb8_floor(),
            _ => color.to_srgb8(),
        }
    }
}

impl fmt::Display for Bends {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(Bend::name).collect();
        f.write_str(&names.join(","))
    }
}

impl FromStr for Bends {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let bend = |name: &str| {
            name.parse::<Bend>().map_err(|_| {
                let guess =
                    super::read::did_you_mean::did_you_mean(name, Bend::all().map(Bend::name));
                let guess = guess.map_or(String::new(), |near| format!("did you mean `{near}`? "));
                format!("`{name}` is no bend; {guess}`raytree grade --bends` lists them")
            })
        };
        let bends = text.split(',').map(bend).collect::<Result<Vec<_>, _>>()?;
        match bends[..] {
            [one] => Ok(one.into()),
            [a, b] if a.law() != b.law() => Ok(Self([Some(a), Some(b)])),
            [a, _] => Err(format!("both bend the law `{}`; give one of them", a.law())),
            _ => Err("at most two laws can be bent; give one or two".to_owned()),
        }
    }
}
