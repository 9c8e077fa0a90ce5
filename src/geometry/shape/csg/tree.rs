//! The tree of a CSG solid as it is written, and what it is made into.

use super::Solid;
use super::program::{CsgOp, CsgProgram, Instruction};
use crate::geometry::Aabb;
use crate::math::DVec3;
use crate::math::rounding::gamma;

/// A solid as it is written: leaves, and what is done with them.
#[derive(Clone, Debug)]
pub enum CsgTree {
    /// A solid by itself.
    Leaf(Solid),
    /// One or more parts, taken together.
    Op(CsgOp, Vec<CsgTree>),
}

/// A leaf in its place in the tree.
#[derive(Clone, Debug)]
pub(super) struct PlacedLeaf {
    pub solid: Solid,
    /// True if the whole has less where the leaf is: it is behind an odd number of minus signs.
    pub is_subtracted: bool,
    /// Sets of leaves: where a line misses all leaves of any of these sets, this one cannot matter.
    pub needs: Vec<u64>,
}

/// What a tree is made into.
#[derive(Debug, Default)]
pub(super) struct Compiled {
    pub leaves: Vec<PlacedLeaf>,
    pub program: CsgProgram,
}

/// What a part knows of those above it.
#[derive(Clone, Default)]
struct Above {
    depth: usize,
    is_subtracted: bool,
    needs: Vec<u64>,
}

impl Compiled {
    /// Most leaves of a tree: the sets of leaves are words of 64 bits.
    pub const MAX_LEAVES: usize = 64;
    /// Most operations inside each other.
    pub const MAX_DEPTH: usize = 32;

    /// The program, the leaves and the box of a tree. Errors: what is wrong, to be shown behind the name of the solid, a colon, and what to do.
    pub fn new(tree: CsgTree) -> Result<(Self, Aabb), String> {
        let mut compiled = Self::default();
        let bounds = compiled.add(tree, &Above::default())?;
        let is_bounded = bounds.is_empty() || (bounds.min.is_finite() && bounds.max.is_finite());
        if !is_bounded {
            return Err(
                "has no end, since half-spaces (planes) go on for ever: intersect the whole with a solid that has an end, such as a box \
                 around all that you want to keep"
                    .to_owned(),
            );
        }
        if bounds.is_empty() {
            return Ok((compiled, Aabb::EMPTY));
        }
        let reach = bounds.min.abs().max(bounds.max.abs()).max_element();
        Ok((compiled, bounds.padded(DVec3::splat(gamma(16) * reach))))
    }

    /// Adds a part to the program; gives the box around it.
    fn add(&mut self, tree: CsgTree, above: &Above) -> Result<Aabb, String> {
        match tree {
            CsgTree::Leaf(solid) => self.add_leaf(solid, above),
            CsgTree::Op(op, parts) => self.add_op(op, parts, above),
        }
    }

    fn add_leaf(&mut self, solid: Solid, above: &Above) -> Result<Aabb, String> {
        let number = self.leaves.len();
        if number == Self::MAX_LEAVES {
            let most = Self::MAX_LEAVES;
            return Err(format!("has more than {most} parts: make two solids of it"));
        }
        if !solid.has_inside() {
            let (place, kind) = (number + 1, solid.kind());
            return Err(format!(
                "has a {kind} without an inside as its part number {place}: leave out `open`, since only solids can be cut"
            ));
        }
        let bounds = solid.bounds();
        if bounds.min.is_nan() || bounds.max.is_nan() {
            return Err(format!(
                "has a part, number {}, whose size is not a number: write finite numbers",
                number + 1
            ));
        }
        self.leaves.push(PlacedLeaf {
            solid,
            is_subtracted: above.is_subtracted,
            needs: above.needs.clone(),
        });
        self.program.0.push(Instruction::Leaf(number as u32));
        Ok(bounds)
    }

    fn add_op(&mut self, op: CsgOp, parts: Vec<CsgTree>, above: &Above) -> Result<Aabb, String> {
        if above.depth == Self::MAX_DEPTH {
            let most = Self::MAX_DEPTH;
            return Err(format!(
                "has more than {most} operations inside each other: join some of them"
            ));
        }
        let mut below = Above {
            depth: above.depth + 1,
            ..above.clone()
        };
        let mut whole = None;
        for part in parts {
            let first_leaf = self.leaves.len();
            let bounds = self.add(part, &below)?;
            whole = Some(match whole {
                None => bounds,
                Some(so_far) => {
                    self.program.0.push(Instruction::Op(op));
                    combined(op, so_far, bounds)
                }
            });
            // Nothing is left of an intersection without one of its parts, nor of a difference without its first.
            let is_first = below.is_subtracted == above.is_subtracted;
            match op {
                CsgOp::Intersection => below.needs.push(self.leaves_from(first_leaf)),
                CsgOp::Difference if is_first => {
                    below.needs.push(self.leaves_from(first_leaf));
                    below.is_subtracted = !above.is_subtracted;
                }
                CsgOp::Union | CsgOp::Difference => {}
            }
        }
        whole.ok_or_else(|| format!("has a {} of no parts: give it at least one", op.name()))
    }

    /// The set of the leaves from this number on.
    fn leaves_from(&self, first: usize) -> u64 {
        (first..self.leaves.len()).fold(0, |set, leaf| set | 1 << leaf)
    }
}

/// The box around what is left of two parts.
fn combined(op: CsgOp, a: Aabb, b: Aabb) -> Aabb {
    match op {
        CsgOp::Union if a.is_empty() => b,
        CsgOp::Union if b.is_empty() => a,
        CsgOp::Union => a.union(b),
        CsgOp::Intersection => Aabb {
            min: a.min.max(b.min),
            max: a.max.min(b.max),
        },
        CsgOp::Difference => a,
    }
}
