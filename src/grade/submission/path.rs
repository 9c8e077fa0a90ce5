//! Paths in what is handed in: which are taken, and how they are written here.

use super::limits::MAX_PATH_BYTES;

/// A path as it is written here, with `/` between folders and nothing else before a name; or why it is refused.
pub fn cleaned(path: &[u8]) -> Result<String, &'static str> {
    let text = str::from_utf8(path).map_err(|_| "its name is not UTF-8")?;
    if text.len() > MAX_PATH_BYTES {
        return Err("its name has more than 200 bytes");
    }
    // Old programs on Windows pack `\`.
    let text = text.replace('\\', "/");
    if text.starts_with('/') {
        return Err("its path starts at the root of a disk");
    }
    if text.chars().any(char::is_control) {
        return Err("its name has a control character");
    }
    let parts: Vec<&str> = text
        .split('/')
        .filter(|part| !matches!(*part, "" | "."))
        .collect();
    if parts.contains(&"..") {
        return Err("its path leads out of its folder with `..`");
    }
    if parts.iter().any(|part| part.contains(':')) {
        return Err("its path has a colon, as drives of Windows have");
    }
    if parts.is_empty() {
        return Err("it has no name");
    }
    Ok(parts.join("/"))
}

/// True for what systems and tools put beside files: hidden files, and what macOS packs.
pub fn is_hidden(path: &str) -> bool {
    path.split('/')
        .any(|part| part.starts_with('.') || part == "__MACOSX")
}

/// True for a zip archive, by its first bytes or its name.
pub fn is_zip(file_name: &str, bytes: &[u8]) -> bool {
    archive_kind(file_name, bytes) == Some("zip")
}

/// The kind of an archive, by its first bytes or its name.
pub fn archive_kind(path: &str, bytes: &[u8]) -> Option<&'static str> {
    const SIGNS: [(&[u8], &str); 6] = [
        (b"PK\x03\x04", "zip"),
        (b"PK\x05\x06", "zip"),
        (b"\x1f\x8b", "gzip"),
        (b"7z\xbc\xaf\x27\x1c", "7z"),
        (b"Rar!", "rar"),
        (b"\xfd7zXZ", "xz"),
    ];
    const ENDINGS: [&str; 9] = ["zip", "gz", "tgz", "7z", "rar", "xz", "tar", "bz2", "zst"];
    let sign = SIGNS.iter().find(|(sign, _)| bytes.starts_with(sign));
    let ending = path
        .rsplit_once('.')
        .map_or("", |(_, ending)| ending)
        .to_ascii_lowercase();
    let by_name = ENDINGS.into_iter().find(|known| *known == ending);
    sign.map(|(_, kind)| *kind).or(by_name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_inside() {
        for (path, clean) in [
            ("a.json", "a.json"),
            ("./a//b.png", "a/b.png"),
            ("a\\b", "a/b"),
            ("..a/b..", "..a/b.."),
            ("ü/☃", "ü/☃"),
        ] {
            assert_eq!(cleaned(path.as_bytes()).as_deref(), Ok(clean));
        }
        let long = "a".repeat(201);
        for bad in [
            "",
            ".",
            "/",
            "/etc/passwd",
            "\\\\server\\a",
            "C:\\a",
            "c:a",
            "a/../b",
            "..",
            "a/..\\b",
            "a\0b",
            "a\nb",
            &long,
        ] {
            assert!(cleaned(bad.as_bytes()).is_err(), "{bad:?}");
        }
        assert!(cleaned(b"\xff.json").is_err());
        assert!(
            is_hidden(".git/a")
                && is_hidden("a/.DS_Store")
                && is_hidden("__MACOSX/._a")
                && !is_hidden("a/b.c")
        );
    }
}
