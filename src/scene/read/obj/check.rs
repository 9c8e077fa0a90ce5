//! The check in front of `tobj`: what it would refuse, mistake or take for good is mended, noted, or refused with its line.
//!
//! The mended text has points, texture coordinates, normals and faces, no names. It ends with texture coordinates and a
//! normal that stand for none, because `tobj` gives a corner without them those of its neighbour.

use std::fmt::Write;

use crate::math::DVec3;
use crate::scene::limits::{MAX_COORDINATE, MAX_PRIMITIVES};
use crate::scene::read::error::Problem;
use crate::scene::read::notes::Notes;
use crate::scene::read::text::{Lines, is_plain_number, name, number, whole, words};
use crate::scene::warning::WarningCode;

/// Faces of one model of `tobj`, which needs a hundred bytes for each until the model ends.
const FACES: usize = 1 << 15;

/// Faces with one name and one material.
#[derive(Clone, Debug, Default)]
pub struct FaceRun {
    /// What follows `o` or `g`.
    pub name: String,
    /// What follows `usemtl`, and its line.
    pub material: (String, usize),
    /// The number of its first face, and how many triangles its faces are.
    pub first: usize,
    pub triangles: usize,
}

/// What the check has found.
#[derive(Debug, Default)]
pub struct Checked {
    /// The mended text of the lines since it was taken.
    pub text: String,
    /// The line of each face.
    pub faces: Vec<u32>,
    /// The runs of its faces.
    pub runs: Vec<FaceRun>,
    /// The files of materials that it names, with their lines.
    pub libraries: Vec<(String, usize)>,
    /// What is left out or guessed.
    pub notes: Notes,
    /// The line at hand.
    line: usize,
    /// Points, texture coordinates, normals: in the file, before this line, and the highest number that a face names.
    totals: [usize; 3],
    before: [usize; 3],
    named: [usize; 3],
    /// The run at hand, and if a face of it is still to come.
    run: FaceRun,
    is_new: bool,
    is_smooth: bool,
    triangles: usize,
}

/// What a line gives a number to: 0 for points, 1 for texture coordinates, 2 for normals.
fn kind(key: &str) -> Option<usize> {
    ["v", "vt", "vn"].iter().position(|known| *known == key)
}

impl Checked {
    /// The check before the first line of a text.
    pub fn new(text: &str) -> Self {
        let mut totals = [0; 3];
        for (_, line) in Lines::new(text) {
            let is_vertex = line.trim_ascii_start().starts_with('v');
            let key = is_vertex.then(|| words(&line).next()).flatten();
            if let Some(kind) = key.and_then(kind) {
                totals[kind] += 1;
            }
        }
        Self {
            totals,
            is_new: true,
            ..Self::default()
        }
    }

    /// The mended text so far, which is not kept.
    pub fn take_text(&mut self) -> String {
        std::mem::take(&mut self.text)
    }

    /// Ends the mended text.
    pub fn end(&mut self) {
        for (kind, none) in [(1, "vt nan nan\n"), (2, "vn 0 0 0\n")] {
            self.text += if self.totals[kind] > 0 { none } else { "" };
        }
    }

    fn note(&mut self, code: WarningCode, about: &str) {
        self.notes.add(code, about, self.line);
    }

    /// Checks a line, and mends it.
    pub fn read(&mut self, number: usize, line: &str) -> Result<(), Problem> {
        self.line = number;
        let mut words = words(line);
        let Some(key) = words.next() else {
            return Ok(());
        };
        match key {
            "v" | "vt" | "vn" => return self.vertex(key, words),
            "f" | "fo" => return self.face(words),
            "o" | "g" => (self.run.name, self.is_new) = (name(line), true),
            "mtllib" => self.libraries.push((name(line), self.line)),
            "usemtl" => {
                let material = name(line);
                if material.is_empty() {
                    self.note(WarningCode::NoMaterialName, key);
                }
                self.is_new |= material != self.run.material.0;
                self.run.material = (material, self.line);
            }
            "s" => self.is_smooth = !matches!(words.next(), None | Some("off" | "0")),
            _ => self.note(WarningCode::LeftOut, key),
        }
        Ok(())
    }

