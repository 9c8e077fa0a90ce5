//! Every instruction set, one ray at a time: the bits of the list.

use super::*;
use crate::accel::List;
use crate::accel::packet::tests::{Random, bits, rays, shapes};
use crate::probe::Silent;

#[test]
fn every_instruction_set_answers_as_the_list_does() {
    let mut random = Random(7);
    let shapes = shapes(&mut random);
    let rays = rays(&shapes, &mut random);
    let list = List::build(&shapes);
    let mut wide = Wide::build(&shapes, &|_| ());
    for isa in Isa::all() {
        wide.isa = isa;
        for (ray, interval) in &rays {
            let query = Query::new(&shapes, ray, *interval);
            let expected = bits(list.closest(&query, &mut Silent));
            let found = bits(wide.closest(&query, &mut Silent));
            assert_eq!(found, expected, "{isa:?} {ray:?}");
            let blocked = wide.any(&query, &mut Silent).is_some();
            assert_eq!(blocked, expected.is_some(), "{isa:?} {ray:?}");
        }
    }
}

#[test]
fn nodes_and_blocks_stay_small() {
    assert_eq!((size_of::<Node>(), size_of::<Block>()), (224, 192));
}
