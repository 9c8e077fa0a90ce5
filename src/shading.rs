//! What a surface does with light.

pub mod area;
pub mod interaction;
pub mod light;
pub mod material;
pub mod optics;
pub mod phong;
pub mod projected;

pub use area::Area;
pub use interaction::{Interaction, Side};
pub use light::{Illumination, Light, Source};
pub use material::{Checker, Material};
pub use optics::Fresnel;
pub use projected::Projected;