    /// A point with its weight, which divides, or its colour; texture coordinates; a normal.
    fn vertex<'a>(
        &mut self,
        key: &str,
        words: impl Iterator<Item = &'a str>,
    ) -> Result<(), Problem> {
        let (mut first, mut count) = ([""; 4], 0);
        for word in words {
            if let Some(place) = first.get_mut(count) {
                *place = word;
            }
            count += 1;
        }
        let words = &first[..count.min(4)];
        self.before[kind(key).unwrap_or(0)] += 1;
        if count < 4 && is_usual(key, words) {
            self.hand_on(key, words);
            return Ok(());
        }
        let (mut numbers, mut good) = ([0.0; 4], 0);
        for x in words.iter().map_while(|word| number(word, MAX_COORDINATE)) {
            numbers[good] = x;
            good += 1;
        }
        let mut kept = good.min(3);
        match (key, &numbers[..good]) {
            ("v", [x, y, z, rest @ ..]) => match (count, rest) {
                (3, _) => {}
                (4, [w]) if is_weight(*w, [*x, *y, *z]) => kept = 4,
                (4, _) => self.note(WarningCode::BadVertexData, "the weight of v"),
                (5, _) => self.note(WarningCode::ExtraNumbers, key),
                _ => self.note(WarningCode::VertexColors, key),
            },
            ("v", _) => return Err(broken(words, good)),
            // The second is 0 if it is not said.
            ("vt", [u]) if count == 1 => {
                let _ = write!(self.text, "vt {u} 0");
                kept = 0;
            }
            ("vt", [_, _, ..]) => kept = 2,
            ("vn", [x, y, z, ..]) if DVec3::new(*x, *y, *z).try_normalize().is_some() => {}
            _ => {
                self.note(WarningCode::BadVertexData, key);
                self.text += if key == "vt" {
                    "vt nan nan"
                } else {
                    "vn 0 0 0"
                };
                kept = 0;
            }
        }
        self.hand_on(if kept > 0 { key } else { "" }, &words[..kept]);
        Ok(())
    }

    /// Ends a line with words.
    fn hand_on(&mut self, key: &str, words: &[&str]) {
        self.text += key;
        for word in words {
            self.text += " ";
            self.text += word;
        }
        self.text += "\n";
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str> + Clone) -> Result<(), Problem> {
        let corners = words.clone().count();
        if corners < 3 {
            self.note(WarningCode::FewCorners, "f");
            return Ok(());
        }
        // Asked before there are many more: a face is a few letters, a triangle in memory a hundred bytes.
        self.triangles += corners - 2;
        if self.triangles > MAX_PRIMITIVES {
            let what = format!("here are more than {MAX_PRIMITIVES} triangles");
            return Err(Problem::new(what, "use a model with fewer triangles"));
        }
        if std::mem::take(&mut self.is_new) {
            self.run.first = self.faces.len();
            self.runs.push(self.run.clone());
        }
        if let Some(run) = self.runs.last_mut() {
            run.triangles += corners - 2;
        }
        // A model of `tobj` ends where it is large and names nothing that comes later.
        let is_full = self.faces.len() % FACES == FACES - 1;
        if is_full && (0..3).all(|kind| self.named[kind] <= self.before[kind]) {
            self.text += "g\n";
        }
        self.text += "f";
        let mut is_flat = false;
        for word in words {
            is_flat |= !self.corner(word)?;
        }
        self.text += "\n";
        self.faces.push(self.line as u32);
        if self.is_smooth && is_flat {
            self.note(WarningCode::SmoothingGroup, "s");
        }
        Ok(())
    }

    /// Hands on a corner; true if it has a normal.
    fn corner(&mut self, corner: &str) -> Result<bool, Problem> {
        let (mut found, mut is_good) = ([0; 3], true);
        for (kind, part) in corner.as_bytes().split(|b| *b == b'/').enumerate() {
            match (kind, self.index(kind, part)) {
                (_, Some(index)) => found[kind] = index,
                (0, None) => return Err(self.no_point(corner)),
                (1 | 2, None) if part.is_empty() => {}
                (kind, None) => {
                    is_good = false;
                    let (code, about) = match kind {
                        1 | 2 => (WarningCode::DanglingIndex, ["vt", "vn"][kind - 1]),
                        _ => (WarningCode::ExtraNumbers, "f"),
                    };
                    self.note(code, about);
                }
            }
        }
        // The number behind the last stands for none.
        let none = |kind: usize| found[kind] == 0 && self.totals[kind] > 0;
        let handed =
            [0, 1, 2].map(|kind| found[kind] + usize::from(none(kind)) * (self.totals[kind] + 1));
        self.named = [0, 1, 2].map(|kind| self.named[kind].max(handed[kind]));
        let [v, vt, vn] = handed;
        // Writing to a string cannot fail.
        let _ = match (vt, vn) {
            _ if is_good && handed == found => {
                self.text += " ";
                self.text += corner;
                Ok(())
            }
            (0, 0) => write!(self.text, " {v}"),
            (_, 0) => write!(self.text, " {v}/{vt}"),
            (0, _) => write!(self.text, " {v}//{vn}"),
            _ => write!(self.text, " {v}/{vt}/{vn}"),
        };
        Ok(found[2] > 0)
    }

    /// A number of a corner, from 1. Files count from 1 up, or from -1 down: backwards from the last one so far.
    fn index(&self, kind: usize, part: &[u8]) -> Option<usize> {
        let total = *self.totals.get(kind)?;
        let index = whole(part)?;
        let from = if index < 0 { self.before[kind] + 1 } else { 0 };
        let found = from.checked_add_signed(index)?;
        (1..=total).contains(&found).then_some(found)
    }

    fn no_point(&self, corner: &str) -> Problem {
        let [before, total] = [self.before[0], self.totals[0]];
        let what = format!("the corner `{corner}` names no vertex: there are {total}");
        let cure = format!(
            "name a vertex from 1 to {total}, or from -1 to -{before} to count backwards: v, v/vt, v//vn or v/vt/vn"
        );
        Problem::new(what, cure)
    }
}

/// True for what nearly all lines are: as many numbers as there should be, in digits, and no normal of zeros.
fn is_usual(key: &str, words: &[&str]) -> bool {
    let is_zero = |word: &&str| !word.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
    words.len() == (if key == "vt" { 2 } else { 3 })
        && words.iter().all(|word| is_plain_number(word))
        && !(key == "vn" && words.iter().all(is_zero))
}

/// True if a point can be divided by its weight.
fn is_weight(w: f64, point: [f64; 3]) -> bool {
    w.abs() >= 1e-9 && point.iter().all(|x| (x / w).abs() <= MAX_COORDINATE)
}

/// Why the words are no point, of which the first `good` are numbers.
fn broken(words: &[&str], good: usize) -> Problem {
    match words.get(good) {
        Some(word) => Problem::new(
            format!("`v` has `{word}`, which is no usable number"),
            format!(
                "write numbers with a decimal point, such as 0.5, from -{MAX_COORDINATE:e} to {MAX_COORDINATE:e}"
            ),
        ),
        None => Problem::new(
            format!("`v` needs 3 numbers and has {good}"),
            "complete the line; perhaps the file was cut off",
        ),
    }
}
