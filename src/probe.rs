//! The words in which the tracer speaks.
//!
//! One function follows rays ([`crate::tracer`]); whoever wants to know what it does listens as a [`Probe`]. With
//! [`Silent`] every call compiles to nothing, so the picture pays nothing for being explainable.
//!
//! Events carry decisions and ids, not derivations: what can be computed again from them with the tracer's own
//! functions is not stored. They are plain `Copy` data of at most 96 bytes, so that a log of millions stays small.

mod term;
mod words;

/// Parts of the program that builds for counting instructions leave out: what they cost others is what is counted.
pub mod counting {
    /// Transparent surfaces.
    pub const REFRACTION: bool = cfg!(not(feature = "count-without-refraction"));
    /// Lights with an area.
    pub const AREAS: bool = cfg!(not(feature = "count-without-areas"));
    /// Bent laws.
    pub const BENDS: bool = cfg!(not(feature = "count-without-bends"));
}

/// Tells a probe of an event: `tell!(probe, Event::Miss)`. Nothing at all, the event included, in builds that count
/// what probes cost.
macro_rules! tell {
    ($probe:expr, $event:expr $(,)?) => {
        if cfg!(not(feature = "count-without-probe")) {
            $probe.event($event)
        }
    };
}
pub(crate) use tell;

pub use term::{Factor, ProjectedShare, Term, TermKind, highlight};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use strum::{EnumDiscriminants, IntoStaticStr, VariantNames};

use crate::geometry::Hit;
use crate::math::{DVec3, Interval, Rgb};

/// Something that wants to know what the tracer does.
pub trait Probe {
    /// Whether the steps through the acceleration structure are wanted as well. Constant, so that traversal code can
    /// leave out what nobody hears.
    const TRAVERSAL: bool;

    /// Whether anything is wanted at all. If not, questions may be answered in bundles, ahead of the one who asks.
    const LISTENS: bool = true;

    /// Called once for everything that happens, in order.
    fn event(&mut self, event: Event);
}

/// Listens to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Probe for Silent {
    const TRAVERSAL: bool = false;
    const LISTENS: bool = false;

    #[inline(always)]
    fn event(&mut self, _: Event) {}
}

/// The four kinds of ray, named as in the lectures.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    Hash,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    JsonSchema,
    IntoStaticStr,
)]
pub enum RayKind {
    /// I, incident: from the eye.
    #[serde(rename = "I")]
    #[strum(serialize = "I")]
    Incident,
    /// L, to a light (a shadow ray).
    #[serde(rename = "L")]
    #[strum(serialize = "L")]
    Light,
    /// R, reflected.
    #[serde(rename = "R")]
    #[strum(serialize = "R")]
    Reflected,
    /// T, transmitted (refracted).
    #[serde(rename = "T")]
    #[strum(serialize = "T")]
    Transmitted,
}

impl RayKind {
    /// All kinds, in the order in which a hit sends them.
    pub const ALL: [Self; 4] = [
        Self::Incident,
        Self::Light,
        Self::Reflected,
        Self::Transmitted,
    ];

    /// The letter of the lectures.
    pub fn letter(self) -> &'static str {
        self.into()
    }
}

/// "No such thing" where an event names a light or an object by index.
pub const NONE: u32 = u32::MAX;

/// What happens while a pixel is traced. A ray's events stand between its `Ray` and its `Return`; those of the rays
/// that it sends stand in between, so the log is the ray tree written depth first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A sample of the pixel begins.
    Sample {
        /// Its number.
        index: u32,
        /// Its place on the film, in pixels from the top left corner.
        film: [f64; 2],
        /// Its weight in the pixel's sum.
        weight: f64,
    },
    /// A ray is sent.
    Ray(RayRecord),
    /// The ray visits a node of the acceleration structure.
    Visit(Visit),
    /// The ray is tested against a primitive.
    Test {
        /// Index into the scene's primitives.
        primitive: u32,
        /// What was found.
        verdict: Verdict,
        /// Where, if the ray's line crosses the primitive at all; else NaN.
        t: f64,
    },
    /// Many shadow rays to an area light follow: each of them, or its absence.
    LightSamples {
        /// The light.
        light: u32,
        /// How many.
        samples: u32,
    },
    /// An I, R or T ray ends on a surface.
    Hit(Hit),
    /// An I, R or T ray leaves the scene.
    Miss,
    /// An L ray reaches its light.
    Lit,
    /// An L ray is stopped by this.
    Blocked(Hit),
    /// A term of the shading equation is added to the ray's radiance.
    Term {
        /// The term with its factors.
        term: Term,
        /// Of an area light, the number of the sample that it comes from.
        sample: u16,
        /// The light that it comes from, or [`NONE`].
        light: u32,
    },
    /// An I, R or T ray goes straight through a surface: the medium behind it is the one before it.
    Passed {
        /// The surface.
        hit: Hit,
        /// The object whose medium it is.
        medium: u32,
    },
    /// The surface bounds a medium: how it shares light between R and T.
    Boundary {
        /// Index of refraction on the side of the ray.
        n1: f64,
        /// Index of refraction on the other side.
        n2: f64,
        /// F: the share of the transmission coefficient that is reflected instead; 1 under total internal reflection.
        reflectance: f64,
    },
    /// A ray is not sent.
    Absent {
        /// The ray that could have been.
        kind: RayKind,
        /// For L rays the light, else [`NONE`].
        light: u32,
        /// Why not.
        reason: Absence,
    },
    /// The ray is done.
    Return {
        /// What it brings back: the sum of its terms and of its weighted R and T rays; black for L rays.
        radiance: Rgb,
    },
}

