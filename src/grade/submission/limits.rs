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
