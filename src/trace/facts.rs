//! Facts of a ray tree: what it says of each ray, as plain data, whoever wrote it.
//!
//! A ray has an exact name, its path from the eye ([`TreePath`]), since what a hit sends is unique: one R, one T, and one L for
//! each light and sample. A fact is a value by name ([`FactName`]). Trees of this tracer and those that strangers wrote
//! ([`super::read`]) end here alike, so that they can be compared.

mod of_document;
mod tree_path;

use crate::math::Rgb;
use crate::probe::{RayKind, TermKind};

pub use of_document::{pixel_facts, sorted};
pub use tree_path::{Step, TreePath};

/// What is said of a pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PixelFacts {
    /// Name of the scene, if it is told.
    pub scene: Option<String>,
    /// The pixel's column and row, if they are told.
    pub pixel: Option<(u32, u32)>,
    /// Linear colour; a colour that is told and has a channel that is no number is [`Fact::Nothing`].
    pub color: Option<Fact>,
    /// Colour for the screen, 0 to 255.
    pub srgb8: Option<Fact>,
    /// The rays of all samples, parents before their children.
    pub rays: Vec<RayFacts>,
    /// Values of single samples of an estimate.
    pub estimates: Vec<f64>,
    /// Mean of an estimate, and the number of its samples.
    pub mean: Option<(f64, u64)>,
    /// What was not understood, in words: fields that hold no number, fields that are unknown.
    pub problems: Vec<String>,
}

/// What is said of a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct RayFacts {
    /// Its name.
    pub path: TreePath,
    /// The index of the ray whose hit sent it.
    pub parent: Option<usize>,
    /// Its kind.
    pub kind: RayKind,
    /// The facts, sorted by name; each name once.
    pub facts: Vec<(FactName, Fact)>,
    /// Rays that its hit did not send: the kind, the light and the reason.
    pub absent: Vec<(RayKind, Option<String>, String)>,
}

/// Value of a fact.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// A number.
    Number(f64),
    /// A vector, a point, or barycentric coordinates.
    Vector([f64; 3]),
    /// Surface coordinates.
    Pair([f64; 2]),
    /// A colour, or a factor a channel.
    Color(Rgb),
    /// A word, or a name.
    Word(String),
    /// Steps through the accelerator.
    Steps(Vec<String>),
    /// Told, but no value of its kind: NaN, infinity, a text where a number belongs.
    Nothing,
}

/// Name of a fact. The order is that in which the facts of a ray depend on each other.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FactName {
    /// `origin`.
    Origin,
    /// `direction`.
    Direction,
    /// `t_max` of an L ray.
    Distance,
    /// `medium`.
    Medium,
    /// `ior` of the medium.
    Ior,
    /// `outcome`; that of an L ray is "lit" or "blocked".
    Outcome,
    /// `traversal`.
    Order,
    /// `hit.object`.
    Object,
    /// `hit.primitive`.
    Primitive,
    /// `hit.t`.
    T,
    /// `hit.barycentric`.
    Barycentric,
    /// `hit.uv`.
    Uv,
    /// `hit.point`.
    Point,
    /// `hit.geometric_normal`.
    GeometricNormal,
    /// `hit.normal`.
    Normal,
    /// `hit.side`.
    Side,
    /// `boundary.n1`.
    N1,
    /// `boundary.n2`.
    N2,
    /// A value of `terms`: the kind, and of a light its name and the number of its sample, 0 if it has one.
    Term(TermKind, Option<String>, u32),
    /// `n_dot_l` of a light's diffuse term.
    NDotL(String, u32),
    /// `r_dot_v` of a light's specular term.
    RDotV(String, u32),
    /// The value of a term at a corner of a triangle, where it is blended: of the term as above, and which corner.
    CornerValue(TermKind, Option<String>, u32, u8),
    /// `boundary.reflectance`.
    Reflectance,
    /// Whether its hit sends an R or a T ray: "yes" or "no".
    Sends(RayKind),
    /// Whether a light that ours does not ask reaches its hit: "yes" or "no".
    Shines(String),
    /// `weight` of an R or a T ray.
    Weight,
    /// `radiance`.
    Radiance,
}

impl RayFacts {
    /// A fact.
    pub fn get(&self, name: &FactName) -> Option<&Fact> {
        let index = self.facts.binary_search_by(|(n, _)| n.cmp(name)).ok()?;
        Some(&self.facts[index].1)
    }

    /// A vector among the facts.
    pub fn vector(&self, name: &FactName) -> Option<[f64; 3]> {
        match self.get(name)? {
            Fact::Vector(v) => Some(*v),
            _ => None,
        }
    }

    /// A number among the facts.
    pub fn number(&self, name: &FactName) -> Option<f64> {
        match self.get(name)? {
            Fact::Number(x) => Some(*x),
            _ => None,
        }
    }

    /// A word among the facts.
    pub fn word(&self, name: &FactName) -> Option<&str> {
        match self.get(name)? {
            Fact::Word(word) => Some(word),
            _ => None,
        }
    }

    /// A colour among the facts.
    pub fn color(&self, name: &FactName) -> Option<Rgb> {
        match self.get(name)? {
            Fact::Color(color) => Some(*color),
            _ => None,
        }
    }
}

impl PixelFacts {
    /// The ray of a name.
    pub fn ray(&self, path: &TreePath) -> Option<&RayFacts> {
        self.rays.iter().find(|ray| ray.path == *path)
    }

    /// The rays that the hit of ray number `index` sent.
    pub fn children(&self, index: usize) -> impl Iterator<Item = (usize, &RayFacts)> {
        let rays = self.rays.iter().enumerate();
        rays.filter(move |(_, ray)| ray.parent == Some(index))
    }
}
