//! A million rays.

use std::time::{Duration, Instant};

use super::support::{app, buffer};
use crate::debug::{Session, StepCommand};
use crate::geometry::Hit;
use crate::math::{DVec3, Rgb};
use crate::probe::{Event, NONE, Probe, RayKind, RayRecord};
use crate::trace::{PixelTrace, RayTree, Recorder};
use crate::tracer::Pixel;
use crate::tui::model::Action;

/// A tree of 2^20 - 1 rays: each hit sends an R and a T ray.
fn huge() -> RayTree {
    let mut recorder = Recorder::<true>::default();
    recorder.event(Event::Sample {
        index: 0,
        film: [0.5, 0.5],
        weight: 1.0,
    });
    let hit = Hit {
        t: 1.0,
        primitive: 0,
        part: 0,
        place: [0.0; 3],
    };
    // What is still to be told: a ray with its depth, or a return.
    let mut open = vec![(RayKind::Incident, 0)];
    while let Some((kind, depth)) = open.pop() {
        if depth == u32::MAX {
            recorder.event(Event::Return {
                radiance: Rgb::WHITE,
            });
            continue;
        }
        recorder.event(Event::Ray(RayRecord {
            kind,
            sample: 0,
            depth,
            light: NONE,
            medium: NONE,
            origin: DVec3::ZERO,
            direction: DVec3::Z,
            t_max: f64::INFINITY,
            weight: Rgb::WHITE,
        }));
        recorder.event(Event::Hit(hit));
        open.push((kind, u32::MAX));
        if depth < 19 {
            open.push((RayKind::Transmitted, depth + 1));
            open.push((RayKind::Reflected, depth + 1));
        }
    }
    RayTree::new(recorder)
}

#[test]
fn a_million_rays_step_and_scroll_without_lag() {
    let mut app = app(120, 36);
    let trace = PixelTrace {
        x: 0,
        y: 0,
        pixel: Pixel {
            color: Rgb::WHITE,
            rays: 1,
            budget_used: 1,
            truncated: false,
            ..Pixel::default()
        },
        tree: huge(),
    };
    assert_eq!(trace.tree.nodes.len(), (1 << 20) - 1);
    let session = Session::of(app.model.world.clone(), app.model.settings, trace);
    app.model.session = Some(Box::new(session));
    let middle = app.model.session.as_ref().map_or(0, |s| s.rows.len() / 2);
    app.act(Action::Rows(i32::try_from(middle).expect("it fits")));
    let start = Instant::now();
    let mut frames = 0;
    for action in [
        Action::Step(StepCommand::Forward),
        Action::Step(StepCommand::Back),
        Action::Rows(1),
        Action::Pages(1),
        Action::Pages(-3),
        Action::Step(StepCommand::Out),
        Action::Step(StepCommand::Over),
        Action::Step(StepCommand::End),
        Action::Step(StepCommand::Start),
    ] {
        for _ in 0..3 {
            app.act(action);
            drop(buffer(&app));
            frames += 1;
        }
    }
    // A key is to be answered within 50 ms.
    let each = start.elapsed() / frames;
    assert!(each < Duration::from_millis(50), "{each:?} a frame");
    println!("{each:?} a frame");
    // Folding lists the rows anew: that may take a moment, but no more.
    let start = Instant::now();
    app.act(Action::Step(StepCommand::Start));
    app.act(Action::Step(StepCommand::Forward));
    app.act(Action::Toggle);
    assert_eq!(app.model.session.as_ref().map(|s| s.rows.len()), Some(1));
    app.act(Action::Toggle);
    println!("{:?} to fold and unfold all", start.elapsed());
    assert!(start.elapsed() < Duration::from_secs(1));
}
