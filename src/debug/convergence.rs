//! Convergence of a pixel: luminance and standard error over the number of samples.
//!
//! Every point is a whole pixel, as `raytree trace --samples N` tells it, and not a part of a larger one: so each can be
//! had again, whatever the sampler. All together cost twice the last.

pub mod curve;
pub mod measure;
pub mod sampling;

pub use curve::{Convergence, error_text};
pub use measure::measure;
pub use sampling::{has_chance, with_samples};
