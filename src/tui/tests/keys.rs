//! Keys and their help.

use crossterm::event::KeyCode;

use super::support::{app, buffer, enter, key, keys, opened, settle, text};
use crate::tui::model::ask::{AskKind, AskState};
use crate::tui::model::bindings::ACTIONS;
use crate::tui::model::{Context, Request};
use crate::tui::panes::help;
use crate::tui::terminal::program::Program;

#[test]
fn every_key_does_something_and_is_in_the_help() {
    let help: String = help::lines(82)
        .iter()
        .map(|line| line.to_string() + "\n")
        .collect();
    for binding in ACTIONS {
        for (key, action) in binding.keys {
            let label = key.label();
            assert!(
                help.split_whitespace().any(|word| word == label),
                "{label} is not in\n{help}"
            );
            // In at least one of these situations the key must change what is seen, or end the program.
            let did = situations(binding.context).into_iter().any(|mut app| {
                let before = buffer(&app);
                let known = app.press(key.event());
                assert!(
                    known || binding.context == Context::Question,
                    "{label} is not known"
                );
                settle(&mut app);
                let asks = app
                    .model
                    .ask
                    .as_ref()
                    .is_some_and(|ask| ask.request.is_some());
                app.model.request != Request::Stay || asks || buffer(&app) != before
            });
            assert!(did, "{label} ({action:?}) does nothing");
        }
    }
}

/// A question that is shown two hints of three.
fn asked(kind: AskKind) -> Program {
    let mut app = opened(120, 36);
    let mut ask = AskState::new("chapter: id", "What is it?", kind);
    (ask.hints, ask.shown) = (2, vec![String::new(); 2]);
    app.model.ask = Some(ask);
    app
}

fn situations(context: Context) -> Vec<Program> {
    let at = |letters: &str| {
        let mut app = opened(120, 36);
        keys(&mut app, letters);
        app
    };
    match context {
        Context::Picture | Context::Always => vec![app(80, 24), at(",")],
        Context::Tree => {
            let mut watching = at("gn*");
            enter(&mut watching, "depth");
            enter(&mut watching, ":20");
            vec![at("gnt"), at("gn "), watching]
        }
        Context::Question => vec![
            asked(AskKind::Word(vec!["lit".to_owned(); 9])),
            asked(AskKind::Law {
                among: vec!["this".to_owned()],
                ours: Box::default(),
            }),
            {
                let mut app = asked(AskKind::Value("a number".to_owned()));
                keys(&mut app, "1");
                app
            },
        ],
        Context::Prompt => {
            let mut within = at("/tir");
            key(&mut within, KeyCode::Left);
            key(&mut within, KeyCode::Left);
            vec![at(":7"), at("/t"), at("="), at("d"), within]
        }
        Context::Effects => vec![at("e"), at("ej")],
        Context::Text => {
            let mut end = at("?");
            key(&mut end, KeyCode::End);
            vec![at("?"), end]
        }
        Context::Places => vec![at("Gw"), at("Gwj")],
    }
}

#[test]
fn help_opens_scrolls_and_closes() {
    let mut app = opened(80, 24);
    let before = text(&app);
    keys(&mut app, "?");
    let top = text(&app);
    assert!(top.contains("Choosing a pixel"), "{top}");
    for _ in 0..150 {
        key(&mut app, KeyCode::Down);
    }
    let bottom = text(&app);
    assert!(bottom.contains("Ctrl-C"), "{bottom}");
    for _ in 0..150 {
        key(&mut app, KeyCode::Up);
    }
    assert_eq!(text(&app), top);
    keys(&mut app, "n");
    assert_eq!(
        text(&app),
        before,
        "another key closes the help and does no more"
    );
}

/// The book's list of keys is made of the table; `RAYTREE_BOOK=1` makes it anew.
#[test]
fn the_book_lists_every_key() {
    let sections = [
        (Context::Picture, "choosing a pixel"),
        (Context::Tree, "in the ray tree"),
        (Context::Question, "before a question"),
        (Context::Prompt, "typing"),
        (Context::Effects, "among the effects"),
        (Context::Places, "in a list"),
        (Context::Text, "in a text"),
        (Context::Always, "always"),
    ];
    let mut table = "| when | keys | |\n|---|---|---|\n".to_owned();
    for (context, heading) in sections {
        for binding in ACTIONS.iter().filter(|b| b.context == context) {
            let keys: Vec<String> = binding.keys.iter().map(|(key, _)| key.label()).collect();
            let keys: Vec<String> = keys.iter().map(|key| format!("`{key}`")).collect();
            table += &[
                "| ",
                heading,
                " | ",
                &keys.join(" "),
                " | ",
                binding.doc,
                " |\n",
            ]
            .concat();
        }
    }
    let path = format!("{}/book/src/tables/key-list.md", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        std::fs::write(&path, &table).expect("written");
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(written, table, "RAYTREE_BOOK=1 makes it anew");
}
