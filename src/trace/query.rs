//! Queries: what is asked of a pixel's ray tree, as in `hits:ball and not lit:lamp`.
//!
//! A query is true or false of a node of the tree, a ray. It is asked of the eye ray; `some(...)` asks it of all rays that
//! follow from it as well. The grammar:
//!
//! ```text
//! query    = all *("or" all)
//! all      = part *("and" part)
//! part     = "not" part | "(" query ")" | "some" "(" query ")" | word | quantity compare number
//! word     = "hit" | "miss" | "front" | "back" | "tir" | "I" | "L" | "R" | "T"
//!          | ("hits" | "material" | "lit" | "blocked") ":" name | "absent" ":" reason | "path" ":" kinds ">" name
//! quantity = "depth" | "rays" | "t" | "red" | "green" | "blue" | "luminance" | "n1" | "n2" | "reflectance"
//!          | ("direction" | "point" | "normal") "." ("x" | "y" | "z") | "angle" | "normal_angle" | "n_dot_v"
//!          | ("n_dot_l" | "r_dot_v" | "diffuse" | "specular") ":" name
//! compare  = "<" | "<=" | ">" | ">=" | "=" | "!="
//! ```
//!
//! A name may hold `*` for any letters, and stands in double quotes if it holds spaces or brackets.

mod error;
mod names;
mod parse;
mod pattern;
mod quantity;
mod token;

use crate::probe::{Event, RayKind};
use crate::shading::Side;
use crate::trace::{Outcome, View};
use quantity::NodeQuantity;

pub use error::QueryError;
pub use names::unknown_names;
pub use pattern::Pattern;

/// A query, made from its text with [`str::parse`].
#[derive(Clone, Debug, PartialEq)]
pub enum TreeQuery {
    /// Both.
    And(Box<TreeQuery>, Box<TreeQuery>),
    /// One of the two, or both.
    Or(Box<TreeQuery>, Box<TreeQuery>),
    /// The contrary.
    Not(Box<TreeQuery>),
    /// True of the ray, or of a ray that follows from it.
    Some(Box<TreeQuery>),
    /// A property.
    Is(Property),
    /// A quantity beside a number; false where the ray has no such quantity.
    Compare(NodeQuantity, Relation, f64),
}

/// A property that a ray has or has not.
#[derive(Clone, Debug, PartialEq)]
pub enum Property {
    /// It is of this kind.
    Kind(RayKind),
    /// It ends on a surface.
    Hit,
    /// It leaves the scene.
    Miss,
    /// It meets a surface from outside.
    Front,
    /// It meets a surface from inside.
    Back,
    /// It ends on an object of such a name.
    Hits(Pattern),
    /// It ends on a material of such a name.
    Material(Pattern),
    /// It ends on a part of such a name: a wall, a cap, or what a csg is made of.
    Part(Pattern),
    /// Where it ends, light reaches the surface from a light of such a name.
    Lit(Pattern),
    /// Where it ends, something is before a light of such a name.
    Blocked(Pattern),
    /// Where it ends, a ray is not sent, for this reason.
    Absent(&'static str),
    /// It is followed by rays of these kinds, the last of which ends on an object of such a name.
    Path(Vec<RayKind>, Pattern),
}

/// How a quantity and a number are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Less.
    Less,
    /// Less or equal.
    AtMost,
    /// More.
    More,
    /// More or equal.
    AtLeast,
    /// Equal, to the last bit.
    Equal,
    /// Not equal.
    Unequal,
}

impl TreeQuery {
    /// True if the eye ray of one of the pixel's samples satisfies the query.
    pub fn holds(&self, view: View) -> bool {
        let mut roots = view.trace.tree.samples.iter().filter_map(|s| s.root);
        roots.any(|root| self.holds_at(view, root))
    }

    /// What is asked of each ray, where the query asks it of any: `some(...)` without its brackets.
    pub fn of_each_ray(&self) -> &Self {
        match self {
            Self::Some(query) => query.of_each_ray(),
            query => query,
        }
    }

