//! Where a question of a quantity stops, and the event that answers it.
//!
//! The horizon stands before the first event in which the answer can be read, not before the one that it belongs to: t is in the
//! tests before the hit, the weight of R in the boundary before the ray.

use crate::probe::{Event, NONE, RayKind};
use crate::trace::address::{AddressPart, node_at};
use crate::trace::facts::Step;
use crate::trace::{Address, RayTree, View};

/// What a question of a quantity hides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AskedEvent {
    /// The first event that is not known before the answer.
    pub horizon: usize,
    /// The event that tells the answer.
    pub answer: usize,
}

impl AskedEvent {
    fn at(event: usize) -> Self {
        Self::of(event, event)
    }

    fn of(horizon: usize, answer: usize) -> Self {
        // The first event of a log is its sample: there is nothing to show without it.
        let horizon = horizon.max(1);
        Self {
            horizon,
            answer: answer.max(horizon),
        }
    }
}

/// Where a question of a field of a ray stops. An error if there is no such ray.
pub fn asked(view: View, at: &Address) -> Result<AskedEvent, String> {
    let node = node_at(view, &at.path)?;
    let finder = AskedFinder {
        view,
        tree: &view.trace.tree,
        node,
    };
    Ok(match &at.part {
        Some(AddressPart::Field(field)) => {
            finder.field(field.strip_prefix("hit.").unwrap_or(field))
        }
        Some(AddressPart::Event(event)) => AskedEvent::at(*event),
        None => finder.whole(),
    })
}

/// A ray whose quantities are asked for.
struct AskedFinder<'a> {
    view: View<'a>,
    tree: &'a RayTree,
    node: u32,
}

