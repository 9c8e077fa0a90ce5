//! Tolerances: how far apart two values may be and still agree, by quantity.
//!
//! The defaults let a right tracer in single precision with a fixed offset of 1e-4 pass (book: "Tolerances").

use std::collections::BTreeMap;

use super::quantity::QuantityKind;
use crate::math::DVec3;
use crate::trace::facts::Fact;

/// Absolute and relative part of a tolerance. Angles are in degrees and have no relative part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowance {
    /// Always allowed.
    pub absolute: f64,
    /// Allowed besides, times the size of our value.
    pub relative: f64,
}

/// Below this size of our value only the absolute part counts.
const TINY: f64 = 1e-9;

/// The tolerances of a task: the defaults, and those that it changes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tolerances(pub BTreeMap<QuantityKind, Allowance>);

impl Allowance {
    const fn new(absolute: f64, relative: f64) -> Self {
        Self { absolute, relative }
    }

    /// The default of a quantity.
    pub fn default_of(quantity: QuantityKind) -> Self {
        match quantity {
            // An offset of 1e-4 at both ends; rounding of single precision at 100 m is 8e-6.
            QuantityKind::T => Self::new(2e-4, 1e-4),
            QuantityKind::Point | QuantityKind::Origin => Self::new(1e-4, 1e-4),
            // A fifth of a pixel at 320 columns and 60 degrees.
            QuantityKind::Direction => Self::new(0.05, 0.0),
            QuantityKind::Normal | QuantityKind::GeometricNormal => Self::new(0.1, 0.0),
            QuantityKind::Distance => Self::new(1e-4, 1e-3),
            // A quarter of a step of 8 bits near 0.1.
            QuantityKind::Terms => Self::new(1e-3, 2e-3),
            QuantityKind::Weight | QuantityKind::Radiance | QuantityKind::Color => {
                Self::new(2e-3, 5e-3)
            }
            // Rounding or cutting off, and one more.
            QuantityKind::Srgb8 => Self::new(2.0, 0.0),
            _ => Self::new(1e-3, 0.0),
        }
    }

    /// True if a number is as near to ours as that.
    fn allows(self, ours: f64, theirs: f64) -> bool {
        let relative = if ours.abs() < TINY {
            0.0
        } else {
            self.relative * ours.abs()
        };
        (theirs - ours).abs() <= self.absolute + relative
    }
}

impl Tolerances {
    /// The tolerance of a quantity.
    pub fn of(&self, quantity: QuantityKind) -> Allowance {
        let changed = self.0.get(&quantity).copied();
        changed.unwrap_or_else(|| Allowance::default_of(quantity))
    }

    /// True if two values of a quantity agree.
    pub fn agree(&self, quantity: QuantityKind, ours: &Fact, theirs: &Fact) -> bool {
        let tolerance = self.of(quantity);
        let near = |a: f64, b: f64| tolerance.allows(a, b);
        match (quantity, ours, theirs) {
            (
                QuantityKind::Direction | QuantityKind::Normal | QuantityKind::GeometricNormal,
                _,
                _,
            ) => angle(ours, theirs).is_some_and(|degrees| degrees <= tolerance.absolute),
            (QuantityKind::Unit, Fact::Vector(a), Fact::Vector(b)) => near(length(*a), length(*b)),
            (QuantityKind::Point | QuantityKind::Origin, Fact::Vector(a), Fact::Vector(b)) => {
                let (a, b) = (DVec3::from_array(*a), DVec3::from_array(*b));
                let size = a.abs().max_element();
                a.distance(b) <= tolerance.absolute + tolerance.relative * size
            }
            (_, Fact::Number(a), Fact::Number(b)) => near(*a, *b),
            (_, Fact::Vector(a), Fact::Vector(b)) => a.iter().zip(b).all(|(a, b)| near(*a, *b)),
            (_, Fact::Pair(a), Fact::Pair(b)) => a.iter().zip(b).all(|(a, b)| near(*a, *b)),
            (_, Fact::Color(a), Fact::Color(b)) => {
                let channels = a.channels().into_iter().zip(b.channels());
                channels.into_iter().all(|(a, b)| near(a, b))
            }
            (_, Fact::Word(a), Fact::Word(b)) => a == b,
            (_, Fact::Steps(a), Fact::Steps(b)) => same_order(a, b),
            _ => false,
        }
    }
}

fn length(v: [f64; 3]) -> f64 {
    DVec3::from_array(v).length()
}

/// The angle between two vectors in degrees; none if one of them has no direction.
pub fn angle(a: &Fact, b: &Fact) -> Option<f64> {
    let (Fact::Vector(a), Fact::Vector(b)) = (a, b) else {
        return None;
    };
    let unit = |v: [f64; 3]| DVec3::from_array(v).try_normalize();
    let (a, b) = (unit(*a)?, unit(*b)?);
    // Twice the angle of half the chord: exact for small angles, too.
    let half = 0.5 * (a - b).length();
    Some((2.0 * libm::asin(half.min(1.0))).to_degrees())
}

/// True if the same nodes are visited and the same primitives tested, those between two nodes in any order.
fn same_order(a: &[String], b: &[String]) -> bool {
    let runs = |steps: &[String]| {
        let mut runs: Vec<Vec<String>> = Vec::new();
        for step in steps {
            match runs.last_mut() {
                Some(run) if step.starts_with("test") && run[0].starts_with("test") => {
                    run.push(step.clone());
                }
                _ => runs.push(vec![step.clone()]),
            }
        }
        for run in &mut runs {
            run.sort();
        }
        runs
    };
    runs(a) == runs(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_quantity_has_its_own_distance() {
        let all = Tolerances::default();
        let number = |x| Fact::Number(x);
        assert!(all.agree(QuantityKind::T, &number(4.0), &number(4.0005)));
        assert!(!all.agree(QuantityKind::T, &number(4.0), &number(4.0007)));
        let turned = |degrees: f64| {
            let a = degrees.to_radians();
            Fact::Vector([libm::cos(a), libm::sin(a), 0.0])
        };
        assert!(all.agree(QuantityKind::Direction, &turned(0.0), &turned(0.049)));
        assert!(!all.agree(QuantityKind::Direction, &turned(0.0), &turned(0.051)));
        // The length is a quantity of its own.
        let long = Fact::Vector([2.0, 0.0, 0.0]);
        assert!(all.agree(QuantityKind::Direction, &turned(0.0), &long));
        assert!(!all.agree(QuantityKind::Unit, &turned(0.0), &long));
        assert!(!all.agree(QuantityKind::T, &number(1.0), &Fact::Nothing));
        assert!(!all.agree(QuantityKind::T, &number(1.0), &number(f64::NAN)));
    }

    #[test]
    fn tests_of_a_leaf_may_come_in_any_order() {
        let steps = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let (a, b) = ("node1 testA testB node2", "node1 testB testA node2");
        assert!(same_order(&steps(a), &steps(b)));
        assert!(!same_order(&steps(a), &steps("node2 testA testB node1")));
    }
}
