//! Files with bytes changed: bits flipped, pieces cut out, put in again, or taken from another file.

use super::dice::Dice;

/// What tends to trip readers.
const PIECES: [&[u8]; 24] = [
    b"\xef\xbb\xbf",
    b"\0",
    b"\r\n",
    b"\r",
    b"\xff",
    b"\xc3",
    b"\xed\xa0\x80",
    b"\\",
    b"\"",
    b"{",
    b"}",
    b"[",
    b"]",
    b",",
    b"1e309",
    b"-",
    b"99999999999999999999",
    b"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
    b"null",
    b"\\u0000",
    b"\\ud800",
    b"#",
    b"e",
    b"\x1b[2J",
];

/// Changes a file in place, a few times.
pub fn change(dice: &mut Dice, file: &mut Vec<u8>, other: &[u8]) {
    for _ in 0..=dice.few(8) {
        one_change(dice, file, other);
    }
    // Copies of copies grow; a megabyte would be no better than a kilobyte.
    file.truncate(16 << 10);
}

fn one_change(dice: &mut Dice, file: &mut Vec<u8>, other: &[u8]) {
    let at = dice.below(file.len() + 1);
    let longest = 1 << dice.below(9);
    let end = (at + dice.below(longest)).min(file.len());
    match dice.below(9) {
        0 if at < file.len() => file[at] ^= 1 << dice.below(8),
        1 if at < file.len() => file[at] = dice.below(256) as u8,
        2 => drop(file.drain(at..end)),
        3 => file.truncate(at),
        4 => drop(file.splice(at..at, PIECES[dice.below(PIECES.len())].iter().copied())),
        // A piece of it again, once or many times.
        5 => {
            let piece = file[at..end].to_vec();
            let times = 1 + dice.few(50);
            drop(file.splice(at..at, piece.repeat(times)));
        }
        6 => {
            let start = dice.below(other.len() + 1);
            let stop = (start + dice.below(100)).min(other.len());
            drop(file.splice(at..end, other[start..stop].iter().copied()));
        }
        // One digit for another: most of them stay good numbers.
        7 => {
            if let Some(digit) = file[at..].iter_mut().find(|b| b.is_ascii_digit()) {
                *digit = b"0123456789-.eE"[dice.below(14)];
            }
        }
        _ => {
            // All line ends at once.
            let ends: &[u8] = if dice.one_in(2) { b"\r\n" } else { b"\r" };
            if dice.one_in(8) {
                *file = file.split(|b| *b == b'\n').collect::<Vec<_>>().join(ends);
            }
        }
    }
}
