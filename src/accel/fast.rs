//! Fast traversal: single precision proposes, double precision decides.
//!
//! Boxes, planes and triangles are rounded to single precision, within proven bounds, and tested with vector instructions
//! or against packets of rays. That only tells what may be left out; the rest is tested in double precision with the
//! operations of the shapes' own tests, so the answers are those of the list, bit for bit.

pub mod bvh8;
pub mod compact;
pub mod local_ray;
mod packet;
mod simd;
mod triangle_filter;
mod triangle_lanes;

pub use bvh8::Bvh8;
pub use compact::CompactTree;
pub use packet::{PACKET_SIZE, PacketScratch, PacketTree, search_packet};
