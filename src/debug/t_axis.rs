//! The t axis of a step through the accelerator as a line of letters: an interval as a bar, and marks on it.

use super::crossings::crossings;
use super::session::Session;
use super::steps::{is_cut, short};
use crate::math::{Interval, Ray};
use crate::probe::{Event, RayKind};

/// What a mark on the axis stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisMarkKind {
    /// The split plane of the node.
    Split,
    /// A crossing with the tested shape.
    Crossing,
    /// The hit that the search leads to.
    Found,
}

/// A mark on the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisMark {
    /// Where.
    pub t: f64,
    /// What is there.
    pub kind: AxisMarkKind,
}

/// The t axis of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct TAxis {
    /// Where it begins and ends; both finite.
    pub ends: [f64; 2],
    /// Of a node the part of the ray inside, of a test the part that is searched.
    pub bar: Option<[f64; 2]>,
    /// The marks, in order of t.
    pub marks: Vec<AxisMark>,
    /// What the bar stands for.
    what: &'static str,
}

impl AxisMarkKind {
    /// Every kind, in the order of the legend.
    const ALL: [Self; 3] = [Self::Split, Self::Crossing, Self::Found];

    /// Its letter.
    pub fn letter(self) -> char {
        match self {
            Self::Split => '|',
            Self::Crossing => 'o',
            Self::Found => 'X',
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Split => "plane",
            Self::Crossing => "crosses",
            Self::Found => "found",
        }
    }
}

impl TAxis {
    /// The axis at the current event; `None` if the current ray was not searched for anything.
    pub fn new(session: &Session) -> Option<Self> {
        let sent = &session.tree().node(session.node()?).ray;
        if session.steps().is_empty() {
            return None;
        }
        let ray = Ray::new(sent.origin, sent.direction);
        let (event, tree) = (session.cursor().position(), &session.step_tree);
        let (mut bar, mut marks, mut what) = (None, Vec::new(), "");
        if let Some(step) = session.step_number(event) {
            match session.tree().events.get(event)? {
                Event::Visit(visit) => {
                    let inside = (!visit.is_missed()).then_some(visit.interval);
                    (bar, what) = (inside, "inside the node");
                    marks.push((visit.t_split, AxisMarkKind::Split));
                }
                Event::Test { primitive, .. } => {
                    // A shadow ray ends its search at any hit, others go on to closer ones.
                    let known = tree.closest_before(step).unwrap_or(f64::INFINITY);
                    (bar, what) = (Some([0.0, known.min(sent.t_max)]), "searched");
                    let shape = session.world.scene.shapes.get(*primitive as usize)?;
                    let crossed = crossings(shape, &ray).into_iter();
                    marks.extend(crossed.map(|t| (t, AxisMarkKind::Crossing)));
                }
                _ => {}
            }
        }
        let found = tree.found().filter(|_| !is_cut(session));
        marks.extend(found.map(|t| (t, AxisMarkKind::Found)));
        let mut marks: Vec<AxisMark> = marks
            .into_iter()
            .filter(|(t, _)| t.is_finite())
            .map(|(t, kind)| AxisMark { t, kind })
            .collect();
        // Of equal t the one that is found comes last: its letter is seen.
        marks.sort_by(|a, b| a.t.total_cmp(&b.t));
        let bounds = session.world.accel.bounds().unwrap_or(session.extent);
        let inside = bounds.clip(&ray, Interval::before(sent.t_max));
        let light = (sent.kind == RayKind::Light).then_some(sent.t_max);
        let ends = ends(inside, found, light, &marks)?;
        Some(Self {
            ends,
            bar,
            marks,
            what,
        })
    }

    /// The axis in so many columns, with the numbers of its ends; empty if there is no room.
    pub fn line(&self, width: usize) -> String {
        let [from, to] = self.ends.map(short);
        let room = width.saturating_sub(from.chars().count() + to.chars().count() + 2);
        if room < 8 {
            return String::new();
        }
        let mut cells = vec!['-'; room];
        if let Some([start, end]) = self.bar {
            self.draw_bar(&mut cells, [start, end]);
        }
        for mark in &self.marks {
            let (column, side) = self.column(mark.t, room);
            cells[column] = side.unwrap_or(mark.kind.letter());
        }
        format!("{from} {} {to}", cells.iter().collect::<String>())
    }

    /// What the letters of the line mean, with the numbers; without the words where there is no room for them.
    pub fn legend(&self, width: usize) -> String {
        let long = self.legend_with(true);
        if long.chars().count() <= width {
            long
        } else {
            self.legend_with(false)
        }
    }

