//! Fields that objects of all kinds have.

use super::TransformStep;
use crate::shading::ShadingModel;

/// Kind of object in a scene file: the fields that all of one material share, then its own.
macro_rules! object_file {
    ($(#[$doc:meta])* $name:ident { $($own:tt)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            /// Its name.
            pub name: String,
            /// What it is there for.
            pub note: Option<String>,
            /// The name of its material.
            pub material: String,
            /// How it is placed.
            #[serde(default)]
            pub transform: Vec<TransformStep>,
            $($own)*
        }
    };
}

/// Kind of solid: as an object it names its material; as a part of a `csg` it may leave that out (`M` is an option).
macro_rules! solid_file {
    ($(#[$doc:meta])* $name:ident { $($own:tt)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name<M = String> {
            /// Its name.
            pub name: String,
            /// What it is there for.
            pub note: Option<String>,
            /// The name of its material; a part of a csg without one has that of the whole.
            pub material: M,
            /// How it is placed.
            #[serde(default)]
            pub transform: Vec<TransformStep>,
            $($own)*
        }
    };
}

pub(super) use {object_file, solid_file};

/// Fields that objects of all kinds have.
pub struct Common<'a> {
    /// The kind, as the file writes it.
    pub kind: &'static str,
    /// The name.
    pub name: &'a str,
    /// The name of the material, if it has one of its own.
    pub material: Option<&'a str>,
    /// How it is placed.
    pub transform: &'a [TransformStep],
    /// How it is shaded, if it says so.
    pub shading: Option<ShadingModel>,
}
