//! Before a question nothing on any screen tells its answer, whatever key is pressed.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::layout::{Position, Rect};

use super::support::{keys, of_scene, settle, text};
use crate::debug::horizon::BEHIND;
use crate::probe::{Event, TermKind};
use crate::trace::address::node_at;
use crate::trace::format::num;
use crate::trace::{Address, View};
use crate::tui::model::ask::{AskKind, AskState, AskTold};
use crate::tui::model::bindings::ACTIONS;
use crate::tui::model::{Mouse, Pane, Request};
use crate::tui::terminal::program::Program;
use crate::tui::update::ask;

/// A question: its scene, the ray and the field, and the numbers of its answer.
struct Question {
    scene: &'static str,
    at: &'static str,
    answer: fn(View, u32) -> Vec<f64>,
}

fn hit(view: View, node: u32) -> f64 {
    use crate::trace::Outcome::{Blocked, Hit};
    match view.trace.tree.node(node).outcome {
        Some(Hit(hit) | Blocked(hit)) => hit.t,
        other => panic!("no hit: {other:?}"),
    }
}

fn term(view: View, node: u32, kind: TermKind) -> f64 {
    let mut own = view.trace.tree.own_events(node);
    let found = own.find_map(|(_, event)| match event {
        Event::Term { term, .. } if term.kind() == kind => Some(term.value().g),
        _ => None,
    });
    found.expect("such a term")
}

const QUESTIONS: [Question; 12] = [
    Question {
        scene: "whitted",
        at: "32,24.t",
        answer: |t, n| vec![hit(t, n)],
    },
    Question {
        scene: "whitted",
        at: "20,14.direction",
        answer: |t, n| t.trace.tree.node(n).ray.direction.to_array().to_vec(),
    },
    Question {
        scene: "whitted",
        at: "32,24/T.direction",
        answer: |t, n| t.trace.tree.node(n).ray.direction.to_array().to_vec(),
    },
    Question {
        scene: "whitted",
        at: "32,24/T.t",
        answer: |t, n| vec![hit(t, n)],
    },
    Question {
        scene: "whitted",
        at: "32,24.radiance",
        answer: |t, n| t.trace.tree.node(n).radiance.channels().to_vec(),
    },
    Question {
        scene: "whitted",
        at: "32,24.color",
        answer: |t, _| t.trace.pixel.color.channels().to_vec(),
    },
    Question {
        scene: "whitted",
        at: "32,24/T.weight",
        answer: |t, n| vec![t.trace.tree.node(n).ray.weight.g],
    },
    Question {
        scene: "whitted",
        at: "32,24.boundary.reflectance",
        answer: |t, n| {
            let mut own = t.trace.tree.own_events(n);
            own.find_map(|(_, e)| match e {
                Event::Boundary { reflectance, .. } => Some(vec![*reflectance]),
                _ => None,
            })
            .expect("a boundary")
        },
    },
    Question {
        scene: "whitted",
        at: "32,44.terms.diffuse:sun",
        answer: |t, n| vec![term(t, n, TermKind::Diffuse)],
    },
    Question {
        scene: "whitted",
        at: "32,24/T.normal",
        answer: |t, n| {
            t.surface_hit(n)
                .expect("a hit")
                .at
                .normal
                .to_array()
                .to_vec()
        },
    },
    Question {
        scene: "nested-glass",
        at: "30,24/T.t",
        answer: |t, n| vec![hit(t, n)],
    },
    Question {
        scene: "soft-shadow",
        at: "24,36.terms.diffuse:lamp",
        answer: |t, n| vec![term(t, n, TermKind::Diffuse)],
    },
];

fn started(question: &Question, (width, height): (u16, u16)) -> Program {
    let at: Address = question.at.parse().expect("an address");
    let mut app = of_scene(question.scene, width, height, |options| {
        let mut asked = AskState::new(
            "chapter: id",
            "How large is it?",
            AskKind::Value("a number".to_owned()),
        );
        asked.at = Some(at.clone());
        asked.hints = 3;
        options.size = Some((64, 48));
        options.at = Some(Address { part: None, ..at });
        options.ask = Some(Box::new(asked));
    });
    settle(&mut app);
    app
}

