//! Debugger without a screen: a recorded pixel, a cursor in its log, and what panes show of both.
//!
//! Nothing here knows a terminal, a key or a layout; the faces draw what is computed here.

pub mod asked;
pub mod breaks;
pub mod cell;
pub mod convergence;
pub mod crossings;
pub mod cursor;
pub mod drawing;
pub mod edit;
pub mod effects;
pub mod extent;
pub mod fan;
pub mod horizon;
pub mod landmarks;
pub mod log_run;
pub mod marks;
pub mod origin;
pub mod outline;
pub mod pick;
pub mod picture;
pub mod progressive;
pub mod projection;
pub mod ranking;
pub mod ray_search;
pub mod row_text;
pub mod rows;
pub mod running;
pub mod samples;
pub mod search;
pub mod session;
pub mod step_pairs;
pub mod step_tree;
pub mod steps;
pub mod t_axis;
#[cfg(test)]
mod tests;
pub mod watch;
pub mod window;

pub use convergence::Convergence;
pub use cursor::{Cursor, StepCommand};
pub use drawing::drawing;
pub use outline::{ObjectOutline, outlines};
pub use pick::{Picked, pick};
pub use picture::PartialPicture;
pub use projection::Axis;
pub use row_text::RowText;
pub use rows::{RowKind, TreeRow, TreeRows};
pub use search::QuerySearch;
pub use session::Session;
pub use steps::{StepKind, StepText};
pub use window::Window;
