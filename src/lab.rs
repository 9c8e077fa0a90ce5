//! What can be measured about a scene: how far a picture is from the truth, and what it costs to come nearer.

mod arithmetic_sweep;
pub mod budget;
pub mod contact_sheet;
pub mod converge;
pub mod cost;
pub mod differ;
pub mod effort;
pub mod equal_time;
pub mod error;
pub mod find;
pub mod flip;
pub mod measured;
pub mod parameter;
pub mod parameters;
pub mod pareto;
pub mod plot;
pub mod raster;
pub mod show;
pub mod stability;

pub use budget::{CostModel, affordable};
pub use contact_sheet::contact_sheet;
pub use cost::Lab;
pub use effort::Effort;
pub use equal_time::EqualTime;
pub use error::{Errors, Reference};
pub use measured::{Measured, Slopes, Sweep};
pub use parameter::Parameter;
pub use parameters::parameters;
