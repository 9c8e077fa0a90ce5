//! Where the numbers of an event come from, and where they go.
//!
//! Only the first is written down; the second is found by asking every event nearby for the first.

use crate::probe::{Event, RayKind, Term, TermKind, Verdict};
use crate::trace::{RayTree, View};

/// Events that are asked, and places that are listed, at most.
const MOST: usize = 500;

/// A number of an event, and where it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// What comes from there.
    pub what: &'static str,
    /// Where that is.
    pub place: OriginPlace,
}

/// Where a number comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OriginPlace {
    /// An event of the log.
    Event(usize),
    /// A field of the scene file, or a setting, in words.
    Input(String),
}

/// What is known of the event whose numbers are followed.
struct OriginFinder<'a> {
    view: View<'a>,
    tree: &'a RayTree,
    event: usize,
    node: u32,
    list: Vec<Origin>,
}

/// Where the numbers of an event come from.
pub fn origins(view: View, event: usize) -> Vec<Origin> {
    let tree = &view.trace.tree;
    let Some(what) = tree.events.get(event) else {
        return Vec::new();
    };
    let mut of = OriginFinder {
        view,
        tree,
        event,
        node: tree.node_of_event(event).unwrap_or(0),
        list: Vec::new(),
    };
    if tree.nodes.is_empty() {
        return Vec::new();
    }
    match what {
        Event::Sample { .. } => {
            of.input(
                "place in the pixel, weight",
                "settings: samples, sampling, filter, seed",
            );
            of.input("u, v, w, tan(fov/2)", "scene: camera");
        }
        Event::Ray(sent) => of.sent(sent.kind, sent.light),
        Event::Visit(visit) => {
            of.start("the ray");
            of.event("the interval", |o| o.parent_visit(visit.node));
        }
        Event::Test { primitive, .. } => {
            of.start("the ray");
            of.object("the shape", *primitive);
        }
        Event::LightSamples { light, .. } => {
            of.event("the hit point", |o| o.own(is_hit));
            of.light("place and size", *light);
            of.input("how many", "settings: light-samples");
        }
        Event::Hit(hit) | Event::Blocked(hit) | Event::Passed { hit, .. } => {
            of.start("origin, direction");
            of.event("t", |o| o.test_of(hit.primitive));
            of.object("N", hit.primitive);
        }
        Event::Miss => {
            of.start("direction");
        }
        Event::Lit => {
            of.start("the ray");
        }
        Event::Term {
            term,
            sample,
            light,
        } => of.term(term, *light, *sample),
        Event::Boundary { .. } => {
            of.start("I");
            of.event("N", |o| o.own(is_hit));
            of.material("n1, n2");
        }
        Event::Absent { light, .. } => {
            of.event("the hit point", |o| o.own(is_hit));
            of.event("F", |o| o.own(is_boundary));
            of.material("coefficients");
            of.light("place", *light);
        }
        Event::Return { .. } => of.sums(),
    }
    of.list
}

/// The events whose numbers come from this one.
pub fn uses(view: View, event: usize) -> Vec<(usize, &'static str)> {
    let tree = &view.trace.tree;
    let Some(node) = tree.node_of_event(event) else {
        // A sample: its eye ray follows.
        let next = event + 1;
        return of_event(view, next, event)
            .map(|what| (next, what))
            .into_iter()
            .collect();
    };
    let parent = tree.node(node).parent;
    let own = tree.own_events(node).map(|(at, _)| at);
    let of_parent = parent
        .into_iter()
        .flat_map(|p| tree.own_events(p).map(|(at, _)| at));
    let sent = |n: u32| {
        tree.children(n)
            .map(|child| tree.node(child).first_event as usize)
    };
    let asked = own.chain(sent(node)).chain(of_parent);
    let found = asked
        .filter(|at| *at > event)
        .take(MOST)
        .filter_map(|at| of_event(view, at, event).map(|what| (at, what)));
    let mut found: Vec<_> = found.collect();
    found.sort_unstable();
    found
}

/// What of an event comes from another one.
fn of_event(view: View, event: usize, from: usize) -> Option<&'static str> {
    let all = origins(view, event).into_iter();
    let mut here = all.filter(|o| o.place == OriginPlace::Event(from));
    here.next().map(|o| o.what)
}

fn is_hit(event: &Event) -> bool {
    matches!(event, Event::Hit(_))
}

