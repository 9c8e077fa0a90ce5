//! Actions that keys can ask for, and the contexts in which keys mean them.

use crate::debug::StepCommand;

/// What a user can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Leave at once.
    Quit,
    /// Close what lies on top; at the bottom, leave.
    Back,
    /// Show or hide the help.
    Help,
    /// Stop the program as a shell's Ctrl-Z does; `fg` lets it go on.
    Suspend,
    /// Catch the mouse, or leave it to the terminal.
    Mouse,
    /// Show or hide which effects the scene calls for.
    Effects,
    /// Show or hide the warnings about the scene.
    Warnings,
    /// To the effect that stands so many rows below.
    Choose(i32),
    /// Leave the chosen effect out, or take it in again.
    Switch,
    /// Show or hide the convergence of the pixel under the cursor.
    Convergence,
    /// Move the pixel cursor right and down by so many pixels.
    Move(i32, i32),
    /// Trace the pixel under the cursor and open its ray tree.
    Open,
    /// Move the cursor in the log.
    Step(StepCommand),
    /// Step by itself, forwards or backwards; once more, faster.
    Play(bool),
    /// Choose what a step is that runs by itself.
    PlayBy,
    /// Ask for a break point.
    Break,
    /// Show the break points.
    Breaks,
    /// Run to the next break point (back to the one before, if false).
    Run(bool),
    /// Ask for a number to watch.
    Watch,
    /// Show the watched numbers.
    Watches,
    /// Run to where a watched number changes next (back to where it changed last, if false).
    RunToChange(bool),
    /// Show where the numbers of the current event come from (where they go, if false).
    Origin(bool),
    /// To the place before the last jump (forward again, if false).
    History(bool),
    /// Open the tree of a pixel so far to the right and below, at the same ray.
    Neighbour(i32, i32),
    /// Ask for an event or an address to go to.
    GoTo,
    /// Ask for a setting or a number of the scene to change.
    Set,
    /// Show the samples of the pixel as a table.
    Samples,
    /// Ask for what the open tree is compared with.
    Compare,
    /// Twice (half, if the second is false) as many samples of lights (of pixels, if the first is false).
    MoreSamples(bool, bool),
    /// Other random numbers.
    NextSeed,
    /// Ask for a note, and mark what is shown with it.
    Mark,
    /// To the next mark.
    NextMark,
    /// Ask for a file to write the marks into.
    WriteMarks,
    /// Take the last change back.
    Undo,
    /// Show the picture before the last change, and this one again.
    Flip,
    /// Show how far both are apart.
    Difference,
    /// Show what is changed.
    Changes,
    /// Ask for a file to write the changes of the scene into.
    WritePatch,
    /// Ask for a query to search for.
    Search,
    /// To the next (previous, if false) pixel or ray that satisfies the query.
    FindNext(bool),
    /// Show the next (previous, if false) thing in the place of colours.
    Show(bool),
    /// To the pixel with the next smaller (larger, if false) number of what is shown.
    NextInOrder(bool),
    /// List the pixels that stand out.
    Outliers,
    /// Show the function of this program that does what the current event tells.
    Source,
    /// Copy the command that opens what is shown.
    Copy,
    /// To the next (previous, if false) ready text of the prompt.
    Ready(bool),
    /// Go to the chosen place of a list.
    GoThere,
    /// Down (up, if negative) by so many rows of the focused pane.
    Rows(i32),
    /// Down (up, if negative) by pages of the focused pane.
    Pages(i32),
    /// Show what hangs on the current ray.
    Unfold,
    /// Hide what hangs on the current ray; if that is hidden, go to the ray that sent it.
    Fold,
    /// Show it if hidden, else hide it.
    Toggle,
    /// Give the keys to the next pane.
    NextPane,
    /// Give the keys to the pane before.
    PreviousPane,
    /// The focused pane alone on the screen, and back.
    Zoom,
    /// Look at the scene from the next side.
    View,
    /// Draw the eye rays of the pixel's row, of its column, or neither.
    Fan,
    /// Take the text that was typed.
    Accept,
    /// Show the next hint to a question.
    Hint,
    /// Answer a question by the word with this number.
    Reply(u8),
    /// Choose the law that is broken.
    Laws,
    /// Show where a broken tracer and ours differ.
    WithOurs,
    /// Give the answer; where it is given, go on.
    Give,
    /// Delete the letter before the place where letters are typed (the one behind it, if false).
    Erase(bool),
    /// Move this place by so many letters.
    Caret(i32),
}

/// When a key means what the table says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Context {
    /// While a pixel is being chosen.
    Picture,
    /// While a ray tree is open.
    Tree,
    /// While a question of a lesson is open.
    Question,
    /// While a text is typed.
    Prompt,
    /// While the effects are shown.
    Effects,
    /// While a list of places is shown.
    Places,
    /// While a text is shown.
    Text,
    /// Unless something above says otherwise.
    Always,
}
