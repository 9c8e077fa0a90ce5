//! The debugger without a terminal: actions in, screens out.

mod address;
mod bundle;
mod color;
mod convergence;
mod edit;
mod effects;
mod huge;
mod keys;
mod mouse;
mod picture;
mod places;
mod random;
mod search;
mod set;
mod show;
mod sizes;
mod steps;
mod stories;
mod support;
mod walk;
mod warnings;
