//! Hard cases stay numerically stable: each is a test whose name holds the number that it has in README.md.
//!
//! `cargo test` runs a share of the rays; `RAYTREE_STABILITY=full cargo test --release --test stability` runs all.
//! What is right is told by something that shares nothing with the code under test: exact rational numbers, a formula
//! known on paper, or the list, which has no tree to go wrong.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/from_text.rs"]
mod from_text;
#[path = "../common/random.rs"]
mod random;

mod bsp;
mod camera;
mod files;
mod media;
mod meshes;
mod optics;
mod oracle;
mod plates;
mod shadows;
mod shapes;
mod spheres;
mod support;
mod triangles;
mod vessel;
