//! Meshes as OBJ files.

use std::io::{BufWriter, Write};

use raytree::geometry::Triangle;
use tempfile::NamedTempFile;

/// A file that is gone when it is let go. Corners that two triangles share are written once.
pub fn written(triangles: &[Triangle]) -> NamedTempFile {
    let file = tempfile::Builder::new().suffix(".obj").tempfile();
    let file = file.expect("a place for files");
    let mut out = BufWriter::new(&file);
    let mut numbers = std::collections::HashMap::new();
    let mut write = |line: String| out.write_all(line.as_bytes()).expect("room on the disk");
    for triangle in triangles {
        let corners = triangle.corners.map(|p| {
            let next = numbers.len() + 1;
            *numbers
                .entry(p.to_array().map(f64::to_bits))
                .or_insert_with(|| {
                    write(format!("v {:.6} {:.6} {:.6}\n", p.x, p.y, p.z));
                    next
                })
        });
        write(format!("f {} {} {}\n", corners[0], corners[1], corners[2]));
    }
    out.flush().expect("room on the disk");
    drop(out);
    file
}
