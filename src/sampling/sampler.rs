//! The samplers: how points in the unit square are chosen, and with what density on a light.

use serde::{Deserialize, Serialize};

/// How points are chosen.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Sampler {
    /// The middles of a grid's cells: the lecture's regular point lights.
    Grid,
    /// Anywhere, each point independent of all others.
    Random,
    /// One point in each cell of a grid, anywhere in it.
    Stratified,
    /// Sobol's sequence, scrambled as by Owen: evenly spread at every scale.
    #[default]
    Sobol,
}

/// How a place on a light is chosen with two numbers.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum LightSampling {
    /// Even on the light's area (on a sphere, in the cone that is seen): each sample brings what it brings.
    #[default]
    Area,
    /// On matt surfaces, in proportion to what a place of a rectangle or triangle brings: all samples bring the same,
    /// and the only noise is that of what stands in the way. Elsewhere as `area`.
    Projected,
}

impl LightSampling {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Area, Self::Projected];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Projected => "projected",
        }
    }
}

impl Sampler {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Grid, Self::Random, Self::Stratified, Self::Sobol];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Random => "random",
            Self::Stratified => "stratified",
            Self::Sobol => "sobol",
        }
    }
}
