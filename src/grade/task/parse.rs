//! The parts of a task file: its text, its paths, its settings and tolerances.

use std::io::Read as _;
use std::path::{Component, Path, PathBuf};

use serde::de::IgnoredAny;

use super::advice::explained;
use super::error::TaskError;
use super::{TaskFile, ToleranceValue};
use crate::grade::quantity::QuantityKind;
use crate::grade::tolerance::{Allowance, Tolerances};
use crate::scene::read::files::{regular, unreadable};
use crate::scene::settings::knobs::set_knob;
use crate::scene::{Bend, Bends, Settings};

/// Bytes of a task file at most.
const MAX_TASK_BYTES: u64 = 1 << 20;

/// The task file and its text.
pub fn read(path: &str) -> Result<(TaskFile, String), TaskError> {
    let wrong = |what: String| TaskError::Task {
        file: path.to_owned(),
        what,
    };
    let (mut opened, length) =
        regular(Path::new(path), ".toml or .json").map_err(|problem| problem.in_file(path))?;
    if length > MAX_TASK_BYTES {
        return Err(wrong("is no file of at most 1 MiB".to_owned()));
    }
    let mut text = String::new();
    let read = opened.read_to_string(&mut text);
    read.map_err(|error| unreadable(&error).in_file(path))?;
    let file = parse(&text).map_err(wrong)?;
    Ok((file, text))
}

/// A task file from its text: JSON if it begins with a bracket, else TOML.
pub fn parse(text: &str) -> Result<TaskFile, String> {
    if text.trim_start().starts_with('{') {
        let broken = serde_json::from_str::<IgnoredAny>(text).err();
        return serde_json::from_str(text).map_err(|error| match broken {
            None => format!("is no task: {}", explained(&error.to_string())),
            Some(broken) => format!("is no JSON: {}", explained(&broken.to_string())),
        });
    }
    toml::from_str(text).map_err(|e| {
        let line = e.span().map_or(1, |span| {
            text[..span.start.min(text.len())].matches('\n').count() + 1
        });
        let message = e.message().replace('\n', ", ");
        format!("line {line}: {}", explained(&message))
    })
}

/// A scene's path, which does not leave the folder of the task; or the name of a built-in scene.
pub fn beside(task: &str, scene: &str) -> Result<String, String> {
    let path = Path::new(scene);
    if !path
        .components()
        .all(|part| matches!(part, Component::Normal(_)))
    {
        return Err(format!(
            "scene `{scene}` leaves the folder of the task; put it there"
        ));
    }
    let folder = Path::new(task).parent().unwrap_or(Path::new(""));
    let file: PathBuf = folder.join(path);
    if file.is_file() {
        return Ok(file.to_string_lossy().into_owned());
    }
    if path.extension().is_some() {
        return Err(format!(
            "scene `{scene}` is not beside the task, and is not built in"
        ));
    }
    Ok(scene.to_owned())
}

/// Sets a knob by its flag. Bends are no settings of a task.
pub fn set(settings: &mut Settings, flag: &str, value: &str) -> Result<(), String> {
    if flag == "bend" {
        return Err("`bend` is no setting of a task".to_owned());
    }
    set_knob(settings, flag, value)
}

/// A bend by name.
pub fn bend(name: &str) -> Result<Bend, String> {
    let bends: Bends = name.parse()?;
    bends
        .iter()
        .next()
        .ok_or_else(|| format!("`{name}` is no bend"))
}

/// Bends by name.
pub fn names(list: &[String]) -> Result<Vec<Bend>, String> {
    list.iter().map(|name| bend(name)).collect()
}

/// The tolerances of a task.
pub fn tolerances(file: &TaskFile) -> Result<Tolerances, String> {
    let mut all = Tolerances::default();
    for (name, value) in &file.tolerance {
        let quantity: QuantityKind = name
            .parse()
            .map_err(|_| format!("`tolerance` names `{name}`, which is no quantity"))?;
        let [absolute, relative] = match *value {
            ToleranceValue::Absolute(x) => [x, 0.0],
            ToleranceValue::Both(both) => both,
        };
        if !(absolute >= 0.0 && relative >= 0.0) {
            return Err(format!("the tolerance of `{name}` is below 0"));
        }
        all.0.insert(quantity, Allowance { absolute, relative });
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_with_a_task_is_told_with_a_cure() {
        for (text, what, cure) in [
            ("", "`format`", "write format = \"raytree-task/1\""),
            ("format = \"raytree-task/1\"", "`name`", "write name = "),
            (
                "format = \"raytree-task/1\"\nname = \"a\"",
                "`check`",
                "[[check]]",
            ),
            (
                "format = \"raytree-task/1\"\nname = \"a\"\n[[check]]\nid = \"a\"\nscene = \"b\"",
                "`points`",
                "write points = 4",
            ),
            ("nam = \"a\"", "`nam`", "did you mean `name`?"),
            ("{\"nam\": 1}", "`nam`", "did you mean `name`?"),
            ("{\"name\": \"a\"}", "`format`", "raytree-task/1"),
            ("name = ", "line 1", "lessons/tasks/hits.toml"),
            ("{\"name\": 1", "is no JSON", "lessons/tasks/hits.toml"),
        ] {
            let said = parse(text).expect_err(text);
            assert!(said.contains(what) && said.contains(cure), "{text}: {said}");
            assert!(!said.contains('\n'), "{said}");
        }
    }
}
