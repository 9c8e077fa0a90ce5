//! Parting a cell: which items go where, and the new bounds of those that are cut.

use super::events::{Best, BoundEvent};
use super::{Bounds, Cell, Item};
use crate::accel::fast::local_ray::UnitBox;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// By how much a box is grown before a triangle is cut to it. Its sides are rounded by up to 2^-24, and a triangle that is
/// flat and lies along a side would lose whole parts to that.
const ROUNDED: f64 = 1.0 / (1 << 22) as f64;

/// What clipping needs to know.
pub struct Clip<'a> {
    pub shapes: &'a [Shape],
    pub unit_box: &'a UnitBox,
}

impl Clip<'_> {
    /// A whole primitive.
    pub fn whole(&self, primitive: u32) -> Item {
        let bounds = self.shapes[primitive as usize]
            .bounds()
            .unwrap_or(Aabb::EMPTY);
        let corner = |p: DVec3| self.unit_box.to_local(p).to_array().map(|x| x as f32);
        Item {
            primitive,
            bounds: [corner(bounds.min), corner(bounds.max)],
        }
    }

    /// The bounds of the part of a primitive inside a box; the box itself if the primitive is no triangle.
    pub fn inside(&self, primitive: u32, [min, max]: &Bounds) -> Bounds {
        let Shape::Triangle(triangle) = &self.shapes[primitive as usize] else {
            return [*min, *max];
        };
        // A triangle cut by six planes has at most nine corners.
        let mut corners = ([DVec3::ZERO; 10], 3);
        for (to, from) in corners.0.iter_mut().zip(triangle.corners) {
            *to = self.unit_box.to_local(from);
        }
        for axis in 0..3 {
            let (low, high) = (f64::from(min[axis]), f64::from(max[axis]));
            corners = cut(&corners.0[..corners.1], axis, 1.0, low - ROUNDED);
            corners = cut(&corners.0[..corners.1], axis, -1.0, high + ROUNDED);
        }
        if corners.1 == 0 {
            // Rounding has lost it.
            return [*min, *max];
        }
        let mut bounds = [*max, *min];
        for corner in &corners.0[..corners.1] {
            for axis in 0..3 {
                let x = (corner[axis] as f32).clamp(min[axis], max[axis]);
                bounds[0][axis] = bounds[0][axis].min(x);
                bounds[1][axis] = bounds[1][axis].max(x);
            }
        }
        bounds
    }
}

/// The part of a convex polygon where `sign` (x - d) >= 0. Source: Sutherland and Hodgman 1974.
fn cut(polygon: &[DVec3], axis: usize, sign: f64, d: f64) -> ([DVec3; 10], usize) {
    let (mut out, mut count) = ([DVec3::ZERO; 10], 0);
    let mut put = |p: DVec3| {
        if count < out.len() {
            out[count] = p;
            count += 1;
        }
    };
    let height = |p: DVec3| sign * (p[axis] - d);
    let Some(&last) = polygon.last() else {
        return (out, 0);
    };
    let (mut p, mut s) = (last, height(last));
    for &q in polygon {
        let r = height(q);
        if (s < 0.0) != (r < 0.0) && s != 0.0 && r != 0.0 {
            let mut crossing = p + (s / (s - r)) * (q - p);
            crossing[axis] = d;
            put(crossing);
        }
        if r >= 0.0 {
            put(q);
        }
        (p, s) = (q, r);
    }
    (out, count)
}

/// Neither number.
const NONE: u32 = u32::MAX;

/// The cells behind a plane and in front of it.
pub fn part(clip: &Clip, cell: Cell, plane: &Best) -> [Cell; 2] {
    let Best { axis, d, .. } = *plane;
    let Cell {
        items,
        events,
        bounds,
    } = cell;
    let (mut low, mut high) = (bounds, bounds);
    (low[1][axis], high[0][axis]) = (d, d);

    // Which side an item goes to, and its number there. What is cut comes last, and its events anew.
    let mut sides = [Vec::new(), Vec::new()];
    let mut numbers = vec![(0u8, NONE); items.len()];
    let mut crossing = Vec::new();
    for (item, number) in items.iter().zip(&mut numbers) {
        let (min, max) = (item.bounds[0][axis], item.bounds[1][axis]);
        let side = match (min >= d, max <= d) {
            (true, true) => usize::from(plane.flat_to_front),
            (true, false) => 1,
            (false, true) => 0,
            (false, false) => {
                crossing.push(*item);
                continue;
            }
        };
        *number = (side as u8, sides[side].len() as u32);
        sides[side].push(*item);
    }
    drop(items);
    let uncut = [sides[0].len(), sides[1].len()];
    for item in crossing {
        let (mut behind, mut front) = (item.bounds, item.bounds);
        (behind[1][axis], front[0][axis]) = (d, d);
        for (side, bounds) in [behind, front].iter().enumerate() {
            sides[side].push(Item {
                primitive: item.primitive,
                bounds: clip.inside(item.primitive, bounds),
            });
        }
    }

    let mut lists: [[Vec<BoundEvent>; 3]; 2] = Default::default();
    for (k, list) in events.into_iter().enumerate() {
        for side in 0..2 {
            let mut new = Vec::new();
            for (i, item) in sides[side].iter().enumerate().skip(uncut[side]) {
                BoundEvent::push(&mut new, i, &item.bounds, k);
            }
            new.sort_unstable();
            let old = list.iter().filter_map(|event| {
                let (at, number) = numbers[event.item()];
                (number != NONE && usize::from(at) == side).then(|| event.renumbered(number))
            });
            lists[side][k] = merged(old, &new, 2 * sides[side].len());
        }
    }
    let [behind, front] = sides;
    let [first, second] = lists;
    let cell = |items, events, bounds| Cell {
        items,
        events,
        bounds,
    };
    [cell(behind, first, low), cell(front, second, high)]
}

/// Two sorted lists in one.
fn merged(
    old: impl Iterator<Item = BoundEvent>,
    new: &[BoundEvent],
    scratch: usize,
) -> Vec<BoundEvent> {
    let mut all = Vec::with_capacity(scratch);
    let mut new = new.iter().copied().peekable();
    for event in old {
        while let Some(earlier) = new.next_if(|n| *n < event) {
            all.push(earlier);
        }
        all.push(event);
    }
    all.extend(new);
    all
}
