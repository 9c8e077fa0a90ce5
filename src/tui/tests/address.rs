//! The debugger opened at an address.

use super::support::{app_with, settle, text};
use crate::trace::Address;

fn opened_at(address: &str, size: Option<(u32, u32)>) -> String {
    let address: Address = address.parse().expect("an address");
    let mut app = app_with(150, 40, |options| {
        options.at = Some(address);
        options.size = size;
    });
    settle(&mut app);
    text(&app)
}

#[test]
fn the_tree_of_a_pixel_is_open_at_its_ray() {
    let size = Some((320, 240));
    let eye = opened_at("160,120", size);
    assert!(
        eye.contains("pixel 160,120") && eye.contains("I: a ray from the eye"),
        "{eye}"
    );
    let reflected = opened_at("160,120/R", size);
    assert!(
        reflected.contains("pixel 160,120") && reflected.contains("R: the reflected ray"),
        "{reflected}"
    );
    let event = opened_at("160,120#7", size);
    assert!(event.contains("event 7 of"), "{event}");
}

#[test]
fn what_is_not_there_is_told_on_the_screen() {
    let missing = opened_at("160,120/L:moon", Some((320, 240)));
    assert!(
        missing.contains("there is no step L:moon from the eye ray"),
        "{missing}"
    );
    assert!(
        missing.contains("ray tree:"),
        "the tree is open all the same\n{missing}"
    );
    let outside = opened_at("900,120/T", None);
    assert!(
        outside.contains("pixel 900,120 is outside the picture of"),
        "{outside}"
    );
    assert!(!outside.contains("event 0 of"), "{outside}");
}
