//! Quantities of a ray that a query compares with a number.

use super::pattern::Pattern;
use crate::math::{DVec3, Rgb};
use crate::probe::{Event, Factor, RayKind, Term, TermKind};
use crate::shading::Interaction;
use crate::trace::{Outcome, View};

/// A quantity of a ray.
#[derive(Clone, Debug, PartialEq)]
pub enum NodeQuantity {
    /// The depth of the deepest reflected or transmitted ray that follows from it; 0 for an eye ray without any.
    Depth,
    /// The number of rays that follow from it, itself included.
    Rays,
    /// The distance to its hit point.
    T,
    /// A channel of its radiance: red, green or blue.
    Channel(usize),
    /// The luminance of its radiance.
    Luminance,
    /// The index of refraction before the surface.
    N1,
    /// The index of refraction behind it.
    N2,
    /// The share of light that a boundary reflects.
    Reflectance,
    /// A coordinate of its direction: x, y or z.
    Direction(usize),
    /// A coordinate of its hit point.
    Point(usize),
    /// A coordinate of the normal N there, that shading uses.
    Normal(usize),
    /// Degrees between the way back along the ray and N.
    Angle,
    /// Degrees between N and the geometric normal.
    NormalAngle,
    /// N.V, the cosine of the angle.
    NDotV,
    /// A factor of the term of a light of such a name, by the factor's name.
    Factor(&'static str, Pattern),
    /// The luminance of the diffuse or specular terms of lights of such a name.
    Terms(TermKind, Pattern),
}

impl NodeQuantity {
    /// Names of the quantities without a light's name.
    pub const PLAIN: [(&'static str, Self); 22] = [
        ("depth", Self::Depth),
        ("rays", Self::Rays),
        ("t", Self::T),
        ("red", Self::Channel(0)),
        ("green", Self::Channel(1)),
        ("blue", Self::Channel(2)),
        ("luminance", Self::Luminance),
        ("n1", Self::N1),
        ("n2", Self::N2),
        ("reflectance", Self::Reflectance),
        ("direction.x", Self::Direction(0)),
        ("direction.y", Self::Direction(1)),
        ("direction.z", Self::Direction(2)),
        ("point.x", Self::Point(0)),
        ("point.y", Self::Point(1)),
        ("point.z", Self::Point(2)),
        ("normal.x", Self::Normal(0)),
        ("normal.y", Self::Normal(1)),
        ("normal.z", Self::Normal(2)),
        ("angle", Self::Angle),
        ("normal_angle", Self::NormalAngle),
        ("n_dot_v", Self::NDotV),
    ];

    /// Names of the quantities that a light's name follows.
    pub const OF_LIGHTS: [&'static str; 4] = ["n_dot_l", "r_dot_v", "diffuse", "specular"];

    /// The quantity of lights of such a name; `None` if `name` is none of [`Self::OF_LIGHTS`].
    pub fn of_light(name: &str, light: Pattern) -> Option<Self> {
        match name {
            "n_dot_l" => Some(Self::Factor("n_dot_l", light)),
            "r_dot_v" => Some(Self::Factor("r_dot_v", light)),
            "diffuse" => Some(Self::Terms(TermKind::Diffuse, light)),
            "specular" => Some(Self::Terms(TermKind::Specular, light)),
            _ => None,
        }
    }

    /// The quantity of a node, if it has it.
    pub fn of(&self, view: View, node: u32) -> Option<f64> {
        let tree = &view.trace.tree;
        let this = tree.node(node);
        let events = || tree.own_events(node).map(|(_, event)| event);
        match self {
            Self::Depth => {
                let subtree = (node..node + this.size).map(|n| tree.node(n).ray);
                let paths = subtree.filter(|ray| ray.kind != RayKind::Light);
                paths.map(|ray| f64::from(ray.depth)).reduce(f64::max)
            }
            Self::Rays => Some(f64::from(this.size)),
            Self::T => match this.outcome {
                Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => Some(hit.t),
                _ => None,
            },
            Self::Channel(channel) => Some(this.radiance.channels()[*channel]),
            Self::Luminance => Some(this.radiance.luminance()),
            Self::Direction(axis) => Some(this.ray.direction[*axis]),
            Self::Point(_) | Self::Normal(_) | Self::Angle | Self::NormalAngle | Self::NDotV => {
                Some(self.of_surface(&view.surface_hit(node)?.at))
            }
            Self::N1 | Self::N2 | Self::Reflectance => events().find_map(|event| match event {
                Event::Boundary {
                    n1,
                    n2,
                    reflectance,
                } => Some(match self {
                    Self::N1 => *n1,
                    Self::N2 => *n2,
                    _ => *reflectance,
                }),
                _ => None,
            }),
            Self::Factor(name, pattern) => events().find_map(|event| match event {
                Event::Term { term, light, .. } if pattern.matches(view.light_name(*light)) => {
                    factor(term, name)
                }
                _ => None,
            }),
            Self::Terms(kind, pattern) => {
                let values = events().filter_map(|event| match event {
                    Event::Term { term, light, .. } => {
                        let fits = term.kind() == *kind && pattern.matches(view.light_name(*light));
                        fits.then(|| term.value())
                    }
                    _ => None,
                });
                let sum = values.reduce(|a, b| a + b);
                sum.map(Rgb::luminance)
            }
        }
    }

    /// The quantity of the surface that a ray ends on; NaN if it is none of a surface.
    fn of_surface(&self, at: &Interaction) -> f64 {
        match self {
            Self::Point(axis) => at.point[*axis],
            Self::Normal(axis) => at.normal[*axis],
            Self::Angle => degrees_between(at.to_viewer, at.normal),
            Self::NormalAngle => degrees_between(at.normal, at.geometric_normal),
            Self::NDotV => at.normal.dot(at.to_viewer),
            _ => f64::NAN,
        }
    }
}

/// Degrees between two vectors. (By sine and cosine: right for small angles, too.)
fn degrees_between(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b)).to_degrees()
}

/// A factor of a term that is a number.
fn factor(term: &Term, wanted: &str) -> Option<f64> {
    term.factors()
        .into_iter()
        .find_map(|(name, factor)| match factor {
            Factor::Number(number) if name == wanted => Some(number),
            _ => None,
        })
}
