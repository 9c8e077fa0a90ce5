//! Reduction: the smallest part of a scene in which a pixel keeps its ray tree, bit for bit.
//!
//! First everything goes that no ray of the tree met. Where that changes the tree (a body that rays are inside of decides a
//! medium), more is kept. What is left is tried out by delta debugging (`ddmin.rs`) over objects, over the shapes of an
//! object, and over lights. Nothing is left out unless the tree was traced without it and compared (`essence.rs`).
//!
//! The part is written as a scene file in world space (`write.rs`), read again and traced again before it is given to anybody.

mod ddmin;
mod error;
mod essence;
mod reduction;
mod search;
mod start;
mod task;
mod touched;
mod trials;

pub use crate::scene::kept::Kept;
pub use crate::scene::part::{ScenePart, part};
pub use ddmin::ddmin;
pub use error::ReduceError;
pub use essence::essence;
pub use reduction::{Reduction, reduce};
pub use task::{ReduceProgress, ReduceTask};
