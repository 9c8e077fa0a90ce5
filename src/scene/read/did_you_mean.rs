//! "Did you mean ...?": the name that comes closest to a wrong one.

/// Bytes of a word that is looked at: the table of letters grows with their square.
const LONGEST: usize = 100;

/// Names that are looked at, of the right length.
const MOST: usize = 1000;

/// The candidate that differs from `word` by the fewest letters, if it is near enough to be a slip of the hand: a
/// third of the letters at most.
pub fn did_you_mean<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    // No slip of the hand, and not worth the time.
    if word.len() > LONGEST {
        return None;
    }
    let allowed = (word.chars().count() / 3).clamp(1, 4);
    candidates
        .into_iter()
        .filter(|candidate| candidate.len().abs_diff(word.len()) <= 4 * allowed)
        .take(MOST)
        .map(|candidate| (distance(word, candidate), candidate))
        .filter(|&(d, _)| d <= allowed)
        .min_by_key(|&(d, _)| d)
        .map(|(_, candidate)| candidate)
}

/// Letters to insert, remove or replace to turn `a` into `b` (Levenshtein 1966), by Wagner and Fischer's table of
/// 1974, of which one row at a time is kept.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        // What stood to the left in the row before.
        let mut corner = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = corner + usize::from(!x.eq_ignore_ascii_case(y));
            corner = row[j + 1];
            row[j + 1] = replaced.min(corner + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_recognised_and_strangers_are_not() {
        let names = ["whitted", "mirrors", "room"];
        assert_eq!(did_you_mean("whited", names), Some("whitted"));
        assert_eq!(did_you_mean("Mirors", names), Some("mirrors"));
        assert_eq!(did_you_mean("teapot", names), None);
        assert_eq!(did_you_mean("", names), None);
        assert_eq!(distance("kitten", "sitting"), 3);
    }
}
