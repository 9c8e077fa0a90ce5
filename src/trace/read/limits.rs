//! How much a document may hold. Beyond a limit that pixel is broken, and no other.

/// Bytes of a file.
pub const MAX_TREE_FILE_BYTES: usize = 64 << 20;
/// Bytes of a document that stands on one line.
pub const MAX_LINE_BYTES: usize = 16 << 20;
/// Brackets inside of brackets: two a ray and a few.
pub const MAX_BRACKETS: usize = 2100;
/// Bytes of a text.
pub const MAX_TEXT_BYTES: usize = 64 << 10;
/// Values of a document, the names of its fields included.
pub const MAX_VALUES: usize = 8 << 20;
/// Rays of a pixel.
pub const MAX_RAYS: usize = 100_000;
/// Rays that one hit sends.
pub const MAX_CHILDREN: usize = 70_000;
/// Rays between a ray and the eye.
pub const MAX_RAY_DEPTH: usize = MAX_BRACKETS / 2;
/// Steps of the paths of all rays of a pixel together: paths take memory.
pub const MAX_STEPS: usize = 4_000_000;
/// Pixels of a file.
pub const MAX_DOCUMENTS: usize = 100_000;
/// Rays of a file.
pub const MAX_FILE_RAYS: usize = 1_000_000;
/// Errors of a file: beyond, the rest is left.
pub const MAX_ERRORS: usize = 1000;
/// Problems of a pixel that are told; further ones are counted.
pub const MAX_PROBLEMS: usize = 20;

/// The limits as the book tells them: what is limited, to how much, and what is lost beyond.
pub fn table() -> Vec<[String; 3]> {
    const PIXEL: &str = "that pixel";
    let mebibytes = |bytes: usize| format!("{} MiB", bytes >> 20);
    let rows: [(&str, String, &str); 12] = [
        (
            "a file of trees",
            mebibytes(MAX_TREE_FILE_BYTES),
            "the file",
        ),
        ("a line", mebibytes(MAX_LINE_BYTES), PIXEL),
        ("brackets inside brackets", MAX_BRACKETS.to_string(), PIXEL),
        ("a text", format!("{} KiB", MAX_TEXT_BYTES >> 10), PIXEL),
        (
            "values of a document, names of fields included",
            MAX_VALUES.to_string(),
            PIXEL,
        ),
        ("rays of a pixel", MAX_RAYS.to_string(), PIXEL),
        ("rays that a hit sends", MAX_CHILDREN.to_string(), PIXEL),
        (
            "rays between a ray and the eye",
            MAX_RAY_DEPTH.to_string(),
            PIXEL,
        ),
        (
            "steps of the paths of all rays of a pixel",
            MAX_STEPS.to_string(),
            PIXEL,
        ),
        (
            "pixels of a file",
            MAX_DOCUMENTS.to_string(),
            "the rest of the file",
        ),
        (
            "rays of a file",
            MAX_FILE_RAYS.to_string(),
            "the rest of the file",
        ),
        (
            "errors of a file",
            MAX_ERRORS.to_string(),
            "the rest of the file",
        ),
    ];
    rows.map(|(what, most, beyond)| [what.to_owned(), most, beyond.to_owned()])
        .to_vec()
}
