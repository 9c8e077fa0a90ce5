//! A scene that was changed until its goals hold.

use serde_json::Value;

use super::AnswerVerdict;
use crate::lesson::chapter::Chapter;
use crate::lesson::exercise::{ChangeTask, Exercise, Goal, Must};
use crate::lesson::near::is_near;
use crate::lesson::stage::Stage;
use crate::scene::printable::excerpt;
use crate::scene::{Edit, SceneSource};
use crate::trace::export::json;
use crate::trace::field::FieldValue;
use crate::trace::format::num;

/// The scene that the student gets, as the text of a scene file.
pub fn start_text(stage: &Stage, task: &ChangeTask) -> Result<String, String> {
    let edits: Vec<Edit> = task.start.iter().cloned().map(Edit::Typed).collect();
    let (text, changed) = stage.source.file_with(&edits).map_err(|e| e.to_string())?;
    let Some(changed) = changed else {
        return Ok(text);
    };
    let mut out = Vec::new();
    json::write(&mut out, &changed).map_err(|e| e.to_string())?;
    String::from_utf8(out).map_err(|e| e.to_string())
}

/// Judges the text of a changed scene file, with the settings that it has now.
pub fn judge(
    (chapter, exercise): (&Chapter, &Exercise),
    stage: &Stage,
    task: &ChangeTask,
    text: &str,
) -> Result<AnswerVerdict, String> {
    let source = SceneSource::text(text).map_err(|e| e.to_string())?;
    let scene = source.scene().map_err(|e| e.to_string())?;
    let start = start_text(stage, task)?;
    for part in &task.keep {
        if part_of(&start, part) != part_of(text, part) {
            return Ok(AnswerVerdict::wrong(format!(
                "`{}` has changed, and is to stay as it was",
                excerpt(part)
            )));
        }
    }
    let before = stage.changed(&task.start)?;
    let after = Stage::new(&stage.scene, source, scene, chapter, &exercise.settings)?;
    let mut verdict = AnswerVerdict {
        right: true,
        lines: Vec::new(),
    };
    for goal in &task.goals {
        let (holds, line) = goal.told(&before, &after);
        verdict.right &= holds;
        verdict.lines.push(line);
    }
    verdict.lines.insert(
        0,
        if verdict.right {
            "all goals hold: right"
        } else {
            "not all goals hold yet"
        }
        .to_owned(),
    );
    Ok(verdict)
}

/// A part of a scene file, by its name at the top.
fn part_of(text: &str, part: &str) -> Option<Value> {
    let file: Value = serde_json::from_str(text).ok()?;
    file.get(part).cloned()
}

impl Goal {
    /// Whether it holds, and a line that says so.
    fn told(&self, before: &Stage, after: &Stage) -> (bool, String) {
        let value = match self.asked.value(after) {
            Ok(value) => value,
            Err(why) => return (false, format!("no   {}: {why}", self.asked.name())),
        };
        let number = || value.numbers().first().copied();
        let (holds, wanted) = match &self.must {
            Must::Word(word) => (
                is_near(&value, &FieldValue::Word(word.clone()), None),
                word.clone(),
            ),
            Must::Near(x, off) => (
                number().is_some_and(|y| (x - y).abs() <= *off),
                format!("{}, or {} off at most", num(*x), num(*off)),
            ),
            Must::Between([least, most]) => (
                number().is_some_and(|y| (*least..=*most).contains(&y)),
                format!("{} to {}", num(*least), num(*most)),
            ),
            Must::Same => {
                let start = self.asked.value(before);
                let wanted = start.as_ref().map(|v| v.text(None)).unwrap_or_default();
                (
                    start.is_ok_and(|start| is_near(&value, &start, None)),
                    wanted,
                )
            }
        };
        let sign = if holds { "yes" } else { "no " };
        let is = value.text(None);
        (
            holds,
            format!("{sign}  {} is {is}; wanted: {wanted}", self.asked.name()),
        )
    }
}
