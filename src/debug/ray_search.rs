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
    /// The first of them that satisfies the query, however it stands to `here`: the answer if no other follows.
    first: Option<usize>,
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
            first: None,
        }
    }

    /// Searches until a ray is found, all were looked at, or the time is over: then none.
    pub fn go_on(&mut self, session: &Session, until: Option<Instant>) -> Option<RayFound> {
        let count = session.tree().nodes.len();
        while self.looked_at < count {
            let number = if self.forward {
                self.looked_at
            } else {
                count - 1 - self.looked_at
            };
            self.looked_at += 1;
            if let Some(event) = self.query.event(session.view(), number as u32) {
                if self.is_next(event) {
                    return Some(Some(event));
                }
                self.first = self.first.or(Some(event));
            }
            let is_late = || until.is_some_and(|until| Instant::now() >= until);
            if self.looked_at.is_multiple_of(BETWEEN) && is_late() {
                return None;
            }
        }
        Some(self.first)
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

    /// Every event that a search forward stops at, a search back stops at, too; and the clock changes nothing.
    #[test]
    fn back_finds_what_forward_finds_whatever_the_clock_does() {
        let scene = load("nested-glass").expect("a scene");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (64, 48);
            s.pixel.samples = 400;
        });
        let world = Arc::new(World::new(scene, settings.accel));
        let mut session = Session::new(world, settings, (32, 24));
        assert!(session.tree().nodes.len() > 4 * BETWEEN);
        for text in ["T and hit", "absent:tir", "depth >= 4", "depth >= 60"] {
            let query: TreeQuery = text.parse().expect(text);
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
            let all: Vec<usize> = {
                let (mut all, mut here) = (Vec::new(), 0);
                while let (Some(event), _) = walk(true, here)
                    && event > here
                {
                    all.push(event);
                    here = event;
                }
                all
            };
            assert_eq!(all.is_empty(), text == "depth >= 60", "{text}");
            let (nowhere, pauses) = walk(true, usize::MAX);
            assert_eq!(nowhere, all.first().copied(), "from the start again");
            assert!(pauses >= 4, "{text}: {pauses} pauses");
            let mut here = usize::MAX;
            for event in all.iter().rev() {
                assert_eq!(walk(false, here).0, Some(*event), "{text}");
                here = *event;
            }
        }
    }
}
