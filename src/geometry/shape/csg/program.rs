//! The program of a CSG tree: from the set of leaves that a point is inside of, whether it is inside of the whole.

/// What is done with the parts of a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum CsgOp {
    /// What is inside any part.
    Union,
    /// What is inside all parts.
    Intersection,
    /// What is inside the first part and none of the others.
    Difference,
}

impl CsgOp {
    /// Its name in scene files.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// An instruction of a machine with a stack of bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Instruction {
    /// Push: is the point inside of this leaf?
    Leaf(u32),
    /// Pop two answers and push one.
    Op(CsgOp),
}

/// The tree in postfix notation: operands first, then what is done with them.
#[derive(Clone, Debug, Default)]
pub(super) struct CsgProgram(pub Vec<Instruction>);

impl CsgProgram {
    /// Whether a point that is inside of the leaves of `set` (bit i for leaf i) is inside of the whole. The stack is a word:
    /// a tree that is 32 deep never has more than 33 answers waiting.
    #[inline]
    pub fn is_inside(&self, set: u64) -> bool {
        let mut stack = 0u64;
        for instruction in &self.0 {
            match *instruction {
                Instruction::Leaf(leaf) => stack = stack << 1 | (set >> leaf & 1),
                Instruction::Op(op) => {
                    let (first, second) = (stack >> 1, stack);
                    let answer = match op {
                        CsgOp::Union => first | second,
                        CsgOp::Intersection => first & second,
                        CsgOp::Difference => first & !second,
                    };
                    stack = stack >> 2 << 1 | (answer & 1);
                }
            }
        }
        stack & 1 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Instruction::{Leaf, Op};

    #[test]
    fn the_three_words_have_their_truth_tables() {
        let table = |op| {
            let program = CsgProgram(vec![Leaf(0), Leaf(1), Op(op)]);
            [0b00, 0b01, 0b10, 0b11].map(|set| program.is_inside(set))
        };
        assert_eq!(table(CsgOp::Union), [false, true, true, true]);
        assert_eq!(table(CsgOp::Intersection), [false, false, false, true]);
        assert_eq!(table(CsgOp::Difference), [false, true, false, false]);
    }

    #[test]
    fn operands_wait_on_the_stack() {
        // 0 - (1 - (2 - 3))
        let op = Op(CsgOp::Difference);
        let program = CsgProgram(vec![Leaf(0), Leaf(1), Leaf(2), Leaf(3), op, op, op]);
        assert!(program.is_inside(0b0001));
        assert!(!program.is_inside(0b0011));
        assert!(program.is_inside(0b0111));
        assert!(!program.is_inside(0b1111));
        assert!(!CsgProgram::default().is_inside(u64::MAX));
    }
}
