//! Every tree with every instruction set, sixteen rays together: the bits of the list.

use super::*;
use crate::accel::list::List;
use crate::accel::query::Query;
use crate::accel::{Accel, AccelKind};
use crate::geometry::Triangle;
use crate::math::DVec3;
use crate::probe::Silent;

/// Random numbers in [-1, 1) that are the same in every run.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn point(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }
}

pub fn bits(hit: Option<Hit>) -> Option<(u32, u64, [u64; 3])> {
    hit.map(|h| (h.primitive, h.t.to_bits(), h.place.map(f64::to_bits)))
}

/// Small triangles on a grid of quarters, so that rays to their corners meet edges and corners exactly.
pub fn shapes(random: &mut Random) -> Vec<Shape> {
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
pub fn rays(shapes: &[Shape], random: &mut Random) -> Vec<(Ray, Interval)> {
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

/// How many groups of rays a tree follows together with these instructions, all of which answer as expected.
fn agreeing<T: PacketTree>(
    (isa, tree): (Isa, &T),
    shapes: &[Shape],
    rays: &[(Ray, Interval)],
    expected: &[Option<(u32, u64, [u64; 3])>],
) -> usize {
    let (mut closest, mut any) = ([None; PACKET_SIZE], [None; PACKET_SIZE]);
    let scratch = &mut PacketScratch::new();
    let groups = rays.chunks(PACKET_SIZE).zip(expected.chunks(PACKET_SIZE));
    let together = groups.filter(|(rays, expected)| {
        let Some(_) = search_packet::<false, T>(isa, tree, shapes, rays, &mut closest, scratch)
        else {
            return false;
        };
        let blocked =
            search_packet::<true, T>(isa, tree, shapes, rays, &mut any, scratch).expect("again");
        for (i, (ray, _)) in rays.iter().enumerate() {
            assert_eq!(bits(closest[i]), expected[i], "{isa:?}: {ray:?}");
            assert_eq!(
                blocked >> i & 1 == 1,
                expected[i].is_some(),
                "{isa:?}, any: {ray:?}"
            );
        }
        true
    });
    together.count()
}

#[test]
fn every_tree_and_instruction_set_answers_as_the_list_does() {
    let mut random = Random(7);
    let shapes = shapes(&mut random);
    let rays = rays(&shapes, &mut random);
    let list = List::build(&shapes);
    let ask = |(ray, interval): &(Ray, Interval)| {
        let mut closest = None;
        list.search(
            &Query::new(&shapes, ray, *interval),
            &mut closest,
            &mut Silent,
        );
        bits(closest)
    };
    let expected: Vec<_> = rays.iter().map(ask).collect();
    // The test means something: many hits, and most groups go together.
    assert!(expected.iter().flatten().count() > rays.len() / 3);
    for kind in [AccelKind::Wide, AccelKind::Kd, AccelKind::BspAxis] {
        let accel = Accel::build(kind, &shapes);
        assert!(accel.gains_from_packets(), "{kind:?}");
        for isa in Isa::all() {
            let together = match &accel {
                Accel::Bvh8(bvh8) => agreeing((isa, bvh8), &shapes, &rays, &expected),
                Accel::Compact(compact) => agreeing((isa, compact), &shapes, &rays, &expected),
                Accel::Bsp(_, compact) => {
                    let compact = compact.as_deref().expect("planes along the axes");
                    agreeing((isa, compact), &shapes, &rays, &expected)
                }
                _ => 0,
            };
            assert!(together > 200, "{kind:?}: {together}");
        }
    }
}
