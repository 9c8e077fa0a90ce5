//! Grading: what students hand in, read with care, compared with this tracer and marked.

mod believed;
pub mod compare;
pub mod diff;
pub mod follow;
pub mod quantity;
pub mod submission;
pub mod tolerance;
mod value;
