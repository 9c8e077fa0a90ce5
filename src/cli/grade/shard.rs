//! A part of the submissions, for one machine of many.

use std::str::FromStr;

/// Part `number` of `count`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 1.
    pub number: usize,
    /// At least 1.
    pub count: usize,
}

impl Shard {
    /// Its part of all: parts follow each other, and their lengths differ by one at most.
    pub fn of<T>(self, all: &[T]) -> &[T] {
        let start = |number: usize| number * all.len() / self.count;
        &all[start(self.number - 1)..start(self.number)]
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text
            .split_once('/')
            .and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
        match numbers {
            Some((number, count)) if (1..=count).contains(&number) && count <= 1_000_000 => {
                Ok(Self { number, count })
            }
            _ => Err(format!(
                "`{text}` is no shard; write K/N with K from 1 to N, such as 2/8"
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_are_all_in_order_and_nothing_twice() {
        for length in [0, 1, 2, 3, 7, 100] {
            let all: Vec<usize> = (0..length).collect();
            for count in 1..9 {
                let parts = (1..=count).map(|number| Shard { number, count }.of(&all));
                let parts: Vec<&[usize]> = parts.collect();
                assert_eq!(parts.concat(), all);
                let longest = parts.iter().map(|p| p.len()).max().unwrap_or(0);
                let shortest = parts.iter().map(|p| p.len()).min().unwrap_or(0);
                assert!(longest - shortest <= 1);
            }
        }
        for text in ["", "1", "0/2", "3/2", "1/0", "a/b", "-1/2"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }
}
