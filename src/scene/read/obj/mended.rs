//! The mended text of an OBJ file, as `tobj` reads it: a piece at a time, which the check makes on a thread of its own, some
//! pieces ahead of the reader.

use std::io::{self, BufRead, Read};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use super::check::Checked;
use crate::scene::read::error::Problem;
use crate::scene::read::text::Lines;

/// Bytes of mended text after which a piece ends.
const PIECE: usize = 1 << 15;

/// Pieces that the check is ahead of the reader at most.
const AHEAD: usize = 8;

/// Why a file is refused, and its line.
type Refused = (usize, Problem);

/// Gives the mended text of a file to `read`. What the check found in all of it, and what `read` made of it.
pub fn read_mended<T>(
    text: &str,
    read: impl FnOnce(&mut MendedText) -> T,
) -> (Result<Checked, Refused>, T) {
    let (sender, pieces) = sync_channel(AHEAD);
    thread::scope(|scope| {
        let checker = scope.spawn(move || mend(text, &sender));
        let mut mended = MendedText {
            pieces,
            piece: String::new(),
            at: 0,
        };
        let made = read(&mut mended);
        // Whoever stops early lets the check end, too.
        drop(mended);
        let checked = checker.join();
        let checked = checked.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        (checked, made)
    })
}

/// Checks all lines, and sends their mended text in pieces. An error ends the text; so does a reader who is gone.
fn mend(text: &str, pieces: &SyncSender<String>) -> Result<Checked, Refused> {
    let mut checked = Checked::new(text);
    for (number, line) in Lines::new(text) {
        checked
            .read(number, &line)
            .map_err(|problem| (number, problem))?;
        if checked.text.len() >= PIECE && pieces.send(checked.take_text()).is_err() {
            return Ok(checked);
        }
    }
    checked.end();
    // If nobody reads it, it is not needed.
    let _ = pieces.send(checked.take_text());
    Ok(checked)
}

/// The reader's end of the mended text.
pub struct MendedText {
    pieces: Receiver<String>,
    /// The piece at hand, and how much of it is read.
    piece: String,
    at: usize,
}

impl BufRead for MendedText {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.at >= self.piece.len() {
            self.piece = self.pieces.recv().unwrap_or_default();
            self.at = 0;
        }
        Ok(&self.piece.as_bytes()[self.at..])
    }

    fn consume(&mut self, bytes: usize) {
        self.at += bytes;
    }
}

impl Read for MendedText {
    fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
        let bytes = self.fill_buf()?.read(place)?;
        self.consume(bytes);
        Ok(bytes)
    }
}
