//! What an OBJ file may hold. The reader behind accepts NaN, takes lines and points for triangles, and may overflow
//! on wild indices; so each line is checked here first, and only what makes up surfaces is handed on.

use crate::scene::error::Problem;
use crate::scene::limits::{MAX_COORDINATE, MAX_CORNERS};

/// An OBJ file that was checked.
#[derive(Debug, Default)]
pub struct Checked {
    /// The lines that make up surfaces, without mtllib.
    pub text: String,
    /// The material files that it names.
    pub libraries: Vec<(usize, String)>,
    /// The materials that its faces use, with the first line of each.
    pub uses: Vec<(usize, String)>,
    /// Its faces, in their order.
    pub faces: Vec<Face>,
    /// Faces with one or two corners, which have no surface: how many, and the line of the first.
    pub edges: (usize, usize),
    points: usize,
    uvs: usize,
    normals: usize,
}

/// What is known of a face.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Its line in the file.
    pub line: u32,
    /// True if all its corners have normals.
    pub normals: bool,
    /// True if all its corners have surface coordinates.
    pub uvs: bool,
}

/// Checks the text of an OBJ file; an error tells the line, from 1.
pub fn check(text: &str) -> Result<Checked, (usize, Problem)> {
    let mut checked = Checked::default();
    for (number, line) in (1..).zip(text.lines()) {
        checked
            .line(number, line)
            .map_err(|problem| (number, problem))?;
    }
    Ok(checked)
}

impl Checked {
    fn line(&mut self, number: usize, line: &str) -> Result<(), Problem> {
        let mut words = line.split_whitespace();
        let key = words.next().unwrap_or("");
        let rest: Vec<&str> = words.take_while(|w| !w.starts_with('#')).collect();
        if line.trim_end().ends_with('\\') && !key.starts_with('#') {
            return Err(Problem::new(
                "the line goes on in the next one, by `\\`",
                "join the two lines",
            ));
        }
        match key {
            "v" => {
                numbers(key, &rest, 3, MAX_COORDINATE)?;
                // Colours that follow the point are passed over; a fourth number is a weight.
                let kept = if rest.len() == 4 { 4 } else { 3 };
                if kept == 4 {
                    numbers("the weight of v", &rest[3..], 1, MAX_COORDINATE)?;
                    if rest[3].parse().is_ok_and(|w: f64| w.abs() < 1e-9) {
                        return Err(Problem::new(
                            format!("`v` has the weight {}", rest[3]),
                            "write three numbers: `v x y z`",
                        ));
                    }
                }
                self.points += 1;
                self.keep(key, &rest[..kept]);
            }
            "vt" => {
                numbers(key, &rest, 2, MAX_COORDINATE)?;
                self.uvs += 1;
                self.keep(key, &rest[..2]);
            }
            "vn" => {
                numbers(key, &rest, 3, MAX_COORDINATE)?;
                self.normals += 1;
                self.keep(key, &rest[..3]);
            }
            "f" => self.face(number, &rest)?,
            "mtllib" => self.libraries.push((number, rest.join(" "))),
            "usemtl" if rest.is_empty() => {
                return Err(Problem::new(
                    "`usemtl` names no material",
                    "write `usemtl name`, or take the line away",
                ));
            }
            "usemtl" => {
                let name = rest.join(" ");
                if !self.uses.iter().any(|(_, known)| *known == name) {
                    self.uses.push((number, name));
                }
                self.keep(key, &rest);
            }
            "o" | "g" => self.keep(key, &rest),
            _ => {}
        }
        Ok(())
    }

    fn keep(&mut self, key: &str, words: &[&str]) {
        self.text.push_str(key);
        for word in words {
            self.text.push(' ');
            self.text.push_str(word);
        }
        self.text.push('\n');
    }

