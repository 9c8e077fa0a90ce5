//! Reader of scene files: JSON in the format `raytree-scene/1`, and the OBJ and MTL files that it names.
//!
//! [`mod@file`] is what stands in the JSON, [`resolve`] makes a scene of it. What passes here cannot make the tracer panic,
//! and every refusal names the field or line and what to do.

mod cut;
pub mod did_you_mean;
pub mod error;
pub mod file;
pub mod files;
mod mesh;
mod notes;
mod obj;
pub mod resolve;
mod text;