    /// The event of a node's ray by which it satisfies the query: that of a ray which is not sent, where that is asked, else its
    /// start. None if it does not.
    pub fn event(&self, view: View, node: u32) -> Option<usize> {
        let start = view.trace.tree.node(node).first_event as usize;
        let holds = self.holds_at(view, node);
        holds.then(|| self.absence(view, node).unwrap_or(start))
    }

    /// The event of a ray that is not sent, of those that the query names.
    fn absence(&self, view: View, node: u32) -> Option<usize> {
        match self {
            Self::And(a, b) | Self::Or(a, b) => {
                a.absence(view, node).or_else(|| b.absence(view, node))
            }
            Self::Is(Property::Absent(name)) => {
                let mut events = view.trace.tree.own_events(node);
                let is_it = |event: &Event| matches!(event, Event::Absent { reason, .. } if reason.name() == *name);
                events.find_map(|(at, event)| is_it(event).then_some(at))
            }
            _ => None,
        }
    }

    /// True if a node satisfies the query.
    pub fn holds_at(&self, view: View, node: u32) -> bool {
        match self {
            Self::And(a, b) => a.holds_at(view, node) && b.holds_at(view, node),
            Self::Or(a, b) => a.holds_at(view, node) || b.holds_at(view, node),
            Self::Not(query) => !query.holds_at(view, node),
            Self::Some(query) => {
                let subtree = node..node + view.trace.tree.node(node).size;
                subtree.into_iter().any(|n| query.holds_at(view, n))
            }
            Self::Is(property) => property.holds_at(view, node),
            Self::Compare(quantity, comparison, number) => quantity
                .of(view, node)
                .is_some_and(|value| comparison.holds(value, *number)),
        }
    }
}

impl Property {
    fn holds_at(&self, view: View, node: u32) -> bool {
        let tree = &view.trace.tree;
        let this = tree.node(node);
        let (world, scene) = (view.world, &view.world.scene);
        let hit = match this.outcome {
            Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => Some(hit),
            _ => None,
        };
        let side = || Some(view.surface_hit(node)?.at.side);
        // The shadow rays to lights of such a name.
        let shadow_ray = |pattern: &Pattern, lit: bool| {
            tree.children(node)
                .map(|child| tree.node(child))
                .any(|ray| {
                    ray.ray.kind == RayKind::Light
                        && matches!(ray.outcome, Some(Outcome::Lit)) == lit
                        && pattern.matches(view.light_name(ray.ray.light))
                })
        };
        match self {
            Self::Kind(kind) => this.ray.kind == *kind,
            Self::Hit => hit.is_some(),
            Self::Miss => this.outcome == Some(Outcome::Miss),
            Self::Front => side() == Some(Side::Front),
            Self::Back => side() == Some(Side::Back),
            Self::Hits(pattern) => {
                hit.is_some_and(|hit| pattern.matches(&scene.object_of(hit.primitive).name))
            }
            Self::Material(pattern) => {
                hit.is_some_and(|hit| pattern.matches(&world.scene.material_at(&hit).name))
            }
            Self::Part(pattern) => {
                let part = hit.as_ref().and_then(|hit| scene.part_name(hit));
                part.is_some_and(|name| pattern.matches(name))
            }
            Self::Lit(pattern) => shadow_ray(pattern, true),
            Self::Blocked(pattern) => shadow_ray(pattern, false),
            Self::Absent(name) => tree.own_events(node).any(
                |(_, event)| matches!(event, Event::Absent { reason, .. } if reason.name() == *name),
            ),
            Self::Path(kinds, pattern) => match kinds.split_first() {
                None => Self::Hits(pattern.clone()).holds_at(view, node),
                Some((kind, rest)) => {
                    let rest = Self::Path(rest.to_vec(), pattern.clone());
                    tree.children(node)
                        .any(|c| tree.node(c).ray.kind == *kind && rest.holds_at(view, c))
                }
            },
        }
    }
}

impl Relation {
    fn holds(self, value: f64, number: f64) -> bool {
        match self {
            Self::Less => value < number,
            Self::AtMost => value <= number,
            Self::More => value > number,
            Self::AtLeast => value >= number,
            Self::Equal => value == number,
            Self::Unequal => value != number,
        }
    }
}
