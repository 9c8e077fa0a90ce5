//! One ray in two ways: every step of both is there once, in its order, and both find the same.

use std::sync::Arc;

use super::*;
use crate::probe::Verdict;
use crate::scene::load;

fn session(scene: &str, kind: AccelKind, at: (u32, u32)) -> Session {
    let scene = load(scene).expect("built in");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (64, 48);
        s.accel = kind;
    });
    let mut session = Session::new(Arc::new(World::new(scene, kind)), settings, at);
    session.go_to_event(1);
    session
}

/// Each ray that is searched for something.
fn each_ray(session: &mut Session, mut check: impl FnMut(&Session)) -> usize {
    let mut count = 0;
    for node in 0..session.tree().nodes.len() as u32 {
        session.go_to_event(session.tree().node(node).first_event as usize);
        if !session.steps().is_empty() {
            check(session);
            count += 1;
        }
    }
    count
}

/// Every step of both sides is in a row, once and in its order; rows of the same have the same in both.
fn is_whole(session: &Session, beside: &StepsBeside) {
    let a: Vec<usize> = beside.pairs.iter().filter_map(|pair| pair.a).collect();
    let b: Vec<usize> = beside.pairs.iter().filter_map(|pair| pair.b).collect();
    assert_eq!(a, session.steps().collect::<Vec<_>>());
    assert_eq!(b, beside.other.steps().collect::<Vec<_>>());
    for pair in beside.pairs.iter().filter(|pair| pair.is_same) {
        let (a, b) = (pair.a.expect("both"), pair.b.expect("both"));
        match (session.tree().events[a], beside.other.tree().events[b]) {
            (Event::Test { primitive: a, .. }, Event::Test { primitive: b, .. }) => {
                assert_eq!(a, b);
            }
            (Event::Visit(a), Event::Visit(b)) => assert_eq!(a.node, b.node),
            (a, b) => panic!("{a:?} {b:?}"),
        }
    }
}

/// The hit that the steps lead to.
fn hit(session: &Session) -> Option<(u32, u64)> {
    let steps = session.tree().events.get(session.steps()).expect("steps");
    let mut hits = steps.iter().filter_map(|event| match event {
        Event::Test {
            primitive,
            verdict: Verdict::Hit,
            t,
        } => Some((*primitive, t.to_bits())),
        _ => None,
    });
    hits.next_back()
}

#[test]
fn structures_stand_side_by_side() {
    for kind in AccelKind::ALL {
        let mut session = session("room", AccelKind::Bsp, (30, 24));
        let mut same = 0;
        let rays = each_ray(&mut session, |session| {
            let beside = through(session, kind).expect("a small scene");
            is_whole(session, &beside);
            assert!(!beside.told.contains("bug"), "{}", beside.told);
            same += beside.pairs.iter().filter(|pair| pair.is_same).count();
            if kind == AccelKind::Bsp {
                assert!(beside.pairs.iter().all(|pair| pair.is_same));
            }
        });
        assert!(rays > 1 && same > 0, "{kind:?}: {rays}, {same}");
    }
}

/// The wrong order finds the same hit, and never with less work.
#[test]
fn the_far_child_first_finds_the_same_with_more_work() {
    let (mut near, mut far) = (0, 0);
    for (scene, at) in [
        ("teapot", (32, 26)),
        ("teapot", (25, 30)),
        ("room", (30, 24)),
    ] {
        let mut session = session(scene, AccelKind::Bsp, at);
        each_ray(&mut session, |session| {
            let beside = far_first(session).expect("a bsp tree");
            is_whole(session, &beside);
            let is_shadow = session
                .node()
                .is_some_and(|n| session.tree().node(n).ray.kind == RayKind::Light);
            if is_shadow {
                assert_eq!(hit(session).is_some(), hit(&beside.other).is_some());
                return;
            }
            assert_eq!(hit(session), hit(&beside.other), "{}", beside.told);
            let work = |s: &Session| (s.step_tree.visited, s.step_tree.tested);
            let ours = work(session);
            let theirs = work(&beside.other);
            assert!(ours.0 <= theirs.0 && ours.1 <= theirs.1, "{}", beside.told);
            (near, far) = (near + ours.1, far + theirs.1);
        });
    }
    assert!(far > near + 10, "{far} {near}");
}

#[test]
fn what_has_no_order_is_told() {
    let session = session("room", AccelKind::Kd, (30, 24));
    let error = far_first(&session).err().expect("no BSP tree");
    assert!(error.contains("accel=bsp"), "{error}");
}
