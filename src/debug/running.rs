//! The sum of a ray as far as the cursor has come: at its last event it is what the ray brings back.

use super::session::Session;
use crate::math::Rgb;
use crate::probe::{Event, RayKind};

/// Events of a ray that are looked at: a screen must not wait for more.
const MOST: usize = 100_000;

/// What is known at the cursor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunningSum {
    /// The terms and the weighted R and T rays that were added to the current ray up to here.
    pub sum: Rgb,
    /// How many of them.
    pub added: usize,
    /// The factor of this ray in its sample.
    pub throughput: Rgb,
}

/// The sum at the cursor; none between the samples, for L rays, which bring nothing back, of a ray whose end is behind a question, and
/// behind very many events.
pub fn running_sum(session: &Session) -> Option<RunningSum> {
    running_sum_at(session, session.cursor().position())
}

/// The sum at an event, of the ray that it belongs to.
pub fn running_sum_at(session: &Session, here: usize) -> Option<RunningSum> {
    let tree = session.tree();
    let id = tree.node_of_event(here)?;
    let node = tree.node(id);
    // Before a question the sum may be its answer.
    if node.ray.kind == RayKind::Light || !session.trace.is_whole() && !tree.is_done(id) {
        return None;
    }
    let (mut sum, mut added) = (Rgb::BLACK, 0);
    let mut add = |value: Rgb| {
        sum += value;
        added += 1;
    };
    // The ray's own events and its children stand in the order in which they are added.
    let mut at = node.first_event as usize + 1;
    let mut child = id + 1;
    let mut looked_at = 0;
    while at <= here.min(node.last_event as usize) {
        match tree.events.get(at)? {
            Event::Ray(_) => {
                let sent = tree.node(child);
                if sent.ray.kind != RayKind::Light && sent.last_event as usize <= here {
                    add(sent.ray.weight * sent.radiance);
                }
                child += sent.size;
                at = sent.last_event as usize;
            }
            Event::Term { term, .. } => add(term.value()),
            _ => {}
        }
        at += 1;
        looked_at += 1;
        if looked_at > MOST {
            return None;
        }
    }
    Some(RunningSum {
        sum,
        added,
        throughput: node.throughput,
    })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::scene::load;
    use crate::world::World;

    /// It begins with nothing, and at the return of each ray it is what the ray brings back, to the last bit.
    #[test]
    fn the_sum_grows_to_what_is_brought_back() {
        for name in ["whitted", "nested-glass", "soft-shadow"] {
            let scene = load(name).expect(name);
            let settings = scene.settings.with(|s| {
                (s.image.width, s.image.height) = (64, 48);
                s.light.samples = 2;
            });
            let world = Arc::new(World::new(scene, settings.accel));
            let mut session = Session::new(world, settings, (30, 24));
            let mut grown = 0;
            for id in 0..session.tree().nodes.len() as u32 {
                let node = *session.tree().node(id);
                session.go_to_event(node.first_event as usize);
                if node.ray.kind == RayKind::Light {
                    assert_eq!(running_sum(&session), None);
                    continue;
                }
                assert_eq!(running_sum(&session).map(|s| s.sum), Some(Rgb::BLACK));
                session.go_to_event(node.last_event as usize);
                let end = running_sum(&session).expect("a ray");
                assert_eq!(end.sum, node.radiance, "{name}: ray {id}");
                grown += end.added;
            }
            assert!(grown > 3, "{name}");
        }
    }
}
