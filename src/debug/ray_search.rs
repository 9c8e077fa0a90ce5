//! Search of an open tree for the next ray that satisfies a query, a few milliseconds at a time.

use std::time::Instant;

use super::cursor::Cursor;
use super::session::Session;
use crate::trace::TreeQuery;

/// Rays between two looks at the clock.
const BETWEEN: usize = 256;

/// Rays of a tree at most of which all that satisfy a query are counted.
const COUNTED: usize = 20_000;

/// A search that is under way.
#[derive(Clone, Debug, PartialEq)]
pub struct RaySearch {
    /// What each ray is asked.
    query: TreeQuery,
    forward: bool,
    /// The event that it is sought behind, or before.
    here: usize,
    /// Rays looked at: from the first of the tree on, or from the last one back.
    pub looked_at: usize,
    /// The nearest of their events that lies in this direction.
    next: Option<usize>,
    /// The farthest in the other direction: the answer if there is none in this one.
    around: Option<usize>,
}

/// The event of a ray that was found, if one was.
pub type RayFound = Option<usize>;

impl RaySearch {
    /// A search from an event on. What the query asks of any ray is asked of each.
    pub fn new(query: &TreeQuery, here: usize, forward: bool) -> Self {
        Self {
            query: query.of_each_ray().clone(),
            forward,
            here,
            looked_at: 0,
            next: None,
            around: None,
        }
    }

    /// Searches until a ray is found, all were looked at, or the time is over: then none.
    ///
    /// Rays stand in the order in which they were sent. That a ray is *not* sent is logged after the rays that its hit has sent, so a
    /// later ray may have the earlier event.
    pub fn go_on(&mut self, session: &Session, until: Option<Instant>) -> Option<RayFound> {
        let nodes = &session.tree().nodes;
        while self.looked_at < nodes.len() {
            let number = if self.forward {
                self.looked_at
            } else {
                nodes.len() - 1 - self.looked_at
            };
            if self.is_nearest(nodes[number].first_event as usize) {
                break;
            }
            self.looked_at += 1;
            self.look_at(session, number as u32);
            let is_late = || until.is_some_and(|until| Instant::now() >= until);
            if self.looked_at.is_multiple_of(BETWEEN) && is_late() {
                return None;
            }
        }
        Some(self.next.or(self.around))
    }

    /// True if none of the rays that are left, of which this is the first event of the next one, has a nearer event.
    fn is_nearest(&self, event: usize) -> bool {
        self.next.is_some_and(|next| !self.forward || event >= next)
    }

    /// Keeps a ray's event if it is nearer than what was found. Backwards, of the rays before it only those around it can have an
    /// event behind its own.
    fn look_at(&mut self, session: &Session, ray: u32) {
        let mut ray = Some(ray);
        while let Some(number) = ray {
            if let Some(event) = self.query.event(session.view(), number) {
                let nearer = |best: Option<usize>| {
                    best.map_or(event, |best| {
                        if self.forward {
                            best.min(event)
                        } else {
                            best.max(event)
                        }
                    })
                };
                if self.is_next(event) {
                    self.next = Some(nearer(self.next));
                } else {
                    self.around = Some(nearer(self.around));
                }
            }
            let is_found = !self.forward && self.next.is_some();
            ray = session.tree().node(number).parent.filter(|_| is_found);
        }
    }

    fn is_next(&self, event: usize) -> bool {
        if self.forward {
            event > self.here
        } else {
            event < self.here
        }
    }

    /// Goes to the ray that was found. Tells which it is, or that there is none, and then the cursor stays.
    pub fn finish(&self, session: &mut Session, found: RayFound) -> Result<String, String> {
        let Some(found) = found else {
            let place = match session.horizon() {
                Some(_) => "before the question",
                None => "of this tree",
            };
            return Err(format!("no ray {place} satisfies it"));
        };
        let mut told = String::new();
        let tree = session.tree();
        if tree.nodes.len() <= COUNTED {
            let all = 0..tree.nodes.len() as u32;
            let event = |node| self.query.event(session.view(), node);
            let events: Vec<usize> = all.filter_map(event).collect();
            let number = events.iter().filter(|at| **at <= found).count();
            let known = session.horizon().map_or("", |_| " before the question");
            told = format!("ray {number} of {}{known} that satisfy it", events.len());
        }
        if !self.is_next(found) {
            told += match (found == self.here, self.forward) {
                (true, _) => " (there is no other)",
                (false, true) => " (from the start again)",
                (false, false) => " (from the end again)",
            };
        }
        session.go(Cursor::at(session.tree(), found));
        Ok(told)
    }
}

impl Session {
    /// Goes to the first ray that satisfies a query, if there is one.
    pub fn find_first(&mut self, query: &TreeQuery) {
        let each = query.of_each_ray();
        let mut all = 0..self.tree().nodes.len() as u32;
        let found = all.find_map(|n| each.event(self.view(), n));
        if let Some(found) = found {
            self.go(Cursor::at(self.tree(), found));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::scene::load;
    use crate::world::World;

    /// In the order of the log, forwards and backwards; and the clock changes nothing.
    #[test]
    fn each_event_is_found_both_ways_whatever_the_clock_does() {
        let scene = load("nested-glass").expect("a scene");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (64, 48);
            s.pixel.samples = 200;
        });
        let world = Arc::new(World::new(scene, settings.accel));
        let mut session = Session::new(world, settings, (32, 24));
        assert!(session.tree().nodes.len() > 4 * BETWEEN);
        for text in [
            "T and hit",
            "absent:total-internal-reflection",
            "depth >= 4",
            "depth >= 60",
        ] {
            let query: TreeQuery = text.parse().expect(text);
            let each = query.of_each_ray();
            let rays = 0..session.tree().nodes.len() as u32;
            let mut all: Vec<usize> = rays.filter_map(|n| each.event(session.view(), n)).collect();
            all.sort_unstable();
            assert_eq!(all.is_empty(), text == "depth >= 60", "{text}");
            let mut walk = |forward: bool, here: usize| {
                let mut patient = RaySearch::new(&query, here, forward);
                let found = patient.go_on(&session, None).expect("to the end");
                let mut hasty = RaySearch::new(&query, here, forward);
                let mut pauses = 0;
                let again = loop {
                    match hasty.go_on(&session, Some(Instant::now())) {
                        Some(again) => break again,
                        None => pauses += 1,
                    }
                };
                assert_eq!(found, again, "{text}");
                let told = hasty.finish(&mut session, again);
                assert_eq!(told.is_ok(), found.is_some(), "{text}: {told:?}");
                (found, pauses)
            };
            let (nowhere, pauses) = walk(true, usize::MAX);
            assert_eq!(nowhere, all.first().copied(), "from the start again");
            assert!(pauses >= 4, "{text}: {pauses} pauses");
            assert_eq!(walk(false, 0).0, all.last().copied(), "from the end again");
            let mut here = 0;
            for event in &all {
                assert_eq!(walk(true, here).0, Some(*event), "{text}");
                here = *event;
            }
            here = usize::MAX;
            for event in all.iter().rev() {
                assert_eq!(walk(false, here).0, Some(*event), "{text}");
                here = *event;
            }
        }
    }
}
