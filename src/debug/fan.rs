//! Fan: the eye rays of a row or of a column of pixels, to where each first meets something.

use super::session::Session;
use crate::math::DVec3;
use crate::probe::Silent;

/// Rays of a fan at most: of a larger picture every n-th pixel has one.
const MOST: u32 = 48;

/// Which pixels send rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fan {
    /// Those of the pixel's row.
    Row,
    /// Those of the pixel's column.
    Column,
}

impl Fan {
    /// The next one: none, the row, the column.
    pub fn next(fan: Option<Self>) -> Option<Self> {
        match fan {
            None => Some(Self::Row),
            Some(Self::Row) => Some(Self::Column),
            Some(Self::Column) => None,
        }
    }

    /// The rays through the middles of the pixels: where each starts, and where it ends. Those that meet nothing end beyond what is
    /// drawn.
    pub fn rays(self, session: &Session) -> Vec<[DVec3; 2]> {
        let (world, settings) = (&session.world, &session.settings);
        let (width, height) = settings.size();
        let (x, y) = (session.trace.x, session.trace.y);
        let count = match self {
            Self::Row => width,
            Self::Column => height,
        };
        let far = 2.0 * session.extent.size().length();
        let every = count.div_ceil(MOST).max(1) as usize;
        let ray = |n: u32| {
            let [x, y] = match self {
                Self::Row => [n, y],
                Self::Column => [x, n],
            };
            let middle = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            let ray = world.scene.camera.ray(middle, (width, height));
            let hit = world.closest(&ray, 0.0, &mut Silent);
            [ray.origin, ray.at(hit.map_or(far, |hit| hit.t))]
        };
        (0..count).step_by(every).map(ray).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::scene::load;
    use crate::world::World;

    /// The rays start at the eye, end where the eye rays of these pixels hit, and are not too many.
    #[test]
    fn the_rays_are_those_of_the_pixels() {
        for (width, height) in [(32, 24), (400, 300)] {
            let scene = load("whitted").expect("built in");
            let settings = scene.settings.with(|s| {
                (s.image.width, s.image.height) = (width, height);
                s.pixel.samples = 1;
            });
            let world = Arc::new(World::new(scene, settings.accel));
            let session = Session::new(world, settings, (width / 2, height / 2));
            let eye = session.world.scene.camera.eye;
            for fan in [Fan::Row, Fan::Column] {
                let rays = fan.rays(&session);
                assert!((24..=48).contains(&rays.len()), "{}", rays.len());
                assert!(rays.iter().all(|[from, to]| *from == eye && to.is_finite()));
                // That of the open pixel is among them, if every pixel sends one.
                let node = session.tree().node(0);
                let hit = node.ray.origin
                    + node.ray.direction * session.view().surface_hit(0).expect("a hit").hit.t;
                let near = rays
                    .iter()
                    .map(|[_, to]| to.distance(hit))
                    .fold(f64::INFINITY, f64::min);
                assert!(width > 100 || near < 1e-12, "{near}");
            }
        }
        assert_eq!(Fan::next(Fan::next(Fan::next(None))), None);
    }
}
