//! Knobs of the samples of a pixel.

use super::{ROW, words};
use crate::sampling::{Filter, Sampler};
use crate::scene::limits::{MAX_FILTER_RADIUS, MAX_SAMPLES};
use crate::scene::settings::knob::{Field, Kind, Knob, Value};
use crate::scene::{Adaptive, Pilot, Sampling};

/// First samples of a pixel that may have more, unless the scene or the user wants others.
const FIRST: u32 = 4;

/// Samples that an adaptive pixel has at most.
const MOST: u32 = 256;

const PIXEL: &str = "Samples of a pixel";

const PIXEL_SAMPLERS: fn() -> [(Sampler, &'static str, &'static str); 4] =
    || Sampling::ALL.map(|word| (word.sampler(), word.name(), ""));

/// Rows of the table.
pub const ROWS: &[Knob] = &[
    Knob {
        flag: "samples",
        doc: "Samples a pixel; with --adaptive the first ones",
        heading: PIXEL,
        kind: Kind::Count {
            range: [1, MAX_SAMPLES],
            of: "samples a pixel",
        },
        field: number!(Whole, pixel.samples),
        json: "samples",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "sampling",
        value_name: "WHERE",
        doc: "Where the samples of a pixel lie",
        heading: PIXEL,
        kind: Kind::Choice(|| words(&PIXEL_SAMPLERS())),
        field: choice!(PIXEL_SAMPLERS(), pixel.sampler),
        json: "sampling",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "sets",
        doc: "Sets that the samples are parted into, each spread evenly by itself: the standard error is estimated from \
              how much they differ",
        heading: PIXEL,
        kind: Kind::Count {
            range: [1, MAX_SAMPLES],
            of: "sets of samples",
        },
        field: number!(Whole, pixel.sets),
        json: "sets",
        conflicts_with: Some("adaptive"),
        ..ROW
    },
    Knob {
        flag: "filter",
        value_name: "FILTER",
        doc: "How much samples count by their distance from the pixel's middle",
        heading: PIXEL,
        kind: Kind::Choice(|| words(&names!(Filter))),
        field: Field {
            set: |s, value| {
                if let Some(filter) = Filter::ALL.into_iter().find(|f| value.is(f.name())) {
                    s.pixel.filter = filter;
                    s.pixel.filter_radius = filter.usual_radius();
                }
            },
            ..choice!(names!(Filter), pixel.filter)
        },
        json: "filter",
        implies_others: true,
        ..ROW
    },
    Knob {
        flag: "filter-radius",
        value_name: "R",
        doc: "How far from the middle they lie, in pixels [default: box 0.5, tent 1, gaussian 1.5, mitchell 2]",
        heading: PIXEL,
        kind: Kind::Real {
            possible: |x| x > 0.0 && x <= MAX_FILTER_RADIUS,
            must_be: "a number of pixels above 0, at most 16",
        },
        field: number!(Real, pixel.filter_radius),
        json: "filter_radius",
        ..ROW
    },
    Knob {
        flag: "adaptive",
        value_name: "THRESHOLD",
        doc: "More samples where they are needed: until a pixel's estimated standard error (of linear luminance) is at \
              most this; with --pilot around as many as the standard deviation of a sample is times this",
        heading: PIXEL,
        kind: Kind::POSITIVE,
        field: Field {
            get: |s| s.pixel.adaptive.map(|a| Value::Real(a.threshold)),
            set: |s, value| {
                let Value::Real(threshold) = *value else {
                    return;
                };
                s.pixel.adaptive = Some(Adaptive {
                    threshold,
                    most: MOST,
                    pilot: Pilot::default(),
                });
                s.pixel.samples = s.pixel.samples.max(FIRST);
                // A grid that is full has no place for more.
                if s.pixel.sampler == Sampler::Grid {
                    s.pixel.sampler = Sampler::Sobol;
                }
            },
        },
        json: "adaptive.threshold",
        implies_others: true,
        ..ROW
    },
    Knob {
        flag: "max-samples",
        doc: "The most samples of a pixel [default: 256]",
        heading: PIXEL,
        kind: Kind::Count {
            range: [1, MAX_SAMPLES],
            of: "samples a pixel",
        },
        field: Field {
            get: |s| s.pixel.adaptive.map(|a| Value::Whole(a.most.into())),
            set: |s, value| {
                if let (Some(adaptive), Value::Whole(most)) = (&mut s.pixel.adaptive, value) {
                    adaptive.most = *most as u32;
                }
            },
        },
        json: "adaptive.max_samples",
        requires: Some("adaptive"),
        ..ROW
    },
    Knob {
        flag: "pilot",
        value_name: "WHAT",
        doc: "What becomes of the samples that decide how many there are: kept (a small bias), apart (they do not count: \
              no bias) or around (they decide for the pixels around, and count: no bias, and little is missed)",
        heading: PIXEL,
        kind: Kind::Choice(|| words(&names!(Pilot))),
        field: Field {
            get: |s| {
                s.pixel
                    .adaptive
                    .map(|a| Value::Text(a.pilot.name().to_owned()))
            },
            set: |s, value| {
                let pilot = Pilot::ALL.into_iter().find(|p| value.is(p.name()));
                if let (Some(adaptive), Some(pilot)) = (&mut s.pixel.adaptive, pilot) {
                    adaptive.pilot = pilot;
                }
            },
        },
        json: "adaptive.pilot",
        requires: Some("adaptive"),
        ..ROW
    },
];
