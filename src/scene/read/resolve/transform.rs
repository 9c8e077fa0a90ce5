//! Transforms: from a list of steps to one affine map.

use glam::{DAffine3, DMat3};

use super::checks::{direction, number, point};
use crate::math::{DVec3, Transform};
use crate::scene::limits::MAX_COORDINATE;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{RotateFile, ScaleFile, TransformStep};

/// The map that applies the steps in their order, and `outer` after them. `None` stands for the map that changes
/// nothing.
pub fn to_world(
    steps: &[TransformStep],
    outer: Option<&Transform>,
    path: &FieldPath,
) -> Result<Option<Transform>, SceneError> {
    let path = path.key("transform");
    let mut map = DAffine3::IDENTITY;
    for (i, step) in steps.iter().enumerate() {
        map = matrix(step, &path.index(i))? * map;
    }
    if steps.is_empty() {
        return Ok(outer.copied());
    }
    if let Some(outer) = outer {
        map = outer.to_world() * map;
    }
    let transform = Transform::new(map).ok_or_else(|| {
        path.error(
            "the transform squeezes everything flat, or to a size that numbers cannot hold",
            "make no factor 0, and no row of a matrix a multiple of another",
        )
    })?;
    Ok(Some(transform))
}

fn matrix(step: &TransformStep, path: &FieldPath) -> Result<DAffine3, SceneError> {
    Ok(match step {
        TransformStep::Translate(by) => {
            DAffine3::from_translation(point(*by, &path.key("translate"))?)
        }
        TransformStep::Rotate(rotate) => {
            DAffine3::from_mat3(rotation(rotate, &path.key("rotate"))?)
        }
        TransformStep::Scale(ScaleFile::Even(by)) => {
            DAffine3::from_scale(point([*by; 3], &path.key("scale"))?)
        }
        TransformStep::Scale(ScaleFile::Axes(by)) => {
            DAffine3::from_scale(point(*by, &path.key("scale"))?)
        }
        TransformStep::Matrix(rows) => {
            let path = path.key("matrix");
            for (i, row) in rows.iter().enumerate() {
                for (j, x) in row.iter().enumerate() {
                    let path = path.index(i).index(j);
                    number(*x, [-MAX_COORDINATE, MAX_COORDINATE], &path)?;
                }
            }
            let column = |j: usize| DVec3::new(rows[0][j], rows[1][j], rows[2][j]);
            DAffine3::from_cols(column(0), column(1), column(2), column(3))
        }
    })
}

/// The rotation by an angle around a unit axis a: cos I + (1 - cos) a a^T + sin [a]x (Rodrigues 1840).
fn rotation(file: &RotateFile, path: &FieldPath) -> Result<DMat3, SceneError> {
    let a = direction(file.axis, &path.key("axis"))?;
    let degrees = number(
        file.degrees,
        [-MAX_COORDINATE, MAX_COORDINATE],
        &path.key("degrees"),
    )?;
    let (sin, cos) = sin_cos_degrees(degrees);
    let outer = DMat3::from_cols(a * a.x, a * a.y, a * a.z);
    let cross = DMat3::from_cols(
        DVec3::new(0.0, a.z, -a.y),
        DVec3::new(-a.z, 0.0, a.x),
        DVec3::new(a.y, -a.x, 0.0),
    );
    Ok(DMat3::from_diagonal(DVec3::splat(cos)) + outer * (1.0 - cos) + cross * sin)
}

/// Sine and cosine of an angle in degrees, exact for right angles.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    if turned % 90.0 == 0.0 {
        return match (turned / 90.0) as u8 {
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            3 => (-1.0, 0.0),
            _ => (0.0, 1.0),
        };
    }
    let angle = turned.to_radians();
    (libm::sin(angle), libm::cos(angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn apply(steps: &str, p: DVec3) -> DVec3 {
        let steps: Vec<TransformStep> = serde_json::from_str(steps).expect("steps");
        let path = FieldPath::root("test");
        let map = to_world(&steps, None, &path).expect("can be undone");
        map.map_or(p, |m| m.point(p))
    }

    #[test]
    fn steps_act_in_their_order() {
        let p = DVec3::new(1.0, 2.0, 3.0);
        let turn = r#"{"rotate": {"axis": [0, 3, 0], "degrees": 90}}"#;
        let shift = r#"{"translate": [10, 0, 0]}"#;
        // A quarter turn around y takes x to -z and z to x.
        let turned = apply(&format!("[{turn}, {shift}]"), p);
        assert_eq!(turned, DVec3::new(13.0, 2.0, -1.0));
        let shifted = apply(&format!("[{shift}, {turn}]"), p);
        assert_eq!(shifted, DVec3::new(3.0, 2.0, -11.0));
        assert_eq!(
            apply(r#"[{"scale": 2}, {"scale": [1, -1, 0.5]}]"#, p),
            DVec3::new(2.0, -4.0, 3.0)
        );
        let rows = r#"[{"matrix": [[0, 1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]]}]"#;
        assert_eq!(apply(rows, p), DVec3::new(7.0, 7.0, 10.0));
        assert_eq!(apply("[]", p), p);
    }

    #[test]
    fn a_rotation_keeps_its_axis_and_all_lengths() {
        let p = DVec3::new(1.0, 2.0, 2.0);
        let steps = r#"[{"rotate": {"axis": [1, 2, 2], "degrees": 33}}]"#;
        assert!((apply(steps, p) - p).length() < 1e-15);
        let q = apply(steps, DVec3::X);
        assert!((q.length() - 1.0).abs() < 1e-15 && (q - DVec3::X).length() > 0.1);
    }
}
