//! Exact sums and products: a number is the sum of doubles that do not overlap.
//! Source: Dekker 1971; Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates".

/// An exact number; its parts grow in size.
#[derive(Clone, Debug, Default)]
pub struct Expansion(Vec<f64>);

impl Expansion {
    /// a b.
    pub fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        Self(vec![a.mul_add(b, -high), high])
    }

    /// a - b.
    pub fn difference(a: f64, b: f64) -> Self {
        Self::default().plus_double(a).plus_double(-b)
    }

    /// The sum with a double: its rounding errors stay as parts.
    fn plus_double(mut self, mut carry: f64) -> Self {
        for part in &mut self.0 {
            (carry, *part) = two_sum(carry, *part);
        }
        self.0.push(carry);
        self.0.retain(|part| *part != 0.0);
        self
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        other
            .0
            .iter()
            .fold(self.clone(), |sum, part| sum.plus_double(*part))
    }

    /// The number with the other sign.
    #[must_use]
    pub fn negative(&self) -> Self {
        Self(self.0.iter().map(|part| -part).collect())
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut sum = Self::default();
        for a in &self.0 {
            for b in &other.0 {
                sum = sum.plus(&Self::product(*a, *b));
            }
        }
        sum
    }

    /// The nearest double, or one next to it. Its sign is that of the exact number: the last part outweighs all others.
    pub fn double(&self) -> f64 {
        self.0.iter().sum()
    }
}

/// a + b, and what was rounded away.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_rounded_away() {
        // (1 + 2^-52)^2 - 1 - 2^-51 = 2^-104.
        let x = 1.0 + f64::EPSILON;
        let square = Expansion::product(x, x);
        let rest = square.plus(&Expansion::difference(-1.0, 2.0 * f64::EPSILON));
        assert_eq!(rest.double(), f64::EPSILON * f64::EPSILON);
        // (a - b)(a + b) - a^2 + b^2 = 0 with numbers of very different sizes.
        let (a, b) = (1e17 + 3.0e3, 1.0 / 3.0);
        let left = Expansion::difference(a, b).times(&Expansion::difference(a, -b));
        let right = Expansion::product(a, a).plus(&Expansion::product(b, b).negative());
        assert_eq!(left.plus(&right.negative()).double(), 0.0);
    }
}
