//! Sampling: random numbers, points in the unit square, warps, filters and standard errors.
//!
//! All of it is pure: a number is a function of its key and index alone, a warp of its two numbers, so that a pixel that
//! is traced again meets the same samples.

pub mod batch_means;
pub mod filter;
pub mod points;
pub mod sampler;
pub mod sobol;
pub mod stratified;
pub mod stream;
pub mod warp;

pub use batch_means::BatchMeans;
pub use filter::Filter;
pub use points::{Points, SampleSet};
pub use sampler::{LightSampling, Sampler};
