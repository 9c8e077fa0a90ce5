//! Lines of a file, found quickly wherever one asks.

use std::sync::OnceLock;

/// Bytes between two places where the lines before are counted.
const STRIDE: usize = 1 << 16;

/// Lines of a file.
pub struct LineIndex<'a> {
    bytes: &'a [u8],
    /// Line ends before every stride; counted when the first error is met.
    before: OnceLock<Vec<usize>>,
}

impl<'a> LineIndex<'a> {
    /// The lines of these bytes.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            before: OnceLock::new(),
        }
    }

    /// Line and byte in the line of a place, both from 1.
    pub fn position(&self, at: usize) -> (usize, usize) {
        let at = at.min(self.bytes.len());
        let before = self.before.get_or_init(|| {
            let count = |chunk: &[u8]| memchr::memchr_iter(b'\n', chunk).count();
            let counts = self.bytes.chunks(STRIDE).map(count);
            let sums = counts.scan(0, |sum, count| Some(std::mem::replace(sum, *sum + count)));
            sums.collect()
        });
        let stride = at / STRIDE;
        let start = stride * STRIDE;
        let (sum, rest) = match before.get(stride) {
            Some(sum) => (*sum, &self.bytes[start..at]),
            // Behind the end.
            None => (
                memchr::memchr_iter(b'\n', &self.bytes[..at]).count(),
                &self.bytes[at..at],
            ),
        };
        let line = 1 + sum + memchr::memchr_iter(b'\n', rest).count();
        let line_start = memchr::memrchr(b'\n', &self.bytes[..at]).map_or(0, |end| end + 1);
        (line, at - line_start + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_lines_and_bytes_from_1() {
        let text = "ab\n\nc".to_owned() + &"\n0123456789".repeat(20_000);
        let lines = LineIndex::new(text.as_bytes());
        for at in [
            0,
            1,
            2,
            3,
            4,
            5,
            65_535,
            65_536,
            65_537,
            131_072,
            text.len() - 1,
            text.len(),
        ] {
            let before = &text[..at];
            let line = 1 + before.matches('\n').count();
            let column = at - before.rfind('\n').map_or(0, |end| end + 1) + 1;
            assert_eq!(lines.position(at), (line, column), "{at}");
        }
        assert_eq!(lines.position(usize::MAX), lines.position(text.len()));
    }
}
