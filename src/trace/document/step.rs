//! A step of a ray through the acceleration structure.

use std::borrow::Cow;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::probe::{Choice, NONE, Verdict, Visit};
use crate::scene::Scene;
use crate::world::World;

/// A node visited or a primitive tested.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum TraversalStep {
    /// A node was visited or skipped.
    Visit {
        /// The node.
        node: u32,
        /// a, b, c, d of the plane a x + b y + c z = d; null for leaves.
        plane: Option<[f64; 4]>,
        /// Where the ray's line crosses the plane; null if it never does, or is not asked to.
        t_split: Option<f64>,
        /// The part of the ray inside the node; null for an open end.
        interval: [Option<f64>; 2],
        /// The child on the side that the ray comes from.
        near: Option<u32>,
        /// The other child.
        far: Option<u32>,
        /// Which children are visited.
        visit: VisitedChildren,
        /// Why, in words.
        reason: Cow<'static, str>,
    },
    /// A primitive was tested.
    Test {
        /// Which.
        test: TestedPrimitive,
        /// What was found.
        result: Verdict,
        /// Where the ray's line crosses it; null if it does not.
        t: Option<f64>,
        /// What the result means, in words.
        reason: Cow<'static, str>,
    },
}

/// Which children of a node are visited.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum VisitedChildren {
    /// That on the side that the ray comes from.
    Near,
    /// The other one.
    Far,
    /// First the near, then the far one.
    Both,
    /// Those of a node of many boxes that the ray meets.
    Children,
    /// None: a leaf, or a node that is skipped.
    None,
}

/// A primitive by the name of its object.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct TestedPrimitive {
    /// The object's name.
    pub object: String,
    /// Counted within the object, from 0.
    pub primitive: u32,
}

/// A visit by its log entry.
pub(super) fn visit(world: &World, visit: &Visit) -> TraversalStep {
    let child = |id: u32| (id != NONE).then_some(id);
    let plane = world.accel.plane(visit.node);
    TraversalStep::Visit {
        node: visit.node,
        plane: plane.map(|(n, d)| [n.x, n.y, n.z, d]),
        t_split: finite(visit.t_split),
        interval: visit.interval.map(finite),
        near: child(visit.near),
        far: child(visit.far),
        visit: VisitedChildren::from(visit.choice),
        reason: visit.choice.reason().into(),
    }
}

/// A test by its log entry.
pub(super) fn test(scene: &Scene, primitive: u32, verdict: Verdict, t: f64) -> TraversalStep {
    TraversalStep::Test {
        test: TestedPrimitive {
            object: scene.object_of(primitive).name.clone(),
            primitive: scene.local_index(primitive),
        },
        result: verdict,
        t: finite(t),
        reason: verdict.reason().into(),
    }
}

impl From<Choice> for VisitedChildren {
    fn from(choice: Choice) -> Self {
        match choice {
            Choice::Both | Choice::BothInDoubt => Self::Both,
            Choice::NearSplitBeyond | Choice::NearRunsAway => Self::Near,
            Choice::FarSplitBefore => Self::Far,
            Choice::Children => Self::Children,
            Choice::Leaf
            | Choice::Cell
            | Choice::SkippedCloserHit
            | Choice::SkippedOutside
            | Choice::SkippedMissed => Self::None,
        }
    }
}

/// JSON has neither infinity nor NaN: an open end is null.
pub(super) fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
