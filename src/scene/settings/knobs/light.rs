//! Knobs of the shadow rays to area lights.

use super::{ROW, words};
use crate::sampling::{LightSampling, Sampler};
use crate::scene::limits::MAX_LIGHT_SAMPLES;
use crate::scene::settings::knob::{Field, Kind, Knob, Value};

const LIGHT_SAMPLERS: [(Sampler, &str, &str); 4] = [
    (Sampler::Grid, "grid", "The middles of a grid: hard bands"),
    (Sampler::Random, "random", "Anywhere by chance: noise"),
    (
        Sampler::Stratified,
        "stratified",
        "By chance, one in each cell of a grid",
    ),
    (
        Sampler::Sobol,
        "sobol",
        "Sobol's sequence, scrambled: the least noise",
    ),
];

const LIGHT_SAMPLINGS: [(LightSampling, &str, &str); 2] = [
    (LightSampling::Area, "area", "To its area"),
    (
        LightSampling::Projected,
        "projected",
        "To what they bring to a matt surface, so that only what stands in the way is noise",
    ),
];

/// Rows of the table.
pub const ROWS: &[Knob] = &[
    Knob {
        flag: "light-samples",
        doc: "Shadow rays to an area light, a hit",
        kind: Kind::Count {
            range: [1, MAX_LIGHT_SAMPLES],
            of: "shadow rays to a light",
        },
        field: number!(Whole, light.samples),
        json: "light_samples",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "sampler",
        value_name: "SAMPLER",
        doc: "Where on an area light they go",
        kind: Kind::Choice(|| words(&LIGHT_SAMPLERS)),
        field: choice!(LIGHT_SAMPLERS, light.sampler),
        json: "sampler",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "light-sampling",
        value_name: "LIGHT_SAMPLING",
        doc: "In proportion to what places on an area light are chosen",
        kind: Kind::Choice(|| words(&LIGHT_SAMPLINGS)),
        field: choice!(LIGHT_SAMPLINGS, light.density),
        json: "light_sampling",
        in_files: true,
        ..ROW
    },
];
