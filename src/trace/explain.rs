//! Explanations of events: the equation with its numbers, and one plain sentence.
//!
//! Nothing here is derived by hand: values come from the log, or from the tracer's own functions with the recorded
//! inputs.

mod absence;
mod bodies;
mod corners;
mod end;
mod fresnel;
mod light_samples;
mod patches;
mod ray;
mod screen;
mod shapes;
mod source;
mod source_text;
mod surface;
mod term;
mod traversal;

pub use source::SourcePlace;
pub use source_text::source_text;

use super::View;
use super::format::rgb;
use crate::math::Rgb;
use crate::probe::{Event, NONE};

/// What stands in the place of what is not known yet.
pub const UNKNOWN: &str = "?";

/// What an event means.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Explanation {
    /// What it is, in a few words.
    pub title: String,
    /// What it means, in one sentence.
    pub sentence: String,
    /// The numbers, from the given to the result.
    pub rows: Vec<Quantity>,
    /// The function of this program that does it.
    pub source: SourcePlace,
}

/// A quantity and its value, or an equation and its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// What stands left of the equals sign.
    pub name: String,
    /// What stands right of it.
    pub text: String,
    /// The colour, if the value is one.
    pub color: Option<Rgb>,
}

impl Explanation {
    fn new(title: impl Into<String>, sentence: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            sentence: sentence.into(),
            rows: Vec::new(),
            source: SourcePlace::default(),
        }
    }

    /// Adds `name = text`.
    fn row(mut self, name: impl Into<String>, text: impl Into<String>) -> Self {
        self.rows.push(Quantity {
            name: name.into(),
            text: text.into(),
            color: None,
        });
        self
    }

    /// Adds `name = text`, if there is one.
    fn row_if(self, name: &str, text: Option<&str>) -> Self {
        match text {
            Some(text) => self.row(name, text),
            None => self,
        }
    }

    /// Adds `name = colour`.
    fn color(mut self, name: impl Into<String>, value: Rgb) -> Self {
        self.rows.push(Quantity {
            name: name.into(),
            text: rgb(value),
            color: Some(value),
        });
        self
    }
}

/// The explanation of an event, by its index in the log.
pub fn explain(view: View, index: usize) -> Explanation {
    let tree = &view.trace.tree;
    let Some(event) = tree.events.get(index) else {
        return Explanation::new("nothing", "The log is empty.");
    };
    let node = tree.node_of_event(index).unwrap_or(NONE);
    Explanation {
        source: source::source(view, event),
        ..of_event(view, node, index, event)
    }
}

fn of_event(view: View, node: u32, index: usize, event: &Event) -> Explanation {
    match *event {
        Event::Sample {
            index,
            film,
            weight,
        } => ray::sample(view, index, film, weight),
        Event::Ray(sent) => ray::sent(view, node, &sent),
        Event::Visit(visit) => traversal::visit(view, node, &visit),
        Event::Test {
            primitive,
            verdict,
            t,
        } => {
            let leaf = traversal::leaf_at(view, index);
            traversal::test(view, (node, leaf), (primitive, verdict, t))
        }
        Event::LightSamples { light, .. } => light_samples::light_samples(view, node, light),
        Event::Hit(_) => surface::hit(view, node),
        Event::Miss => end::miss(view),
        Event::Lit => end::lit(view, node),
        Event::Blocked(_) => end::blocked(view, node),
        Event::Term {
            term,
            sample,
            light,
        } => term::term(view, node, &term, (light, u32::from(sample))),
        Event::Passed { hit, medium } => surface::passed(view, node, &hit, medium),
        Event::Boundary {
            n1,
            n2,
            reflectance,
        } => surface::boundary(view, node, n1, n2, reflectance),
        Event::Absent {
            kind,
            light,
            reason,
        } => absence::absent(view, node, kind, light, reason),
        Event::Return { radiance } => end::returned(view, node, radiance),
    }
}
