//! Real terminal, its events, signals, and the worker threads.

pub mod events;
pub mod main_loop;
pub mod program;
pub mod screen;
pub mod signals;
pub mod worker;
