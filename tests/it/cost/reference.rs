//! Pictures that others are measured against: whatever file is named, the answer is clear and comes in time.

use std::process::Command;

use super::{cost, json, sweep};

#[test]
fn a_picture_from_a_file_is_what_it_is_measured_against() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).display().to_string();
    let of = ["triangle", "--samples", "4", "--sampling", "regular"];
    for (file, nearest) in [("a.pfm", 1e-7), ("a.png", 3e-3)] {
        let path = place(file);
        let rendered = Command::new(env!("CARGO_BIN_EXE_raytree"))
            .arg("render")
            .args([&of[..], &["--size", "16x12", "-o", &path]].concat())
            .status();
        assert!(rendered.expect("runs").success());
        let args = ["triangle", "--runs", "1", "--most", "4", "--reference"];
        let args = [&args[..], &[&path, "--knob", "pixel-samples-regular"]].concat();
        let document = json(&args);
        let steps = &sweep(&document, "pixel samples, regular")["steps"];
        let rmse = |step: usize| steps[step]["errors"]["rmse"].as_f64().expect("a number");
        assert!(rmse(1) < nearest && rmse(0) > 5.0 * nearest, "{steps:#}");
        let again = document["again"].as_str().expect("a command");
        assert!(
            again.contains("--size 16x12") && again.contains(&path),
            "{again}"
        );
        // Of another size.
        let out = cost(&[&args[..], &["--size", "12x16"]].concat());
        let said = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(1));
        let wanted = "has 16x12 pixels, and the pictures are to have 12x16";
        assert!(said.contains(file) && said.contains(wanted), "{said}");
    }
    // No picture, and a file that is not there.
    let text = place("a.txt");
    std::fs::write(&text, "PNG?").expect("room on the disk");
    std::fs::write(place("b.png"), b"\x89PNG\r\n\x1a\n????").expect("room on the disk");
    for (file, wanted) in [
        (text, "neither a PFM nor a PNG"),
        (place("b.png"), "is no PNG file that can be read"),
        (place("no.pfm"), "there is no such file"),
    ] {
        let out = cost(&["triangle", "--reference", &file]);
        let said = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(1));
        assert!(said.contains(wanted), "{said}");
    }
}

/// The first bytes of a PNG file that claims this size, and no more.
fn claimed(width: u32, height: u32) -> Vec<u8> {
    let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut chunk = |kind: &[u8], data: &[u8]| {
        png.extend((data.len() as u32).to_be_bytes());
        png.extend(kind);
        png.extend(data);
        png.extend(crc([kind, data].concat()).to_be_bytes());
    };
    let edges = [width.to_be_bytes(), height.to_be_bytes()].concat();
    chunk(b"IHDR", &[&edges[..], &[8, 2, 0, 0, 0]].concat());
    chunk(b"IDAT", &[0; 64]);
    png
}

/// The check sum of PNG files. Source: Portable Network Graphics, appendix D.
fn crc(bytes: Vec<u8>) -> u32 {
    let step = |crc: u32, byte: u8| {
        (0..8).fold(crc ^ u32::from(byte), |c, _| {
            if c & 1 == 1 {
                0xedb8_8320 ^ (c >> 1)
            } else {
                c >> 1
            }
        })
    };
    !bytes.into_iter().fold(!0, step)
}

/// A reference is read with the care of scene files: whatever it is, the answer comes at once.
#[test]
fn a_reference_that_takes_too_long_is_refused_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).display().to_string();
    let refused = |file: &str, more: &[&str], code: i32, wanted: &str| {
        let start = std::time::Instant::now();
        let out = cost(&[&["triangle", "--budget", "1", "--reference", file], more].concat());
        let said = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(code), "{said}");
        assert!(said.contains(wanted), "{said}");
        assert!(
            start.elapsed() < std::time::Duration::from_secs(5),
            "{file}: {:?}",
            start.elapsed()
        );
    };
    std::fs::write(place("large.png"), claimed(16_384, 4_096)).expect("room on the disk");
    std::fs::write(place("large.pfm"), "PF\n16384 4096\n-1\n").expect("room on the disk");
    for file in ["large.png", "large.pfm"] {
        refused(
            &place(file),
            &[],
            1,
            "16384x4096 pixels; what is measured has 4194304 at most",
        );
        refused(
            &place(file),
            &["--size", "8x6"],
            1,
            "has 16384x4096 pixels, and the pictures are to have 8x6",
        );
    }
    refused(&place(""), &[], 1, "this is a folder");
    #[cfg(unix)]
    {
        let pipe = place("pipe");
        let made = Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("mkfifo").success());
        for file in [&pipe, "/dev/zero"] {
            refused(file, &[], 1, "not a regular file");
        }
    }
}

#[test]
fn a_budget_without_time_for_one_picture_is_refused() {
    let start = std::time::Instant::now();
    let out = cost(&["whitted", "--budget", "0.1", "--size", "16384x4096"]);
    let said = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{said}");
    assert!(
        said.contains("--budget 0.1: one picture of 16384x4096 takes about"),
        "{said}"
    );
    assert!(
        start.elapsed() < std::time::Duration::from_secs(10),
        "{:?}",
        start.elapsed()
    );
}
