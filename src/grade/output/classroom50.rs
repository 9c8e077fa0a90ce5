//! `result.json` of Classroom 50's autograder, for one submission. Points are whole numbers there: hundredths of ours.

use serde_json::{Value, json};

use super::{Audience, told_causes};
use crate::grade::marks::CheckStatus;
use crate::grade::report::Marked;
use crate::grade::value::shown;

/// What Classroom 50's runner says of a submission, in environment variables, and when it was handed in.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Classroom {
    fields: Vec<(&'static str, String)>,
}

/// The fields, and the variables that may hold each, the first that is set; what it is if none is.
const FIELDS: [(&str, &[&str], Option<&str>); 8] = [
    ("classroom", &["CLASSROOM"], None),
    ("assignment", &["ASSIGNMENT"], None),
    ("assignment_type", &["ASSIGNMENT_TYPE"], Some("individual")),
    ("owner", &["OWNER", "USERNAME"], None),
    ("submission", &["SUBMISSION_TAG"], None),
    ("commit", &["COMMIT_URL"], None),
    ("release", &["RELEASE_URL"], None),
    ("review", &["REVIEW_URL", "COMMIT_URL"], None),
];

impl Classroom {
    /// Reads the variables; `datetime` is `YYYY-MM-DDTHH:MM:SSZ`. An error names the variable that is not set.
    pub fn new(
        variable: &dyn Fn(&str) -> Option<String>,
        datetime: String,
    ) -> Result<Self, String> {
        let mut fields = vec![("datetime", datetime)];
        for (field, names, otherwise) in FIELDS {
            let set = names.iter().find_map(|name| variable(name));
            let value = set.or(otherwise.map(str::to_owned)).ok_or_else(|| {
                format!(
                    "classroom50: the environment variable {} is not set; Classroom 50's runner sets it",
                    names[0]
                )
            })?;
            fields.push((field, value));
        }
        Ok(Self { fields })
    }
}

/// The result of a submission.
pub fn result(audience: Audience, classroom: &Classroom, marked: &Marked) -> Value {
    let checks = audience.task.checks.iter().zip(&marked.marks);
    let tests = checks.map(|(check, mark)| {
        json!({
            "test-name": check.id,
            "passed": mark.status == CheckStatus::Full,
            "score": mark.score / 10,
            "max-score": mark.most / 10,
            "address": told_causes(mark).first().map(|(at, cause)| shown(&cause.first.address(*at))),
            "percent": (100 * mark.score).checked_div(mark.most).unwrap_or(100),
        })
    });
    let mut result = json!({
        "schema": "classroom50/result/v1",
        "score": marked.score() / 10,
        "max-score": marked.most() / 10,
        "tests": tests.collect::<Vec<_>>(),
    });
    for (field, value) in &classroom.fields {
        result[*field] = json!(value);
    }
    result
}

/// A moment as Classroom 50 writes it: seconds since 1970, in UTC.
pub fn utc(seconds: u64) -> String {
    let (days, rest) = (seconds / 86_400, seconds % 86_400);
    // Days since 1 March of the year 0, in eras of 400 years; a year that begins in March has its leap day at its end.
    let days = days + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = 400 * era + year + u64::from(month <= 2);
    let (hour, minute, second) = (rest / 3600, rest / 60 % 60, rest % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

/// True if a text is a moment as Classroom 50 writes it.
pub fn is_datetime(text: &str) -> bool {
    let pattern = "dddd-dd-ddTdd:dd:ddZ";
    let fits = |(c, p): (char, char)| if p == 'd' { c.is_ascii_digit() } else { c == p };
    let number = |range| text.get(range).and_then(|n: &str| n.parse::<u32>().ok());
    text.len() == pattern.len()
        && text.chars().zip(pattern.chars()).all(fits)
        && number(5..7).is_some_and(|m| (1..=12).contains(&m))
        && number(8..10).is_some_and(|d| (1..=31).contains(&d))
        && number(11..13).is_some_and(|h| h < 24)
        && number(14..16).is_some_and(|m| m < 60)
        && number(17..19).is_some_and(|s| s < 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_in_utc() {
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_164_800, "2024-02-29T00:00:00Z"),
            (1_735_689_599, "2024-12-31T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(utc(seconds), text);
            assert!(is_datetime(text));
        }
        for text in [
            "",
            "2024-02-29",
            "2024-13-01T00:00:00Z",
            "2024-01-01T24:00:00Z",
        ] {
            assert!(!is_datetime(text), "{text}");
        }
    }
}
