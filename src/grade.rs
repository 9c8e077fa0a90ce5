//! Grading: what students hand in, read with care, compared with this tracer and marked.

pub mod archive;
pub mod attempts;
mod believed;
pub mod compare;
pub mod diff;
pub mod estimate;
pub mod finder;
pub mod follow;
pub mod marks;
pub mod output;
pub mod picture;
pub mod pixel_tree;
pub mod quantity;
pub mod report;
pub mod run;
pub mod same_tree;
pub mod selftest;
pub mod side_by_side;
pub mod submission;
pub mod task;
pub mod tolerance;
mod value;
