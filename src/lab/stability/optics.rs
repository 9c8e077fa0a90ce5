//! Refraction at the critical angle.

use super::picture::{Panel, Picture, Seen, panel};
use super::pinhole::Eye;
use super::{Case, Outcome, percent};
use crate::math::DVec3;
use crate::shading::optics::refract;

pub const CRITICAL_ANGLE: Case = Case {
    name: "critical-angle",
    hard: "glass to air, some floats from asin(1/1.5): k is 0 or a little less",
    source: "the root of a negative number times zero is no number",
    measure: critical_angle,
    picture: Picture {
        shows: "a chequered sky seen from inside of glass",
        wrong: "no number",
        draw: window_to_the_sky,
    },
};

/// Directions around the critical angle, one float of the sine apart.
fn directions() -> Vec<DVec3> {
    let mut sine = 1.0f64 / 1.5;
    for _ in 0..500 {
        sine = sine.next_down();
    }
    (0..1000)
        .map(|_| {
            sine = sine.next_up();
            DVec3::new(sine, -(1.0 - sine * sine).sqrt(), 0.0)
        })
        .collect()
}

/// Snell's law with the root first and the question whether there is one afterwards.
fn root_first(incident: DVec3, normal: DVec3, n1: f64, n2: f64) -> DVec3 {
    let eta = n1 / n2;
    let c = -normal.dot(incident);
    let k = 1.0 - eta * eta * (1.0 - c * c);
    let there = f64::from(u8::from(k >= 0.0));
    (eta * incident + (eta * c - k.sqrt()) * normal) * there
}

fn critical_angle() -> Vec<Outcome> {
    let all = directions();
    let outcome = |arithmetic: &str, ours, wrong: usize| Outcome {
        arithmetic: arithmetic.to_owned(),
        ours,
        found: percent(wrong, all.len()),
        allowed: 0.0,
        unit: "% of directions that are no numbers",
    };
    let naive = all
        .iter()
        .filter(|d| root_first(**d, DVec3::Y, 1.5, 1.0).is_nan());
    let ours = all
        .iter()
        .filter(|d| match refract(**d, DVec3::Y, 1.5, 1.0) {
            Ok(t) => !(t.is_finite() && t.y <= 0.0),
            Err(k) => k.is_nan(),
        });
    vec![
        outcome("root first", false, naive.count()),
        outcome("ours", true, ours.count()),
    ]
}

/// What is seen from below a glass's surface: the whole sky in a circle, around it the dark ground by total reflection.
fn window_to_the_sky(size: (u32, u32)) -> Vec<Panel> {
    const GROUND: f64 = 0.03;
    let eye = Eye::new(DVec3::ZERO, DVec3::new(0.05, 1.0, 0.03), 1.1);
    let sky = |t: DVec3| {
        let cell = |x: f64| (x * 4.0).floor();
        let even = (cell(t.x) + cell(t.z)) as i64 % 2 == 0;
        if even { 0.85 } else { 0.4 }
    };
    let naive = panel(("root first", false), size, |place| {
        let direction = eye.ray(place).direction;
        let refracted = root_first(direction, DVec3::NEG_Y, 1.5, 1.0);
        if refracted.is_nan() {
            return Seen {
                brightness: 0.0,
                wrong: true,
            };
        }
        // No light goes on: the ground.
        let reflected = refracted == DVec3::ZERO;
        Seen {
            brightness: if reflected { GROUND } else { sky(refracted) },
            wrong: false,
        }
    });
    let ours = panel(("ours", true), size, |place| {
        let direction = eye.ray(place).direction;
        match refract(direction, DVec3::NEG_Y, 1.5, 1.0) {
            Ok(t) => Seen {
                brightness: sky(t),
                wrong: !t.is_finite() || t.y < 0.0,
            },
            Err(k) => Seen {
                brightness: GROUND,
                wrong: k.is_nan(),
            },
        }
    });
    vec![naive, ours]
}
