//! A pixel that was found.

use super::AnswerVerdict;
use crate::lab::show::ShownValue;
use crate::lesson::exercise::Wanted;
use crate::lesson::stage::Stage;
use crate::probe::Silent;
use crate::trace::TreeQuery;
use crate::trace::format::num;
use crate::tracer::pixel;

/// A part of what is wanted, and whether it holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundPart {
    /// The part, in words.
    pub text: String,
    /// Whether it holds.
    pub holds: bool,
}

/// Judges a pixel.
pub fn judge(stage: &Stage, wanted: &Wanted, at: (u32, u32)) -> Result<AnswerVerdict, String> {
    let parts = parts(stage, wanted, at)?;
    let right = parts.iter().all(|part| part.holds);
    let first = format!(
        "pixel {},{} {}",
        at.0,
        at.1,
        if right { "is one: right" } else { "is none" }
    );
    let told = parts.iter().map(|part| {
        let holds = if part.holds { "yes" } else { "no " };
        format!("{holds}  {}", part.text)
    });
    Ok(AnswerVerdict {
        right,
        lines: std::iter::once(first).chain(told).collect(),
    })
}

/// Each part of what is wanted of a pixel, and whether it holds.
pub fn parts(stage: &Stage, wanted: &Wanted, at: (u32, u32)) -> Result<Vec<FoundPart>, String> {
    let trace = stage.traced(at)?;
    let view = stage.view(&trace);
    let mut parts = Vec::new();
    if wanted.query.is_some() {
        for text in conjuncts(&wanted.text) {
            let query: TreeQuery = text.parse().map_err(|e| format!("{e}"))?;
            parts.push(FoundPart {
                holds: query.holds(view),
                text,
            });
        }
    }
    if !wanted.differs.is_empty() {
        let other = stage.with(&wanted.differs)?;
        let color = |stage: &Stage| screen(stage, at);
        let told: Vec<String> = wanted
            .differs
            .iter()
            .map(|(n, v)| format!("{n} {v}"))
            .collect();
        parts.push(FoundPart {
            text: format!("its colour on the screen changes with {}", told.join(", ")),
            holds: color(stage) != color(&other),
        });
    }
    if let Some((mode, [least, most])) = wanted.shown {
        let value = match mode.of(&stage.world, &stage.settings, at) {
            ShownValue::Number(x) => Some(x),
            _ => None,
        };
        let is = value.map_or("nothing".to_owned(), num);
        parts.push(FoundPart {
            text: format!(
                "{} from {} to {}: it has {is}",
                mode.unit(),
                num(least),
                num(most)
            ),
            holds: value.is_some_and(|x| (least..=most).contains(&x)),
        });
    }
    Ok(parts)
}

/// The colour of a pixel on the screen.
pub fn screen(stage: &Stage, at: (u32, u32)) -> [u8; 3] {
    let color = pixel(&stage.world, &stage.settings, at, &mut Silent).color;
    let exposed = color * stage.settings.image.exposure;
    stage.settings.bends.srgb8(exposed)
}

/// The parts of a query that must all hold: split at each `and` outside of brackets, if no `or` stands there.
fn conjuncts(text: &str) -> Vec<String> {
    let (mut parts, mut depth) = (vec![String::new()], 0_usize);
    for word in text.split_whitespace() {
        match word {
            "or" if depth == 0 => return vec![text.to_owned()],
            "and" if depth == 0 => parts.push(String::new()),
            _ => {
                depth += word.matches('(').count();
                depth = depth.saturating_sub(word.matches(')').count());
                if let Some(last) = parts.last_mut() {
                    if !last.is_empty() {
                        last.push(' ');
                    }
                    last.push_str(word);
                }
            }
        }
    }
    parts
}
