//! Every instruction set, one ray at a time: the bits of the list.

use super::*;
use crate::accel::collect::AnyHit;
use crate::accel::fast::packet::tests::{Random, bits, rays, shapes};
use crate::accel::list::List;
use crate::accel::query::Query;
use crate::math::DVec3;
use crate::probe::{Choice, Event, Probe, Silent, Verdict};

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

/// The steps of a ray.
#[derive(Default)]
struct Steps(Vec<Event>);

impl Probe for Steps {
    const TRAVERSAL: bool = true;

    fn event(&mut self, event: Event) {
        self.0.push(event);
    }
}

/// The part of a ray that is told of a leaf ends where the ray leaves the leaf's box, or at what was searched, if that is before.
#[test]
fn a_leaf_tells_where_the_ray_leaves_it() {
    let mut random = Random(7);
    let shapes = shapes(&mut random);
    let rays = rays(&shapes, &mut random);
    let bvh8 = Bvh8::build(&shapes, &|_| ());
    let (mut at_exit, mut at_hit) = (0, 0);
    for (ray, interval) in &rays {
        let (mut found, mut steps) = (None, Steps::default());
        bvh8.search(&Query::new(&shapes, ray, *interval), &mut found, &mut steps);
        let mut max = interval.max;
        for event in steps.0 {
            match event {
                Event::Test {
                    verdict: Verdict::Hit,
                    t,
                    ..
                } => max = t,
                Event::Visit(visit) if visit.choice == Choice::Leaf => {
                    let bounds = bvh8.node_bounds(&shapes, visit.node).expect("a leaf");
                    let Some(inside) = bounds.clip(ray, *interval) else {
                        // Only in single precision.
                        continue;
                    };
                    // The boxes of the tree are a little wider, in single precision.
                    let wider = bounds.padded(DVec3::splat(1e-4)).clip(ray, *interval);
                    let near = 1e-5 * (1.0 + inside.max.abs().min(1e6));
                    let exits = inside.max - near..=wider.map_or(inside.max, |w| w.max) + near;
                    let told = visit.interval[1];
                    if max < *exits.start() {
                        assert!((told - max).abs() <= near, "{told} {max}");
                        at_hit += 1;
                    } else if max > *exits.end() {
                        assert!(exits.contains(&told), "{told} {exits:?} {ray:?}");
                        at_exit += 1;
                    }
                }
                _ => {}
            }
        }
    }
    assert!(at_exit > 100 && at_hit > 20, "{at_exit} {at_hit}");
}
