//! Crossings by exact arithmetic.
//!
//! The expected numbers come from a program in Python that knows nothing of this code: rationals for boxes, 80 digits for
//! spheres, membership in the middle of all elementary intervals. Coordinates are multiples of 1/4, so faces often coincide.

use super::*;

/// A tree in one line: U, I or D with the number of parts, `ball` x y z r, `cube` with its smallest and its largest corner.
fn read<'a>(words: &mut impl Iterator<Item = &'a str>) -> CsgTree {
    let word = words.next().expect("a word");
    let mut number = || {
        words
            .next()
            .expect("a number")
            .parse::<f64>()
            .expect("a number")
    };
    let mut vector = || DVec3::new(number(), number(), number());
    let op = match word {
        "ball" => {
            let center = vector();
            return ball(center, number());
        }
        "cube" => {
            let min = vector();
            return cube(min, vector());
        }
        "U" => Union,
        "I" => Common,
        _ => Difference,
    };
    let count = number() as usize;
    CsgTree::Op(op, (0..count).map(|_| read(words)).collect())
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace()
        .map(|word| word.parse().expect("a number"))
        .collect()
}

fn ray_of(text: &str) -> Ray {
    let n = numbers(text);
    Ray::new(DVec3::from_slice(&n[..3]), DVec3::from_slice(&n[3..]))
}

const CASES: &str = include_str!("oracle.txt");

#[test]
fn crossings_are_those_of_exact_arithmetic() {
    let mut count = 0;
    for line in CASES
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
    {
        let fields: Vec<&str> = line.split('|').collect();
        let solid = csg(read(&mut fields[0].split_whitespace()));
        let expected = numbers(fields[2]);
        let found = crossings(&solid, &ray_of(fields[1]));
        assert_eq!(found.len(), expected.len(), "{line}: {found:?}");
        for (t, exact) in found.iter().zip(&expected) {
            assert!(
                (t - exact).abs() <= 1e-14 * exact.abs().max(1.0),
                "{line}: {found:?}"
            );
        }
        count += 1;
    }
    assert_eq!(count, 30);
}