impl AskedFinder<'_> {
    fn field(&self, field: &str) -> AskedEvent {
        let (first, last) = self.ends();
        let head = field.split(['.', '[', ':']).next().unwrap_or_default();
        match head {
            "origin" | "direction" | "distance" | "t_max" | "depth" => AskedEvent::at(first),
            "weight" | "throughput" | "medium" | "ior" => {
                AskedEvent::of(self.weighed(self.tree.node(self.node).parent, first), first)
            }
            "outcome" | "lit" | "t" | "object" | "part" | "primitive" | "steps" => {
                AskedEvent::of(first + 1, self.end_of_search())
            }
            "point" | "normal" | "geometric_normal" | "side" | "material" | "angle"
            | "normal_angle" => AskedEvent::at(self.end_of_search()),
            "barycentric" | "uv" => AskedEvent::of(self.test_of_hit(), self.end_of_search()),
            "sphere" => AskedEvent::at(self.test_of_hit()),
            "order" => AskedEvent::at((first + 1 + number(field)).min(self.end_of_search())),
            "boundary" => self.or_rest(self.own(|event| matches!(event, Event::Boundary { .. }))),
            "terms" => self.or_rest(self.term(field)),
            "absent" => self.absence(field),
            "radiance" => AskedEvent::of(self.only_term().unwrap_or(last), last),
            "rays" => {
                let mut children = self.tree.children(self.node);
                let child = children.next().map(|child| self.tree.node(child));
                let child = child.map_or(last, |child| child.first_event as usize);
                AskedEvent::of(child, last)
            }
            "color" | "srgb8" | "error" => {
                let events = self.tree.events.iter();
                let returns = |event: &Event| matches!(event, Event::Return { .. });
                AskedEvent::at(events.into_iter().rposition(returns).unwrap_or(last))
            }
            _ => self.whole(),
        }
    }

    /// All of the ray: what is not known here may be read anywhere.
    fn whole(&self) -> AskedEvent {
        let (first, last) = self.ends();
        AskedEvent::of(first, last)
    }

    fn ends(&self) -> (usize, usize) {
        let node = self.tree.node(self.node);
        (node.first_event as usize, node.last_event as usize)
    }

    fn own(&self, is_it: impl Fn(&Event) -> bool) -> Option<usize> {
        self.own_of(self.node, is_it)
    }

    fn own_of(&self, node: u32, is_it: impl Fn(&Event) -> bool) -> Option<usize> {
        let mut own = self.tree.own_events(node);
        own.find_map(|(at, event)| is_it(event).then_some(at))
    }

    /// An event, or all behind the search where there is none.
    fn or_rest(&self, event: Option<usize>) -> AskedEvent {
        match event {
            Some(event) => AskedEvent::at(event),
            None => AskedEvent::of(self.end_of_search() + 1, self.ends().1),
        }
    }

    /// The event that tells what the ray met.
    fn end_of_search(&self) -> usize {
        let is_end = |event: &Event| {
            matches!(
                event,
                Event::Hit(_) | Event::Miss | Event::Lit | Event::Blocked(_)
            )
        };
        self.own(is_end).unwrap_or(self.ends().0)
    }

    /// The first test of what the ray met.
    fn test_of_hit(&self) -> usize {
        let end = self.end_of_search();
        let Some(Event::Hit(hit) | Event::Blocked(hit)) = self.tree.events.get(end) else {
            return self.ends().0 + 1;
        };
        let is_test = |event: &Event| matches!(event, Event::Test { primitive, .. } if *primitive == hit.primitive);
        self.own(is_test).unwrap_or(end)
    }

    /// The boundary at which the weights of R and T are told, or an event where there is none.
    fn weighed(&self, sender: Option<u32>, event: usize) -> usize {
        let is_boundary = |event: &Event| matches!(event, Event::Boundary { .. });
        let boundary = sender.and_then(|sender| self.own_of(sender, is_boundary));
        boundary.map_or(event, |at| at.min(event))
    }

    /// The term of `terms.KIND:LIGHT`.
    fn term(&self, field: &str) -> Option<usize> {
        let mut parts = field.split('.').skip(1);
        let name = parts.next().unwrap_or_default();
        let (kind, light) = name.split_once(':').unwrap_or((name, ""));
        let light = light_of(light);
        let is_it = |event: &Event| match event {
            Event::Term {
                term,
                light: l,
                sample,
            } => {
                term.kind().name() == kind
                    && light.as_ref().is_none_or(|(name, n)| {
                        self.view.light_name(*l) == name && u32::from(*sample) == *n
                    })
            }
            _ => false,
        };
        self.own(is_it)
    }

    /// The only term of a ray that sends none further: its value is the radiance.
    fn only_term(&self) -> Option<usize> {
        let is_term = |event: &Event| matches!(event, Event::Term { .. });
        let mut terms = self.tree.own_events(self.node).filter(|own| is_term(own.1));
        let first = terms.next().map(|own| own.0);
        let is_only = terms.next().is_none() && self.tree.children(self.node).next().is_none();
        first.filter(|_| is_only)
    }

    /// Where it is told that a ray `absent.KIND:LIGHT` is not sent, or is.
    fn absence(&self, field: &str) -> AskedEvent {
        let name = field.split('.').nth(1).unwrap_or_default();
        let (letter, light) = name.split_once(':').unwrap_or((name, ""));
        let light = light_of(light);
        let is_it = |kind: RayKind, to: u32| {
            let name = self.view.light_name(to);
            kind.letter() == letter && (to == NONE || light.as_ref().is_none_or(|l| l.0 == name))
        };
        let absent = self.own(
            |event| matches!(event, Event::Absent { kind, light, .. } if is_it(*kind, *light)),
        );
        let sent = self.tree.children(self.node).find_map(|child| {
            let child = self.tree.node(child);
            is_it(child.ray.kind, child.ray.light).then_some(child.first_event as usize)
        });
        let Some(told) = absent.into_iter().chain(sent).min() else {
            return self.or_rest(None);
        };
        if letter == RayKind::Light.letter() {
            return AskedEvent::at(told);
        }
        AskedEvent::of(self.weighed(Some(self.node), told), told)
    }
}

/// The light and the number of its sample, as they stand in paths.
fn light_of(text: &str) -> Option<(String, u32)> {
    match format!("L:{text}").parse() {
        Ok(Step::Light(name, sample)) if !text.is_empty() => Some((name, sample)),
        _ => None,
    }
}

/// The number in `order[4]`.
fn number(field: &str) -> usize {
    let digits = field.split(['[', ']']).nth(1);
    digits.and_then(|digits| digits.parse().ok()).unwrap_or(0)
}
