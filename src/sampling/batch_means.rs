//! Batch means: the standard error of a pixel, estimated from the spread of its own samples.
//!
//! Samples that follow one another are put together into groups: up to sixteen, then two by two into eight twice as
//! large, so that there are always enough to see how much they differ, and each is as large as can be. If the groups
//! were independent, the standard error of their mean would be s / sqrt(groups): batch means, doubled (Law and Carson
//! 1979, "A sequential procedure for determining the length of a steady-state simulation").
//!
//! What is biased in it. Independent samples, and independent sets of samples: nothing, in the variance. Sobol's points in one
//! set: each group is evenly spread by itself, and the groups complete each other; so the estimate is too large. Jittered
//! samples in one set: the groups are parts of the grid, and the estimate is that of independent samples, which is too large.
//! Few groups: the estimate itself is uncertain, by about a quarter of its value with eight.

/// The largest number of groups.
const MOST: usize = 16;

/// The sums of a pixel's samples so far, in groups.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchMeans {
    /// The first value, which is subtracted from all, so that equal ones differ by exactly 0.
    first: Option<f64>,
    /// For each group the sum of signs, and the sum of signs times values.
    groups: [[f64; 2]; MOST],
    /// The number of complete groups.
    full: usize,
    /// The number of samples in a complete group.
    size: u32,
    /// The number of samples in the group that is not complete.
    inside: u32,
}

impl BatchMeans {
    /// An estimator without samples; groups have `size` samples to begin with.
    pub fn new(size: u32) -> Self {
        Self {
            first: None,
            groups: [[0.0; 2]; MOST],
            full: 0,
            size: size.max(1),
            inside: 0,
        }
    }

    /// Adds a sample with a weight of this sign (1 or -1).
    pub fn add(&mut self, value: f64, sign: f64) {
        let from_first = value - *self.first.get_or_insert(value);
        let group = &mut self.groups[self.full];
        group[0] += sign;
        group[1] += sign * from_first;
        self.inside += 1;
        if self.inside == self.size {
            self.inside = 0;
            self.full += 1;
        }
        if self.full == MOST {
            self.merge_pairs();
        }
    }

    /// Merges groups in pairs: half as many, each twice as large.
    fn merge_pairs(&mut self) {
        for i in 0..MOST / 2 {
            let [a, b] = [self.groups[2 * i], self.groups[2 * i + 1]];
            self.groups[i] = [a[0] + b[0], a[1] + b[1]];
        }
        self.groups[MOST / 2..].fill([0.0; 2]);
        self.full = MOST / 2;
        self.size *= 2;
    }

    /// The estimated standard error of the weighted mean; infinite while there are less than two groups.
    ///
    /// With d = sum D / sum W over the groups: error^2 = g / (g - 1) sum (D - d W)^2 / (sum W)^2, the usual one if all
    /// groups weigh the same (Cochran 1977, "Sampling techniques", section 6.4: the error of a ratio).
    pub fn standard_error(&self) -> f64 {
        let count = self.full + usize::from(self.inside > 0);
        let groups = &self.groups[..count];
        let [w, d] = groups.iter().fold([0.0; 2], |sum, group| {
            [sum[0] + group[0], sum[1] + group[1]]
        });
        if count < 2 || w <= 0.0 {
            return f64::INFINITY;
        }
        let squares: f64 = groups.iter().map(|g| (g[1] - d / w * g[0]).powi(2)).sum();
        let count = count as f64;
        (count / (count - 1.0) * squares).sqrt() / w
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::{splitmix64, to_unit_f64};

    fn error_of(values: impl IntoIterator<Item = f64>) -> f64 {
        let mut means = BatchMeans::new(1);
        for value in values {
            means.add(value, 1.0);
        }
        means.standard_error()
    }

    #[test]
    fn a_few_values_have_the_error_known_on_paper() {
        assert_eq!(error_of([]), f64::INFINITY);
        assert_eq!(error_of([3.0]), f64::INFINITY);
        // s^2 = 5/3 of 1, 2, 3, 4.
        let four = error_of([1.0, 2.0, 3.0, 4.0]);
        assert!((four - (5.0f64 / 12.0).sqrt()).abs() < 1e-15);
        assert_eq!(error_of([0.1; 100]), 0.0);
    }

    #[test]
    fn many_are_merged_into_groups() {
        // 32 values: 8 groups of 4. Each group of 0, 0, 1, 1 has the mean 1/2.
        assert_eq!(error_of((0..32).map(|i| f64::from(i / 2 % 2))), 0.0);
        // 33: a group begins that is not full.
        assert!(error_of((0..33).map(|i| f64::from(i / 2 % 2))) > 0.0);
    }

    #[test]
    fn of_independent_values_the_variance_is_unbiased() {
        // 4000 runs of 100 uniform numbers: the variance of the mean is 1/1200. The mean of the estimates has a
        // relative standard error of about sqrt(2 / 11 / 4000) = 0.7 %.
        let runs = 4000;
        let mean: f64 = (0..runs)
            .map(|run| error_of((0..100).map(|i| to_unit_f64(splitmix64(run << 32 | i)))).powi(2))
            .sum::<f64>()
            / runs as f64;
        assert!((mean * 1200.0 - 1.0).abs() < 0.03, "{}", mean * 1200.0);
    }

    #[test]
    fn signs_do_not_make_equal_values_differ() {
        let mut means = BatchMeans::new(1);
        for i in 0..50 {
            means.add(0.3, if i % 5 == 0 { -1.0 } else { 1.0 });
        }
        assert_eq!(means.standard_error(), 0.0);
    }
}
