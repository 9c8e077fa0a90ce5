//! Keys, clicks, texts and windows by chance: nothing panics, and what was changed can be taken back.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::layout::{Position, Rect};

use super::support::{app_with, buffer, keys, settle};
use crate::sampling::stream::splitmix64;
use crate::tui::model::bindings::ACTIONS;
use crate::tui::model::{Mouse, Request};
use crate::tui::terminal::program::Program;

/// Inputs of a run; with `RAYTREE_KEYS=n` that many.
const INPUTS: u64 = 1200;

const SIZES: [(u16, u16); 10] = [
    (120, 36),
    (80, 24),
    (40, 10),
    (160, 50),
    (10, 6),
    (1, 1),
    (100, 30),
    (72, 13),
    (3, 3),
    (200, 20),
];

const TEXTS: [&str; 20] = [
    "tir\n",
    "samples=2\n",
    "depth=1\n",
    "3,4\n",
    "bend=far-root\n",
    "\u{202e}é☃",
    "hits:",
    "99999\n",
    "/R\n",
    "running sum\n",
    "throughput of ray 1\n",
    "L blocked every 3rd\n",
    "changes:t\n",
    "accel=kd\n",
    "order=far-first\n",
    "material.glass.ior=1.3\n",
    "material.mirror.mirror*=0.5\n",
    "light.sun.intensity=[1,0.5,0]\n",
    "object.glass sphere.center[1]+=0.1\n",
    "camera.eye=[0,1,5]\n",
];

/// Types a change of the scene, and takes it.
fn change(app: &mut Program, choice: usize) {
    for _ in 0..2 {
        app.press(KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
    }
    let text = TEXTS[TEXTS.len() - 5 + choice % 5];
    for letter in "=".chars().chain(text.trim_end().chars()) {
        app.press(KeyEvent::new(KeyCode::Char(letter), KeyModifiers::NONE));
    }
    app.press(KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
}

/// Does something that the number chooses.
fn input(app: &mut Program, dice: u64) {
    let press = |app: &mut Program, code| app.press(KeyEvent::new(code, KeyModifiers::NONE));
    let choice = (dice >> 8) as usize;
    match dice % 20 {
        0 => {
            let (width, height) = SIZES[choice % SIZES.len()];
            app.resize(Rect::new(0, 0, width, height));
        }
        1 => {
            let at = Position::new(choice as u16 % 120, (dice >> 24) as u16 % 40);
            let mouse = [Mouse::Press, Mouse::Drag, Mouse::Wheel(1), Mouse::Wheel(-3)];
            app.mouse(mouse[(dice >> 40) as usize % 4], at);
        }
        2 => {
            for letter in TEXTS[choice % TEXTS.len()].chars() {
                let is_end = letter == '\n';
                press(
                    app,
                    if is_end {
                        KeyCode::Enter
                    } else {
                        KeyCode::Char(letter)
                    },
                );
            }
        }
        4 => change(app, choice),
        3 => {
            press(app, KeyCode::Char(char::from(32 + choice as u8 % 95)));
        }
        _ => {
            let keys = ACTIONS.iter().flat_map(|b| b.keys);
            let count = keys.clone().count();
            if let Some((key, _)) = keys.clone().nth(choice % count) {
                app.press(key.event());
            }
        }
    }
    // The end is asked for, and put off.
    app.model.request = Request::Stay;
    app.model.clipboard = None;
}

#[test]
fn no_keys_in_any_order_break_it() {
    let inputs = std::env::var("RAYTREE_KEYS").map_or(INPUTS, |n| n.parse().expect("a number"));
    // What is typed may become a file.
    let folder = tempfile::tempdir().expect("a folder");
    let mut app = app_with(60, 20, |options| {
        options.folder = folder.path().to_owned();
    });
    settle(&mut app);
    let (start, hash) = (app.model.settings, app.model.world.scene.hash.clone());
    let mut changed = 0;
    let (mut settled, mut drawn) = (0, 0);
    for number in 0..inputs {
        let dice = splitmix64(number);
        input(&mut app, dice);
        // Many samples would take all the time.
        if app.model.settings.pixel.samples > 4 || app.model.settings.light.samples > 32 {
            app.press(KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
            app.model.request = Request::Stay;
            keys(&mut app, "U");
        }
        if dice.is_multiple_of(7) {
            app.receive();
            drawn += u64::from(app.model.layout.screen.area() > 0);
            drop(buffer(&app));
        }
        if dice.is_multiple_of(97) {
            settle(&mut app);
            settled += 1;
            changed += u64::from(!app.model.patch.is_empty());
        }
    }
    assert!(drawn > inputs / 20 && settled > 3, "{drawn}, {settled}");
    assert!(changed > 0, "the scene is changed, too");
    settle(&mut app);
    // Back to the picture, and everything taken back.
    app.resize(Rect::new(0, 0, 60, 20));
    for _ in 0..12 {
        app.press(KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
        app.model.request = Request::Stay;
    }
    while !app.model.undone.is_empty() {
        keys(&mut app, "U");
    }
    settle(&mut app);
    let size = app.model.settings.size();
    let kept = start.with(|s| (s.image.width, s.image.height) = size);
    assert_eq!(app.model.settings, kept);
    assert_eq!(app.model.world.scene.hash, hash);
    assert!(app.model.patch.is_empty() && app.model.world.scene.changes.is_empty());
}
