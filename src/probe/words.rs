//! What things are called, in JSON and in sentences.

use strum::IntoDiscriminant;

use super::{Absence, AbsenceReason, Choice, Verdict};

impl Absence {
    /// Its name in JSON.
    pub fn name(self) -> &'static str {
        self.discriminant().into()
    }

    /// Why the ray is not sent, in a few words.
    pub fn words(self) -> &'static str {
        self.discriminant().words()
    }
}

impl AbsenceReason {
    /// Why a ray is not sent, in a few words.
    pub fn words(self) -> &'static str {
        match self {
            Self::TotalInternalReflection => "total internal reflection",
            Self::NoReflection => "reflects nothing",
            Self::NoTransmission => "lets nothing through",
            Self::NoLocalLight => "lights do not matter",
            Self::FacingAway => "light is behind it",
            Self::OutsideCone => "outside of the cone",
            Self::BelowSurface => "below the surface",
            Self::MinWeight => "weight is too small",
            Self::DepthLimit => "depth limit",
            Self::RayBudget => "rays are used up",
            Self::EffectOff => "effect is left out",
        }
    }

    /// What it means, in a sentence.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::TotalInternalReflection => {
                "The ray meets the boundary too flat: Snell's law has no direction beyond it, and all light is reflected."
            }
            Self::NoReflection => "The material reflects nothing.",
            Self::NoTransmission => "Nothing passes through the material.",
            Self::NoLocalLight => {
                "The material has neither a diffuse nor a specular coefficient, so lights do not matter."
            }
            Self::FacingAway => "The light is behind the surface, which shades itself.",
            Self::OutsideCone => "The point lies outside the cone of the spot light.",
            Self::BelowSurface => {
                "The blended normal leans so far that the ray would run through the surface it leaves."
            }
            Self::MinWeight => "Whatever it would bring back could not be seen in the pixel.",
            Self::DepthLimit => {
                "The depth limit ends the recursion here: what it would bring back is missing in the pixel."
            }
            Self::EffectOff => {
                "This effect was switched off: the picture is not that of the whole scene."
            }
            Self::RayBudget => {
                "The pixel has used up its share of the ray budget: the picture is cut short here."
            }
        }
    }
}

impl Choice {
    /// Why, in words.
    pub fn reason(self) -> &'static str {
        match self {
            Self::Leaf => "leaf: its primitives are tested",
            Self::Cell => "cell: its primitives are tested, then the next cell on the way",
            Self::Both => "the plane is crossed inside the interval",
            Self::BothInDoubt => {
                "the plane is so near that rounding could hide a hit on either side"
            }
            Self::NearSplitBeyond => "far side skipped: the plane is crossed behind the interval",
            Self::NearRunsAway => "far side skipped: the ray does not run towards the plane",
            Self::FarSplitBefore => "near side skipped: the plane is crossed before the interval",
            Self::SkippedCloserHit => "skipped: a hit is known before the ray enters the node",
            Self::SkippedOutside => "skipped: the ray misses the box around the scene",
            Self::Children => "the children whose boxes are met follow, nearest first",
            Self::SkippedMissed => "skipped: the ray misses its box",
        }
    }
}

impl Verdict {
    /// As JSON says it.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// It, for people.
    pub fn word(self) -> &'static str {
        match self {
            Self::Hit => "hit",
            Self::Miss => "miss",
            Self::TooFar => "too far",
            Self::Behind => "behind",
        }
    }

    /// What it means, in words.
    pub fn reason(self) -> &'static str {
        match self {
            Self::Hit => "the closest hit so far",
            Self::Miss => "the ray's line does not cross it",
            Self::TooFar => "crossed, but not before the closest hit so far or the light",
            Self::Behind => "crossed behind the ray's origin",
        }
    }
}
