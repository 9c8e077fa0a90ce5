//! What a check asks: which quantities, at which rays, with which weights.

use std::str::FromStr as _;

use strum::VariantArray as _;

use super::AskFile;
use crate::grade::compare::Compared;
use crate::grade::quantity::QuantityKind;
use crate::probe::RayKind;
use crate::scene::Law;

/// What is asked, in the order of the file: later entries change earlier ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ask {
    entries: Vec<(Asked, u32)>,
}

/// One entry: what it names, and at which kind of ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    what: What,
    ray: Option<RayKind>,
    excludes: bool,
}

#[derive(Clone, Debug, PartialEq)]
enum What {
    Core,
    All,
    Quantity(QuantityKind),
    Law(Law),
}

impl Ask {
    /// The entries of a file; what is wrong with the first that is no quantity.
    pub fn new(entries: &[AskFile]) -> Result<Self, String> {
        let mut ask = Self::default();
        for entry in entries {
            match entry {
                AskFile::Name(name) => ask.entries.push((asked(name)?, 1)),
                AskFile::Weighted(weights) => {
                    for (name, weight) in weights {
                        ask.entries.push((asked(name)?, *weight));
                    }
                }
            }
        }
        Ok(ask)
    }

    /// The weight of a quantity; 0 if it is not asked.
    pub fn weight(&self, compared: &Compared) -> u64 {
        if compared.quantity == QuantityKind::Sent {
            return 0;
        }
        let entries = self
            .entries
            .iter()
            .filter(|(asked, _)| asked.names(compared));
        let weight = entries.fold(
            0,
            |_, (asked, weight)| if asked.excludes { 0 } else { *weight },
        );
        u64::from(weight)
    }

    /// The weight of the pixel's colour (`color` or `srgb8`).
    pub fn color_weight(&self, quantity: QuantityKind) -> u64 {
        let names = |asked: &Asked| match asked.what {
            What::Core | What::All => asked.ray.is_none(),
            What::Quantity(q) => q == quantity,
            What::Law(law) => law == Law::Color && quantity == QuantityKind::Srgb8,
        };
        let entries = self.entries.iter().filter(|(asked, _)| names(asked));
        u64::from(entries.fold(
            0,
            |_, (asked, weight)| if asked.excludes { 0 } else { *weight },
        ))
    }

    /// True if nothing is asked.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }
}

impl Asked {
    fn names(&self, compared: &Compared) -> bool {
        let here = self.ray.is_none_or(|kind| kind == compared.kind);
        here && match self.what {
            What::Core => QuantityKind::CORE.contains(&compared.quantity) && is_core(compared),
            // What only the textbook's accelerators have is asked by name alone.
            What::All => compared.quantity != QuantityKind::Order,
            What::Quantity(quantity) => quantity == compared.quantity,
            What::Law(law) => law == compared.law && is_printed(compared.quantity),
        }
    }
}

/// The direction of I and L rays is not a quantity of `core`: what is made of it is.
fn is_core(compared: &Compared) -> bool {
    let of_direction = matches!(
        compared.quantity,
        QuantityKind::Direction | QuantityKind::Unit
    );
    !of_direction
        || matches!(compared.kind, RayKind::Reflected | RayKind::Transmitted)
        || compared.quantity == QuantityKind::Unit
}

/// What a law gives and every tracer can tell.
fn is_printed(quantity: QuantityKind) -> bool {
    use QuantityKind::{
        Barycentric, Factors, GeometricNormal, Ior, Medium, Order, Origin, Primitive, Reflectance,
        Side, Uv,
    };
    !matches!(
        quantity,
        Barycentric
            | Factors
            | GeometricNormal
            | Ior
            | Medium
            | Order
            | Origin
            | Primitive
            | Reflectance
            | Side
            | Uv
    )
}

/// An entry from its text.
fn asked(text: &str) -> Result<Asked, String> {
    let (excludes, name) = match text.strip_prefix('-') {
        Some(name) => (true, name),
        None => (false, text),
    };
    let kinds = [
        ("I.", RayKind::Incident),
        ("L.", RayKind::Light),
        ("R.", RayKind::Reflected),
        ("T.", RayKind::Transmitted),
    ];
    let restricted = kinds
        .iter()
        .find_map(|(prefix, kind)| Some((name.strip_prefix(prefix)?, *kind)));
    let (name, ray) = restricted.map_or((name, None), |(name, kind)| (name, Some(kind)));
    let what = match (name, name.strip_prefix("law:")) {
        ("core", _) => What::Core,
        ("all", _) => What::All,
        (_, Some(law)) => What::Law(Law::from_str(law).map_err(|_| {
            let names: Vec<&str> = Law::VARIANTS.iter().map(|law| law.name()).collect();
            format!("`{text}` names no law; there are {}", names.join(", "))
        })?),
        _ => What::Quantity(QuantityKind::from_str(name).map_err(|_| {
            let names = QuantityKind::VARIANTS
                .iter()
                .map(|quantity| quantity.name());
            let names: Vec<&str> = names.chain(["core", "all", "law:NAME"]).collect();
            format!("`{text}` is no quantity; there are {}", names.join(", "))
        })?),
    };
    Ok(Asked {
        what,
        ray,
        excludes,
    })
}
