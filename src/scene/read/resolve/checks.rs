//! Checks of single values.

use crate::math::{DVec3, Rgb};
use crate::scene::limits::{MAX_COORDINATE, MAX_NAME_BYTES};
use crate::scene::read::error::{Place, SceneError};
use crate::scene::read::file::Vector;

/// A finite point, not too far away.
pub fn point(v: Vector, place: &Place) -> Result<DVec3, SceneError> {
    for (i, c) in v.into_iter().enumerate() {
        number(c, [-MAX_COORDINATE, MAX_COORDINATE], &place.index(i))?;
    }
    Ok(v.into())
}

/// A direction of any length but 0, made unit.
pub fn direction(v: Vector, place: &Place) -> Result<DVec3, SceneError> {
    let v = point(v, place)?;
    // Scaled first, so that the square of a small length does not vanish.
    (v / v.abs().max_element()).try_normalize().ok_or_else(|| {
        place.error(
            "[0, 0, 0] is no direction",
            "write a vector with some length, such as [0, 1, 0]",
        )
    })
}

/// A number between two bounds.
pub fn number(x: f64, [min, max]: [f64; 2], place: &Place) -> Result<f64, SceneError> {
    if (min..=max).contains(&x) {
        return Ok(x);
    }
    Err(place.error(
        format!("{x} is not possible here"),
        format!("write a number from {} to {}", short(min), short(max)),
    ))
}

/// A length or size above 0.
pub fn positive(x: f64, place: &Place) -> Result<f64, SceneError> {
    if x > 0.0 && x <= MAX_COORDINATE {
        return Ok(x);
    }
    Err(place.error(
        format!("{x} is not possible here"),
        format!("write a number above 0, {} at most", short(MAX_COORDINATE)),
    ))
}

/// A colour with channels from 0 to `max`.
pub fn color(c: Rgb, max: f64, place: &Place) -> Result<Rgb, SceneError> {
    for (i, channel) in c.channels().into_iter().enumerate() {
        number(channel, [0.0, max], &place.index(i))?;
    }
    Ok(c)
}

/// A name that can be shown: not empty, not endless, and without control characters.
pub fn name(name: &str, place: &Place) -> Result<(), SceneError> {
    let problem = if name.trim().is_empty() {
        "the name is empty".to_string()
    } else if name.len() > MAX_NAME_BYTES {
        format!("the name has {} bytes", name.len())
    } else if name.chars().any(char::is_control) {
        "the name has a line end or another control character".to_string()
    } else {
        return Ok(());
    };
    Err(place.error(
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
