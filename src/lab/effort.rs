//! Numbers of samples that are measured.

/// Numbers of samples that are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The most samples of a position.
    pub most: u32,
    /// The samples of the reference.
    pub reference: u32,
}

/// From much to little: the error of a reference is to be small beside those that it judges.
pub const EFFORTS: [Effort; 5] = [
    Effort::of(256),
    Effort::of(64),
    Effort::of(16),
    Effort::of(4),
    Effort::LEAST,
];

impl Effort {
    /// What is tried if there is time for nothing more.
    pub const LEAST: Self = Self {
        most: 4,
        reference: 16,
    };

    const fn of(most: u32) -> Self {
        Self {
            most,
            reference: 16 * most,
        }
    }

    /// 1, 4, 16 and so on.
    pub fn samples(self) -> impl Iterator<Item = u32> {
        std::iter::successors(Some(1u32), |n| n.checked_mul(4)).take_while(move |n| *n <= self.most)
    }
}