/// The digits that tell a number: five of them, or four where it is above 1.
fn digits(answer: f64) -> Vec<String> {
    let number = num(answer.abs());
    let short = format!("{:.3}", answer.abs());
    let count = |text: &String| text.chars().filter(char::is_ascii_digit).count();
    let mut all = vec![number];
    all.retain(|text| count(text) >= 6);
    if answer.abs() > 1.0 {
        all.push(short);
    }
    all
}

/// The digits of the answer to a question that is open.
fn secrets(question: &Question, app: &Program) -> Vec<String> {
    let session = app.model.session.as_ref().expect("a tree");
    let view = View {
        trace: session.whole(),
        ..session.view()
    };
    let at: Address = question.at.parse().expect("an address");
    let node = node_at(view, &at.path).expect("a ray");
    let secrets: Vec<String> = (question.answer)(view, node)
        .into_iter()
        .flat_map(digits)
        .collect();
    assert!(!secrets.is_empty(), "{}", question.at);
    secrets
}

#[track_caller]
fn tells_nothing(question: &Question, app: &Program, secrets: &[String], how: &str) {
    if app.model.layout.screen.is_empty() {
        return;
    }
    let screen = text(app);
    for secret in secrets {
        assert!(
            !screen.contains(secret),
            "{} {secret} by {how}:\n{screen}",
            question.at
        );
    }
    let copied = app.model.clipboard.as_deref().unwrap_or_default();
    assert!(copied.is_empty(), "{copied}");
    let session = app.model.session.as_ref().expect("the tree stays open");
    let at: Address = question.at.parse().expect("an address");
    assert_eq!((session.trace.x, session.trace.y), at.pixel, "by {how}");
    assert!(session.horizon().is_some(), "by {how}");
}

