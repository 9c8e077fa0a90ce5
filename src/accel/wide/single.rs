//! One ray through the tree, the nearest boxes first.

use super::{BLOCK, Block, DEEP, LEAF, Node, WIDTH, Wide};
use crate::accel::Query;
use crate::accel::filter::{depth_inside, doubt};
use crate::accel::local::{Local, Plan, larger, smaller};
use crate::accel::simd::{Level, Task};
use crate::geometry::Hit;
use crate::probe::{Choice, Event, NONE, Probe, Visit, tell};

/// Most trees let no more children wait than this; a short stack is soon made.
const USUAL: usize = 64;

/// The closest hit, or any.
#[inline]
pub fn search<const ANY: bool, P: Probe>(wide: &Wide, query: &Query, probe: &mut P) -> Option<Hit> {
    let task = Search::<ANY, P> { wide, query, probe };
    wide.isa.unless_told::<P>().run(task)
}

struct Search<'a, const ANY: bool, P> {
    wide: &'a Wide,
    query: &'a Query<'a>,
    probe: &'a mut P,
}

impl<const ANY: bool, P: Probe> Task for Search<'_, ANY, P> {
    type Output = Option<Hit>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Option<Hit> {
        let Self { wide, query, probe } = self;
        let mut best = None;
        if query.test_all::<ANY, P>(&wide.outside, &mut best, probe) || wide.nodes.is_empty() {
            return best;
        }
        match wide.frame.plan(&query.ray, query.interval) {
            Plan::Miss => {
                if P::TRAVERSAL {
                    let Query { interval, .. } = query;
                    let all = [interval.min, interval.max];
                    tell!(probe, step(0, all, Choice::SkippedOutside, [NONE; 2]));
                }
            }
            Plan::TestAll => test_all::<ANY, P>(wide, query, &mut best, probe),
            Plan::Follow(local) if wide.waiting <= USUAL => {
                follow::<USUAL, ANY, L, P>(level, wide, query, &local, &mut best, probe);
            }
            Plan::Follow(local) => {
                follow::<DEEP, ANY, L, P>(level, wide, query, &local, &mut best, probe);
            }
        }
        best
    }
}

/// Every primitive of the tree.
#[cold]
#[inline(never)]
fn test_all<const ANY: bool, P: Probe>(
    wide: &Wide,
    query: &Query,
    best: &mut Option<Hit>,
    probe: &mut P,
) {
    for block in &wide.blocks {
        if query.test_all::<ANY, P>(block.primitives(), best, probe) {
            return;
        }
    }
}

#[inline(always)]
fn follow<const DEPTH: usize, const ANY: bool, L: Level, P: Probe>(
    level: L,
    wide: &Wide,
    query: &Query,
    local: &Local,
    best: &mut Option<Hit>,
    probe: &mut P,
) {
    // Children that wait, the nearest on top: where the ray enters (not negative, so its bits sort as it does), and
    // which.
    let sight = Sight::new(local, query.shear.axes);
    let mut stack = [0u64; DEPTH];
    let mut waiting = 0;
    let mut max = best.map_or(local.max, |hit| smaller(local.max, local.not_before(hit.t)));
    let mut id = 0;
    loop {
        let node = &wide.nodes[id as usize];
        let (near, far) = cross(level, node, local, max);
        let mut met = level.le8(&near, &far);
        if P::TRAVERSAL {
            tell(wide, id, node, local, (&near, &far), met, probe);
        }
        let first = waiting;
        while met != 0 {
            let child = met.trailing_zeros() as usize;
            met &= met - 1;
            let key = u64::from(near[child].to_bits()) << 32 | u64::from(node.children[child]);
            let mut place = waiting;
            while place > first && stack[place - 1] < key {
                stack[place] = stack[place - 1];
                place -= 1;
            }
            stack[place] = key;
            waiting += 1;
        }
        id = loop {
            if waiting == 0 {
                return;
            }
            waiting -= 1;
            let (enter, child) = (
                f32::from_bits((stack[waiting] >> 32) as u32),
                stack[waiting] as u32,
            );
            // A hit at the very entry does not count: one beyond it may be as close and have the smaller id.
            if enter > max {
                if P::TRAVERSAL {
                    let part = [local.world(enter), query.interval.max];
                    let choice = Choice::SkippedCloserHit;
                    tell!(probe, step(wide.number(child), part, choice, [NONE; 2]));
                }
                continue;
            }
            if child & BLOCK == 0 {
                break child;
            }
            let block = &wide.blocks[(child & !BLOCK) as usize];
            if P::TRAVERSAL {
                let part = [local.world(enter), local.world(max)];
                tell!(
                    probe,
                    step(wide.number(child), part, Choice::Leaf, [NONE; 2])
                );
            }
            if test_block::<ANY, L, P>(level, query, &sight, block, best, probe) {
                return;
            }
            if let Some(hit) = best {
                max = smaller(max, local.not_before(hit.t));
            }
        };
    }
}

