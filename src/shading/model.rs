//! Shading models: what is computed at the corners of a triangle, and what at each of its points.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is computed at the corners of a triangle, and what at each point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShadingModel {
    /// N is the normal of the triangle's plane.
    Flat,
    /// Light is computed at the corners, with their normals; what it adds is blended between them (Gouraud 1971).
    Gouraud,
    /// The normals of the corners are blended, and light is computed at each point (Phong 1975).
    #[default]
    Phong,
}

impl ShadingModel {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Flat, Self::Gouraud, Self::Phong];

    /// Its name, as people say it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Gouraud => "Gouraud",
            Self::Phong => "Phong",
        }
    }

    /// The word for it in files and on command lines.
    pub fn word(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Gouraud => "gouraud",
            Self::Phong => "phong",
        }
    }
}
