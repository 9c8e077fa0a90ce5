//! Every instruction set does the same.

use super::*;
use crate::accel::fast::packet::tests::{Random, rays, shapes};
use crate::accel::{Accel, AccelKind};
use crate::probe::Event;

/// All operations on numbers of every kind.
struct Compare;

impl SimdKernel for Compare {
    type Output = Vec<u32>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Vec<u32> {
        let odd = [
            0.0,
            -0.0,
            f32::NAN,
            1.0,
            -1.0,
            f32::INFINITY,
            f32::MIN,
            1e-45,
        ];
        let one = |k: usize| -> [f32; 16] { std::array::from_fn(|i| odd[(i * k + i / 8) % 8]) };
        let (a, b) = (one(1), one(3));
        let bvh8: [f64; 8] = std::array::from_fn(|i| f64::from(odd[i]));
        let mut out: Vec<u32> = [level.min16(&a, &b), level.max16(&a, &b)]
            .as_flattened()
            .iter()
            .map(|x| x.to_bits())
            .collect();
        let plain: [f32; 16] = std::array::from_fn(|i| i as f32);
        let products = level.multiply_subtract16(3.0, &plain, &[1.0; 16]);
        out.extend(products.map(f32::to_bits));
        out.extend([
            level.le8(&a.as_chunks().0[0], &b.as_chunks().0[0]),
            level.le16(&a, &b),
            level.le4(&a.as_chunks().0[0], &b.as_chunks().0[0]),
            level.positive8(&bvh8),
            level.less8(&bvh8, &std::array::from_fn(|i| bvh8[7 - i])),
        ]);
        out
    }
}

#[test]
fn every_instruction_set_compares_alike() {
    let expected = Isa::PORTABLE.run(Compare);
    assert_eq!(
        expected[48 + 3],
        0b1010_1011,
        "0, -0, 1, infinity and the smallest"
    );
    for isa in Isa::all() {
        assert_eq!(isa.run(Compare), expected, "{isa:?}");
    }
}

/// Writes down all that it hears; floats are written so that other bits are other words.
#[derive(Default)]
struct Steps(Vec<String>);

impl Probe for Steps {
    const TRAVERSAL: bool = true;

    fn event(&mut self, event: Event) {
        self.0.push(format!("{event:?}"));
    }
}

/// What is recorded, and what is counted, must not depend on the machine.
#[test]
fn every_instruction_set_takes_the_same_steps() {
    let mut random = Random(7);
    let shapes = shapes(&mut random);
    let rays = rays(&shapes, &mut random);
    for kind in [AccelKind::Wide, AccelKind::Kd, AccelKind::BspSah] {
        let mut accel = Accel::build(kind, &shapes);
        for (ray, interval) in rays.iter().step_by(5) {
            let steps = |isa| {
                match &mut accel {
                    Accel::Bvh8(bvh8) => bvh8.isa = isa,
                    Accel::Compact(compact) => compact.isa = isa,
                    _ => panic!("{kind:?} has no instructions of its own"),
                }
                let mut steps = Steps::default();
                accel.closest(&shapes, ray, *interval, &mut steps);
                accel.any_hit(&shapes, ray, *interval, &mut steps);
                steps.0
            };
            let mut all = Isa::all().into_iter().map(steps);
            let expected = all.next().expect("one that is portable");
            assert!(!expected.is_empty());
            for found in all {
                assert_eq!(found, expected, "{kind:?}: {ray:?}");
            }
        }
    }
}
