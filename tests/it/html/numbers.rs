//! The printed sums close: what stands on the page is an equation, not a decoration.

use raytree::math::Rgb;
use raytree::trace::document::SampleTree;

use super::{markup, pages, written};

/// The triples of numbers of a line, in order.
fn triples(line: &str) -> Vec<[f64; 3]> {
    let inner = line
        .split('(')
        .skip(1)
        .filter_map(|part| part.split(')').next());
    inner
        .filter_map(|inner| {
            let numbers: Result<Vec<f64>, _> = inner.split(", ").map(str::parse).collect();
            numbers.ok()?.try_into().ok()
        })
        .collect()
}

/// How far a printed number may be from its value: five decimals, or four digits of a power of ten.
fn rounding(x: f64) -> f64 {
    5e-6 + 5e-4 * if x.abs() < 1e7 { 0.0 } else { x.abs() }
}

/// What is wrong with the equations of a page, in words.
fn problems(page: &str) -> Vec<String> {
    let mut problems = Vec::new();
    for (ray, text) in markup::paragraphs(page, "e") {
        let mut lines = text.lines();
        let radiance = lines.next().map(triples).expect("a line")[0];
        let (mut sum, mut allowed) = ([0.0; 3], radiance.map(rounding));
        for line in lines {
            let all = triples(line);
            let value = all.last().expect("a value");
            for i in 0..3 {
                sum[i] += value[i];
                allowed[i] += rounding(value[i]);
            }
            // The product of what is printed; a power is too steep for printed digits.
            if let (true, false) = (line.contains('×'), line.contains('^')) {
                let factor = line.split("N·L ").nth(1);
                let factor = factor.and_then(|rest| rest.split(' ').next());
                let factor: f64 = factor.map_or(1.0, |x| x.parse().expect("a number"));
                let [a, b] = [all[0], all[1]];
                for i in 0..3 {
                    let product = a[i] * b[i] * factor;
                    let off = rounding(b[i]) * (a[i] + factor).abs().max(1.0)
                        + rounding(a[i]) * b[i].abs().max(1.0)
                        + rounding(factor) * (a[i] * b[i]).abs()
                        + rounding(value[i]);
                    if (product - value[i]).abs() > off {
                        problems.push(format!("ray {ray}: no product: {line}"));
                    }
                }
            }
        }
        if (0..3).any(|i| (sum[i] - radiance[i]).abs() > allowed[i]) {
            problems.push(format!("ray {ray}: the sum is {sum:?}: {text}"));
        }
    }
    problems
}

#[test]
fn terms_and_weighted_rays_add_up_to_the_radiance() {
    let mut equations = 0;
    for (name, document, page) in pages() {
        let rays = document.samples.iter().flat_map(SampleTree::rays);
        let brings = rays.filter(|ray| ray.node.radiance.is_some()).count();
        equations += brings;
        assert_eq!(markup::paragraphs(&page, "e").len(), brings, "{name}");
        assert_eq!(problems(&page), [""; 0], "{name}");
    }
    assert!(equations > 100, "{equations}");
}

/// The samples of an area light stand below its mean, and add up to it.
#[test]
fn samples_add_up_to_the_mean() {
    let mut bundles = 0;
    for (name, _, page) in pages() {
        let mut open: Option<([f64; 3], [f64; 3], [f64; 3])> = None;
        for (tag, text) in markup::tags(&page) {
            if let Some((_, mean)) = text.split_once(" blocked, mean ") {
                let mean = triples(mean)[0];
                open = Some((mean, [0.0; 3], mean.map(rounding)));
            }
            let Some((mean, sum, allowed)) = &mut open else {
                continue;
            };
            let lines = text
                .lines()
                .filter(|l| l.starts_with("diffuse ") || l.starts_with("specular "));
            for value in lines.filter_map(|line| triples(line).pop()) {
                for i in 0..3 {
                    sum[i] += value[i];
                    allowed[i] += rounding(value[i]);
                }
            }
            if tag == "/details" {
                let is_mean = (0..3).all(|i| (sum[i] - mean[i]).abs() <= allowed[i]);
                assert!(is_mean, "{name}: {sum:?} is not {mean:?}");
                bundles += usize::from(mean[0] > 0.0);
                open = None;
            }
        }
    }
    assert!(bundles >= 8, "{bundles}");
}

/// The law can fail: a radiance, a term and a weight that are not the tracer's break it.
#[test]
fn a_wrong_number_breaks_a_printed_sum() {
    let (_, document, _) = pages().swap_remove(0);
    assert_eq!(problems(&written(&document, "")), [""; 0]);
    for what in 0..3 {
        let mut wrong = document.clone();
        let root = wrong.samples[0].root.as_mut().expect("a ray");
        match what {
            0 => root.radiance = root.radiance.map(|c| c + Rgb::grey(1e-3)),
            1 => root.terms[0].value += Rgb::grey(1e-3),
            _ => {
                let child = root.children.iter_mut().find(|ray| ray.weight.is_some());
                let child = child.expect("R or T");
                child.radiance = child.radiance.map(|c| c + Rgb::grey(0.1));
            }
        }
        assert!(!problems(&written(&wrong, "")).is_empty(), "{what}");
    }
}

/// What every ray says of itself, read back from its own paragraph.
#[test]
fn a_ray_says_where_it_comes_from_and_what_it_weighs() {
    for (name, document, page) in pages() {
        let rays = document.samples.iter().flat_map(SampleTree::rays);
        let mut rays = rays.filter(|ray| ray.node.weight.is_some());
        for (id, text) in markup::paragraphs(&page, "") {
            let ray = rays.next().expect("a ray").node;
            assert_eq!(id, ray.id, "{name}");
            let expected = [
                ray.direction,
                ray.weight.expect("a weight").channels(),
                ray.throughput.expect("a throughput").channels(),
            ];
            let mut found = triples(text).into_iter();
            if !text.starts_with("along ") {
                let origin = found.next().expect("an origin");
                assert!(near(origin, ray.origin), "{name}: {text}");
            }
            for expected in expected {
                let found = found.next().expect("three numbers");
                assert!(near(found, expected), "{name}: {text}");
            }
            if let Some(hit) = &ray.hit {
                for expected in [hit.point, hit.normal] {
                    let found = found.next().expect("three numbers");
                    assert!(near(found, expected), "{name}: {text}");
                }
            }
        }
        assert_eq!(rays.count(), 0, "{name}: all are there");
    }
}

fn near(found: [f64; 3], expected: [f64; 3]) -> bool {
    (0..3).all(|i| (found[i] - expected[i]).abs() <= rounding(expected[i]))
}