fn is_boundary(event: &Event) -> bool {
    matches!(event, Event::Boundary { .. })
}

impl OriginFinder<'_> {
    fn push(&mut self, what: &'static str, place: OriginPlace) {
        if self.list.len() < MOST {
            self.list.push(Origin { what, place });
        }
    }

    fn input(&mut self, what: &'static str, words: impl Into<String>) {
        self.push(what, OriginPlace::Input(words.into()));
    }

    /// An event, if there is one.
    fn event(&mut self, what: &'static str, find: impl Fn(&Self) -> Option<usize>) {
        if let Some(at) = find(self) {
            self.push(what, OriginPlace::Event(at));
        }
    }

    /// An object of the scene.
    fn object(&mut self, what: &'static str, primitive: u32) {
        let name = &self.view.world.scene.object_of(primitive).name;
        self.input(what, format!("scene: object `{name}`"));
    }

    /// The material at the hit point.
    fn material(&mut self, what: &'static str) {
        let hit = self.own(is_hit).and_then(|at| self.tree.events.get(at));
        if let Some(Event::Hit(hit)) = hit {
            let name = &self.view.world.scene.material_at(hit).name;
            self.input(what, format!("scene: material `{name}`"));
        }
    }

    /// A light, if it is one.
    fn light(&mut self, what: &'static str, light: u32) {
        let name = self.view.light_name(light);
        if !name.is_empty() {
            self.input(what, format!("scene: light `{name}`"));
        }
    }

    /// Where the ray of this event is sent.
    fn start(&mut self, what: &'static str) {
        let first = self.tree.node(self.node).first_event as usize;
        self.push(what, OriginPlace::Event(first));
    }

    /// The ray's own event of a kind.
    fn own(&self, is_it: fn(&Event) -> bool) -> Option<usize> {
        self.own_of(self.node, is_it)
    }

    fn own_of(&self, node: u32, is_it: impl Fn(&Event) -> bool) -> Option<usize> {
        let before = self.tree.own_events(node);
        let mut before = before.take_while(|(at, _)| *at < self.event);
        before.find_map(|(at, event)| is_it(event).then_some(at))
    }

    /// The visit before here to the node that this one hangs on.
    fn parent_visit(&self, child: u32) -> Option<usize> {
        let first = self.tree.node(self.node).first_event as usize;
        let before = self.tree.events.get(first..self.event)?;
        let is_parent =
            |event: &Event| matches!(event, Event::Visit(v) if v.near == child || v.far == child);
        before.iter().rposition(is_parent).map(|at| first + at)
    }

    /// The test before here that found a primitive.
    fn test_of(&self, wanted: u32) -> Option<usize> {
        let first = self.tree.node(self.node).first_event as usize;
        let before = self.tree.events.get(first..self.event)?;
        let found = |event: &Event| matches!(event, Event::Test { primitive, verdict: Verdict::Hit, .. } if *primitive == wanted);
        before.iter().rposition(found).map(|at| first + at)
    }

    /// A ray: from the sample and the camera, or from the hit that sent it.
    fn sent(&mut self, kind: RayKind, light: u32) {
        let Some(parent) = self.tree.node(self.node).parent else {
            let before = self.event.checked_sub(1);
            self.event("place on the film", |_| before);
            self.input("eye, u, v, w", "scene: camera");
            return;
        };
        let hit = self.own_of(parent, is_hit);
        self.event("origin", |_| hit);
        match kind {
            RayKind::Incident => {}
            RayKind::Light => self.light("direction, distance", light),
            RayKind::Reflected | RayKind::Transmitted => {
                let first = self.tree.node(parent).first_event as usize;
                self.event("I", |_| Some(first));
                let boundary = self.own_of(parent, is_boundary);
                self.event("n1, n2, F", |_| boundary);
                if let Some(Event::Hit(hit)) = hit.and_then(|at| self.tree.events.get(at)) {
                    let name = &self.view.world.scene.material_at(hit).name;
                    self.input("weight", format!("scene: material `{name}`"));
                }
            }
        }
    }

    /// A term of the shading equation.
    fn term(&mut self, term: &Term, light: u32, sample: u16) {
        match term {
            Term::Background { .. } => {
                self.event("direction", |o| o.own(|event| matches!(event, Event::Miss)));
                self.input("colour", "scene: background");
                return;
            }
            Term::Ambient { .. }
            | Term::Blended {
                kind: TermKind::Ambient,
                ..
            } => self.input("ambient light", "scene: ambient"),
            _ => {}
        }
        if matches!(term, Term::Blended { .. }) {
            let hit = self.own(is_hit);
            if let Some(Event::Hit(hit)) = hit.and_then(|at| self.tree.events.get(at)) {
                self.object("corners and their normals", hit.primitive);
            }
            self.event("weights", |_| hit);
        } else {
            self.event("N, V, the hit point", |o| o.own(is_hit));
        }
        self.material("coefficients");
        let (tree, node) = (self.tree, self.node);
        let is_it = |child: &u32| {
            let sent = &tree.node(*child).ray;
            sent.kind == RayKind::Light && (sent.light, sent.sample) == (light, sample)
        };
        let asked = tree.children(node).find(is_it);
        let lit = asked.and_then(|child| self.own_of(child, |event| matches!(event, Event::Lit)));
        self.event("L, whether it is lit", |_| lit);
        self.light("intensity", light);
    }

    /// What a ray brings back: its terms, and what the rays that it sent bring back.
    fn sums(&mut self) {
        let tree = self.tree;
        self.event("whether it is lit", |o| {
            o.own(|event| matches!(event, Event::Lit | Event::Blocked(_)))
        });
        for (at, event) in tree.own_events(self.node) {
            if matches!(event, Event::Term { .. }) {
                self.push("term", OriginPlace::Event(at));
            }
        }
        for child in tree.children(self.node) {
            let child = tree.node(child);
            if child.ray.kind != RayKind::Light {
                let what = if child.ray.kind == RayKind::Reflected {
                    "weight x R"
                } else {
                    "weight x T"
                };
                self.push(what, OriginPlace::Event(child.last_event as usize));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::scene::load;
    use crate::trace::trace_pixel;
    use crate::world::World;

    /// Every event comes from earlier ones, all but the returns of eye rays go somewhere, and both ways are one.
    #[test]
    fn where_it_goes_is_where_it_comes_from_backwards() {
        for (name, at) in [
            ("whitted", (32, 24)),
            ("nested-glass", (30, 24)),
            ("soft-shadow", (24, 36)),
            ("gouraud", (32, 24)),
        ] {
            let scene = load(name).expect(name);
            let settings = scene.settings.with(|s| {
                (s.image.width, s.image.height) = (64, 48);
                s.light.samples = 4;
            });
            let world = World::new(scene, settings.accel);
            let trace = trace_pixel(&world, &settings, at, true);
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            let (mut there, mut back) = (BTreeSet::new(), BTreeSet::new());
            for event in 0..trace.tree.events.len() {
                let from = origins(view, event);
                assert!(!from.is_empty(), "{name}: event {event} comes from nothing");
                for origin in from {
                    if let OriginPlace::Event(from) = origin.place {
                        assert!(from < event, "{name}: {event} from {from}");
                        there.insert((from, event));
                    }
                }
                back.extend(uses(view, event).into_iter().map(|(to, _)| (event, to)));
            }
            assert_eq!(there, back, "{name}");
            assert!(there.len() > trace.tree.events.len(), "{name}");
        }
    }

    /// From the sum of the pixel every event that brings light is reached.
    #[test]
    fn the_sum_leads_to_every_term() {
        let scene = load("whitted").expect("built in");
        let settings = scene.settings;
        let world = World::new(scene, settings.accel);
        let (width, height) = settings.size();
        let trace = trace_pixel(&world, &settings, (width / 2, height / 2), true);
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        let mut reached = BTreeSet::new();
        let mut todo = vec![trace.tree.events.len() - 1];
        let mut inputs = BTreeSet::new();
        while let Some(event) = todo.pop() {
            for origin in origins(view, event) {
                match origin.place {
                    OriginPlace::Event(from) => {
                        if reached.insert(from) {
                            todo.push(from);
                        }
                    }
                    OriginPlace::Input(words) => {
                        inputs.insert(words);
                    }
                }
            }
        }
        for (at, event) in trace.tree.events.iter().enumerate() {
            let brings = matches!(event, Event::Term { .. } | Event::Sample { .. });
            assert!(!brings || reached.contains(&at), "event {at}: {event:?}");
        }
        assert!(inputs.contains("scene: camera"), "{inputs:?}");
        assert!(inputs.iter().any(|i| i.contains("material")), "{inputs:?}");
    }
}
