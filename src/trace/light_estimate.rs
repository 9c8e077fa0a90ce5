//! The estimate of an area light at a hit, from all shadow rays that were sent to it.

use super::View;
use super::tree::Outcome;
use crate::math::Rgb;
use crate::probe::{Event, RayKind};

/// Monte Carlo estimate of what an area light adds at a hit, with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightEstimate {
    /// The light.
    pub light: u32,
    /// Samples that arrived at the light.
    pub lit: u32,
    /// Samples with something in the way.
    pub blocked: u32,
    /// Samples for which no ray was sent: that part of the light is behind the surface.
    pub absent: u32,
    /// What the light adds: the mean over the samples, since each brings its share.
    pub mean: Rgb,
    /// The estimated standard error of the mean, in luminance, as if the samples were independent; they are not with
    /// `stratified` and `sobol`, whose true error is smaller. `None` for fewer than two samples.
    pub standard_error: Option<f64>,
}

impl View<'_> {
    /// The estimates at a node's hit, one for each area light that rays were sent to.
    pub fn light_estimates(self, node: u32) -> Vec<LightEstimate> {
        let tree = &self.trace.tree;
        let lights = 0..self.world.scene.lights.len() as u32;
        let areas: Vec<u32> = lights.filter(|light| self.is_area(*light)).collect();
        if areas.is_empty() || tree.node(node).ray.kind == RayKind::Light {
            return Vec::new();
        }
        let bundles = areas
            .into_iter()
            .map(|light| self.light_estimate(node, light));
        bundles
            .filter(|bundle| bundle.lit + bundle.blocked > 0)
            .collect()
    }

    /// The estimate at a node's hit of one area light.
    pub fn light_estimate(self, node: u32, light: u32) -> LightEstimate {
        let tree = &self.trace.tree;
        let rays = || tree.children(node).map(|child| tree.node(child));
        let count = |wanted: fn(Outcome) -> bool| {
            let ours = rays().filter(|ray| ray.ray.light == light);
            ours.filter(|ray| ray.outcome.is_some_and(wanted)).count() as u32
        };
        let lit = count(|outcome| outcome == Outcome::Lit);
        let blocked = count(|outcome| matches!(outcome, Outcome::Blocked(_)));
        // What each sample brought: its terms stand one after the other. The others brought nothing.
        let mut brought: Vec<(u16, Rgb)> = Vec::new();
        for (_, event) in tree.own_events(node) {
            match event {
                Event::Term {
                    light: l,
                    sample,
                    term,
                } if *l == light => match brought.last_mut() {
                    Some((last, sum)) if last == sample => *sum += term.value(),
                    _ => brought.push((*sample, term.value())),
                },
                _ => {}
            }
        }
        let mean = brought.iter().fold(Rgb::BLACK, |sum, (_, x)| sum + *x);
        let n = self.settings.rays_to_area();
        let brought = brought.iter().map(|(_, x)| x.luminance());
        LightEstimate {
            light,
            lit,
            blocked,
            absent: n.saturating_sub(lit + blocked),
            mean,
            standard_error: standard_error(brought, f64::from(n)),
        }
    }
}

/// The estimated standard error of a sum of n independent shares, of which those that are not named are 0:
/// sqrt(n / (n - 1) sum (x - mean)^2).
fn standard_error(shares: impl Iterator<Item = f64> + Clone, n: f64) -> Option<f64> {
    if n < 2.0 {
        return None;
    }
    let mean = shares.clone().sum::<f64>() / n;
    let named = shares.clone().count() as f64;
    let squares: f64 = shares.map(|x| (x - mean) * (x - mean)).sum();
    Some((n / (n - 1.0) * (squares + (n - named) * mean * mean)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_of_a_coin_is_known() {
        // Half of 100 shares of 1/100: the mean is 1/2, the standard deviation of one coin 1/2 (100/99)^1/2.
        let shares = [0.01; 50];
        let error = standard_error(shares.into_iter(), 100.0).expect("more than one");
        assert!(
            (error - 0.05 * (100.0f64 / 99.0).sqrt()).abs() < 1e-15,
            "{error}"
        );
        assert_eq!(standard_error([0.5].into_iter(), 1.0), None);
    }
}
