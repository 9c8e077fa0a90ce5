//! Samples of a pixel as a table: where on the film each is, what it brings, what of that is the pixel.

use super::session::Session;
use crate::trace::explain::UNKNOWN;
use crate::trace::format::{counted, num, rgb};

/// Samples that are listed at most.
const LISTED: usize = 1000;

/// The samples of a pixel in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SampleTable {
    /// How many there are, and their sum.
    pub head: String,
    /// The number of each, and what it brings.
    pub lines: Vec<(u32, String)>,
}

/// A line a sample, and their sum.
pub fn samples(session: &Session) -> SampleTable {
    let tree = session.tree();
    let mut lines = Vec::new();
    for sample in tree.samples.iter().take(LISTED) {
        let (number, weight) = (sample.index, num(sample.weight));
        let [x, y] = sample.film.map(num);
        let what = match sample.root {
            Some(root) if !session.trace.is_whole() && !tree.is_done(root) => {
                format!("at ({x}, {y}): weight {weight} x radiance {UNKNOWN}")
            }
            Some(root) => {
                let node = tree.node(root);
                format!(
                    "at ({x}, {y}), {}: weight {weight} x radiance {} = {}",
                    counted(u64::from(node.size), "ray"),
                    rgb(node.radiance),
                    rgb(node.radiance * sample.weight)
                )
            }
            None if !session.trace.is_whole() => {
                format!("at ({x}, {y}): weight {weight} x radiance {UNKNOWN}")
            }
            None => format!("at ({x}, {y}), weight {weight}: the log was full"),
        };
        lines.push((number, format!(":{number}  {what}")));
    }
    let count = counted(tree.samples.len() as u64, "sample");
    let more = match tree.samples.len() - lines.len() {
        0 => String::new(),
        more => format!(", the last {more} of them not listed"),
    };
    if !session.trace.is_whole() {
        return SampleTable {
            head: format!("{count}{more} by now. The pixel: {UNKNOWN}"),
            lines,
        };
    }
    let sum = rgb(session.trace.pixel.color);
    SampleTable {
        head: format!("{count}{more}. Their sum is the pixel: {sum}"),
        lines,
    }
}