    fn legend_with(&self, words: bool) -> String {
        let mut parts = Vec::new();
        let mut tell = |letters: &str, word: &str, numbers: &str| {
            let word = if words {
                format!("{word} ")
            } else {
                String::new()
            };
            parts.push(format!("{letters} {word}{numbers}"));
        };
        if let Some([start, end]) = self.bar.map(|bar| bar.map(short)) {
            tell("[=]", self.what, &format!("{start}..{end}"));
        }
        for kind in AxisMarkKind::ALL {
            let marks = self.marks.iter().filter(|mark| mark.kind == kind);
            let numbers: Vec<String> = marks.map(|mark| short(mark.t)).collect();
            if !numbers.is_empty() {
                tell(&kind.letter().to_string(), kind.name(), &numbers.join(", "));
            }
        }
        parts.join("  ")
    }

    /// The bar: at least two columns, with an arrow where it goes on beyond the axis.
    fn draw_bar(&self, cells: &mut [char], bar: [f64; 2]) {
        let last = cells.len() - 1;
        let [(mut start, before), (mut end, behind)] = bar.map(|t| self.column(t, cells.len()));
        if end <= start {
            (start, end) = (start.min(last - 1), start.min(last - 1) + 1);
        }
        cells[start..=end].fill('=');
        cells[start] = before.unwrap_or('[');
        cells[end] = behind.unwrap_or(']');
    }

    /// The column of a t, with an arrow if it lies beyond an end.
    fn column(&self, t: f64, columns: usize) -> (usize, Option<char>) {
        let ([from, to], last) = (self.ends, columns - 1);
        if t < from {
            (0, Some('<'))
        } else if t > to {
            (last, Some('>'))
        } else {
            let share = (t - from) / (to - from);
            (((share * last as f64).round() as usize).min(last), None)
        }
    }
}

/// From 0 to a little beyond the hit, or to where the ray leaves the structure. Where the way to the structure is
/// more than half of that, the axis begins at its end.
fn ends(
    inside: Option<Interval>,
    found: Option<f64>,
    light: Option<f64>,
    marks: &[AxisMark],
) -> Option<[f64; 2]> {
    let exit = inside.map(|inside| inside.max);
    let seen = marks.iter().map(|mark| mark.t).reduce(f64::max);
    let end = match (found, exit) {
        (Some(hit), Some(exit)) => hit.max(exit.min(1.25 * hit)),
        (Some(hit), None) => hit,
        (None, Some(exit)) => exit,
        (None, None) => light.or(seen).unwrap_or(1.0),
    };
    let entry = inside.map_or(0.0, |inside| inside.min);
    let start = if entry > 0.5 * end && entry < end {
        entry
    } else {
        0.0
    };
    (start.is_finite() && end.is_finite() && start < end).then_some([start, end])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(bar: [f64; 2], marks: &[(f64, AxisMarkKind)]) -> TAxis {
        TAxis {
            ends: [0.0, 10.0],
            bar: Some(bar),
            marks: marks
                .iter()
                .map(|&(t, kind)| AxisMark { t, kind })
                .collect(),
            what: "inside the node",
        }
    }

    #[test]
    fn the_bar_and_the_marks_stand_where_they_belong() {
        use AxisMarkKind::{Found, Split};
        let told = axis([2.0, 6.0], &[(4.0, Split), (9.0, Found)]);
        assert_eq!(told.line(26), "0 ----[===|===]-----X-- 10");
        let long = "[=] inside the node 2..6  | plane 4  X found 9";
        assert_eq!(told.legend(46), long);
        assert_eq!(told.legend(45), "[=] 2..6  | 4  X 9");
        assert_eq!(told.line(10), "", "no room");
    }

    #[test]
    fn what_lies_beyond_the_axis_is_an_arrow() {
        use AxisMarkKind::{Crossing, Found};
        let line = axis([-1.0, f64::INFINITY], &[(5.0, Found)]).line(16);
        assert_eq!(line, "0 <====X====> 10");
        let line = axis([3.0, 3.0], &[(-2.0, Crossing), (12.0, Crossing)]).line(16);
        assert_eq!(line, "0 <--[]-----> 10");
        let line = axis([10.0, 10.0], &[]).line(16);
        assert_eq!(line, "0 ---------[] 10");
    }

    #[test]
    fn the_axis_ends_beyond_the_hit_or_where_the_structure_does() {
        let inside = |min, max| Some(Interval::new(min, max));
        assert_eq!(
            ends(inside(1.0, 9.0), Some(4.0), None, &[]),
            Some([0.0, 5.0])
        );
        assert_eq!(
            ends(inside(1.0, 4.5), Some(4.0), None, &[]),
            Some([0.0, 4.5])
        );
        assert_eq!(ends(inside(8.0, 9.0), None, None, &[]), Some([8.0, 9.0]));
        assert_eq!(ends(None, None, Some(3.0), &[]), Some([0.0, 3.0]));
        assert_eq!(ends(None, None, Some(f64::INFINITY), &[]), None);
    }
}
