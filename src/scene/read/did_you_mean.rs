//! "Did you mean ...?": the known name that is closest to a misspelt one.

/// Bytes of a word that is compared: the time grows with their square.
const LONGEST: usize = 100;

/// Names of about the right length that are compared.
const MOST: usize = 1000;

/// The candidate that is closest to `word`, upper and lower case alike: at most a third of the letters inserted,
/// removed, replaced or swapped with the next (restricted Damerau-Levenshtein distance).
pub fn did_you_mean<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    if word.len() > LONGEST {
        return None;
    }
    let allowed = (word.chars().count() / 3).clamp(1, 4);
    let word = word.to_ascii_lowercase();
    candidates
        .into_iter()
        .filter(|candidate| candidate.len().abs_diff(word.len()) <= 4 * allowed)
        .take(MOST)
        .map(|candidate| {
            let distance = strsim::osa_distance(&word, &candidate.to_ascii_lowercase());
            (distance, candidate)
        })
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn misspelt_names_are_recognised_and_others_are_not() {
        let names = ["whitted", "mirrors", "room"];
        assert_eq!(did_you_mean("whited", names), Some("whitted"));
        assert_eq!(did_you_mean("Mirors", names), Some("mirrors"));
        assert_eq!(did_you_mean("orom", names), Some("room"));
        assert_eq!(did_you_mean("teapot", names), None);
        assert_eq!(did_you_mean("", names), None);
    }
}
