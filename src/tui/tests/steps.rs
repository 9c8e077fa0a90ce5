//! The accelerator on the screen: its tree, the t axis, and the cell in the scene.

use crossterm::event::KeyCode;
use ratatui::layout::{Position, Rect};

use super::support::{buffer, key, keys, of_scene, position, settle, text};
use crate::accel::AccelKind;
use crate::tui::model::{Mouse, Pane, inside};
use crate::tui::terminal::program::Program;

/// The debugger in the middle of a scene, at the first step of the eye ray, in the pane of the steps.
fn at_steps(scene: &str, kind: AccelKind, (width, height): (u16, u16)) -> Program {
    let mut app = of_scene(scene, width, height, |_| ());
    settle(&mut app);
    for change in [format!("=accel={}", kind.name()), "=samples=1".to_owned()] {
        keys(&mut app, &change);
        key(&mut app, KeyCode::Enter);
    }
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "nn");
    key(&mut app, KeyCode::Tab);
    key(&mut app, KeyCode::Tab);
    app
}

/// The rows of a pane.
fn rows(app: &Program, pane: Pane) -> Vec<String> {
    let (area, buffer) = (inside(app.model.panes().area(pane)), buffer(app));
    let row = |y| {
        let cells = (area.x..area.right()).filter_map(|x| buffer.cell((x, y)));
        cells.map(ratatui::buffer::Cell::symbol).collect()
    };
    (area.y..area.bottom()).map(row).collect()
}

#[test]
fn the_steps_are_a_tree_with_the_t_axis_below() {
    for kind in AccelKind::ALL {
        for size in [(160, 50), (80, 24)] {
            let mut app = at_steps("teapot", kind, size);
            let count = app.model.session.as_ref().map_or(0, |s| s.steps().len());
            let flat = kind == AccelKind::List;
            let (mut branches, mut bars) = (0, 0);
            for _ in 0..count.min(30) {
                let shown = rows(&app, Pane::Steps);
                let [axis, legend] = &shown[shown.len() - 2..] else {
                    panic!("{shown:?}");
                };
                assert!(axis.contains('-') || axis.contains('='), "{axis}");
                assert!(legend.contains("X "), "{legend}");
                bars += usize::from(legend.contains("[=] "));
                branches += shown.iter().filter(|row| row.contains('└')).count();
                let screen = text(&app);
                let title = screen.lines().find_map(|line| line.split_once(kind.name()));
                let totals = [" nodes, ", " shapes "].map(|what| screen.contains(what));
                assert!(title.is_some() && totals == [!flat, true], "{screen}");
                keys(&mut app, "n");
            }
            assert!(bars > 5, "{kind:?}");
            assert_eq!(branches == 0, flat, "{kind:?} {branches}");
        }
    }
}

/// A click on a step goes there, one on the t axis goes nowhere.
#[test]
fn the_t_axis_is_no_step() {
    let mut app = at_steps("teapot", AccelKind::Bsp, (160, 50));
    let area: Rect = inside(app.model.panes().steps);
    let start = position(&app);
    app.mouse(Mouse::Press, Position::new(area.x + 3, area.y + 2));
    assert_eq!(position(&app), start + 2);
    app.mouse(Mouse::Press, Position::new(area.x + 3, area.bottom() - 1));
    assert_eq!(position(&app), start + 2);
}

/// The cell of a node and the tested shape are drawn over the outlines of the scene, and named.
#[test]
fn the_cell_is_drawn_in_the_scene() {
    let mut app = at_steps("teapot", AccelKind::Kd, (160, 50));
    let mut scenes = std::collections::BTreeSet::new();
    for _ in 0..12 {
        scenes.insert(rows(&app, Pane::Path).concat());
        let screen = text(&app);
        assert!(screen.contains("light cell "), "{screen}");
        keys(&mut app, "n");
    }
    assert!(
        scenes.len() > 4,
        "each node has another cell: {}",
        scenes.len()
    );
    keys(&mut app, "g");
    assert!(!text(&app).contains("light cell "));
}
