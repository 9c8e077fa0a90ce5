//! What comes from outside of the debugger: signals, scenes on standard input, and odd names.

use portable_pty::CommandBuilder;

use super::Session;

#[test]
fn signals_to_end_leave_nothing_behind() {
    for signal in ["TERM", "HUP"] {
        let mut session = Session::raytree(&["view", "room"]);
        session.wait_for("raytree trace room");
        session.signal(signal);
        assert_ne!(session.end(), 0, "{signal} ended it, and a shell sees that");
    }
}

/// More than a terminal hands over in one piece.
#[test]
fn a_long_burst_of_keys_is_taken_in_to_its_end() {
    let mut session = Session::raytree(&["view", "whitted"]);
    session.wait_for("--pixel 60,33");
    session.keys(&"\x1b[C\x1b[D".repeat(600));
    session.keys("\x1b[B");
    session.wait_for("--pixel 60,34");
    session.keys("q");
    assert_eq!(session.end(), 0);
}

#[test]
fn a_signal_to_quit_leaves_nothing_behind() {
    let mut session = Session::raytree(&["view", "room"]);
    session.wait_for("raytree trace room");
    assert!(session.is_raw());
    session.signal("QUIT");
    assert_ne!(session.end(), 0, "it ends as one that was told to quit");
}

#[test]
fn a_signal_to_stop_gives_the_terminal_back_until_it_goes_on() {
    let mut session = Session::raytree(&["view", "room"]);
    session.wait_for("raytree trace room");
    for _ in 0..2 {
        session.signal("TSTP");
        session.wait("the terminal given back", |s| {
            !s.alternate_screen() && !s.hide_cursor()
        });
        // It leaves the raw mode last.
        let start = std::time::Instant::now();
        while session.is_raw() && start.elapsed().as_secs() < 20 {
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        assert!(!session.is_raw());
        session.signal("CONT");
        session.wait("the debugger again", vt100::Screen::alternate_screen);
        session.wait_for("raytree trace room");
        assert!(session.is_raw());
    }
    // What cannot be caught: the terminal is as a shell leaves it, and is taken over again.
    session.signal("STOP");
    session.signal("CONT");
    session.keys("?");
    session.wait_for("Choosing a pixel");
    session.keys("\x03");
    assert_eq!(session.end(), 0);
}

#[test]
fn names_in_the_debugger_show_what_cannot_be_seen() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.json");
    let scene = r#"{"format": "raytree-scene/1", "name": "odd\u202e", "camera": {"eye": [0, 0, 4], "look_at": [0, 0, 0]},
        "materials": {"m\u2066": {"diffuse": [1, 1, 1]}},
        "lights": [{"point": {"name": "lamp\u200b", "position": [0, 0, 9], "intensity": [1, 1, 1]}}],
        "objects": [{"sphere": {"name": "ball\u2069", "material": "m\u2066", "center": [0, 0, 0], "radius": 1}}]}"#;
    std::fs::write(&path, scene).expect("a file");
    let mut session = Session::raytree(&["view", path.to_str().expect("UTF-8")]);
    session.wait_for("ball\\u{2069}");
    session.keys("\r");
    session.wait_for("ray tree:");
    session.wait_for("odd\\u{202e}");
    session.wait_for("lamp\\u{200b}");
    // The event of the hit, which tells the material, comes after those of the search for it.
    for event in 1.. {
        session.keys("n");
        session.wait_for(&format!("event {event} of"));
        if session.text().contains("hit `ball") {
            break;
        }
    }
    session.wait_for("m\\u{2066}");
    let raw = String::from_utf8_lossy(&session.raw).into_owned();
    assert!(!raw.contains(['\u{202e}', '\u{2066}', '\u{2069}', '\u{200b}']));
    session.keys("\x03");
    assert_eq!(session.end(), 0);
}

#[test]
fn a_scene_on_standard_input_leaves_the_keys_to_the_terminal() {
    let mut command = CommandBuilder::new("sh");
    let program = env!("CARGO_BIN_EXE_raytree");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/room.json");
    command.args(["-c", &format!("'{program}' view - < '{scene}'")]);
    let mut session = Session::start(command);
    session.wait_for("raytree trace -");
    session.keys("\r");
    session.wait_for("ray tree:");
    session.keys("\x03");
    assert_eq!(session.end(), 0);
    // A terminal is no scene.
    let mut session = Session::raytree(&["view", "-"]);
    session.wait_for("raytree render - < scene.json");
    assert_eq!(session.end(), 1);
}
