//! What can be measured about a scene: how far a picture is from the truth, and what it costs to come nearer.

pub mod cost;
pub mod effort;
pub mod error;
pub mod flip;
pub mod front;
pub mod knobs;
pub mod plot;
mod robust;
pub mod sheet;
pub mod stability;
pub mod strip;
pub mod until;

pub use cost::{Lab, Measured, Sweep};
pub use effort::{Effort, Price, affordable};
pub use error::{Errors, Reference};
pub use front::Slopes;
pub use knobs::{Knob, knobs};
pub use sheet::sheet;
pub use strip::Strip;
