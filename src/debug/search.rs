//! Search of a picture for the pixels whose ray trees satisfy a query.

use crate::trace::TreeQuery;

/// Queries to begin with.
pub const READY: [&str; 8] = [
    "tir",
    "depth >= 3",
    "some(blocked:*)",
    "path:TT>*",
    "some(absent:min-weight)",
    "some(R and hit)",
    "luminance > 1",
    "miss",
];

/// A query, and the pixels that were found so far.
#[derive(Clone, Debug, PartialEq)]
pub struct QuerySearch {
    /// As it was typed.
    pub text: String,
    /// The query.
    pub query: TreeQuery,
    /// True if the first pixel that is found is to be shown.
    pub is_new: bool,
    width: u32,
    /// In the order of reading.
    pixels: Vec<(u32, u32)>,
    searched: u64,
    is_complete: bool,
}

impl QuerySearch {
    /// A search of a picture of this width. An error says what is wrong with the query.
    pub fn new(text: &str, width: u32) -> Result<Self, String> {
        let query: TreeQuery = text.parse().map_err(|error| format!("{error}"))?;
        Ok(Self {
            text: text.to_owned(),
            query,
            is_new: true,
            width,
            pixels: Vec::new(),
            searched: 0,
            is_complete: false,
        })
    }

    /// A search for the same query in another picture, of this width.
    #[must_use]
    pub fn again(&self, width: u32) -> Self {
        Self {
            width,
            pixels: Vec::new(),
            searched: 0,
            is_complete: false,
            is_new: false,
            ..self.clone()
        }
    }

    /// Takes in the pixels that were found among the next `searched` ones.
    pub fn add(&mut self, pixels: &[(u32, u32)], searched: u64) {
        self.pixels.extend_from_slice(pixels);
        self.searched += searched;
    }

    /// The whole picture was searched.
    pub fn finish(&mut self) {
        self.is_complete = true;
    }

    /// Whether a pixel satisfies the query; none if it was not searched yet.
    pub fn is_found(&self, at: (u32, u32)) -> Option<bool> {
        (self.place(at) < self.searched).then(|| {
            self.pixels
                .binary_search_by_key(&(at.1, at.0), |p| (p.1, p.0))
                .is_ok()
        })
    }

    /// The next pixel that was found behind one, or before it; from the last to the first.
    pub fn pixel(&self, from: (u32, u32), forward: bool) -> Option<(u32, u32)> {
        let here = self.place(from);
        let found = &self.pixels;
        let next = if forward {
            let behind = found.partition_point(|at| self.place(*at) <= here);
            found.get(behind).or(found.first())
        } else {
            let before = found.partition_point(|at| self.place(*at) < here);
            before.checked_sub(1).map_or(found.last(), |i| found.get(i))
        };
        next.copied()
    }

    /// What was found, with the number of the pixel at hand: "`tir`: pixel 3 of 41".
    pub fn told(&self, at: (u32, u32)) -> String {
        let count = self.pixels.len();
        let so_far = if self.is_complete { "" } else { " so far" };
        let number = self.pixels.iter().position(|p| *p == at);
        let text = &self.text;
        match (number, count) {
            (Some(number), _) => format!("`{text}`: pixel {} of {count}{so_far}", number + 1),
            (None, 0) if self.is_complete => format!("`{text}`: no pixel"),
            (None, 1) => format!("`{text}`: 1 pixel{so_far}"),
            (None, _) => format!("`{text}`: {count} pixels{so_far}"),
        }
    }

    /// The place of a pixel in the order of reading.
    fn place(&self, (x, y): (u32, u32)) -> u64 {
        u64::from(y) * u64::from(self.width) + u64::from(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_walked_in_the_order_of_reading_and_around() {
        let mut search = QuerySearch::new("tir", 10).expect("a query");
        assert_eq!(search.pixel((0, 0), true), None);
        assert_eq!(search.told((0, 0)), "`tir`: 0 pixels so far");
        search.add(&[(3, 0), (7, 1)], 20);
        search.add(&[(0, 2)], 10);
        assert_eq!(search.pixel((3, 0), true), Some((7, 1)));
        assert_eq!(search.pixel((9, 1), true), Some((0, 2)));
        assert_eq!(search.pixel((0, 2), true), Some((3, 0)));
        assert_eq!(search.pixel((7, 1), false), Some((3, 0)));
        assert_eq!(search.pixel((3, 0), false), Some((0, 2)));
        assert_eq!(search.is_found((7, 1)), Some(true));
        assert_eq!(search.is_found((8, 1)), Some(false));
        assert_eq!(search.is_found((8, 3)), None);
        search.finish();
        assert_eq!(search.told((7, 1)), "`tir`: pixel 2 of 3");
        assert_eq!(search.told((8, 1)), "`tir`: 3 pixels");
    }

    #[test]
    fn ready_queries_are_queries() {
        for text in READY {
            QuerySearch::new(text, 1).unwrap_or_else(|error| panic!("{text}: {error}"));
        }
        let error = QuerySearch::new("glas", 1).expect_err("no query");
        assert!(error.contains("letter 1"), "{error}");
    }
}
