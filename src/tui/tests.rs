//! The debugger without a terminal: actions in, screens out.

mod address;
mod bundle;
mod color;
mod convergence;
mod edit;
mod effects;
mod horizon;
mod huge;
mod keys;
mod lesson;
mod lesson_keys;
mod mouse;
mod picture;
mod places;
mod prompts;
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
mod watches;
