//! Attempts: which of the scores of a student counts, where the platform tells the earlier ones.
//!
//! Gradescope writes them into `submission_metadata.json`: `previous_submissions`, each with its `score`, and with
//! `autograder_error` where the grader itself failed.
//! Source: <https://gradescope-autograders.readthedocs.io/en/latest/submission_metadata/>.

use serde::Deserialize;

use super::value::points;

/// Which attempts count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Attempts {
    /// Whether the best score counts, not the last one.
    #[serde(default)]
    pub best: bool,
    /// Attempts that count; after them the best one so far stays.
    #[serde(default)]
    pub most: Option<u32>,
}

/// The scores of the attempts before, in thousandths of a point.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct EarlierScores(Vec<u64>);

/// The score that counts, and why it is that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CountedScore {
    /// Thousandths of a point.
    pub score: u64,
    /// For the student.
    pub why: String,
}

#[derive(Deserialize)]
struct Metadata {
    #[serde(default)]
    previous_submissions: Vec<Earlier>,
}

#[derive(Deserialize)]
struct Earlier {
    /// Points, as a number or as its digits.
    #[serde(default)]
    score: Option<EarlierScore>,
    #[serde(default)]
    autograder_error: bool,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum EarlierScore {
    Number(f64),
    Digits(String),
}

impl EarlierScores {
    /// Reads `submission_metadata.json`. An attempt at which the grader failed counts for nothing.
    pub fn from_metadata(text: &str) -> Result<Self, String> {
        let metadata: Metadata = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let earlier = metadata.previous_submissions.into_iter();
        let scores = earlier
            .filter(|earlier| !earlier.autograder_error)
            .map(|earlier| {
                let score = match earlier.score {
                    Some(EarlierScore::Number(score)) => score,
                    Some(EarlierScore::Digits(digits)) => digits
                        .parse()
                        .map_err(|_| format!("`score` is {digits:?}, which is no number"))?,
                    None => 0.0,
                };
                // NaN and numbers below 0 become 0.
                Ok((score.max(0.0) * 1000.0).round() as u64)
            });
        scores.collect::<Result<_, String>>().map(Self)
    }
}

impl Attempts {
    /// The score that counts when this attempt earns `score`; none if it is that, and nothing is to be said.
    pub fn counted(self, score: u64, earlier: &EarlierScores) -> Option<CountedScore> {
        let best = earlier.0.iter().copied().max()?;
        let number = earlier.0.len() as u64 + 1;
        let most = self.most.map(u64::from);
        if let Some(most) = most.filter(|most| number > *most) {
            return Some(CountedScore {
                score: best,
                why: format!(
                    "Attempt {number}; {most} count. The best of the earlier ones counts: {} points.",
                    points(best)
                ),
            });
        }
        let is_kept = self.best && best > score;
        is_kept.then(|| CountedScore {
            score: best,
            why: format!("An earlier attempt counts: {} points.", points(best)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn earlier(scores: &str) -> EarlierScores {
        let text = format!("{{\"id\": 1, \"previous_submissions\": {scores}}}");
        EarlierScores::from_metadata(&text).expect("read")
    }

    #[test]
    fn the_best_counts_and_too_many_attempts_change_nothing() {
        let two = earlier(r#"[{"score": 2.5}, {"score": "1", "autograder_error": false}]"#);
        let rule = |best, most| Attempts { best, most };
        let score = |rule: Attempts, score| rule.counted(score, &two).map(|counted| counted.score);
        assert_eq!(score(rule(true, None), 2000), Some(2500));
        assert_eq!(score(rule(true, None), 3000), None);
        assert_eq!(score(rule(false, None), 2000), None);
        assert_eq!(score(rule(false, Some(3)), 2000), None);
        assert_eq!(score(rule(false, Some(2)), 3000), Some(2500));
        let none = earlier("[]");
        assert_eq!(rule(true, Some(1)).counted(2000, &none), None);
    }

    #[test]
    fn failures_of_the_grader_are_no_attempts() {
        let one = earlier(r#"[{"score": 4, "autograder_error": true}, {"score": null}]"#);
        assert_eq!(one, EarlierScores(vec![0]));
        for text in [
            "",
            "[1]",
            r#"{"previous_submissions": [{"score": "much"}]}"#,
        ] {
            assert!(EarlierScores::from_metadata(text).is_err(), "{text}");
        }
    }
}
