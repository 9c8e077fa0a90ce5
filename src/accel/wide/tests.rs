//! Every instruction set, one ray or many: the bits of the list.

use super::*;
use crate::accel::{Accel, List, packet};
use crate::geometry::Triangle;
use crate::math::{DVec3, Interval, Ray};
use crate::probe::Silent;

/// Random numbers in [-1, 1) that are the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn point(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }
}

fn bits(hit: Option<Hit>) -> Option<(u32, u64, [u64; 3])> {
    hit.map(|h| (h.primitive, h.t.to_bits(), h.barycentric.map(f64::to_bits)))
}

/// Small triangles on a grid of quarters, so that rays to their corners meet edges and corners exactly.
fn shapes(random: &mut Random) -> Vec<Shape> {
    let grid = |p: DVec3| (p * 4.0).round() / 4.0;
    (0..300)
        .map(|i| {
            let a = grid(random.point());
            let (b, c) = (a + 0.5 * random.point(), a + 0.5 * random.point());
            let corners = match i % 3 {
                0 => [a, b, c],
                1 => [a, grid(b), grid(c)],
                // A sliver, for the branch in which most digits cancel.
                _ => [a, b, 0.5 * (a + b) + 1e-13 * c],
            };
            Shape::Triangle(Triangle { corners })
        })
        .collect()
}

/// Sixteen rays at a time from one point: to all sides, or to places close to each other, corners among them.
fn rays(shapes: &[Shape], random: &mut Random) -> Vec<(Ray, Interval)> {
    let mut rays = Vec::new();
    for group in 0..400usize {
        let eye = 3.0 * random.point().normalize_or(DVec3::X);
        let Shape::Triangle(aim) = &shapes[group % shapes.len()] else {
            continue;
        };
        for i in 0..16usize {
            let to = match i % 4 {
                0 => aim.corners[i / 4 % 3],
                1 => 0.5 * (aim.corners[0] + aim.corners[1]),
                _ => aim.corners[0] + 0.05 * random.point(),
            };
            let direction = if group % 5 == 0 {
                random.point()
            } else {
                to - eye
            };
            let end = if group % 7 == 0 { 3.0 } else { f64::INFINITY };
            let ray = Ray::new(eye, direction.normalize_or(DVec3::Y));
            rays.push((ray, Interval::before(end)));
        }
    }
    rays
}

#[test]
fn every_instruction_set_answers_as_the_list_does() {
    let mut random = Random(7);
    let shapes = shapes(&mut random);
    let rays = rays(&shapes, &mut random);
    let list = List::build(&shapes);
    let expected: Vec<_> = rays
        .iter()
        .map(|(ray, interval)| {
            bits(list.closest(&Query::new(&shapes, ray, *interval), &mut Silent))
        })
        .collect();
    let mut wide = Wide::build(&shapes);
    for isa in Isa::all() {
        wide.isa = isa;
        let (mut closest, mut any) = (vec![None; rays.len()], vec![false; rays.len()]);
        let together = Accel::Wide(wide.clone());
        together.closest_many(&shapes, &rays, &mut closest);
        together.any_many(&shapes, &rays, &mut any);
        for (i, (ray, interval)) in rays.iter().enumerate() {
            let query = Query::new(&shapes, ray, *interval);
            let hit = bits(wide.closest(&query, &mut Silent));
            assert_eq!(hit, expected[i], "{isa:?} {ray:?}");
            assert_eq!(bits(closest[i]), expected[i], "{isa:?}, together: {ray:?}");
            let blocked = wide.any(&query, &mut Silent).is_some();
            assert_eq!(
                (blocked, any[i]),
                (hit.is_some(), hit.is_some()),
                "{isa:?} {ray:?}"
            );
        }
    }
    // The test means something: many hits, and most groups go together.
    assert!(expected.iter().flatten().count() > rays.len() / 3);
    let (mut out, mut waiting) = (
        [None; packet::RAYS],
        <Wide as packet::Follow>::Waiting::default(),
    );
    let groups = rays.chunks(packet::RAYS);
    let together = groups.filter(|group| {
        packet::together::<false, _>(&wide, &shapes, group, &mut out, &mut waiting).is_some()
    });
    assert!(together.count() > 200);
}

#[test]
fn nodes_and_blocks_stay_small() {
    assert_eq!((size_of::<Node>(), size_of::<Block>()), (224, 192));
}
