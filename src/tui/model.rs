//! State of the debugger, the messages that change it, and the table of keys. Nothing here draws or does input or output.

pub mod action;
mod address;
pub mod ask;
pub mod ask_lines;
pub mod bindings;
pub mod change;
pub mod examples;
pub mod first;
pub mod key;
pub mod layout;
pub mod list;
pub mod message;
pub mod motion;
pub mod options;
pub mod overlay;
pub mod placement;
pub mod state;

pub use action::{Action, Context};
pub use change::{Before, PendingChange};
pub use layout::{Pane, Panes, inside};
pub use message::{Job, JobOutput, Message, Mouse};
pub use motion::{LongRun, Play, PlayUnit};
pub use options::Options;
pub use overlay::{Overlay, Prompt};
pub use state::{Model, Request};
