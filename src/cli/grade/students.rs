//! The list of a course: who is who, and who handed in nothing.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use super::small_file::{broken, text_of};
use crate::cli::Failure;
use crate::scene::printable::excerpt;

/// One who is to be marked.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Entry {
    /// What was handed in; nothing if it was not.
    pub path: Option<PathBuf>,
    /// The name in the list, if there is one.
    pub name: Option<String>,
    /// The id in the list.
    pub id: Option<String>,
}

/// All who are to be marked.
#[derive(Debug, Default)]
pub struct Entries {
    /// Submissions in the order of the command line, then those who handed in nothing in the order of the list.
    pub entries: Vec<Entry>,
    /// What is strange.
    pub warnings: Vec<String>,
}

/// The submissions with the list, if there is one. A submission is of the line whose id or name it has.
pub fn entries(submissions: &[PathBuf], list: Option<&Path>) -> Result<Entries, Failure> {
    let Some(path) = list else {
        let all = submissions.iter();
        let entries = all.map(|path| Entry {
            path: Some(path.clone()),
            ..Entry::default()
        });
        return Ok(Entries {
            entries: entries.collect(),
            warnings: Vec::new(),
        });
    };
    let text = text_of(path, "list of students")?;
    let students = parse(&text).map_err(|what| broken(path, &what))?;
    Ok(match_up(submissions, &students))
}

fn match_up(submissions: &[PathBuf], students: &[(String, String)]) -> Entries {
    let mut all = Entries::default();
    let mut seen: HashSet<usize> = HashSet::new();
    for path in submissions {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let whole = path.file_name().unwrap_or_default().to_string_lossy();
        let is = |text: &str| text == stem || path.is_dir() && text == whole;
        let by_id = students.iter().position(|(_, id)| is(id));
        let index = by_id.or_else(|| students.iter().position(|(name, _)| is(name)));
        let student = index.and_then(|index| students.get(index));
        match index {
            None => all.warnings.push(format!(
                "{} is of nobody in the list",
                excerpt(&path.to_string_lossy())
            )),
            Some(index) if !seen.insert(index) => all.warnings.push(format!(
                "{} is of {}, who handed in something else as well",
                excerpt(&path.to_string_lossy()),
                excerpt(&students[index].0)
            )),
            Some(_) => {}
        }
        all.entries.push(Entry {
            path: Some(path.clone()),
            name: student.map(|(name, _)| name.clone()),
            id: student.map(|(_, id)| id.clone()),
        });
    }
    let absent = students.iter().enumerate();
    let absent = absent.filter(|(index, _)| !seen.contains(index));
    all.entries.extend(absent.map(|(_, (name, id))| Entry {
        path: None,
        name: Some(name.clone()),
        id: Some(id.clone()),
    }));
    all
}

/// Names and ids, from lines `name,id`. A cell may stand in quotes; a first line `name,id` is a heading.
fn parse(text: &str) -> Result<Vec<(String, String)>, String> {
    let text = text.trim_start_matches('\u{feff}');
    let mut students = Vec::new();
    let mut seen = HashSet::new();
    for (line, number) in text.lines().zip(1..) {
        let line = line.trim();
        if line.is_empty() || number == 1 && line.eq_ignore_ascii_case("name,id") {
            continue;
        }
        let (name, id) = cells(line).ok_or_else(|| {
            format!("line {number}: write the name, a comma and the id, such as alice,4711")
        })?;
        if !seen.insert(id.clone()) {
            return Err(format!(
                "line {number}: the id `{}` is there already",
                excerpt(&id)
            ));
        }
        students.push((name, id));
    }
    Ok(students)
}

/// The two cells of a line. The comma is the last one that stands in no quotes, so that `Meier, Alice,4711` is read as it is meant.
fn cells(line: &str) -> Option<(String, String)> {
    let mut comma = None;
    let mut quoted = false;
    for (index, c) in line.char_indices() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => comma = Some(index),
            _ => {}
        }
    }
    let (name, id) = line.split_at(comma?);
    let plain = |cell: &str| {
        let cell = cell.trim();
        let inner = cell.strip_prefix('"').and_then(|c| c.strip_suffix('"'));
        inner.map_or(cell.to_owned(), |inner| inner.replace("\"\"", "\""))
    };
    let (name, id) = (plain(name), plain(id.get(1..)?));
    (!name.is_empty() && !id.is_empty()).then_some((name, id))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_read_as_spreadsheets_write_them() {
        let text =
            "\u{feff}Name,ID\r\nalice,4711\r\n\r\n\"Meier, \"\"Bo\"\"\",4712\nMeier, Cora,x@y\n";
        let all = parse(text).expect("a list");
        let expected = [
            ("alice", "4711"),
            ("Meier, \"Bo\"", "4712"),
            ("Meier, Cora", "x@y"),
        ];
        let expected = expected.map(|(a, b)| (a.to_owned(), b.to_owned()));
        assert_eq!(all, expected);
        assert!(parse("alice").is_err_and(|e| e.starts_with("line 1")));
        assert!(parse("a,1\nb,1").is_err_and(|e| e.contains("already")));
        assert!(parse("a,").is_err());
    }

    #[test]
    fn who_handed_in_nothing_comes_last() {
        let students = [("alice", "1"), ("bo", "2"), ("cy", "3")];
        let students = students.map(|(a, b)| (a.to_owned(), b.to_owned()));
        let paths = ["in/3.zip", "in/eve", "alice.json", "1.zip"].map(PathBuf::from);
        let all = match_up(&paths, &students);
        let names = all.entries.iter().map(|e| e.name.as_deref());
        let expected = [Some("cy"), None, Some("alice"), Some("alice"), Some("bo")];
        assert_eq!(names.collect::<Vec<_>>(), expected);
        assert!(all.entries[4].path.is_none());
        assert_eq!(all.warnings.len(), 2, "{:?}", all.warnings);
    }
}
