//! Samples of a pixel as a table: where on the film each is, what it brings, what of that is the pixel.

use std::fmt::Write as _;

use super::session::Session;
use crate::trace::format::{counted, num, rgb};

/// Samples that are listed at most.
const LISTED: usize = 1000;

/// A line a sample, and their sum.
pub fn samples(session: &Session) -> String {
    let tree = session.tree();
    let mut text = format!("{}\n", counted(tree.samples.len() as u64, "sample"));
    for sample in tree.samples.iter().take(LISTED) {
        let (number, weight) = (sample.index, num(sample.weight));
        let [x, y] = sample.film.map(num);
        let Some(root) = sample.root else {
            let _ = writeln!(
                text,
                "  :{number}  at ({x}, {y}), weight {weight}: the log was full"
            );
            continue;
        };
        let node = tree.node(root);
        let brought = node.radiance * sample.weight;
        let rays = counted(u64::from(node.size), "ray");
        let _ = writeln!(
            text,
            "  :{number}  at ({x}, {y}), {rays}: weight {weight} x radiance {} = {}",
            rgb(node.radiance),
            rgb(brought)
        );
    }
    if tree.samples.len() > LISTED {
        let more = tree.samples.len() - LISTED;
        let _ = writeln!(text, "  and {more} more");
    }
    let _ = writeln!(text, "sum: the pixel is {}", rgb(session.trace.pixel.color));
    let _ = writeln!(
        text,
        "`:` and the number, such as :2, opens the tree of a sample"
    );
    text
}
