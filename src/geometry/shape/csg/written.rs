//! The tree of a CSG solid read back from its program.

use super::program::Instruction;
use super::{Csg, CsgOp};

/// A part of a solid: a leaf by its number, or what is done with parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CsgNode {
    /// A leaf.
    Leaf(u32),
    /// Two or more parts, taken together.
    Op(CsgOp, Vec<CsgNode>),
}

impl Csg {
    /// The tree. Operations of the same kind one after the other are one of many parts: a - b - c.
    pub fn tree(&self) -> Option<CsgNode> {
        let mut stack: Vec<CsgNode> = Vec::new();
        for instruction in &self.program.0 {
            let node = match *instruction {
                Instruction::Leaf(leaf) => CsgNode::Leaf(leaf),
                Instruction::Op(op) => {
                    let (second, first) = (stack.pop()?, stack.pop()?);
                    match first {
                        CsgNode::Op(same, mut parts) if same == op => {
                            parts.push(second);
                            CsgNode::Op(op, parts)
                        }
                        first => CsgNode::Op(op, vec![first, second]),
                    }
                }
            };
            stack.push(node);
        }
        stack.pop()
    }
}
