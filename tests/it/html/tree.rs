//! Every ray of the document stands on the page once, inside the ray whose hit sent it; so do those that were not sent.

use std::collections::BTreeSet;

use raytree::probe::RayKind;
use raytree::trace::document::SampleTree;

use super::{markup, pages};

#[test]
fn every_ray_stands_once_where_it_belongs() {
    for (name, document, page) in pages() {
        let mut expected: Vec<(u32, Option<u32>)> = Vec::new();
        for sample in &document.samples {
            let rays: Vec<_> = sample.rays().collect();
            let id = |index: usize| rays[index].node.id;
            expected.extend(rays.iter().map(|ray| (ray.node.id, ray.parent.map(id))));
        }
        let (found, open) = markup::rays(&page);
        assert_eq!(found, expected, "{name}");
        assert_eq!(open, 0, "{name}");
    }
}

/// Only the first eye ray is unfolded, and the sample that it belongs to if there are others.
#[test]
fn deep_rays_are_closed() {
    for (name, document, page) in pages() {
        let tags = markup::tags(&page);
        let open: Vec<&str> = tags
            .iter()
            .map(|(tag, _)| *tag)
            .filter(|tag| tag.starts_with("details") && tag.ends_with(" open"))
            .collect();
        let first = "details id=r0 class=I open";
        let expected = if document.samples.len() > 1 {
            vec!["details open", first]
        } else {
            vec![first]
        };
        assert_eq!(open, expected, "{name}");
    }
}

#[test]
fn rays_that_were_not_sent_stand_at_the_hit_with_their_reasons() {
    let mut seen = BTreeSet::new();
    for (name, document, page) in pages() {
        let mut expected: Vec<(u32, &str)> = Vec::new();
        let mut reasons = BTreeSet::new();
        let rays = document.samples.iter().flat_map(SampleTree::rays);
        for ray in rays {
            for absent in &ray.node.absent {
                expected.push((ray.node.id, absent.kind.letter()));
                reasons.insert(absent.reason.words());
            }
        }
        let mut found = Vec::new();
        for (ray, text) in markup::paragraphs(&page, "a") {
            for line in text.lines() {
                let letter = line.strip_prefix("no ").and_then(|rest| rest.get(..1));
                let letter = letter.expect("a letter");
                let count = line.split_once(" samples)");
                let count = count.and_then(|(before, _)| before.rsplit('(').next()?.parse().ok());
                found.extend(std::iter::repeat_n((ray, letter), count.unwrap_or(1)));
            }
        }
        assert_eq!(found, expected, "{name}");
        // A sentence for each reason that is on the page, and for no other.
        let told = markup::tags(&page).into_iter();
        let told = told
            .filter(|(tag, _)| *tag == "dt")
            .map(|(_, text)| text.trim());
        assert_eq!(told.collect::<BTreeSet<_>>(), reasons, "{name}");
        seen.extend(reasons);
    }
    assert!(seen.len() >= 6, "{seen:?}");
}

/// A letter of the drawing for each kind of ray there is, and no number that is none.
#[test]
fn every_kind_of_ray_is_drawn() {
    for (name, document, page) in pages() {
        let kinds: BTreeSet<RayKind> = document
            .samples
            .iter()
            .flat_map(SampleTree::rays)
            .map(|ray| ray.node.kind)
            .collect();
        // Where nothing is hit nothing is drawn.
        let mut rays = document.samples.iter().flat_map(SampleTree::rays);
        let is_drawn = rays.any(|ray| ray.node.hit.is_some());
        let views = if is_drawn { 3 } else { 0 };
        assert_eq!(page.matches("<svg ").count(), views, "{name}");
        for kind in RayKind::ALL.into_iter().filter(|_| is_drawn) {
            let path = format!("<path class={} d=\"M", kind.letter());
            assert_eq!(
                page.contains(&path),
                kinds.contains(&kind),
                "{name}, {kind:?}"
            );
        }
        let paths = page.lines().filter(|line| line.starts_with("<path "));
        for path in paths {
            let d = path.split("d=\"").nth(1).expect("a path");
            let is_path = |c: char| "MLh- .0123456789\"/>".contains(c);
            assert!(d.chars().all(is_path), "{name}: {path}");
        }
    }
}
