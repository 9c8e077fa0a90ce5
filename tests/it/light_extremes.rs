//! Lights that are hardly there: without an area, seen from their edge, at or through the place that they light.

use std::f64::consts::PI;

use raytree::math::DVec3;
use raytree::sampling::{LightSampling, Sampler};
use raytree::scene::Settings;
use raytree::trace::{View, trace_pixel};
use raytree::world::World;

use crate::floor::{LAMP, floor, irradiance, load, polygon, runs, settings};

/// Every way of sampling, with its irradiance at one place.
fn ways(world: &World) -> impl Iterator<Item = (Sampler, LightSampling, f64)> {
    Sampler::ALL.into_iter().flat_map(move |sampler| {
        LightSampling::ALL.map(|by| {
            let got = irradiance(world, &settings((sampler, by), 64, 5));
            (sampler, by, got)
        })
    })
}

/// How many shadow rays from the one pixel meet something.
fn blocked(world: &World, settings: &Settings) -> u32 {
    let trace = trace_pixel(world, settings, (0, 0), false);
    let view = View {
        world,
        settings,
        trace: &trace,
    };
    view.light_estimates(0)
        .iter()
        .map(|bundle| bundle.blocked)
        .sum()
}

#[test]
fn a_light_without_an_area_is_an_error_that_names_it() {
    for lamp in [
        r#"{"triangle": {"name": "lamp", "material": "lamp", "corners": [[0, 1, 0], [1, 2, 0], [3, 4, 0]]}}"#,
        r#"{"quad": {"name": "lamp", "material": "lamp", "corner": [0, 1, 0], "u": [1, 0, 0], "v": [2, 0, 0]}}"#,
        r#"{"disc": {"name": "lamp", "material": "lamp", "center": [0, 1, 0], "normal": [0, 1, 0], "radius": 0}}"#,
        r#"{"sphere": {"name": "lamp", "material": "lamp", "center": [0, 1, 0], "radius": 0}}"#,
        r#"{"plane": {"name": "lamp", "material": "lamp", "point": [0, 9, 0], "normal": [0, 1, 0]}}"#,
    ] {
        let problem = load([0.0, 0.0], LAMP, lamp).expect_err(lamp).to_string();
        assert!(
            problem.contains("lamp") || problem.contains("objects[0]"),
            "{lamp}: {problem}"
        );
    }
}

#[test]
fn a_light_seen_from_its_edge_brings_nothing() {
    // The lamps' planes run through the floor's place. A sphere has no edge; a quad on the floor lies in its plane.
    for lamp in [
        r#"{"quad": {"name": "lamp", "material": "lamp", "corner": [-1, 1, 0], "u": [2, 0, 0], "v": [0, 1, 0]}}"#,
        r#"{"triangle": {"name": "lamp", "material": "lamp", "corners": [[0, 1, 0], [0, 2, 0], [1, 2, 0]]}}"#,
        r#"{"disc": {"name": "lamp", "material": "lamp", "center": [0, 3, 0], "normal": [1, 0, 0], "radius": 1}}"#,
        r#"{"quad": {"name": "lamp", "material": "lamp", "corner": [1, 0, 1], "u": [1, 0, 0], "v": [0, 0, 1]}}"#,
    ] {
        for (sampler, by, got) in ways(&floor([0.0, 0.0], LAMP, lamp)) {
            // Not quite: the place that was hit is off by rounding.
            assert!(
                (0.0..1e-12).contains(&got),
                "{lamp}, {sampler:?}, {by:?}: {got}"
            );
        }
    }
}

#[test]
fn a_light_that_begins_at_the_lit_place_is_defined() {
    // A wall that stands on the floor along z = 0, its foot as good as at the place itself. By what they bring, no
    // sample can bring more than its share of the whole wall; by area, one may bring anything, but a number.
    let wall = r#"{"quad": {"name": "lamp", "material": "lamp", "corner": [-1, 0, 0], "u": [2, 0, 0], "v": [0, 2, 0]}}"#;
    let corners =
        [[-1.0, 0.0], [1.0, 0.0], [1.0, 2.0], [-1.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    for z in [1e-9, 1e-6, 1e-3] {
        let truth = polygon(DVec3::new(0.0, 0.0, z), &corners);
        let world = floor([0.0, z], LAMP, wall);
        for (sampler, by, got) in ways(&world) {
            assert!(
                got.is_finite() && got >= 0.0,
                "{z}, {sampler:?}, {by:?}: {got}"
            );
            // Its own far corners say how well rays meet it near by: it must not stand in its own way.
            let blocked = blocked(&world, &settings((sampler, by), 64, 5));
            assert_eq!(blocked, 0, "{z}, {sampler:?}, {by:?}");
            if by == LightSampling::Projected && sampler != Sampler::Grid {
                assert!(
                    (got - truth).abs() < 1e-6,
                    "{z}, {sampler:?}: {got}, not {truth}"
                );
            }
        }
    }
    // Exactly in the wall's plane there is nothing to see of it.
    for (sampler, by, got) in ways(&floor([0.0, 0.0], LAMP, wall)) {
        assert!(got.is_finite() && got >= 0.0, "{sampler:?}, {by:?}: {got}");
    }
}

#[test]
fn a_light_at_the_lit_place_is_defined() {
    // A point light on the floor has no direction to it from where it stands; a small ball around the place is a
    // furnace; half of a larger one that is cut by the floor as well.
    let point = r#"{"point": {"name": "here", "position": [0, 0, 0], "intensity": [1, 1, 1]}}"#;
    let marker =
        r#"{"sphere": {"name": "far", "material": "black", "center": [90, 90, 90], "radius": 1}}"#;
    for (sampler, by, got) in ways(&floor([0.0, 0.0], point, marker)) {
        assert!(got.is_finite(), "{sampler:?}, {by:?}: {got}");
    }
    for radius in [1e-3, 0.2] {
        let ball = format!(
            r#"{{"sphere": {{"name": "lamp", "material": "lamp", "center": [0, 0, 0], "radius": {radius}}}}}"#
        );
        // The eye is outside and sees the ball, not the floor in it: only the ball's own radiance comes back.
        for (sampler, by, got) in ways(&floor([0.0, 0.0], LAMP, &ball)) {
            assert!((got - PI).abs() < 1e-12, "{sampler:?}, {by:?}: {got}");
        }
    }
}

#[test]
fn a_light_partly_below_the_horizon_brings_its_upper_part() {
    // A wall from 1 below the floor to 1 above it, beside the place: the truth is the part above, by Lambert.
    let wall = |foot: f64| {
        format!(
            r#"{{"quad": {{"name": "lamp", "material": "lamp", "corner": [-1, {foot}, -1], "u": [2, 0, 0], "v": [0, {}, 0]}}}}"#,
            1.0 - foot
        )
    };
    let above = floor([0.0, 0.0], LAMP, &wall(0.0));
    let truth = irradiance(
        &above,
        &settings((Sampler::Sobol, LightSampling::Projected), 1, 1),
    );
    let world = floor([0.0, 0.0], LAMP, &wall(-1.0));
    for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        for by in LightSampling::ALL {
            let (mean, error) = runs(&world, (sampler, by), 64, 200);
            assert!(
                (mean - truth).abs() < 4.3 * error + 1e-9,
                "{sampler:?}, {by:?}: {mean} +- {error}, not {truth}"
            );
        }
    }
}
