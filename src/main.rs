//! The command line of raytree.

fn main() {}
