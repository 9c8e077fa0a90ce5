//! The bounds of items along an axis, sorted, and the best plane among them.

use super::{Bounds, EMPTY_BONUS, STEP, TEST};

/// A bound of an item: its position, kind and item, in one number that sorts by these. At one position items end first,
/// then come those that are flat, then others begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct BoundEvent(u64);

/// The kinds.
const ENDS: u64 = 0;
const FLAT: u64 = 1;
const BEGINS: u64 = 2;

/// Bits of an item's number.
const ITEM: u32 = 30;

impl BoundEvent {
    /// Adds the one or two events of an item.
    #[inline]
    pub fn push(to: &mut Vec<Self>, item: usize, [min, max]: &Bounds, axis: usize) {
        let (min, max) = (min[axis], max[axis]);
        if min == max {
            to.push(Self::new(min, FLAT, item));
        } else {
            to.push(Self::new(min, BEGINS, item));
            to.push(Self::new(max, ENDS, item));
        }
    }

    fn new(d: f32, kind: u64, item: usize) -> Self {
        // Positive numbers sort as their bits do, negative ones the other way round. Adding 0 takes the sign off -0.
        let bits = (d + 0.0).to_bits();
        let sorted = if bits >> 31 == 1 {
            !bits
        } else {
            bits | 1 << 31
        };
        Self(u64::from(sorted) << 32 | kind << ITEM | item as u64)
    }

    fn d(self) -> f32 {
        let sorted = (self.0 >> 32) as u32;
        f32::from_bits(if sorted >> 31 == 1 {
            sorted & !(1 << 31)
        } else {
            !sorted
        })
    }

    fn kind(self) -> u64 {
        self.0 >> ITEM & 3
    }

    /// Whose it is.
    pub fn item(self) -> usize {
        (self.0 & ((1 << ITEM) - 1)) as usize
    }

    /// The bound with another number for its item.
    pub fn renumbered(self, item: u32) -> Self {
        Self(self.0 >> ITEM << ITEM | u64::from(item))
    }
}

/// A plane, what it is expected to cost, and how many items it cuts.
pub struct Best {
    pub axis: usize,
    pub d: f32,
    /// Whether items that are flat and lie on it go to the front.
    pub flat_to_front: bool,
    pub cost: f64,
    pub cut: usize,
}

/// What planes across an axis of a cell cost.
pub struct Costs {
    /// Where the cell begins and ends.
    min: f64,
    max: f64,
    /// Half the area of a part of the cell is side + rim x width.
    side: f64,
    rim: f64,
}

impl Costs {
    /// Those of a cell.
    pub fn new(axis: usize, cell: &Bounds) -> Self {
        let [min, max] = cell.map(|corner| corner.map(f64::from));
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3].map(|k| max[k] - min[k]);
        Self {
            min: min[axis],
            max: max[axis],
            side: u * v,
            rim: u + v,
        }
    }

    /// The cost of the plane at d, with so many items behind it and in front. Source: MacDonald and Booth 1990.
    #[inline]
    pub fn of(&self, d: f64, behind: usize, front: usize) -> f64 {
        let area = |width: f64| self.side + self.rim * width;
        let tests = area(d - self.min) * behind as f64 + area(self.max - d) * front as f64;
        let bonus = if behind == 0 || front == 0 {
            EMPTY_BONUS
        } else {
            1.0
        };
        bonus * (STEP + TEST * tests / area(self.max - self.min))
    }
}

/// The best plane across an axis, of all where something begins or ends.
pub fn sweep(events: &[BoundEvent], axis: usize, count: usize, cell: &Bounds) -> Option<Best> {
    let costs = Costs::new(axis, cell);
    let mut best: Option<Best> = None;
    let (mut behind, mut front, mut next) = (0, count, 0);
    while next < events.len() {
        let d = events[next].d();
        let mut kinds = [0; 3];
        while let Some(event) = events.get(next).filter(|e| e.d() == d) {
            kinds[event.kind() as usize] += 1;
            next += 1;
        }
        let [ended, flat, begun] = kinds;
        front -= ended + flat;
        if cell[0][axis] < d && d < cell[1][axis] {
            for flat_to_front in [false, true] {
                let (f, b) = if flat_to_front { (flat, 0) } else { (0, flat) };
                let cost = costs.of(f64::from(d), behind + b, front + f);
                if best.as_ref().is_none_or(|best| cost < best.cost) {
                    let cut = behind + front + flat - count;
                    best = Some(Best {
                        axis,
                        d,
                        flat_to_front,
                        cost,
                        cut,
                    });
                }
            }
        }
        behind += flat + begun;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_sort_by_position_then_kind_and_keep_both() {
        let positions = [f32::MIN, -1.0, -0.0, 1e-40, 0.5, 2.0];
        let mut all = Vec::new();
        for (i, &d) in positions.iter().enumerate() {
            for kind in [ENDS, FLAT, BEGINS] {
                all.push(BoundEvent::new(d, kind, i));
            }
        }
        assert!(all.is_sorted());
        let back = all.iter().map(|e| (e.d(), e.kind(), e.item()));
        assert!(
            back.eq((0..positions.len()).flat_map(|i| [0, 1, 2].map(|k| (positions[i], k, i))))
        );
        assert_eq!(
            BoundEvent::new(0.0, FLAT, 1),
            BoundEvent::new(-0.0, FLAT, 1)
        );
    }

    #[test]
    fn two_apart_are_parted_and_the_empty_space_between_goes_with_one() {
        let items = [[0.0, 1.0], [3.0, 4.0]];
        let mut events = Vec::new();
        for (i, [min, max]) in items.into_iter().enumerate() {
            BoundEvent::push(&mut events, i, &[[min; 3], [max; 3]], 0);
        }
        events.sort_unstable();
        let best = sweep(&events, 0, 2, &[[0.0; 3], [4.0, 1.0, 1.0]]).expect("a plane");
        // Half areas: 9 of the whole, 3 and 7 of the parts at x = 1.
        assert_eq!((best.d, best.cut), (1.0, 0));
        assert!((best.cost - (STEP + TEST * (3.0 + 7.0) / 9.0)).abs() < 1e-12);
    }
}
