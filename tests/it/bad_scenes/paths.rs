//! Files that are missing, are no files, or lie where they must not.

use std::fs;

use raytree::scene::load;

use super::{CORNERS, Folder, OBJ, assert_says, loaded, with_obj};

#[test]
fn folder_instead_of_file() {
    let folder = Folder::new(&[]);
    fs::create_dir(folder.path("a.json")).expect("a folder");
    let message = folder.load("a.json").expect_err("a folder");
    assert_says(&message, &["a.json: this is a folder", ".json or .obj"]);
}

#[test]
fn missing_file() {
    let message = Folder::new(&[]).load("a.json").expect_err("missing");
    assert_says(
        &message,
        &["a.json: there is no such file", "check the spelling"],
    );
}

#[cfg(unix)]
#[test]
fn device_instead_of_file() {
    let folder = Folder::new(&[]);
    std::os::unix::fs::symlink("/dev/zero", folder.path("a.json")).expect("a link");
    let message = folder.load("a.json").expect_err("a device");
    assert_says(&message, &["not a regular file"]);
}

#[test]
fn unknown_scene() {
    let message = load("whited").expect_err("unknown").to_string();
    assert_says(
        &message,
        &[
            "whited: there is no built-in scene",
            "did you mean `whitted`?",
            "bunny",
            ".json or .obj",
        ],
    );
    let folder = Folder::new(&[("a.txt", b"x")]);
    assert_says(
        &folder.load("a.txt").expect_err("unknown"),
        &["ends in .json"],
    );
}

#[test]
fn missing_obj() {
    let message = loaded(OBJ, &[]).expect_err("missing");
    assert_says(
        &message,
        &[
            "objects[0].obj.file",
            "no file `m.obj`",
            "the folder of the scene",
        ],
    );
}

#[test]
fn obj_path_outside_the_folder() {
    for path in ["/etc/passwd", "../m.obj", "a/../../m.obj", "a\\\\m.obj", ""] {
        let message = loaded(&OBJ.replace("m.obj", path), &[]).expect_err(path);
        assert_says(
            &message,
            &["objects[0].obj.file", "copy the file into the folder"],
        );
    }
}

#[test]
fn mtllib_outside_the_folder() {
    for path in ["/etc/passwd", "../x.mtl", "a/../../x.mtl", "a\\x.mtl"] {
        let scene = with_obj(&format!("mtllib {path}\n{CORNERS}f 1 2 3\n")).expect(path);
        assert_says(
            &scene.warnings[0].to_string(),
            &["m.obj:1:", path, "into the folder"],
        );
    }
}

#[cfg(unix)]
#[test]
fn mtllib_that_is_a_link_out_of_the_folder() {
    let outside = Folder::new(&[("x.mtl", b"newmtl a\nKd 1 1 1\n")]);
    let obj = format!("mtllib x.mtl\n{CORNERS}f 1 2 3\n");
    let folder = Folder::new(&[("m.obj", obj.as_bytes())]);
    std::os::unix::fs::symlink(outside.path("x.mtl"), folder.path("x.mtl")).expect("a link");
    let scene = folder.load("m.obj").expect("drawn without");
    assert_eq!(scene.materials.len(), 1);
    assert_says(
        &scene.warnings[0].to_string(),
        &["m.obj:1:", "link", "outside the scene's folder"],
    );
    // A link that stays inside is followed.
    fs::remove_file(folder.path("x.mtl")).expect("the link");
    fs::write(folder.path("y.mtl"), "newmtl a\nKd 1 1 1\n").expect("a file");
    std::os::unix::fs::symlink("y.mtl", folder.path("x.mtl")).expect("a link");
    assert!(folder.load("m.obj").is_ok_and(|s| s.warnings.is_empty()));
}
