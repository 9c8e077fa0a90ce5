//! Steps through every accelerator: where they stand in the tree, the cells of their nodes, and their t axes.

use std::sync::Arc;

use crate::accel::AccelKind;
use crate::debug::cell::NodeCell;
use crate::debug::crossings::crossings;
use crate::debug::steps::totals;
use crate::debug::t_axis::{AxisMarkKind, TAxis};
use crate::debug::{Cursor, Session, StepText};
use crate::math::Ray;
use crate::probe::{Choice, Event, RayKind, Verdict, Visit};
use crate::scene::load;
use crate::world::World;

/// Rays of a pixel that are looked at.
const MOST: usize = 30;

/// Sessions on the first rays of some pixels of some scenes, with every accelerator.
fn each_ray(mut look: impl FnMut(&mut Session, AccelKind)) {
    for (name, pixels) in [
        ("teapot", [(30, 26), (12, 20)]),
        ("whitted", [(32, 24), (20, 40)]),
        ("soft-shadow", [(32, 36), (32, 20)]),
        ("room", [(15, 20), (40, 30)]),
    ] {
        for kind in AccelKind::ALL {
            let scene = load(name).expect("a built-in scene");
            let settings = scene.settings.with(|s| {
                (s.image.width, s.image.height) = (64, 48);
                (s.pixel.samples, s.light.samples) = (1, 4);
                s.accel = kind;
            });
            let world = Arc::new(World::new(scene, kind));
            for at in pixels {
                let mut session = Session::new(Arc::clone(&world), settings, at);
                for node in 0..session.tree().nodes.len().min(MOST) {
                    session.go(Cursor::at_node(session.tree(), node as u32));
                    look(&mut session, kind);
                }
            }
        }
    }
}

fn event(session: &Session, step: usize) -> Event {
    session.tree().events[session.steps().start + step]
}

fn visit(session: &Session, step: usize) -> Option<Visit> {
    match event(session, step) {
        Event::Visit(visit) => Some(visit),
        _ => None,
    }
}

#[test]
fn each_step_stands_below_the_node_that_leads_to_it() {
    let (mut deepest, mut on_planes, mut before) = (0, 0, 0);
    each_ray(|session, kind| {
        let (tree, accel) = (&session.step_tree, &session.world.accel);
        let (mut leaf, mut roots) = (None, 0);
        let (mut visited, mut tested) = (0, 0);
        for step in 0..session.steps().len() {
            let (depth, parent) = (tree.depth(step), tree.parent(step));
            assert_eq!(depth, parent.map_or(0, |parent| tree.depth(parent) + 1));
            assert_eq!(tree.guides(step).chars().count(), depth);
            deepest = deepest.max(depth);
            let above = parent.and_then(|parent| visit(session, parent));
            match event(session, step) {
                Event::Visit(visit) => {
                    visited += usize::from(!visit.is_skipped());
                    match above {
                        Some(above) => {
                            let children = accel.children(above.node);
                            assert!(children.contains(&visit.node), "{kind:?} step {step}");
                        }
                        None if kind == AccelKind::Grid => {}
                        None => {
                            assert_eq!(visit.node, 0, "{kind:?} step {step}");
                            roots += 1;
                        }
                    }
                    if visit.is_leaf() {
                        leaf = Some(step);
                    }
                }
                Event::Test { primitive, .. } => {
                    tested += 1;
                    let Some(above) = above else {
                        let unbounded = accel.unbounded().contains(&primitive);
                        assert!(unbounded || kind == AccelKind::List, "{kind:?} step {step}");
                        assert_eq!(leaf, None, "they come before the tree");
                        before += 1;
                        continue;
                    };
                    let held = accel.node(above.node).expect("visited").primitives;
                    assert!(held.contains(&primitive), "{kind:?} step {step}");
                    if above.is_leaf() {
                        assert_eq!(parent, leaf, "{kind:?} step {step}");
                    } else {
                        on_planes += 1;
                    }
                }
                other => panic!("{other:?}"),
            }
        }
        assert!(roots <= 1);
        assert_eq!((tree.visited, tree.tested), (visited, tested));
    });
    assert!(
        deepest > 8 && on_planes > 0 && before > 0,
        "{deepest} {on_planes} {before}"
    );
}

#[test]
fn the_cell_of_a_node_holds_the_part_of_the_ray_inside() {
    let mut looked = 0;
    each_ray(|session, kind| {
        let id = session.node().expect("a ray");
        let sent = session.tree().node(id).ray;
        let ray = Ray::new(sent.origin, sent.direction);
        let size = session.world.accel.bounds().map(|b| b.size().length());
        for step in 0..session.steps().len() {
            let Some(visit) = visit(session, step) else {
                continue;
            };
            if visit.is_missed() {
                continue;
            }
            // Nodes of eight boxes tell only where the ray enters a leaf.
            let wide = kind == AccelKind::Wide;
            if wide && visit.choice == Choice::Children {
                continue;
            }
            let size = size.expect("a structure with nodes");
            let cell = NodeCell::of_event(session, session.steps().start + step);
            let cell = cell.expect("the cell of a visited node");
            let [start, end] = visit.interval;
            let end = if wide { start } else { end.min(start + size) };
            for share in [0.0, 0.3, 0.7, 1.0] {
                let p = ray.at(start + share * (end - start));
                assert!(
                    cell.contains(p, 3e-4 * size),
                    "{kind:?} step {step}: {visit:?} at {p}"
                );
            }
            looked += 1;
        }
    });
    assert!(looked > 2000, "{looked}");
}

