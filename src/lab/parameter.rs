//! Parameter that `raytree cost` varies, and its steps.

use crate::scene::Settings;
use crate::scene::settings::knob::{Knob, Value};
use crate::scene::settings::knobs::knob;

/// Group of all that is about samples of a pixel.
pub const PIXEL_SAMPLES: &str = "pixel samples";

/// Group of all that is about rays to area lights.
pub const LIGHT_SAMPLES: &str = "light samples";

/// Parameter that is varied while all the rest stays.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// What is varied.
    pub group: &'static str,
    /// Which way of it, where there are several: they share a reference, and can be compared.
    pub variant: Option<&'static str>,
    /// Its steps, the cheapest first.
    pub steps: Vec<ParameterStep>,
    /// The settings of the reference: the parameter at its best, with another seed. `None` if it never changes the
    /// picture.
    pub reference: Option<Settings>,
    /// The slope of log error over log samples that theory tells, where there is one.
    pub theory: Option<&'static str>,
}

/// Step of a parameter.
#[derive(Clone, Debug)]
pub struct ParameterStep {
    /// Its name.
    pub name: String,
    /// The samples that it takes, if it is about samples.
    pub samples: Option<u32>,
    /// The whole settings.
    pub settings: Settings,
    /// Whether shapes are tested one by one with the arithmetic of the settings, ours like any other: see
    /// `lab::arithmetic_sweep`.
    pub one_by_one: bool,
}

impl Parameter {
    /// What is varied, and which way.
    pub fn name(&self) -> String {
        match self.variant {
            None => self.group.to_owned(),
            Some(variant) => format!("{}, {variant}", self.group),
        }
    }

    /// True if it varies the arithmetic that shapes are tested with, and nothing else.
    pub fn is_arithmetic(&self) -> bool {
        self.steps.iter().any(|step| step.one_by_one)
    }

    /// True if a user means it by `name`: its group, or its whole name; with `-` for what is no letter.
    pub fn is_called(&self, name: &str) -> bool {
        let slug = |text: &str| text.replace(", ", "-").replace(' ', "-");
        [slug(self.group), slug(&self.name())].contains(&slug(name))
    }
}

impl ParameterStep {
    /// A step that is not about samples.
    pub fn new(name: String, settings: Settings) -> Self {
        Self {
            name,
            samples: None,
            settings,
            one_by_one: false,
        }
    }
}

/// A knob of the command line as a parameter, with the steps of its row; no reference.
pub fn swept(group: &'static str, flag: &str, base: &Settings) -> Parameter {
    let step = |knob: &Knob, value: Value| {
        let settings = base.with(|s| (knob.field.set)(s, &value));
        let name = match value {
            Value::Real(x) => format!("{x:.3}"),
            value => value.to_string(),
        };
        ParameterStep::new(name, settings)
    };
    let steps = |knob: &Knob| {
        knob.steps()
            .into_iter()
            .map(|value| step(knob, value))
            .collect()
    };
    Parameter {
        group,
        variant: None,
        steps: knob(flag).map(steps).unwrap_or_default(),
        reference: None,
        theory: None,
    }
}