    fn face(&mut self, line: usize, corners: &[&str]) -> Result<(), Problem> {
        let mut face = Face {
            line: line as u32,
            normals: true,
            uvs: true,
        };
        for corner in corners {
            let mut parts = corner.split('/');
            let counts = [
                ("vertex", self.points),
                ("texture coordinate", self.uvs),
                ("normal", self.normals),
            ];
            for (i, (what, count)) in counts.into_iter().enumerate() {
                match parts.next() {
                    Some(part) if i == 0 || !part.is_empty() => index(corner, part, what, count)?,
                    _ if i == 1 => face.uvs = false,
                    _ => face.normals = false,
                }
            }
            if parts.next().is_some() {
                return Err(Problem::new(
                    format!("the corner `{corner}` has too many parts"),
                    "write v, v/vt, v//vn or v/vt/vn",
                ));
            }
        }
        match corners.len() {
            0 => Err(Problem::new(
                "the face has no corners",
                "write `f a b c`, or take the line away",
            )),
            1 | 2 => {
                let first = if self.edges.0 == 0 {
                    line
                } else {
                    self.edges.1
                };
                self.edges = (self.edges.0 + 1, first);
                Ok(())
            }
            n if n > MAX_CORNERS => Err(Problem::new(
                format!("the face has {n} corners; {MAX_CORNERS} are possible"),
                "cut it into triangles in the program that made it",
            )),
            _ => {
                self.faces.push(face);
                self.keep("f", corners);
                Ok(())
            }
        }
    }
}

/// Checks that at least `count` numbers begin the list, finite and not beyond `max`.
fn numbers(key: &str, words: &[&str], count: usize, max: f64) -> Result<(), Problem> {
    if words.len() < count {
        return Err(Problem::new(
            format!("`{key}` needs {count} numbers and has {}", words.len()),
            "complete the line; perhaps the file was cut off",
        ));
    }
    for word in &words[..count] {
        let Ok(value) = word.parse::<f64>() else {
            return Err(Problem::new(
                format!("`{key}` has `{word}`, which is not a number"),
                "write numbers with a decimal point, such as 0.5",
            ));
        };
        if !value.is_finite() || value.abs() > max {
            return Err(Problem::new(
                format!("`{key}` has `{word}`, which is no usable number"),
                format!("write a finite number between -{max:e} and {max:e}"),
            ));
        }
    }
    Ok(())
}

/// Checks the number of a vertex, a texture coordinate or a normal: from 1 up, or from -1 down, which counts
/// backwards from the last one so far.
fn index(corner: &str, part: &str, what: &str, count: usize) -> Result<(), Problem> {
    let index: i64 = part.parse().map_err(|_| {
        Problem::new(
            format!("the corner `{corner}` has `{part}`, which is not a number of a {what}"),
            "write v, v/vt, v//vn or v/vt/vn with whole numbers",
        )
    })?;
    if index == 0 || index.unsigned_abs() > count as u64 {
        return Err(Problem::new(
            format!("the corner `{corner}` asks for {what} {index}, and there are {count} so far"),
            if count == 0 {
                "list them before the faces that use them".to_string()
            } else {
                format!(
                    "write a number from 1 to {count}, or from -1 to -{count} to count backwards"
                )
            },
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const THREE: &str = "v 0 0 0\nv 1 0 0 1\nv 0 1 0 0.5 0.5 0.5\nvn 0 0 1\nvt 0 0\n";

    fn error(line: &str) -> Option<usize> {
        check(&format!("{THREE}{line}")).err().map(|e| e.0)
    }

    #[test]
    fn good_lines_pass() {
        for line in [
            "f 1 2 3",
            "f 1/1 2/1 3/1",
            "f 1//1 2//-1 -1//1",
            "f 1/1/1 2/1/1 3/1/1 # end",
        ] {
            assert_eq!(error(line), None, "{line}");
        }
    }

    #[test]
    fn bad_lines_are_told_by_number() {
        for line in [
            "f",
            "f 0 1 2",
            "f 1 2 4",
            "f 1 2 -4",
            "f 1 2 99999999999999999999",
            "f 1 2 x",
            "f 1/2 2/1 3/1",
            "f 1//9223372036854775807 2//1 3//1",
            "f 1/1/1/1 2 3",
            "f / / /",
            "v nan 0 0",
            "v 0 inf 0",
            "v 0 0 1e39",
            "v 0 0",
            "v 0 0 0 0",
            "v 0,5 0 0",
            "vn 0 0",
            "vt 0",
            "f 1 2 \\",
            "usemtl",
        ] {
            assert_eq!(error(line), Some(6), "{line}");
        }
    }

    #[test]
    fn faces_without_surface_are_counted() {
        let checked = check(&format!("{THREE}f 1\nf 1 2\nf 1//1 2//1 3\nl 1 2 3")).expect("good");
        assert_eq!(checked.edges, (2, 6));
        assert_eq!(checked.faces.len(), 1);
        assert!(!checked.faces[0].normals && !checked.faces[0].uvs);
    }
}
