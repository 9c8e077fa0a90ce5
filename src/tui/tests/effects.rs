//! The panel of effects.

use crossterm::event::KeyCode;

use super::support::{is_as_set, key, keys, of_scene, settle, text};
use crate::scene::Effect;
use crate::scene::effects::findings;
use crate::tui::model::Action;
use crate::tui::terminal::program::Program;

fn soft_shadow() -> Program {
    let mut app = of_scene("soft-shadow", 100, 40, |_| ());
    settle(&mut app);
    app
}

#[test]
fn each_effect_stands_there_with_the_reason_that_the_command_tells() {
    for scene in ["soft-shadow", "whitted", "triangle"] {
        let mut app = of_scene(scene, 200, 40, |_| ());
        keys(&mut app, "e");
        let screen = text(&app);
        for finding in findings(&app.model.world.scene) {
            let row = screen.lines().find(|l| l.contains(finding.effect.name()));
            let row = row.expect("a row");
            let state = if finding.on { " on " } else { "off " };
            assert!(row.replace('▶', " ").contains(state), "{row}");
            // Reasons are wrapped: the first words stand beside the name.
            let start: String = finding.reason.chars().take(20).collect();
            assert!(row.contains(&start), "{start} is not in {row}");
        }
        keys(&mut app, "e");
        assert!(!text(&app).contains("effects (↓ ↑ choose"));
    }
}

#[test]
fn an_effect_that_is_left_out_is_rendered_without_named_and_taken_in_again() {
    let mut app = soft_shadow();
    let whole = text(&app);
    keys(&mut app, "ej ");
    assert!(!app.model.settings.effects.has(Effect::SoftShadows));
    let panel = text(&app);
    assert!(panel.contains("left out soft-shadows"), "{panel}");
    assert!(panel.contains("one shadow ray to the middle"), "{panel}");
    keys(&mut app, "q");
    let hard = text(&app);
    assert!(hard.contains(" without soft-shadows "), "{hard}");
    assert!(hard.contains("--without soft-shadows"), "{hard}");
    is_as_set(&app);
    keys(&mut app, "ej q");
    assert_eq!(text(&app), whole);
    is_as_set(&app);
}

#[test]
fn an_open_tree_is_traced_again_without_it() {
    let mut app = soft_shadow();
    app.act(Action::Move(0, 15));
    key(&mut app, KeyCode::Enter);
    let lights = |app: &Program| {
        let session = app.model.session.as_ref().expect("a tree");
        let nodes = session.tree().nodes.iter();
        nodes
            .filter(|n| n.ray.kind == crate::probe::RayKind::Light)
            .count()
    };
    assert_eq!(lights(&app), 4 * 16);
    keys(&mut app, "ej ");
    assert_eq!(lights(&app), 4);
    keys(&mut app, "k ");
    assert_eq!(lights(&app), 0);
    keys(&mut app, "q");
    let title = text(&app).lines().next().expect("a title").to_owned();
    assert!(title.contains("without shadows, soft-shadows"), "{title}");
    keys(&mut app, "e j q");
    assert_eq!(lights(&app), 4 * 16);
}

#[test]
fn what_the_scene_does_not_call_for_cannot_be_switched() {
    let mut app = soft_shadow();
    let before = app.model.settings;
    keys(&mut app, "ejjjj ");
    assert_eq!(app.model.settings, before);
    let said = "refraction would change nothing: no material has a transmission coefficient";
    assert!(text(&app).contains(said), "{}", text(&app));
}
