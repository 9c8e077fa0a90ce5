//! What a surface does with light.

pub mod area;
pub mod effects;
pub mod interaction;
pub mod light;
mod light_sample;
pub mod material;
mod model;
pub mod optics;
pub mod point;
pub mod projected;
mod shadow_gap;

pub use area::Area;
pub use effects::{Effect, Effects};
pub use interaction::{Interaction, Side};
pub use light::{Light, LightKind};
pub use light_sample::LightSample;
pub use material::{Checker, Material};
pub use model::ShadingModel;
pub use optics::{Fresnel, reflect, refract};
pub use point::{FresnelSplit, Secondary, ShadingPoint};
pub use projected::ProjectedPolygon;