/// Where the ray enters each box and where it leaves it, cut to the interval.
#[inline(always)]
fn cross<L: Level>(level: L, node: &Node, local: &Local, max: f32) -> ([f32; WIDTH], [f32; WIDTH]) {
    let [x, y, z] = local.backwards;
    let (nx, ny, nz) = (&node.planes[x], &node.planes[2 + y], &node.planes[4 + z]);
    let (fx, fy, fz) = (
        &node.planes[1 - x],
        &node.planes[3 - y],
        &node.planes[5 - z],
    );
    let Local {
        inverse: inv,
        near,
        far,
        min,
        ..
    } = *local;
    let t =
        |plane: f32, k: usize, offset: [f32; 3]| level.multiply_subtract(plane, inv[k], offset[k]);
    let (mut enter, mut leave) = ([0.0; WIDTH], [0.0; WIDTH]);
    for i in 0..WIDTH {
        let xy = larger(t(nx[i], 0, near), t(ny[i], 1, near));
        enter[i] = larger(larger(xy, t(nz[i], 2, near)), min);
        let xy = smaller(t(fx[i], 0, far), t(fy[i], 1, far));
        leave[i] = smaller(smaller(xy, t(fz[i], 2, far)), max);
    }
    (enter, leave)
}

/// A ray as the filter of triangles sees it, in the tree's space.
struct Sight {
    axes: [usize; 3],
    origin: [f32; 3],
    slope: [f32; 2],
    pad: f32,
}

impl Sight {
    #[inline(always)]
    fn new(local: &Local, axes: [usize; 3]) -> Self {
        let [x, y, z] = axes;
        let (o, inverse) = (local.origin, local.inverse);
        Self {
            axes,
            origin: [o[x], o[y], o[z]],
            slope: [inverse[z] / inverse[x], inverse[z] / inverse[y]],
            pad: local.pad,
        }
    }

    /// The mask of what may be hit in a block.
    #[inline(always)]
    fn candidates<L: Level>(&self, level: L, block: &Block) -> u32 {
        let [x, y, z] = self.axes;
        let rows = [&block.corners[x], &block.corners[y], &block.corners[z]];
        let depth = depth_inside::<LEAF>(
            |c, k, i| rows[k][c][i],
            |k, _| self.origin[k],
            |k, _| self.slope[k],
        );
        level.le4(&[-doubt(block.size, self.pad); LEAF], &depth) | u32::from(block.others)
    }
}

/// Tests the primitives of a block: those that the ray may hit, or all if someone listens.
#[inline(always)]
fn test_block<const ANY: bool, L: Level, P: Probe>(
    level: L,
    query: &Query,
    sight: &Sight,
    block: &Block,
    best: &mut Option<Hit>,
    probe: &mut P,
) -> bool {
    if P::TRAVERSAL {
        return query.test_all::<ANY, P>(block.primitives(), best, probe);
    }
    let mut candidates = sight.candidates(level, block);
    while candidates != 0 {
        let lane = candidates.trailing_zeros() as usize;
        candidates &= candidates - 1;
        query.test(block.primitives[lane], best, probe);
        if ANY && best.is_some() {
            return true;
        }
    }
    false
}

/// Tells of a node: which children are met, nearest first, then which are not.
fn tell<P: Probe>(
    wide: &Wide,
    id: u32,
    node: &Node,
    local: &Local,
    (near, far): (&[f32; WIDTH], &[f32; WIDTH]),
    met: u32,
    probe: &mut P,
) {
    let is_met = |i: &usize| met >> i & 1 == 1;
    let mut order: Vec<usize> = (0..WIDTH).filter(is_met).collect();
    order.sort_by(|&i, &j| near[i].total_cmp(&near[j]));
    let child = |rank: usize| {
        order
            .get(rank)
            .map_or(NONE, |&i| wide.number(node.children[i]))
    };
    let enter = near.iter().copied().fold(f32::INFINITY, f32::min);
    let leave = far.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let part = [local.world(enter), local.world(leave)];
    tell!(
        probe,
        step(id, part, Choice::Children, [child(0), child(1)])
    );
    for i in (0..WIDTH).filter(|i| !is_met(i) && node.children[*i] != NONE) {
        let part = [local.world(near[i]), local.world(far[i])];
        let number = wide.number(node.children[i]);
        tell!(probe, step(number, part, Choice::SkippedMissed, [NONE; 2]));
    }
}

fn step(node: u32, interval: [f64; 2], choice: Choice, [near, far]: [u32; 2]) -> Event {
    Event::Visit(Visit {
        node,
        interval,
        t_split: f64::NAN,
        near,
        far,
        choice,
    })
}
