//! The light that a picture may have lost to the limits of recursion, and where most.

use std::fmt;

use crate::scene::error::Problem;
use crate::scene::limits::MAX_DEPTH;
use crate::scene::{Scene, Settings, Warning, WarningCode, label, trace_command};
use crate::tracer::pixel::Pixel;
use crate::world::RayCuts;

/// The share of a picture's light that may be lost before it is a warning: a difference that the eye begins to see.
const VISIBLE: f64 = 0.01;

/// The part of the pixels that may lose more than half before it is a warning: a spot of 9 x 9 pixels of 320 x 240.
const SPOT: f64 = 0.001;

/// What a picture's pixels lost. The share of a pixel is the weight of its rays that were left out, over its samples: the part
/// of its light that is missing if they would have met what is as bright as the rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutShare {
    /// All rays that were left out.
    pub rays: RayCuts,
    /// The sum of the pixels' shares.
    pub sum: f64,
    /// The number of the picture's pixels.
    pub pixels: u64,
    /// How many pixels lost more than half.
    pub dark: u64,
    /// The pixel that lost most, the first of several, and its share.
    pub worst: Option<((u32, u32), f64)>,
}

impl CutShare {
    /// Adds pixel `at` of the picture, and what it lost.
    pub fn add(&mut self, at: (u32, u32), pixel: &Pixel) {
        self.pixels += 1;
        if pixel.cuts.is_empty() {
            return;
        }
        let share = pixel.cut_share();
        let own = Self {
            rays: pixel.cuts,
            sum: share,
            pixels: 0,
            dark: u64::from(share > 0.5),
            worst: Some((at, share)),
        };
        *self = self.plus(own);
    }

    /// The share of the whole picture: the mean of those of its pixels.
    pub fn share(&self) -> f64 {
        self.sum / (self.pixels.max(1)) as f64
    }

    /// A warning, if what was lost can be seen: more than a hundredth of the picture's light, or more than half of the light
    /// of a thousandth of its pixels. `name` is the scene as the user named it.
    pub fn warning(&self, name: &str, scene: &Scene, settings: &Settings) -> Option<Warning> {
        let dark = self.dark as f64 > SPOT * self.pixels as f64;
        (self.share() > VISIBLE || dark).then(|| {
            let worst = self.worst.map_or((0, 0), |(at, _)| at);
            // The accelerator changes no result.
            let settings = &settings.with(|s| s.accel = scene.settings.accel);
            let command = trace_command(name, scene, settings, worst);
            let cure = format!("{}; `{command}` shows them", cure(&self.rays, settings));
            let what = format!("limits left out {self}");
            Warning {
                code: WarningCode::RaysCut,
                problem: Problem::new(what, cure).in_file(label(name)),
                count: 1,
            }
        })
    }

    /// Both, those of `self` first.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let worst = match (self.worst, other.worst) {
            (Some(a), Some(b)) => Some(if b.1 > a.1 { b } else { a }),
            (a, b) => a.or(b),
        };
        Self {
            rays: self.rays.plus(other.rays),
            sum: self.sum + other.sum,
            pixels: self.pixels + other.pixels,
            dark: self.dark + other.dark,
            worst,
        }
    }
}

impl Pixel {
    /// A warning, if the pixel lost more than half of its light.
    pub fn cut_warning(&self, settings: &Settings, label: &str) -> Option<Warning> {
        let share = self.cut_share();
        (share > 0.5).then(|| {
            let what = format!("limits left out {}", self.cut_text());
            Warning {
                code: WarningCode::RaysCut,
                problem: Problem::new(what, cure(&self.cuts, settings)).in_file(label),
                count: 1,
            }
        })
    }

    /// How many rays were left out, and the share of the pixel's light.
    pub fn cut_text(&self) -> String {
        let share = 100.0 * self.cut_share();
        format!(
            "{}, with up to {share:.1} % of the pixel's light",
            counted(&self.cuts)
        )
    }
}

/// Which limit to change.
fn cure(cuts: &RayCuts, settings: &Settings) -> String {
    let recursion = &settings.recursion;
    // What is cut by weight weighs little.
    if cuts.by_depth > 0 && recursion.depth >= MAX_DEPTH {
        format!("--depth is {MAX_DEPTH}, and none is higher: give mirrors a coefficient below 1")
    } else if cuts.by_depth > 0 {
        format!(
            "raise --depth ({} now) until the picture stays as it is",
            recursion.depth
        )
    } else {
        format!("lower --min-weight ({} now)", recursion.min_weight)
    }
}

/// How many rays were left out by which limit.
fn counted(cuts: &RayCuts) -> String {
    let RayCuts {
        by_depth,
        by_weight,
        ..
    } = cuts;
    format!(
        "{} rays ({by_depth} by depth, {by_weight} by weight)",
        cuts.count()
    )
}

impl fmt::Display for CutShare {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = 100.0 * self.share();
        write!(
            f,
            "{}, with up to {share:.2} % of the picture's light",
            counted(&self.rays)
        )?;
        match self.worst {
            Some(((x, y), share)) => write!(f, "; most in pixel {x},{y}: {:.1} %", 100.0 * share),
            None => Ok(()),
        }
    }
}
