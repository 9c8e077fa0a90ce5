//! Table of keys: dispatch, the help and the hint line are made from it.

use crossterm::event::{KeyCode, KeyEvent};

use super::action::{Action, Context};
use super::key::{Key, ch, control, key, shift};
use crate::debug::StepCommand;
use crate::probe::RayKind;

/// A line of the table.
pub struct Binding {
    /// The keys, and what each asks for.
    pub keys: &'static [(Key, Action)],
    /// What they do, in a word or two.
    pub name: &'static str,
    /// What they do, in a sentence.
    pub doc: &'static str,
    /// When they do it.
    pub context: Context,
    /// True if the hint line shows it.
    pub hint: bool,
}

const fn row(
    context: Context,
    hint: bool,
    keys: &'static [(Key, Action)],
    name: &'static str,
    doc: &'static str,
) -> Binding {
    Binding {
        keys,
        name,
        doc,
        context,
        hint,
    }
}

/// More lines than any text has.
const FAR: i32 = i16::MAX as i32;

/// The table.
#[rustfmt::skip]
pub const ACTIONS: &[Binding] = {
    use Action as A;
    use Context::{Always, Effects, Picture, Places, Prompt, Question, Text, Tree};
    use KeyCode::{BackTab, Backspace, Delete, Down, End, Enter, Esc, Home, Left, PageDown, PageUp, Right, Tab, Up};
    use StepCommand::{Back, Forward, NextAbsent, NextRay, Out, Over, PreviousAbsent, PreviousRay, Start};
    use RayKind::{Incident, Light, Reflected, Transmitted};
    &[
        row(Picture, true, &[(key(Left), A::Move(-1, 0)), (key(Down), A::Move(0, 1)), (key(Up), A::Move(0, -1)), (key(Right), A::Move(1, 0)),
            (ch('h'), A::Move(-1, 0)), (ch('j'), A::Move(0, 1)), (ch('k'), A::Move(0, -1)), (ch('l'), A::Move(1, 0))],
            "move", "Move to another pixel (or click it)."),
        row(Picture, false, &[(shift(Left), A::Move(-8, 0)), (shift(Down), A::Move(0, 8)), (shift(Up), A::Move(0, -8)), (shift(Right), A::Move(8, 0)),
            (ch('H'), A::Move(-8, 0)), (ch('J'), A::Move(0, 8)), (ch('K'), A::Move(0, -8)), (ch('L'), A::Move(8, 0))],
            "leap", "Move by 8 pixels."),
        row(Picture, true, &[(key(Enter), A::Open), (ch(' '), A::Open)], "open its ray tree", "Trace the pixel again and open its ray tree."),

        row(Picture, true, &[(ch('/'), A::Search)], "find", "Find the pixels whose ray trees satisfy a query, such as tir or hits:ball. The others are drawn darker."),
        row(Picture, false, &[(ch('n'), A::FindNext(true)), (ch('N'), A::FindNext(false)), (ch('f'), A::FindNext(true)), (ch('F'), A::FindNext(false))],
            "next found", "To the next (previous) pixel that was found."),
        row(Picture, false, &[(ch('s'), A::Show(true)), (ch('S'), A::Show(false))], "show",
            "Show rays, nodes, tests, depth, t, errors, normals or objects in the place of colours."),
        row(Picture, false, &[(ch('x'), A::NextInOrder(true)), (ch('X'), A::NextInOrder(false))], "next in order",
            "To the pixel with the next smaller (larger) number of what is shown, or luminance."),
        row(Picture, false, &[(ch('o'), A::Outliers)], "outliers", "The pixels that stand out from their neighbours, such as fireflies; if none does, the largest."),
        row(Picture, false, &[(key(Tab), A::Flip)], "the other picture", "The picture before the last change, and this one again: two settings in turn."),
        row(Picture, false, &[(ch('d'), A::Difference)], "difference", "How far this picture is from the one before the last change, pixel by pixel."),
        row(Picture, false, &[(ch('w'), A::Warnings)], "warnings", "What of the scene can hardly be meant, and what to do."),
        row(Picture, false, &[(ch(':'), A::GoTo)], "go to", "To the pixel or the address that you type, such as 160,120/R."),

        row(Tree, true, &[(ch('n'), A::Step(Forward))], "next", "One event on."),
        row(Tree, true, &[(ch('p'), A::Step(Back))], "previous", "One event back: the exact inverse."),
        row(Tree, true, &[(ch('o'), A::Step(Over))], "over", "Over what begins here: a ray with all that it sends, or a search for the hit."),
        row(Tree, true, &[(ch('u'), A::Step(Out))], "out", "Out of the ray, to what it brings back."),
        row(Tree, true, &[(ch('r'), A::Step(NextRay(Reflected))), (ch('R'), A::Step(PreviousRay(Reflected)))], "R ray", "The next (previous) reflected ray."),
        row(Tree, true, &[(ch('t'), A::Step(NextRay(Transmitted))), (ch('T'), A::Step(PreviousRay(Transmitted)))], "T ray", "The next (previous) transmitted ray."),
        row(Tree, true, &[(ch('l'), A::Step(NextRay(Light))), (ch('L'), A::Step(PreviousRay(Light)))], "L ray", "The next (previous) ray to a light."),
        row(Tree, false, &[(ch('>'), A::Play(true)), (ch('<'), A::Play(false))], "play", "Step on (back) by itself, twice a second; once more doubles the speed, any other key stops."),
        row(Tree, false, &[(ch('-'), A::PlayBy)], "play by", "Let these steps be events, rays, or rays level by level."),
        row(Tree, false, &[(ch('b'), A::Break)], "break", "Set a break point, such as tir, absent, test:ball or L blocked every 3rd; the same again takes it away."),
        row(Tree, false, &[(ch('x'), A::Run(true)), (ch('X'), A::Run(false))], "run", "Run to the next break point (back to the one before)."),
        row(Tree, false, &[(ch('B'), A::Breaks)], "break points", "All break points, and how often each stops a run through this tree."),
        row(Tree, false, &[(ch('*'), A::Watch)], "watch", "Watch a number of the details, or radiance, throughput, running sum, depth; the same again takes it away."),
        row(Tree, false, &[(ch(')'), A::RunToChange(true)), (ch('('), A::RunToChange(false))], "next change",
            "Run to where a watched number changes next (back to where it changed last)."),
        row(Tree, false, &[(ch('#'), A::Watches)], "watches", "All watched numbers: what each is, what it was before, and where it was told."),
        row(Tree, false, &[(ch('w'), A::Origin(true)), (ch('W'), A::Origin(false))], "from, to", "Where the numbers of this event come from (where they go): choose one to go there."),
        row(Tree, false, &[(shift(Left), A::Neighbour(-1, 0)), (shift(Down), A::Neighbour(0, 1)), (shift(Up), A::Neighbour(0, -1)), (shift(Right), A::Neighbour(1, 0))],
            "next pixel", "The tree of the pixel beside this one, at the same ray if it has one."),
        row(Tree, false, &[(ch('a'), A::Step(NextAbsent)), (ch('A'), A::Step(PreviousAbsent))], "absent", "The next (previous) ray that is not sent."),
        row(Tree, false, &[(ch('i'), A::Step(NextRay(Incident))), (ch('I'), A::Step(PreviousRay(Incident)))], "I ray", "The next (previous) ray from the eye, if the pixel has several."),
        row(Tree, false, &[(ch('g'), A::Step(Start)), (ch('G'), A::Step(StepCommand::End)), (key(Home), A::Step(Start)), (key(End), A::Step(StepCommand::End))], "start, end", "To the first event, to the last."),
        row(Tree, false, &[(ch(':'), A::GoTo)], "go to", "To the event or the address that you type, such as 17 or /T/R."),
        row(Tree, true, &[(ch('/'), A::Search)], "find", "Find the rays that satisfy a query, such as blocked:* or t < 0.1."),
        row(Tree, false, &[(ch('h'), A::Samples)], "samples", "All samples of the pixel as a table, and their sum."),
        row(Tree, false, &[(ch('d'), A::Compare)], "compare", "Compare with another pixel (X,Y), a setting or a bend (flag=value), another scene, or a file of ray trees; with accel=kd or order=far-first the steps of this ray."),
        row(Tree, false, &[(ch('f'), A::FindNext(true)), (ch('F'), A::FindNext(false))], "next found", "To the next (previous) ray that satisfies the query."),
        row(Tree, true, &[(key(Tab), A::NextPane), (key(BackTab), A::PreviousPane)], "pane", "Give the arrow keys to the next (previous) pane."),
        row(Tree, true, &[(ch('z'), A::Zoom)], "zoom", "The focused pane on the whole screen, and back."),
        row(Tree, false, &[(ch('s'), A::Source)], "source", "The function of this program that does what this event tells."),
        row(Tree, false, &[(key(Down), A::Rows(1)), (key(Up), A::Rows(-1)), (ch('j'), A::Rows(1)), (ch('k'), A::Rows(-1))],
            "rows", "In the tree and the steps: to the next (previous) row. In the details: scroll. In the scene: to the next (previous) ray."),
        row(Tree, false, &[(key(PageDown), A::Pages(1)), (key(PageUp), A::Pages(-1))], "pages", "The same by a page."),
        row(Tree, false, &[(ch(' '), A::Toggle), (key(Right), A::Unfold), (key(Left), A::Fold)],
            "fold", "Show or hide the rays below this one; Left on a closed one goes to its parent."),
        row(Tree, false, &[(ch('v'), A::View)], "view", "Look at the scene from the top, the front, the side."),
        row(Tree, false, &[(ch('V'), A::Fan)], "row, column", "Draw the eye rays of all pixels in this row, in this column, or neither."),
        row(Tree, false, &[(key(Enter), A::Step(Over))], "over", "As o."),

        row(Question, true, &[(ch('1'), A::Reply(1)), (ch('2'), A::Reply(2)), (ch('3'), A::Reply(3)), (ch('4'), A::Reply(4)), (ch('5'), A::Reply(5)),
            (ch('6'), A::Reply(6)), (ch('7'), A::Reply(7)), (ch('8'), A::Reply(8)), (ch('9'), A::Reply(9))],
            "answer", "Answer by the word with this number. Numbers are typed, Enter gives them."),
        row(Question, true, &[(key(Enter), A::Give)], "give the answer", "Give the number that is typed, or the pixel under the cursor; where the answer is told, go on."),
        row(Question, true, &[(ch('b'), A::Laws)], "name the law", "Of a broken tracer: choose the law that is broken. The ray under the cursor belongs to the answer."),
        row(Question, false, &[(ch('d'), A::WithOurs)], "difference", "Of a broken tracer, after two hints: where its tree and ours differ."),
        row(Question, true, &[(ch('H'), A::Hint)], "hint", "The next of three hints: where to look, which law, almost the answer."),

        row(Prompt, true, &[(key(Enter), A::Accept)], "go", "Go there, search for it, or change it."),
        row(Prompt, true, &[(key(Down), A::Ready(true)), (key(Up), A::Ready(false))], "examples", "The next (previous) of some texts to begin with."),
        row(Prompt, true, &[(key(Backspace), A::Erase(true)), (key(Delete), A::Erase(false))], "erase", "Delete the letter before (behind) the bar."),
        row(Prompt, false, &[(key(Left), A::Caret(-1)), (key(Right), A::Caret(1)), (key(Home), A::Caret(-FAR)), (key(End), A::Caret(FAR))],
            "within the text", "To the letter before (behind), to the start, to the end: letters are typed there."),

        row(Effects, true, &[(key(Down), A::Choose(1)), (key(Up), A::Choose(-1)), (ch('j'), A::Choose(1)), (ch('k'), A::Choose(-1))],
            "choose", "To the next (previous) effect."),
        row(Effects, true, &[(ch(' '), A::Switch), (key(Enter), A::Switch)], "leave out, take in",
            "Leave the effect out of the picture, or take it in again."),

        row(Places, true, &[(key(Down), A::Choose(1)), (key(Up), A::Choose(-1)), (ch('j'), A::Choose(1)), (ch('k'), A::Choose(-1))],
            "choose", "To the next (previous) line."),
        row(Places, true, &[(key(Enter), A::GoThere), (ch(' '), A::GoThere)], "go there", "Go to the chosen place."),

        row(Text, true, &[(key(Down), A::Rows(1)), (key(Up), A::Rows(-1)), (ch('j'), A::Rows(1)), (ch('k'), A::Rows(-1))],
            "scroll", "Scroll; any key that is not named here closes the text."),
        row(Text, true, &[(key(PageDown), A::Pages(1)), (key(PageUp), A::Pages(-1)), (ch(' '), A::Pages(1))], "page", "Scroll by ten lines."),
        row(Text, false, &[(key(Home), A::Rows(-FAR)), (key(End), A::Rows(FAR))], "start, end", "To the first line, to the last."),

        row(Always, true, &[(ch('e'), A::Effects)], "effects", "Which effects the scene calls for, and why; each can be left out."),
        row(Always, true, &[(ch('c'), A::Convergence)], "convergence",
            "How the pixel under the cursor nears its value with more samples: a chart that grows."),
        row(Always, false, &[(ch('='), A::Set)], "set", "Change a setting, such as samples=16, or the scene, such as material.glass.ior=1.3: the picture follows."),
        row(Always, false, &[(ch(']'), A::MoreSamples(true, true)), (ch('['), A::MoreSamples(true, false))], "light samples", "Twice (half) as many samples of lights with an area."),
        row(Always, false, &[(ch('}'), A::MoreSamples(false, true)), (ch('{'), A::MoreSamples(false, false))], "samples", "Twice (half) as many samples of a pixel."),
        row(Always, false, &[(ch('+'), A::NextSeed)], "seed", "Other random numbers."),
        row(Always, false, &[(ch('U'), A::Undo)], "undo", "Take the last change back."),
        row(Always, false, &[(ch('C'), A::Changes)], "changes", "What is changed, as flags and as a patch of the scene."),
        row(Always, false, &[(ch('P'), A::WritePatch)], "write patch", "Write the changes of the scene into a new file, for --patch."),
        row(Always, false, &[(ch('M'), A::Mark)], "mark", "Mark what is shown, with a note."),
        row(Always, false, &[(ch('\''), A::NextMark)], "next mark", "To the next mark."),
        row(Always, false, &[(ch('"'), A::WriteMarks)], "write marks", "Write all marks into a new file, for raytree view --marks."),
        row(Always, false, &[(ch('y'), A::Copy)], "copy", "Copy the command that opens the debugger here again (if the terminal allows it), and show it."),
        row(Always, false, &[(ch(','), A::History(true)), (ch('.'), A::History(false))], "back, forward", "To the place before the last jump (forward again)."),
        row(Always, false, &[(ch('!'), A::Warnings)], "warnings", "The warnings, from anywhere."),
        row(Always, false, &[(ch('m'), A::Mouse)], "mouse", "Leave the mouse to the terminal, to select text, or take it again."),
        row(Always, true, &[(ch('?'), A::Help)], "help", "This list."),
        row(Always, true, &[(ch('q'), A::Back), (key(Esc), A::Back)], "back", "One level back; from the picture, quit."),
        row(Always, false, &[(control('c'), A::Quit)], "quit", "Quit at once."),
        #[cfg(unix)]
        row(Always, false, &[(control('z'), A::Suspend)], "suspend", "Back to the shell for a while; fg comes back."),
    ]
};

