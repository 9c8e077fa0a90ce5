//! Knobs of recursion, shading and the accelerator.

use super::{ROW, words};
use crate::accel::AccelKind;
use crate::scene::settings::knob::{Field, Kind, Knob, Value};
use crate::scene::{Effect, Effects};
use crate::shading::{Fresnel, ShadingModel};

const FRESNELS: [(Fresnel, &str, &str); 3] = [
    (
        Fresnel::None,
        "none",
        "The material's coefficients at every angle",
    ),
    (Fresnel::Schlick, "schlick", "Schlick's approximation"),
    (Fresnel::Exact, "exact", "Fresnel's equations"),
];

const SHADINGS: [(Option<ShadingModel>, &str, &str); 4] = [
    (
        None,
        "scene",
        "As each object of the scene says: Phong's model if it says nothing",
    ),
    (
        Some(ShadingModel::Flat),
        "flat",
        "With the normal of the triangle's plane",
    ),
    (
        Some(ShadingModel::Gouraud),
        "gouraud",
        "At the corners, with their normals; what lights add is blended between them",
    ),
    (
        Some(ShadingModel::Phong),
        "phong",
        "At each point, with a normal that is blended between the corners",
    ),
];

const ACCELS: fn() -> [(AccelKind, &'static str, &'static str); 11] =
    || AccelKind::ALL.map(|kind| (kind, kind.name(), kind.note()));

/// Rows of the table.
pub const ROWS: &[Knob] = &[
    Knob {
        flag: "depth",
        doc: "How often a ray may bounce",
        kind: Kind::Count {
            range: [0, u32::MAX],
            of: "bounces",
        },
        field: number!(Whole, recursion.depth),
        json: "depth",
        in_files: true,
        steps: &["0", "1", "2", "3", "4", "5", "6"],
        ..ROW
    },
    Knob {
        flag: "min-weight",
        value_name: "W",
        doc: "Do not send rays that could add less than this to the pixel",
        kind: Kind::NOT_NEGATIVE,
        field: number!(Real, recursion.min_weight),
        json: "min_weight",
        in_files: true,
        steps: &["0.3", "0.1", "0.03", "0.01", "0.001953125"],
        ..ROW
    },
    Knob {
        flag: "fresnel",
        value_name: "FRESNEL",
        doc: "How transparent surfaces share light between reflection and transmission",
        kind: Kind::Choice(|| words(&FRESNELS)),
        field: choice!(FRESNELS, fresnel),
        json: "fresnel",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "shading",
        value_name: "MODEL",
        doc: "How triangles are shaded, whatever their objects say",
        kind: Kind::Choice(|| words(&SHADINGS)),
        field: choice!(SHADINGS, shading),
        json: "shading",
        ..ROW
    },
    Knob {
        flag: "exposure",
        value_name: "X",
        doc: "Factor on the picture before it is clamped",
        kind: Kind::NOT_NEGATIVE,
        field: number!(Real, image.exposure),
        json: "exposure",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "without",
        value_name: "EFFECT",
        doc: "Effects to leave out, though the scene calls for them",
        kind: Kind::Choices(|| words(&Effect::ALL.map(|e| (e, e.name(), e.without())))),
        field: Field {
            get: |s| {
                let without = Effect::ALL.into_iter().filter(|e| !s.effects.has(*e));
                let names: Vec<String> = without.map(|e| e.name().to_owned()).collect();
                (!names.is_empty()).then_some(Value::List(names))
            },
            set: |s, value| {
                let Value::List(names) = value else { return };
                let without = Effect::ALL
                    .into_iter()
                    .filter(|e| names.iter().any(|n| n == e.name()));
                s.effects = without.fold(s.effects, Effects::without);
            },
        },
        json: "without",
        ..ROW
    },
    Knob {
        flag: "seed",
        doc: "Seed of all random numbers",
        kind: Kind::Whole(0),
        field: number!(Whole, seed),
        json: "seed",
        in_files: true,
        ..ROW
    },
    Knob {
        flag: "accel",
        value_name: "ACCEL",
        doc: "How hits are found; never changes the picture. Where it is not given: auto for pictures; for looking at \
              rays a BSP tree, or wide for large scenes",
        kind: Kind::Choice(|| words(&ACCELS())),
        field: choice!(ACCELS(), accel),
        json: "accel",
        changes_picture: false,
        ..ROW
    },
    Knob {
        flag: "max-rays",
        doc: "Rays that the whole picture may cost, at least one a pixel",
        kind: Kind::Whole(1),
        field: number!(Whole, recursion.max_rays),
        json: "max_rays",
        ..ROW
    },
];
