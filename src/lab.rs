//! What can be measured about a scene: how far a picture is from the truth, and what it costs to come nearer.

pub mod cost;
pub mod error;
pub mod front;
pub mod knobs;
pub mod plot;

pub use cost::{Lab, Measured};
pub use error::Errors;
pub use knobs::{Knob, knobs};
