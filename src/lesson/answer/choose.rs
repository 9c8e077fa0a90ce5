//! An answer that was chosen; of a slide, with a pixel where the slide fails.

use super::AnswerVerdict;
use super::find::screen;
use crate::lesson::chapter::Chapter;
use crate::lesson::course::Course;
use crate::lesson::exercise::{Choices, Rightness};
use crate::lesson::stage::Stage;
use crate::lesson::value::LessonValue;
use crate::scene::Bend;

/// Judges a choice.
pub fn judge(
    course: &Course,
    chapter: &Chapter,
    stage: &Stage,
    (bend, options): (Option<Bend>, &[Choices]),
    pixel: Option<(u32, u32)>,
    chosen: char,
) -> Result<AnswerVerdict, String> {
    let index = (0..options.len()).find(|i| letter(*i) == chosen.to_ascii_lowercase());
    let option = index.map(|i| &options[i]).ok_or_else(|| {
        format!(
            "there is no option {chosen}; they are a to {}",
            letter(options.len() - 1)
        )
    })?;
    if let Some(bend) = bend {
        let at = pixel.ok_or("name a pixel where the slide fails, and a letter: 120,80 b")?;
        stage.traced(at)?;
        let bent = stage.with(&[("bend".to_owned(), bend.name().to_owned())])?;
        if screen(stage, at) == screen(&bent, at) && !differs(stage, bend, at) {
            return Ok(AnswerVerdict::wrong(format!(
                "at pixel {},{} the slide is right by chance: ours is the same there; find another one",
                at.0, at.1
            )));
        }
    }
    let is_right = is_right(course, chapter, stage, &option.right)?;
    Ok(if is_right {
        let mut verdict = AnswerVerdict::right("right");
        if let Some(bend) = bend {
            verdict.lines.push(format!(
                "the slide computes {}: {}",
                bend.entry().formula,
                bend.entry().note
            ));
        }
        verdict
    } else {
        let say = if option.say.is_empty() {
            "that is not it"
        } else {
            &option.say
        };
        AnswerVerdict::wrong(say)
    })
}

/// True if a bend changes the tree of a pixel, even where its colour stays.
fn differs(stage: &Stage, bend: Bend, at: (u32, u32)) -> bool {
    super::bug::first_wrong(stage, bend, at).is_ok()
}

/// Whether an option is right.
pub fn is_right(
    course: &Course,
    chapter: &Chapter,
    stage: &Stage,
    right: &Rightness,
) -> Result<bool, String> {
    let (a, order, b) = match right {
        Rightness::Fixed(right) => return Ok(*right),
        Rightness::When(a, order, b) => (a, order, b),
    };
    let value = |asked: &LessonValue| -> Result<f64, String> {
        let stage = match &asked.scene {
            None => stage.clone(),
            Some(scene) => {
                let path = crate::lesson::names::scene_path(&chapter.folder, scene)?;
                let stage = course.stage(chapter, Some(&path), &[]);
                stage.map_err(|e| e.to_string())?
            }
        };
        let value = asked.value(&stage)?;
        let number = value.numbers().first().copied();
        number.ok_or_else(|| format!("{} is no number", value.text(None)))
    };
    Ok(value(a)?.partial_cmp(&value(b)?) == Some(*order))
}

/// The letter of an option.
pub fn letter(index: usize) -> char {
    char::from(b'a' + index.min(25) as u8)
}
