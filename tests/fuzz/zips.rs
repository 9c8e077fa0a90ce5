//! Zip archives made byte by byte, so that they can lie. PKWARE, .ZIP File Format Specification.

use std::io::Write as _;

use flate2::write::DeflateEncoder;
use flate2::{Compression, Crc};

/// An entry, which may say of itself what it is not.
pub struct Packed {
    pub name: Vec<u8>,
    /// As they stand in the archive.
    pub data: Vec<u8>,
    /// Bytes that it says it unpacks to.
    pub claimed: u32,
    pub sum: u32,
    /// 0: as they are, 8: deflate.
    pub method: u16,
    /// Kind and rights, as Unix has them.
    pub mode: u32,
}

impl Packed {
    /// An honest entry.
    pub fn new(name: &str, bytes: &[u8]) -> Self {
        let mut packer = DeflateEncoder::new(Vec::new(), Compression::best());
        packer.write_all(bytes).expect("a buffer takes everything");
        let mut sum = Crc::new();
        sum.update(bytes);
        Self {
            name: name.as_bytes().to_vec(),
            data: packer.finish().expect("a buffer takes everything"),
            claimed: bytes.len() as u32,
            sum: sum.sum(),
            method: 8,
            mode: 0o100_644,
        }
    }

    /// What stands in the description as well as before the data.
    fn common(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        // Version 2.0; names are UTF-8; time 0 of 1980-01-01.
        for number in [20, 1 << 11, self.method, 0, 0x21] {
            bytes.extend(u16::to_le_bytes(number));
        }
        for number in [self.sum, self.data.len() as u32, self.claimed] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend((self.name.len() as u16).to_le_bytes());
        bytes.extend([0, 0]);
        bytes
    }
}

/// The archive of these entries. With `overlapping` all of the same data stand at the place of the first.
pub fn archive(entries: &[Packed], overlapping: bool) -> Vec<u8> {
    let (mut zip, mut directory) = (Vec::new(), Vec::new());
    for (index, entry) in entries.iter().enumerate() {
        let at = if overlapping { 0 } else { zip.len() as u32 };
        if !overlapping || index == 0 {
            zip.extend(b"PK\x03\x04");
            zip.extend(entry.common());
            zip.extend(&entry.name);
            zip.extend(&entry.data);
        }
        // Made on Unix.
        directory.extend(b"PK\x01\x02\x14\x03");
        directory.extend(entry.common());
        directory.extend([0; 6]);
        directory.extend((entry.mode << 16).to_le_bytes());
        directory.extend(at.to_le_bytes());
        directory.extend(&entry.name);
    }
    let (start, length) = (zip.len() as u32, directory.len() as u32);
    zip.extend(directory);
    zip.extend(b"PK\x05\x06\0\0\0\0");
    for _ in 0..2 {
        zip.extend((entries.len() as u16).to_le_bytes());
    }
    zip.extend(length.to_le_bytes());
    zip.extend(start.to_le_bytes());
    zip.extend([0, 0]);
    zip
}
