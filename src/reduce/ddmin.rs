//! Delta debugging: the smallest part of a list that still has a property.
//!
//! Source: Zeller and Hildebrandt 2002, "Simplifying and isolating failure-inducing input", the algorithm ddmin. The outcome is
//! 1-minimal: without any one of its items the property is lost.

use std::ops::ControlFlow;

/// Leaves items out of `kept`, which has the property, as long as what is left `holds` it. Whatever stops the search, `kept` has
/// the property.
pub fn ddmin<T: Clone>(
    kept: &mut Vec<T>,
    mut holds: impl FnMut(&[T]) -> ControlFlow<(), bool>,
) -> ControlFlow<()> {
    let mut parts = 2;
    while !kept.is_empty() {
        parts = parts.min(kept.len());
        let size = kept.len().div_ceil(parts);
        let starts: Vec<usize> = (0..kept.len()).step_by(size).collect();
        let end = |start: usize| (start + size).min(kept.len());
        let mut found = None;
        // One part alone. (Of two parts, each is what is left without the other.)
        if starts.len() > 2 {
            for &start in &starts {
                if holds(&kept[start..end(start)])? {
                    found = Some((kept[start..end(start)].to_vec(), 2));
                    break;
                }
            }
        }
        // All but one part.
        if found.is_none() {
            for &start in &starts {
                let rest = [&kept[..start], &kept[end(start)..]].concat();
                if holds(&rest)? {
                    found = Some((rest, (parts - 1).max(2)));
                    break;
                }
            }
        }
        match found {
            Some((fewer, next)) => (*kept, parts) = (fewer, next),
            None if size == 1 => break,
            None => parts *= 2,
        }
    }
    ControlFlow::Continue(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left of the first 100 numbers, and how often was asked.
    fn left(property: impl Fn(&[u32]) -> bool) -> (Vec<u32>, usize) {
        let (mut kept, mut asked) = ((0..100).collect(), 0);
        let flow = ddmin(&mut kept, |some| {
            asked += 1;
            ControlFlow::Continue(property(some))
        });
        assert_eq!(flow, ControlFlow::Continue(()));
        (kept, asked)
    }

    #[test]
    fn what_is_needed_is_left_in_its_order() {
        for needed in [&[][..], &[0], &[99], &[3, 50, 51], &[0, 1, 2, 97, 98, 99]] {
            let (kept, asked) = left(|some| needed.iter().all(|n| some.contains(n)));
            assert_eq!(kept, needed);
            assert!(asked < 200, "{needed:?}: {asked}");
        }
        assert_eq!(left(|some| some.len() == 100).0.len(), 100);
    }

    #[test]
    fn without_any_one_item_the_property_is_lost() {
        // Neither grows with the list nor shrinks with it.
        let odd = |some: &[u32]| some.iter().sum::<u32>() % 7 == 1 || some.len() == 100;
        let (kept, _) = left(odd);
        assert!(odd(&kept));
        for i in 0..kept.len() {
            let mut fewer = kept.clone();
            fewer.remove(i);
            assert!(!odd(&fewer), "{kept:?} without {i}");
        }
    }

    #[test]
    fn a_search_that_is_stopped_keeps_what_it_has() {
        let (mut kept, mut asked): (Vec<u32>, _) = ((0..100).collect(), 0);
        let flow = ddmin(&mut kept, |some| {
            asked += 1;
            if asked > 5 {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(some.contains(&40))
        });
        assert_eq!(flow, ControlFlow::Break(()));
        assert!(kept.contains(&40) && kept.len() < 100, "{kept:?}");
    }
}
