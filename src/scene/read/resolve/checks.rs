//! Checks of single values.

use crate::math::rounding::gamma;
use crate::math::{DVec3, Rgb};
use crate::scene::limits::{MAX_COORDINATE, MAX_NAME_BYTES};
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::Triple;

/// A finite point, not too far away.
pub fn point(v: Triple, path: &FieldPath) -> Result<DVec3, SceneError> {
    for (i, c) in v.into_iter().enumerate() {
        number(c, [-MAX_COORDINATE, MAX_COORDINATE], &path.index(i))?;
    }
    Ok(v.into())
}

/// A direction of any length but 0, made unit. One that is unit already, as far as rounding goes, is taken as it is: what a
/// program made unit and wrote down has the same bits again.
pub fn direction(v: Triple, path: &FieldPath) -> Result<DVec3, SceneError> {
    let v = point(v, path)?;
    if (v.length_squared() - 1.0).abs() <= gamma(16) {
        return Ok(v);
    }
    // Scaled first, so that the square of a small length does not vanish.
    (v / v.abs().max_element()).try_normalize().ok_or_else(|| {
        path.error(
            "[0, 0, 0] is no direction",
            "write a vector with some length, such as [0, 1, 0]",
        )
    })
}

/// Finite points, not too far away.
pub fn points(list: &[Triple], path: &FieldPath) -> Result<Vec<DVec3>, SceneError> {
    let inside = |v: &Triple| v.iter().all(|c| c.abs() <= MAX_COORDINATE);
    if let Some(i) = list.iter().position(|v| !inside(v)) {
        point(list[i], &path.index(i))?;
    }
    Ok(list.iter().copied().map(DVec3::from).collect())
}

/// Directions of any length but 0, made unit.
pub fn directions(list: &[Triple], path: &FieldPath) -> Result<Vec<DVec3>, SceneError> {
    let unit = |(i, v): (usize, &Triple)| direction(*v, &path.index(i));
    list.iter().enumerate().map(unit).collect()
}

/// A number between two bounds.
pub fn number(x: f64, [min, max]: [f64; 2], path: &FieldPath) -> Result<f64, SceneError> {
    if (min..=max).contains(&x) {
        return Ok(x);
    }
    Err(path.error(
        format!("{x} is not possible here"),
        format!("write a number from {} to {}", short(min), short(max)),
    ))
}

/// A length or size above 0.
pub fn positive(x: f64, path: &FieldPath) -> Result<f64, SceneError> {
    if x > 0.0 && x <= MAX_COORDINATE {
        return Ok(x);
    }
    Err(path.error(
        format!("{x} is not possible here"),
        format!("write a number above 0, {} at most", short(MAX_COORDINATE)),
    ))
}

/// A colour with channels from 0 to `max`.
pub fn color(c: Rgb, max: f64, path: &FieldPath) -> Result<Rgb, SceneError> {
    for (i, channel) in c.channels().into_iter().enumerate() {
        number(channel, [0.0, max], &path.index(i))?;
    }
    Ok(c)
}

/// A name that can be shown: not empty, not endless, and without control characters.
pub fn name(name: &str, path: &FieldPath) -> Result<(), SceneError> {
    let problem = if name.trim().is_empty() {
        "the name is empty".to_string()
    } else if name.len() > MAX_NAME_BYTES {
        format!("the name has {} bytes", name.len())
    } else if name.chars().any(char::is_control) {
        "the name has a line end or another control character".to_string()
    } else {
        return Ok(());
    };
    Err(path.error(
        problem,
        format!("write a short name in plain letters, {MAX_NAME_BYTES} bytes at most"),
    ))
}

/// A bound as people write it.
fn short(x: f64) -> String {
    if x.abs() >= 1e6 {
        format!("{x:e}")
    } else {
        format!("{x}")
    }
}
