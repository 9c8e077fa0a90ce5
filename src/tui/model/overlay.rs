//! What lies over the panes: texts, lists, prompts.

use super::list::PlaceList;

/// What lies over the panes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The help, from this line on.
    Help(u16),
    /// The warnings, from this line on.
    Warnings(u16),
    /// A text with its title, from this line on.
    Report(&'static str, String, u16),
    /// A text is typed.
    Prompt(Prompt, String),
    /// The effects, with this one chosen.
    Effects(usize),
    /// Places to go to.
    Places(PlaceList),
}

/// What a text is typed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prompt {
    /// To go to an event or an address.
    GoTo,
    /// To search for a query.
    Search,
    /// To change a setting or a number of the scene.
    Set,
    /// To compare the open tree with another one.
    Compare,
    /// To mark what is shown, with a note.
    Note,
    /// To write the marks into a file.
    Write,
    /// To set a break point, or to take it away.
    Break,
    /// To watch a number, or to watch it no more.
    Watch,
    /// To write the changes of the scene into a file.
    WritePatch,
}
