//! How much may be handed in. What is beyond is refused and named, and the rest is read.

/// Bytes of a file, and of an archive.
pub const MAX_SUBMITTED_BYTES: u64 = 64 << 20;
/// Bytes of all files of a submission together, unpacked.
pub const MAX_UNPACKED_BYTES: u64 = 256 << 20;
/// Files of a submission.
pub const MAX_FILES: usize = 2000;
/// Entries of folders and archives that are looked at.
pub const MAX_ENTRIES: usize = 10_000;
/// Folders inside of folders.
pub const MAX_FOLDERS: usize = 32;
/// Bytes of a path.
pub const MAX_PATH_BYTES: usize = 200;
/// Bytes that a byte of an archive may become.
pub const MAX_RATIO: u64 = 200;
/// Bytes that an entry may have whatever it was packed to: a black picture packs well.
pub const SMALL_ENTRY_BYTES: u64 = 1 << 20;
/// Problems that are told; further ones are counted.
pub const MAX_TOLD: usize = 100;

/// The limits as the book tells them: what is limited, to how much, and what is lost beyond.
pub fn table() -> Vec<[String; 3]> {
    const FILE: &str = "that file";
    let mebibytes = |bytes: u64| format!("{} MiB", bytes >> 20);
    let rows: [(&str, String, &str); 7] = [
        (
            "a file of a submission, or an archive",
            mebibytes(MAX_SUBMITTED_BYTES),
            FILE,
        ),
        (
            "all files of a submission, unpacked",
            mebibytes(MAX_UNPACKED_BYTES),
            FILE,
        ),
        ("files of a submission", MAX_FILES.to_string(), FILE),
        (
            "entries of a folder or an archive",
            MAX_ENTRIES.to_string(),
            "the others; an archive is not opened",
        ),
        (
            "folders inside folders",
            MAX_FOLDERS.to_string(),
            "that folder",
        ),
        (
            "a path in a submission",
            format!("{MAX_PATH_BYTES} bytes"),
            FILE,
        ),
        (
            "bytes that a byte of an archive becomes",
            MAX_RATIO.to_string(),
            FILE,
        ),
    ];
    rows.map(|(what, most, beyond)| [what.to_owned(), most, beyond.to_owned()])
        .to_vec()
}