/// Brings everything back to the open question.
fn recover(app: &mut Program) {
    for _ in 0..3 {
        if app.model.overlay.is_some() || app.model.convergence.is_some() || app.model.is_moving() {
            app.press(KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
        }
    }
    app.model.request = Request::Stay;
    app.model.message = None;
    app.model.layout.zoom = false;
    if let Some(ask) = &mut app.model.ask {
        (ask.request, ask.typed) = (None, String::new());
    }
}

const TYPED: [&str; 16] = [
    ":99999",
    ":/R",
    ":/T/T/R",
    ":1,1",
    "/hit",
    "/some(t > 0)",
    "/not miss",
    "=samples=4",
    "=camera.eye=[0,1,5]",
    "=bend=far-root",
    "d1,1",
    "dbend=none",
    "bmiss",
    "bnew object",
    "Mnote",
    "\"file.json",
];

/// Every key, from several places, in every pane; texts in every prompt; clicks everywhere: no screen tells the answer.
#[test]
fn no_screen_tells_the_answer_whatever_is_pressed() {
    for (number, question) in QUESTIONS.iter().enumerate() {
        let size = if number % 2 == 0 { (160, 50) } else { (80, 24) };
        let mut app = started(question, size);
        let secrets = secrets(question, &app);
        let look = |app: &Program, how: &str| tells_nothing(question, app, &secrets, how);
        look(&app, "nothing");
        let session = app.model.session.as_ref();
        let end = session.and_then(|s| s.horizon()).expect("open");
        let places = [end - 1, end / 2].into_iter();
        for place in places.take(if number == 0 { 2 } else { 1 }) {
            for binding in ACTIONS {
                for (key, action) in binding.keys {
                    if let Some(session) = &mut app.model.session {
                        session.go_to_event(place);
                    }
                    app.press(key.event());
                    settle(&mut app);
                    look(&app, &format!("{action:?} at {place}"));
                    if app.model.overlay.is_some() {
                        app.press(KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
                        settle(&mut app);
                        look(&app, &format!("{action:?}, Enter at {place}"));
                    }
                    recover(&mut app);
                }
            }
        }
        walk(question, &mut app, &secrets);
        typed_and_clicked(question, &mut app, &secrets);
        ask::tell(
            &mut app.model,
            AskTold {
                is_right: true,
                text: "It is so.".to_owned(),
            },
        );
        settle(&mut app);
        app.resize(Rect::new(0, 0, 200, 70));
        let mut screens = text(&app);
        keys(&mut app, "G");
        screens += &text(&app);
        for secret in &secrets {
            if secret.len() > 5 {
                assert!(
                    screens.contains(secret),
                    "{} {secret} is told:\n{screens}",
                    question.at
                );
            }
        }
    }
}

/// Every known event in every pane, alone on the screen and beside the others.
fn walk(question: &Question, app: &mut Program, secrets: &[String]) {
    let end = app
        .model
        .session
        .as_ref()
        .and_then(|s| s.horizon())
        .expect("open");
    for event in 0..end {
        if let Some(session) = &mut app.model.session {
            session.go_to_event(event);
        }
        for pane in Pane::FOCUS {
            app.model.layout.focus = pane;
            for zoom in [false, true] {
                app.model.layout.zoom = zoom;
                tells_nothing(
                    question,
                    app,
                    secrets,
                    &format!("event {event} in {pane:?}"),
                );
            }
        }
    }
    recover(app);
}

fn typed_and_clicked(question: &Question, app: &mut Program, secrets: &[String]) {
    let press = |app: &mut Program, code| {
        app.press(KeyEvent::new(code, KeyModifiers::NONE));
        settle(app);
    };
    for typed in TYPED {
        for letter in typed.chars() {
            press(app, KeyCode::Char(letter));
        }
        press(app, KeyCode::Enter);
        tells_nothing(question, app, secrets, typed);
        press(app, KeyCode::Char('x'));
        press(app, KeyCode::Char('f'));
        tells_nothing(question, app, secrets, typed);
        recover(app);
    }
    let screen = app.model.layout.screen;
    for y in (0..screen.height).step_by(2) {
        for x in (0..screen.width).step_by(9) {
            app.mouse(Mouse::Press, Position::new(x, y));
            settle(app);
            tells_nothing(question, app, secrets, &format!("a click at {x},{y}"));
        }
    }
    recover(app);
}

/// What leads to other pixels, settings or pictures, and past the horizon, is refused by one sentence.
#[test]
fn what_is_behind_the_question_is_refused_in_one_sentence() {
    for typed in [
        "n", "u", "r", "t", "l", "a", "i", "G", "c", "=", "d", "]", "}", "+", "U", "C", "P", "M",
        "'", "\"", "y", "V", ":99999\n", ":1,1\n", ":/R\n",
    ] {
        let mut app = started(&QUESTIONS[0], (160, 50));
        let before = app.model.settings;
        for letter in typed.chars() {
            let code = if letter == '\n' {
                KeyCode::Enter
            } else {
                KeyCode::Char(letter)
            };
            app.press(KeyEvent::new(code, KeyModifiers::NONE));
            settle(&mut app);
        }
        assert_eq!(app.model.message.as_deref(), Some(BEHIND), "{typed}");
        assert_eq!(app.model.settings, before);
        assert!(text(&app).contains(BEHIND), "{typed}");
    }
}

/// The pixel that is asked for is a sign in the picture, and nothing is known of it; answered, it has its colour.
#[test]
fn the_pixel_is_hidden_in_the_picture() {
    let mut app = started(&QUESTIONS[0], (160, 50));
    assert_eq!(app.model.picture.exact((32, 24)), None);
    assert_eq!(app.model.picture.nearest((32, 24)), None);
    assert!(app.model.picture.exact((33, 24)).is_some());
    let (x, y) = app.model.placement(&app.model.panes()).cell((32, 24));
    let sign = |app: &Program| super::support::buffer(app)[(x, y)].symbol().to_owned();
    assert_eq!(sign(&app), "?");
    ask::tell(
        &mut app.model,
        AskTold {
            is_right: false,
            text: String::new(),
        },
    );
    assert!(app.model.picture.exact((32, 24)).is_some());
    assert_ne!(sign(&app), "?");
}

/// What is behind the horizon is kept in one place, and nothing that draws or moves asks for it.
#[test]
fn nothing_on_the_screen_asks_for_the_whole_recording() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tui");
    let mut looked_at = 0;
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() && path != root.join("tests") {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = std::fs::read_to_string(&path).expect("text");
                assert!(!text.contains(".whole()"), "{}", path.display());
                looked_at += 1;
            }
        }
    }
    assert!(looked_at > 50, "{looked_at}");
}
