//! Every instruction set, one ray at a time: the bits of the list.

use super::*;
use crate::accel::collect::AnyHit;
use crate::accel::fast::packet::tests::{Random, bits, rays, shapes};
use crate::accel::list::List;
use crate::accel::query::Query;
use crate::probe::Silent;

#[test]
fn every_instruction_set_answers_as_the_list_does() {
    let mut random = Random(7);
    let shapes = shapes(&mut random);
    let rays = rays(&shapes, &mut random);
    let list = List::build(&shapes);
    let mut bvh8 = Bvh8::build(&shapes, &|_| ());
    for isa in Isa::all() {
        bvh8.isa = isa;
        for (ray, interval) in &rays {
            let query = Query::new(&shapes, ray, *interval);
            let (mut expected, mut found, mut any) = (None, None, AnyHit(None));
            list.search(&query, &mut expected, &mut Silent);
            bvh8.search(&query, &mut found, &mut Silent);
            assert_eq!(bits(found), bits(expected), "{isa:?} {ray:?}");
            bvh8.search(&query, &mut any, &mut Silent);
            assert_eq!(any.0.is_some(), expected.is_some(), "{isa:?} {ray:?}");
        }
    }
}

#[test]
fn nodes_and_leaves_stay_small() {
    assert_eq!((size_of::<Node>(), size_of::<Leaf>()), (224, 192));
}
