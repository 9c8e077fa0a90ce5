//! A zip archive that was handed in. Its entries are read into memory; nothing is unpacked onto the disk, and nothing that its
//! headers say of sizes is believed.

use std::cell::Cell;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::rc::Rc;

use zip::ZipArchive;
use zip::read::ZipFile;

use super::gather::Gathered;
use super::limits::MAX_ENTRIES;
use crate::scene::printable::excerpt;

/// Where the description of an entry begins (PKWARE, .ZIP File Format Specification, 4.3.12).
const ENTRY: &[u8] = b"PK\x01\x02";

/// Bytes in memory that count how many of them were read.
struct CountedBytes<'a> {
    bytes: Cursor<&'a [u8]>,
    read: Rc<Cell<u64>>,
}

impl Read for CountedBytes<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let length = self.bytes.read(buffer)?;
        self.read.set(self.read.get() + length as u64);
        Ok(length)
    }
}

impl Seek for CountedBytes<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(to)
    }
}

/// Reads all files of an archive.
pub fn read_archive(bytes: &[u8], gathered: &mut Gathered) {
    // Each entry takes memory before the first is read.
    let signs = memchr::memmem::find_iter(bytes, ENTRY);
    if signs.take(MAX_ENTRIES + 1).count() > MAX_ENTRIES {
        gathered.tell(format!(
            "the archive has more than {MAX_ENTRIES} entries, and is not opened"
        ));
        return;
    }
    let read = Rc::new(Cell::new(0));
    let counted = CountedBytes {
        bytes: Cursor::new(bytes),
        read: Rc::clone(&read),
    };
    let mut archive = match ZipArchive::new(counted) {
        Ok(archive) => archive,
        Err(e) => {
            let why = excerpt(&e.to_string());
            gathered.tell(format!(
                "the archive cannot be read ({why}); pack it again as a .zip"
            ));
            return;
        }
    };
    if archive.has_duplicate_names() {
        gathered.tell("the archive has two entries of one name; one of them is read".to_owned());
    }
    let names: Vec<Vec<u8>> = archive.file_names_raw().map(<[u8]>::to_vec).collect();
    for (index, path) in names.iter().enumerate() {
        if !gathered.counts() {
            return;
        }
        match archive.by_index(index) {
            Ok(file) => read_entry(file, path, &read, gathered),
            Err(e) => gathered.refuse(
                path,
                &format!("it cannot be unpacked ({})", excerpt(&e.to_string())),
            ),
        }
    }
}

fn read_entry<R: Read>(
    mut file: ZipFile<'_, R>,
    path: &[u8],
    read: &Cell<u64>,
    gathered: &mut Gathered,
) {
    if path.ends_with(b"/") || path.ends_with(b"\\") {
        // A folder, which its files name again.
        return;
    }
    if let Some(why) = special(&file) {
        gathered.refuse(path, why);
        return;
    }
    let Some(name) = gathered.wanted(path) else {
        return;
    };
    let before = read.get();
    match gathered.read(&mut file, || Some(read.get() - before)) {
        Ok(bytes) => gathered.take(name, bytes),
        Err(why) => gathered.refuse(path, &why),
    }
}

/// Why an entry is none that is read: it is no regular file.
fn special<R: Read>(file: &ZipFile<'_, R>) -> Option<&'static str> {
    const KIND: u32 = 0o170_000;
    const REGULAR: u32 = 0o100_000;
    if file.is_symlink() {
        return Some("it is a link; hand in the file itself");
    }
    match file.unix_mode().map(|mode| mode & KIND) {
        None | Some(0 | REGULAR) => None,
        Some(_) => Some("it is no regular file"),
    }
}