#[test]
fn marks_of_the_t_axis_are_in_order_and_where_the_tests_say() {
    let (mut twice, mut splits) = (0, 0);
    each_ray(|session, kind| {
        for step in 0..session.steps().len().min(60) {
            session.go_to_event(session.steps().start + step);
            let Some(axis) = TAxis::new(session) else {
                continue;
            };
            assert!(axis.ends[0] < axis.ends[1]);
            assert!(axis.marks.is_sorted_by(|a, b| a.t <= b.t), "{axis:?}");
            let line = axis.line(60);
            assert!(line.chars().count() == 60, "{line}");
            let id = session.node().expect("a ray");
            let sent = session.tree().node(id).ray;
            let has = |kind, t: f64| {
                let near = |a: f64| (a - t).abs() <= 1e-6 * t.abs().max(1.0);
                axis.marks.iter().any(|m| m.kind == kind && near(m.t))
            };
            match event(session, step) {
                Event::Test { primitive, t, .. } => {
                    let shape = &session.world.scene.shapes[primitive as usize];
                    let ray = Ray::new(sent.origin, sent.direction);
                    let all = crossings(shape, &ray);
                    assert!(all.is_sorted());
                    twice += usize::from(all.len() == 2);
                    // A shape that is missed has no t.
                    if t.is_finite() {
                        assert!(has(AxisMarkKind::Crossing, t), "{kind:?} {t} {axis:?}");
                    }
                }
                Event::Visit(visit) => {
                    let inside = (!visit.is_missed()).then_some(visit.interval);
                    assert_eq!(axis.bar, inside);
                    if visit.t_split.is_finite() {
                        splits += 1;
                        assert!(has(AxisMarkKind::Split, visit.t_split));
                    }
                }
                other => panic!("{other:?}"),
            }
            // What the search leads to is what the ray met.
            if let Some(found) = session.step_tree.found() {
                assert!(has(AxisMarkKind::Found, found));
            }
        }
    });
    assert!(twice > 10 && splits > 100, "{twice} {splits}");
}

#[test]
fn steps_say_what_is_empty_outside_of_the_tree_or_beyond_its_leaf() {
    let mut told = std::collections::BTreeSet::new();
    each_ray(|session, kind| {
        let steps = session.steps();
        let id = session.node().expect("a ray");
        let kind_of_ray = session.tree().node(id).ray.kind;
        for (step, index) in steps.clone().enumerate() {
            let text = StepText::new(session, index).expect("a step");
            let line = format!("{}{}{}", text.name, text.result, text.interval);
            match event(session, step) {
                Event::Visit(visit) if visit.is_leaf() => {
                    let node = session.world.accel.node(visit.node).expect("visited");
                    let empty = node.primitives.is_empty();
                    assert_eq!(line.contains("empty, nothing to test"), empty, "{line}");
                    told.extend(empty.then_some("empty leaf"));
                }
                Event::Visit(_) => {
                    told.extend(line.contains("(empty)").then_some("empty child"));
                }
                Event::Test { verdict, t, .. } => {
                    let above = session.step_tree.parent(step);
                    let above = above.and_then(|step| visit(session, step));
                    let beyond = verdict == Verdict::Hit
                        && kind_of_ray != RayKind::Light
                        && above.is_some_and(|leaf| leaf.is_leaf() && leaf.interval[1] < t);
                    assert_eq!(line.contains("kept in mind"), beyond, "{line}");
                    told.extend(beyond.then_some("beyond"));
                    let explained = crate::trace::explain(session.view(), index).sentence;
                    assert_eq!(explained.contains("kept in mind"), beyond, "{explained}");
                    let before = above.is_none() && kind != AccelKind::List;
                    assert_eq!(line.contains("before the tree"), before, "{line}");
                    told.extend(before.then_some("before"));
                }
                other => panic!("{other:?}"),
            }
        }
        if steps.is_empty() {
            return;
        }
        session.go_to_event(steps.start);
        let (nodes, tree) = (session.nodes, &session.step_tree);
        let long = totals(session, 200);
        let shapes = session.world.scene.shapes.len();
        let visited = if kind == AccelKind::List {
            String::new()
        } else {
            format!("{} of {nodes} nodes, ", tree.visited)
        };
        let expected = format!(
            "{} step 1 of {}: {visited}{} of {shapes} shapes",
            kind.name(),
            steps.len(),
            tree.tested
        );
        assert_eq!(long, expected);
        for width in 30..60 {
            assert!(totals(session, width).chars().count() <= width);
        }
    });
    assert_eq!(told.len(), 4, "{told:?}");
}