/// A ray as it is sent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayRecord {
    /// Its kind.
    pub kind: RayKind,
    /// For L rays to an area light the number of the sample, else 0.
    pub sample: u16,
    /// Bounces since the eye.
    pub depth: u32,
    /// For L rays the light, else [`NONE`].
    pub light: u32,
    /// The object in whose medium it travels, or [`NONE`] for the scene's air.
    pub medium: u32,
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes (unit).
    pub direction: DVec3,
    /// Where it ends: infinite, or for L rays the distance to the light.
    pub t_max: f64,
    /// Its factor in the parent's sum. White for I and L rays.
    pub weight: Rgb,
}

/// A step through a tree of nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Visit {
    /// The node.
    pub node: u32,
    /// The part of the ray that is inside it.
    pub interval: [f64; 2],
    /// Where the ray's line crosses the splitting plane, negative if behind the origin; NaN for a leaf, for a node
    /// that is skipped, and if it never does.
    pub t_split: f64,
    /// The child on the side that the ray comes from, or [`NONE`].
    pub near: u32,
    /// The other child, or [`NONE`].
    pub far: u32,
    /// What is done.
    pub choice: Choice,
}

impl Visit {
    /// A step that goes no further down: to a leaf, or to a node that is skipped.
    pub fn end(node: u32, inside: Interval, choice: Choice) -> Event {
        Self::step(node, inside, [NONE; 2], choice)
    }

    /// A step to a node of many boxes, of which these two are entered first.
    pub fn children(node: u32, inside: Interval, nearest: [u32; 2]) -> Event {
        Self::step(node, inside, nearest, Choice::Children)
    }

    /// True if the node's primitives are tested, and those of no node below it.
    pub fn is_leaf(&self) -> bool {
        matches!(self.choice, Choice::Leaf | Choice::Cell)
    }

    /// True if no part of the ray is inside the node.
    pub fn is_missed(&self) -> bool {
        matches!(self.choice, Choice::SkippedOutside | Choice::SkippedMissed)
    }

    /// True if the node is left out whole.
    pub fn is_skipped(&self) -> bool {
        self.is_missed() || self.choice == Choice::SkippedCloserHit
    }

    fn step(node: u32, inside: Interval, [near, far]: [u32; 2], choice: Choice) -> Event {
        Event::Visit(Self {
            node,
            interval: [inside.min, inside.max],
            t_split: f64::NAN,
            near,
            far,
            choice,
        })
    }
}

/// Which children of a node are visited, and why not the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// A leaf: its primitives are tested.
    Leaf,
    /// A cell of a grid: its primitives are tested, then those of the next one on the ray's way.
    Cell,
    /// The plane is crossed within the interval: near, then far.
    Both,
    /// The ray runs in the plane, starts on it or leaves the node on it, as far as can be told: near, then far.
    BothInDoubt,
    /// The plane is crossed only behind the interval: the far side is skipped.
    NearSplitBeyond,
    /// The ray runs away from the plane, or along it: the far side is skipped.
    NearRunsAway,
    /// The plane is crossed before the interval: the near side is skipped.
    FarSplitBefore,
    /// Skipped whole: a closer hit is known than where the ray enters the node.
    SkippedCloserHit,
    /// Skipped whole: the ray misses the box around everything.
    SkippedOutside,
    /// A node of many boxes: the children whose boxes the ray meets follow, the one it enters first at first.
    Children,
    /// Skipped whole: the ray misses the node's box.
    SkippedMissed,
}

/// What the test of one primitive found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, IntoStaticStr)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Verdict {
    /// The closest hit so far (for L rays: an occluder).
    Hit,
    /// Not crossed.
    Miss,
    /// Crossed behind the closest hit so far, or behind the light.
    TooFar,
    /// Crossed behind the ray's origin.
    Behind,
}

/// Why a ray was not sent, with the number that decided.
#[derive(Clone, Copy, Debug, PartialEq, EnumDiscriminants)]
#[strum_discriminants(
    name(AbsenceReason),
    doc = "Why a ray was not sent.",
    derive(Serialize, Deserialize, JsonSchema, IntoStaticStr, VariantNames),
    serde(rename_all = "kebab-case"),
    strum(serialize_all = "kebab-case")
)]
pub enum Absence {
    /// Snell's law has no answer that leaves the surface: k = 1 - (n1/n2)^2 (1 - cos^2) is not positive.
    TotalInternalReflection {
        /// The number under the root.
        k: f64,
    },
    /// The material reflects nothing.
    NoReflection,
    /// The material lets nothing through.
    NoTransmission,
    /// The material has no diffuse and no specular coefficient, so lights do not matter.
    NoLocalLight,
    /// The light is behind the surface.
    FacingAway {
        /// The cosine between normal and light.
        n_dot_l: f64,
    },
    /// The point lies outside the spot light's cone.
    OutsideCone {
        /// The cosine between the spot's axis and the way to the point.
        cos_angle: f64,
    },
    /// The ray would run into the surface itself: the shading normal leans too far from the geometric one.
    BelowSurface {
        /// The cosine between geometric normal and ray.
        n_dot_r: f64,
    },
    /// Its largest possible contribution is under the threshold.
    MinWeight {
        /// The largest channel of the throughput it would have had.
        weight: f64,
    },
    /// The depth limit is reached.
    DepthLimit,
    /// The pixel's share of the ray budget is used up.
    RayBudget,
    /// The user left this effect out.
    EffectOff,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_of_millions_stays_small() {
        assert!(size_of::<Event>() <= 104, "{}", size_of::<Event>());
    }
}
