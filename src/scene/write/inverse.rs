//! Numbers from which a reader computes given ones: searched for around the inverse, since what was rounded cannot be undone.

use crate::math::DVec3;

/// Distances that are tried where no point is found that is easy to read.
const FAR: u32 = 20_000;

/// Neighbours of an angle that are tried, on each side.
const ULPS: u32 = 64;

/// A point p with unit(p - from) = `direction`, to the bit. Points with few digits come first, such as the one that a person wrote.
pub fn point_along(from: DVec3, direction: DVec3) -> Option<DVec3> {
    let leads = |p: &DVec3| (p - from).try_normalize() == Some(direction);
    let rounded = |p: DVec3| (p * 1e6).round() / 1e6;
    // Where the line crosses planes like x = 0.3.
    let planes = (0..=200).map(|k| f64::from((k + 1) / 2) / if k % 2 == 0 { 10.0 } else { -10.0 });
    let crossings = planes.flat_map(|plane| {
        (0..3).filter_map(move |axis| {
            let t = (plane - from[axis]) / direction[axis];
            (t > 0.0 && t < 1e6).then(|| rounded(from + t * direction))
        })
    });
    // Far away, what is rounded is small beside the way.
    let scale = 64.0 * (1.0 + from.abs().max_element());
    let far = (0..FAR).map(|k| from + scale * (1.0 + 0.0371 * f64::from(k)) * direction);
    crossings.chain(far).find(leads)
}

/// An angle in degrees that `value_of` takes to `value`, to the bit; near `degrees`, with few digits if there is such a one.
pub fn angle(degrees: f64, value: f64, value_of: impl Fn(f64) -> f64) -> Option<f64> {
    let rounded = (degrees * 1e9).round() / 1e9;
    let (mut below, mut above) = (degrees, degrees);
    let near = (0..ULPS).flat_map(|_| {
        (below, above) = (below.next_down(), above.next_up());
        [below, above]
    });
    let mut all = [rounded, degrees].into_iter().chain(near);
    all.find(|degrees| value_of(*degrees) == value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = DVec3> {
        let axis = -10.0..10.0f64;
        (axis.clone(), axis.clone(), axis).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #[test]
        fn points_lead_to_the_same_bits(from in vector(), to in vector()) {
            let direction = (to - from).normalize();
            let point = point_along(from, direction).expect("a point");
            prop_assert_eq!((point - from).normalize(), direction);
        }

        #[test]
        fn angles_lead_to_the_same_bits(degrees in 0.0..180.0f64) {
            let cos = |degrees: f64| libm::cos(degrees.to_radians());
            let found = angle(libm::acos(cos(degrees)).to_degrees(), cos(degrees), cos);
            prop_assert_eq!(found.map(cos), Some(cos(degrees)));
        }
    }

    #[test]
    fn what_a_person_wrote_is_found() {
        let (eye, at) = (DVec3::new(0.0, 1.6, 5.0), DVec3::new(0.0, 0.98, 0.0));
        assert_eq!(point_along(eye, (at - eye).normalize()), Some(at));
        let tan = |degrees: f64| libm::tan(degrees.to_radians() / 2.0);
        let near = 2.0 * libm::atan(tan(36.0)).to_degrees();
        assert_eq!(angle(near, tan(36.0), tan), Some(36.0));
    }
}
