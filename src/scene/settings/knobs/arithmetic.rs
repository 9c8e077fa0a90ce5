//! Knobs of arithmetic other than our own.

use super::{ROW, words};
use crate::geometry::{Offset, PatchMethod, Precision, Quadratic, QuarticMethod, TriangleTest};
use crate::scene::Bends;
use crate::scene::settings::knob::{Field, Kind, Knob, Value};

/// What these rows have in common.
const ARITHMETIC_ROW: Knob = Knob {
    heading: "Other arithmetic, to see what goes wrong (see raytree stability)",
    shows_default: true,
    ..ROW
};

/// Rows of the table.
pub const ROWS: &[Knob] = &[
    Knob {
        flag: "triangle",
        value_name: "TEST",
        doc: "How triangles are tested",
        kind: Kind::Choice(|| words(&names!(TriangleTest))),
        field: choice!(names!(TriangleTest), arithmetic.triangle),
        json: "arithmetic.triangle",
        ..ARITHMETIC_ROW
    },
    Knob {
        flag: "offset",
        value_name: "OFFSET",
        doc: "Where rays start that leave a surface: none, fixed:EPS (metres along the normal) or bounded",
        kind: Kind::Text(|text| text.parse::<Offset>().map(|_| ())),
        field: text!(arithmetic.offset),
        json: "arithmetic.offset",
        steps: &["none", "fixed:1e-9", "fixed:1e-4", "fixed:1e-2", "bounded"],
        ..ARITHMETIC_ROW
    },
    Knob {
        flag: "quadratic",
        value_name: "FORMULA",
        doc: "How spheres, cylinders and the like are tested",
        kind: Kind::Choice(|| words(&names!(Quadratic))),
        field: choice!(names!(Quadratic), arithmetic.quadratic),
        json: "arithmetic.quadratic",
        ..ARITHMETIC_ROW
    },
    Knob {
        flag: "quartic",
        value_name: "ROOTS",
        doc: "How tori and the like are tested",
        kind: Kind::Choice(|| words(&names!(QuarticMethod))),
        field: choice!(names!(QuarticMethod), arithmetic.quartic),
        json: "arithmetic.quartic",
        ..ARITHMETIC_ROW
    },
    Knob {
        flag: "patch-test",
        value_name: "METHOD",
        doc: "How parametric patches are tested: exact, or triangles:N (N x N squares of two for each leaf)",
        kind: Kind::Text(|text| text.parse::<PatchMethod>().map(|_| ())),
        field: text!(arithmetic.patch),
        json: "arithmetic.patch_test",
        steps: &["triangles:1", "triangles:4", "triangles:16", "exact"],
        ..ARITHMETIC_ROW
    },
    Knob {
        flag: "precision",
        value_name: "BITS",
        doc: "The numbers that shapes are tested with",
        kind: Kind::Choice(|| words(&names!(Precision))),
        field: choice!(names!(Precision), arithmetic.precision),
        json: "arithmetic.precision",
        ..ARITHMETIC_ROW
    },
    Knob {
        flag: "bend",
        value_name: "NAME[,NAME]",
        doc: "Trace as one who makes this mistake (see raytree grade --bends)",
        kind: Kind::Text(|text| text.parse::<Bends>().map(|_| ())),
        field: Field {
            get: |s| (!s.bends.is_empty()).then(|| Value::Text(s.bends.to_string())),
            set: |s, value| {
                if let Ok(bends) = value.to_string().parse() {
                    s.bends = bends;
                }
            },
        },
        json: "bent",
        shows_default: false,
        ..ARITHMETIC_ROW
    },
];
