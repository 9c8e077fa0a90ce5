//! Quantities: what of a ray tree can be right or wrong, by name.

use strum::{Display, EnumString, IntoStaticStr, VariantArray};

use crate::probe::{RayKind, TermKind};
use crate::scene::Law;
use crate::trace::facts::FactName;

/// A kind of quantity, as tasks and messages name it.
#[derive(
    Clone,
    Copy,
    Debug,
    Display,
    EnumString,
    Eq,
    Hash,
    IntoStaticStr,
    Ord,
    PartialEq,
    PartialOrd,
    VariantArray,
)]
#[strum(serialize_all = "snake_case")]
pub enum QuantityKind {
    /// Where a ray starts.
    Origin,
    /// Where it goes, as an angle.
    Direction,
    /// The length of a direction or a normal.
    Unit,
    /// Distance to the light of an L ray.
    Distance,
    /// The medium that a ray travels in.
    Medium,
    /// The index of refraction of the medium, of both sides of a surface.
    Ior,
    /// Hit or miss.
    Outcome,
    /// The steps through the accelerator.
    Order,
    /// The object hit.
    Object,
    /// The primitive hit.
    Primitive,
    /// The ray parameter of the hit.
    T,
    /// The weights of a triangle's corners.
    Barycentric,
    /// Texture coordinates.
    Uv,
    /// The hit point.
    Point,
    /// The normal of the shape.
    GeometricNormal,
    /// The normal that shading uses.
    Normal,
    /// The side of the surface.
    Side,
    /// Whether a light is seen.
    Lit,
    /// Terms of the shading equation.
    Terms,
    /// Factors of terms.
    Factors,
    /// The reflected share at a boundary.
    Reflectance,
    /// Whether an R or a T ray is sent, or a light behind the surface shines on it.
    Sent,
    /// Factor of R or T in the sum.
    Weight,
    /// What a ray brings back.
    Radiance,
    /// Rays that are not sent, with their reasons.
    Absent,
    /// Linear colour of a pixel.
    Color,
    /// Colour on the screen.
    Srgb8,
}

impl QuantityKind {
    /// What every tracer has: what `core` asks.
    pub const CORE: [Self; 13] = [
        Self::Outcome,
        Self::Object,
        Self::T,
        Self::Point,
        Self::Normal,
        Self::Lit,
        Self::Terms,
        Self::Direction,
        Self::Unit,
        Self::Weight,
        Self::Radiance,
        Self::Color,
        Self::Srgb8,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The kind of a fact of a ray.
    pub fn of(ray: RayKind, name: &FactName) -> Self {
        match name {
            FactName::Origin => Self::Origin,
            FactName::Direction => Self::Direction,
            FactName::Distance => Self::Distance,
            FactName::Medium => Self::Medium,
            FactName::Ior | FactName::N1 | FactName::N2 => Self::Ior,
            FactName::Outcome if ray == RayKind::Light => Self::Lit,
            FactName::Outcome => Self::Outcome,
            FactName::Order => Self::Order,
            FactName::Object => Self::Object,
            FactName::Primitive => Self::Primitive,
            FactName::T => Self::T,
            FactName::Barycentric => Self::Barycentric,
            FactName::Uv => Self::Uv,
            FactName::Point => Self::Point,
            FactName::GeometricNormal => Self::GeometricNormal,
            FactName::Normal => Self::Normal,
            FactName::Side => Self::Side,
            FactName::Term(..) => Self::Terms,
            FactName::NDotL(..) | FactName::RDotV(..) | FactName::CornerValue(..) => Self::Factors,
            FactName::Reflectance => Self::Reflectance,
            FactName::Sends(_) | FactName::Shines(_) => Self::Sent,
            FactName::Weight => Self::Weight,
            FactName::Radiance => Self::Radiance,
        }
    }
}

/// The law that gives a fact of a ray.
pub fn law_of(ray: RayKind, name: &FactName) -> Law {
    match (name, ray) {
        (FactName::Origin | FactName::Direction, RayKind::Incident) => Law::EyeRay,
        (FactName::Origin, _) => Law::Start,
        (FactName::Direction, RayKind::Reflected) | (FactName::Sends(RayKind::Reflected), _) => {
            Law::Reflect
        }
        (FactName::Direction, RayKind::Transmitted) | (FactName::Sends(_), _) => Law::Refract,
        (FactName::Direction | FactName::Distance | FactName::Shines(_), _) => Law::Illumination,
        (FactName::Medium | FactName::Ior | FactName::N1 | FactName::N2, _) => Law::Media,
        (FactName::Outcome, RayKind::Light) => Law::Shadow,
        (
            FactName::Outcome
            | FactName::Object
            | FactName::Primitive
            | FactName::T
            | FactName::Order,
            _,
        ) => Law::Closest,
        (FactName::Term(kind, ..) | FactName::CornerValue(kind, ..), _) => match kind {
            TermKind::Ambient => Law::Ambient,
            TermKind::Background => Law::Background,
            TermKind::Specular => Law::Specular,
            TermKind::Diffuse => Law::Diffuse,
            TermKind::Emission => Law::Radiance,
        },
        (FactName::NDotL(..), _) => Law::Diffuse,
        (FactName::RDotV(..), _) => Law::Specular,
        (FactName::Reflectance | FactName::Weight, _) => Law::Shares,
        (FactName::Radiance, _) => Law::Radiance,
        _ => Law::Interaction,
    }
}

/// A fact as messages and JSON name it, such as `hit.t` or `terms.diffuse:sun`.
pub fn field(name: &FactName) -> String {
    let of_light = |light: &str, sample: u32| match sample {
        0 => light.to_owned(),
        _ => format!("{light}~{sample}"),
    };
    match name {
        FactName::Origin => "origin".into(),
        FactName::Direction => "direction".into(),
        FactName::Distance => "t_max".into(),
        FactName::Medium => "medium".into(),
        FactName::Ior => "ior".into(),
        FactName::Outcome => "outcome".into(),
        FactName::Order => "traversal".into(),
        FactName::Object => "hit.object".into(),
        FactName::Primitive => "hit.primitive".into(),
        FactName::T => "hit.t".into(),
        FactName::Barycentric => "hit.barycentric".into(),
        FactName::Uv => "hit.uv".into(),
        FactName::Point => "hit.point".into(),
        FactName::GeometricNormal => "hit.geometric_normal".into(),
        FactName::Normal => "hit.normal".into(),
        FactName::Side => "hit.side".into(),
        FactName::N1 => "boundary.n1".into(),
        FactName::N2 => "boundary.n2".into(),
        FactName::Term(kind, None, _) => format!("terms.{}", kind.name()),
        FactName::Term(kind, Some(light), sample) => {
            format!("terms.{}:{}", kind.name(), of_light(light, *sample))
        }
        FactName::NDotL(light, sample) => format!("n_dot_l:{}", of_light(light, *sample)),
        FactName::RDotV(light, sample) => format!("r_dot_v:{}", of_light(light, *sample)),
        FactName::CornerValue(kind, light, sample, corner) => {
            let term = field(&FactName::Term(*kind, light.clone(), *sample));
            format!("{term}.corners[{corner}].value")
        }
        FactName::Reflectance => "boundary.reflectance".into(),
        FactName::Shines(light) => format!("light of {light}"),
        FactName::Sends(kind) => format!("sends {}", kind.letter()),
        FactName::Weight => "weight".into(),
        FactName::Radiance => "radiance".into(),
    }
}