/// What a key asks for in a context.
pub fn lookup(context: Context, event: KeyEvent) -> Option<Action> {
    let of = |context| ACTIONS.iter().filter(move |b| b.context == context);
    of(context)
        .chain(of(Context::Always))
        .flat_map(|b| b.keys)
        .find_map(|(key, action)| key.matches(event).then_some(*action))
}

impl Binding {
    /// All its keys.
    pub fn labels(&self) -> String {
        let labels: Vec<_> = self.keys.iter().map(|(key, _)| key.label()).collect();
        labels.join(" ")
    }

    /// Its first key, and those that belong with it: short enough for the hint line.
    pub fn short_label(&self) -> String {
        let arrows: String = self
            .keys
            .iter()
            .map(|(key, _)| key.label())
            .filter(|label| ["←", "↓", "↑", "→"].contains(&label.as_str()))
            .collect();
        match self.keys.first() {
            _ if !arrows.is_empty() => arrows,
            Some((key, _)) => key.label(),
            None => String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_means_two_things_at_once() {
        for context in [
            Context::Picture,
            Context::Tree,
            Context::Question,
            Context::Prompt,
            Context::Effects,
            Context::Places,
            Context::Text,
        ] {
            let mut seen: Vec<Key> = Vec::new();
            let here = |b: &&Binding| b.context == context || b.context == Context::Always;
            for (key, action) in ACTIONS.iter().filter(here).flat_map(|b| b.keys) {
                assert!(!seen.contains(key), "{} twice", key.label());
                seen.push(*key);
                assert_eq!(lookup(context, key.event()), Some(*action));
            }
        }
    }
}
