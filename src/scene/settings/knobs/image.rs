//! Knob of the size of the picture.

use super::ROW;
use crate::scene::settings::knob::{Field, Kind, Knob, Value};

/// Rows of the table.
pub const ROWS: &[Knob] = &[Knob {
    flag: "size",
    value_name: "WxH",
    doc: "Size of the picture in pixels",
    kind: Kind::Size,
    field: Field {
        get: |s| Some(Value::Size([s.image.width, s.image.height])),
        set: |s, value| {
            if let Value::Size(size) = value {
                [s.image.width, s.image.height] = *size;
            }
        },
    },
    in_files: true,
    shows_default: true,
    ..ROW
}];
