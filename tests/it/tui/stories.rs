//! The stories that the debugger is for, typed on a terminal.

use super::Session;

/// The first pixel with total internal reflection, and the ray that is not sent there; then the same step, opened by a colleague
/// from the line that was copied.
#[test]
fn a_step_is_found_and_opened_again_from_a_pasted_line() {
    let mut here = Session::raytree(&["view", "nested-glass"]);
    here.wait_for("find");
    here.keys("/tir\r");
    here.wait_for("`tir`: pixel 1 of");
    here.keys("\r");
    here.wait_for("event ");
    here.wait_for("otal internal reflection");
    here.keys("y");
    here.wait_for("raytree view nested-glass");
    let text = here.text();
    // The message may be wrapped.
    let start = text.find("raytree view nested-glass").expect("the command");
    let lines: Vec<&str> = text[start..].lines().map(str::trim).collect();
    let told = lines.join(" ");
    let words = shlex::split(&told).expect("words of a shell");
    // Behind it stand the keys.
    let end = words
        .iter()
        .position(|word| word == "?")
        .unwrap_or(words.len());
    let event = |session: &mut Session| {
        session.wait_for("event ");
        let text = session.text();
        let from = text.find("event ").expect("an event") + 6;
        text[from..].split(',').next().expect("a number").to_owned()
    };
    let step = event(&mut here);
    here.keys("qqqq");
    here.end();
    let args: Vec<&str> = words[1..end].iter().map(String::as_str).collect();
    let mut there = Session::raytree(&args);
    there.wait_for("otal internal reflection");
    assert_eq!(event(&mut there), step, "{words:?}");
    there.keys("qqqq");
    there.end();
}

/// A glass pixel down to its 8 bits, and the noise of a penumbra.
#[test]
fn a_colour_is_explained_and_noise_is_made_and_halved() {
    let mut session = Session::raytree(&["view", "whitted"]);
    session.wait_for("open its ray tree");
    session.keys("\r");
    session.wait_for("ray tree:");
    session.keys("G\tz");
    session.wait_for("x 255");
    session.keys("qqq");
    session.end();
    let mut session = Session::raytree(&["view", "soft-shadow"]);
    session.wait_for("open its ray tree");
    session.keys("[[[[");
    session.wait_for("samples a light: 1");
    session.keys("]]]");
    session.wait_for("samples a light: 8");
    session.keys("qqq");
    session.end();
}
