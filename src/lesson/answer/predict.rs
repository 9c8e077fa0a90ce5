//! A value told before it is shown.

use super::AnswerVerdict;
use crate::debug::asked::asked as asked_event;
use crate::lesson::directive::in_lines;
use crate::lesson::near::is_near;
use crate::lesson::question::{AnswerForm, Question};
use crate::lesson::stage::Stage;
use crate::lesson::value::LessonValue;
use crate::scene::printable::excerpt;
use crate::trace::explain;
use crate::trace::field::FieldValue;

/// Judges a value.
pub fn judge(
    stage: &Stage,
    asked: &LessonValue,
    tolerance: Option<f64>,
    text: &str,
    tries: u32,
) -> Result<AnswerVerdict, String> {
    let question = Question::new(stage, asked, tries)?;
    let given = read(text, &question.form)?;
    let right = is_near(&given, &question.answer, tolerance);
    let (said, is) = (given.text(None), question.answer.text(None));
    let mut verdict = if right {
        AnswerVerdict::right(format!("you said {said}, it is {is}: right"))
    } else {
        AnswerVerdict::wrong(format!("you said {said}, but it is {is}"))
    };
    if let Some(ray) = &question.ray {
        let trace = stage.with(&asked.settings)?.traced(ray.pixel)?;
        let view = stage.view(&trace);
        let told = explain(view, asked_event(view, &ray.address())?.answer);
        verdict
            .lines
            .extend(in_lines(&told, true).lines().map(str::to_owned));
    }
    Ok(verdict)
}

/// A number, or a fraction of two.
fn number(text: &str) -> Option<f64> {
    match text.split_once('/') {
        Some((a, b)) => Some(a.parse::<f64>().ok()? / b.parse::<f64>().ok()?),
        None => text.parse().ok(),
    }
}

/// A value from its text.
fn read(text: &str, form: &AnswerForm) -> Result<FieldValue, String> {
    let wrong = || format!("`{}` is not what is asked: {}", excerpt(text), form.asks());
    let numbers = || -> Option<Vec<f64>> {
        let text = text.trim().trim_start_matches('(').trim_end_matches(')');
        let parts = text.split([',', ' ', ';']).filter(|part| !part.is_empty());
        parts
            .map(|part| number(part).filter(|x| x.is_finite()))
            .collect()
    };
    match form {
        AnswerForm::Number => match numbers().as_deref() {
            Some([x]) => Ok(FieldValue::Number(*x)),
            _ => Err(wrong() + ", such as 4.09 or 1/3"),
        },
        AnswerForm::Numbers(count) => {
            let all = numbers().filter(|all| all.len() == *count);
            all.map(FieldValue::Numbers).ok_or_else(wrong)
        }
        AnswerForm::Word(words) => {
            let text = text.trim();
            let by_number = text
                .parse::<usize>()
                .ok()
                .and_then(|n| words.get(n.wrapping_sub(1)));
            let word = words.iter().find(|word| word.eq_ignore_ascii_case(text));
            let word = word.or(by_number).cloned().ok_or_else(wrong)?;
            Ok(FieldValue::Word(word))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_may_be_fractions() {
        let of = |text| match read(text, &AnswerForm::Number) {
            Ok(FieldValue::Number(x)) => Ok(x),
            Ok(other) => Err(format!("{other:?}")),
            Err(error) => Err(error),
        };
        assert_eq!(of("4.09"), Ok(4.09));
        assert_eq!(of("-1e-3"), Ok(-1e-3));
        assert_eq!(of("1/480"), Ok(1.0 / 480.0));
        for wrong in ["4,09", "1/0", "1/", "half", ""] {
            let error = of(wrong).expect_err(wrong);
            assert!(error.contains("a number, such as 4.09 or 1/3"), "{error}");
        }
    }
}
